// SPDX-License-Identifier: GPL-3.0-or-later
// TikZ, using only texlive-pictures: a scope for each layer. The file is a LaTeX document that compiles by itself; read
// by \input in another document, it is only the picture.
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "render/figure/internal/bezier_arcs.h"
#include "render/figure/internal/chains.h"
#include "render/figure/internal/grid.h"
#include "render/figure/internal/text_tools.h"
#include "render/figure/writers.h"

namespace mes::figure {
namespace {

// Lengths in TeX are below 16384 points; coordinates are within six diagonals of the page.
constexpr double kLongestSide = 1900.0;
// Angles in TeX have five decimals, which determine the end of an arc of this radius within a hundredth of a point.
constexpr double kLargestArc = 500.0;
constexpr int kAngleDecimals = 5;
// TeX reads a path in pieces but keeps all of it.
constexpr std::size_t kShapesInAPath = 200;
// TeX keeps a page in its memory until the page is complete, 30 to 300 words for each shape, and pdflatex has five
// million words by default. A transparency group is output immediately instead (`write`).
constexpr std::size_t kShapesInAGroup = 2000;

class TikzWriter {
 public:
  explicit TikzWriter(const Figure& figure) : figure_(figure) {}

  std::string write() {
    const std::string page = "(0,0) rectangle " + text({figure_.width, 0.0});
    if (figure_.background) body_ += "\\fill[" + color(*figure_.background) + "] " + page + ";\n";
    for (const FigureLayer& layer : figure_.layers) write(layer);
    legend();
    // LaTeX sets \@nodocument to \relax at the beginning of the document.
    std::string out =
        "% By itself, on a page of its size: pdflatex FILE.tex\n"
        "% In a document with \\usepackage{tikz}: \\input{FILE.tex}\n"
        "\\expandafter\\ifx\\csname @nodocument\\endcsname\\relax\n"
        "\\def\\finishpicture{}%\n"
        "\\else\n"
        "\\documentclass{article}\n"
        "\\usepackage[paperwidth=" +
        length(figure_.width) + ",paperheight=" + length(figure_.height) +
        ",margin=0bp]{geometry}\n"
        "\\usepackage{tikz}\n"
        "\\pagestyle{empty}\n"
        "\\setlength{\\parindent}{0pt}\n"
        "\\setlength{\\topskip}{0pt}\n"
        "\\def\\finishpicture{\\end{document}}%\n"
        "\\begin{document}\n"
        "\\fi\n";
    for (const auto& [name, number] : colors_) {
      std::string digits = name.substr(1);
      std::ranges::transform(digits, digits.begin(), [](char c) { return c >= 'a' ? static_cast<char>(c - 32) : c; });
      out += "\\definecolor{" + color_name(number) + "}{HTML}{" + digits + "}%\n";
    }
    out += "\\begin{tikzpicture}[x=1bp,y=1bp,line cap=round,line join=round]\n";
    // \immediate is needed because pdflatex would otherwise keep each group in memory until the page is complete. Other
    // engines do so, but their memory grows.
    if (has_parts_)
      out +=
          "\\ifdefined\\pdfxform\\let\\mesecinaform\\pdfxform"
          "\\def\\pdfxform{\\immediate\\mesecinaform}\\fi\n";
    out += "\\path[use as bounding box] " + page + ";\n\\clip " + page + ";\n";
    return out + body_ + "\\end{tikzpicture}%\n\\finishpicture%\n";
  }

 private:
  static std::string color_name(std::size_t number) { return "mesecina" + std::to_string(number); }
  std::string color(Rgb color) { return color_name(colors_.try_emplace(hex(color), colors_.size()).first->second); }
  std::string number(double value) const {
    std::string out;
    append_decimal(out, value, figure_.decimals);
    return out;
  }
  static std::string fraction(double value, int decimals = kOpacityDecimals) {
    std::string out;
    append_decimal(out, value, decimals);
    return out;
  }
  /// y grows upwards in TikZ.
  std::string text(Vec2 p) const { return '(' + number(p.x) + ',' + number(figure_.height - p.y) + ')'; }
  std::string length(double value) const { return number(value) + "bp"; }

  void write(const FigureLayer& layer) {
    body_ += "% layer " + layer.id + ": " + layer.title + "\n\\begin{scope}[line width=" + length(layer.line_width) +
             "]\n";
    if (layer.clip)
      body_ += "\\clip " + text(layer.clip->corner) + " rectangle " +
               text(layer.clip->corner + Vec2{layer.clip->width, layer.clip->height}) + ";\n";
    for (const Group& group : layer.groups) {
      if (group.opacity < 1.0)
        body_ += "\\begin{scope}[transparency group,opacity=" + fraction(group.opacity) + "]\n";
      write(group);
      if (group.opacity < 1.0) body_ += "\\end{scope}\n";
    }
    write(layer.texts);
    body_ += "\\end{scope}\n";
  }

  /// Paints many shapes in parts, each its own group: painting is associative, so this is invisible.
  void write(const Group& group) {
    std::size_t count = 0;
    for (const Run& run : group.runs) count += run.shapes.size();
    if (count <= kShapesInAGroup) {
      for (const Run& run : group.runs) write(run, run.shapes);
      return;
    }
    has_parts_ = true;
    std::size_t in_part = 0;
    for (const Run& run : group.runs) {
      std::span<const Shape> left(run.shapes);
      while (!left.empty()) {
        if (in_part == 0) body_ += "\\begin{scope}[transparency group]\n";
        const std::size_t most = std::min(left.size(), kShapesInAGroup - in_part);
        write(run, left.first(most));
        left = left.subspan(most);
        in_part += most;
        if (in_part < kShapesInAGroup) continue;
        body_ += "\\end{scope}\n";
        in_part = 0;
      }
    }
    if (in_part != 0) body_ += "\\end{scope}\n";
  }

  /// Writes some shapes of the run.
  void write(const Run& run, std::span<const Shape> shapes) {
    const bool is_one_path = run.opacity >= 1.0;
    std::string look = color(run.color);
    if (run.opacity < 1.0) look += ",opacity=" + fraction(run.opacity);
    if (run.dashes != Dashes{})
      look += ",line cap=butt,dash pattern=on " + length(run.dashes.on) + " off " + length(run.dashes.off) +
              ",dash phase=" + length(run.dashes.offset);
    // The common look of many paths is written once: TeX stores every repetition in its memory.
    const bool has_scope = !is_one_path && shapes.size() > 1;
    if (has_scope) body_ += "\\begin{scope}[" + look + "]\n";
    const std::string command =
        std::string(run.is_filled ? "\\fill" : "\\draw") + (has_scope ? std::string() : '[' + look + ']');
    std::size_t in_path = 0;
    for (std::size_t i = 0; i < shapes.size();) {
      if (in_path == 0) body_ += command;
      const std::size_t count = path(shapes, i, is_one_path);
      i += count;
      in_path += count;
      if (is_one_path && in_path < kShapesInAPath && i < shapes.size()) {
        body_ += '\n';
        continue;
      }
      body_ += ";\n";
      in_path = 0;
    }
    if (has_scope) body_ += "\\end{scope}\n";
  }

  void curves(const std::vector<Bezier>& beziers) {
    for (const Bezier& bezier : beziers)
      body_ += " .. controls " + text(bezier.first_handle) + " and " + text(bezier.second_handle) + " .. " +
               text(bezier.end);
  }

  /// Writes the shape at `i`, or the chain that begins there; returns the number of shapes.
  std::size_t path(std::span<const Shape> shapes, std::size_t i, bool with_chains) {
    const Shape& shape = shapes[i];
    body_ += ' ' + text(shape.p[0]);
    switch (shape.kind) {
      case ShapeKind::disk:
      case ShapeKind::circle: body_ += " circle[radius=" + length(shape.radius) + ']'; return 1;
      case ShapeKind::parabola:
      case ShapeKind::segment: {
        const std::size_t count = std::min(with_chains ? chain_length(shapes, i) : 1, kShapesInAPath);
        const std::span<const Shape> chain = shapes.subspan(i, count);
        for (const Shape& side : chain) {
          if (side.kind == ShapeKind::parabola)
            curves({parabola_curve(side)});
          else if (!is_loop(chain) || &side != &chain.back())
            body_ += " -- " + text(side.p[1]);
        }
        if (is_loop(chain)) body_ += " -- cycle";
        return count;
      }
      case ShapeKind::triangle:
        body_ += " -- " + text(shape.p[1]) + " -- " + text(shape.p[2]) + " -- cycle";
        return 1;
      case ShapeKind::arc: {
        if (shape.radius > kLargestArc) {
          curves(arc_curves(shape, figure_.decimals));
          return 1;
        }
        constexpr double kDegree = 180.0 / std::numbers::pi;
        const Vec2 from = shape.p[0] - shape.p[2];
        const double start = kDegree * std::atan2(-from.y, from.x);
        body_ += " arc[start angle=" + fraction(start, kAngleDecimals) +
                 ",delta angle=" + fraction(kDegree * shape.sweep, kAngleDecimals) +
                 ",radius=" + length(shape.radius) + ']';
        return 1;
      }
      case ShapeKind::curve: curves({{shape.p[1], shape.p[2], shape.p[3]}}); return 1;
      case ShapeKind::rim:
        curves({{shape.p[1], shape.p[2], shape.p[3]}});
        body_ += " -- " + text(shape.p[4]) + " -- " + text(shape.p[5]) + " -- cycle";
        return 1;
    }
    return 1;
  }

  void legend() {
    const Legend& legend = figure_.legend;
    if (legend.is_empty()) return;
    body_ += "% legend\n\\begin{scope}\n";
    for (const Box& box : legend.boxes) {
      body_ += "\\fill[" + color(box.color);
      if (box.opacity < 1.0) body_ += ",opacity=" + fraction(box.opacity);
      body_ += "] " + text(box.corner) + " rectangle " + text(box.corner + Vec2{box.width, box.height}) + ";\n";
    }
    for (const Run& run : legend.runs) write(run, run.shapes);
    write(legend.texts);
    body_ += "\\end{scope}\n";
  }

  void write(std::span<const Text> texts) {
    for (const TexText& each : tex_texts(texts)) {
      const std::string size = number(kEmOfSize * each.text.size) + "bp";
      const std::string opacity = each.text.opacity < 1.0 ? ",text opacity=" + fraction(each.text.opacity) : "";
      body_ += "\\node[anchor=base west,inner sep=0pt," + color(each.text.color) + opacity + ",font=\\sffamily" +
               each.look + "\\fontsize{" + size + "}{" + size + "}\\selectfont] at " + text(each.text.start) + " {" +
               each.content + "};\n";
    }
  }

  const Figure& figure_;
  std::string body_;
  std::map<std::string, std::size_t> colors_;
  bool has_parts_ = false;
};

}  // namespace

Expected<std::string> tikz_of(const Figure& figure) {
  if (std::max(figure.width, figure.height) > kLongestSide)
    return std::unexpected(Error{ErrorCode::usage, "a page in TikZ has sides of 1900 points (26 inches) at most"});
  return TikzWriter(figure).write();
}

}  // namespace mes::figure
