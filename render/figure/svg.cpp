// SPDX-License-Identifier: GPL-3.0-or-later
// Scalable Vector Graphics (SVG) 1.1 (Second Edition), W3C Recommendation, 2011.
#include <cmath>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "core/base/carried_session.h"
#include "render/figure/internal/chains.h"
#include "render/figure/internal/grid.h"
#include "render/figure/internal/text_tools.h"
#include "render/figure/writers.h"
#include "render/image/png.h"

namespace mes::figure {
namespace {

constexpr const char* kClip = "page";

class SvgWriter {
 public:
  explicit SvgWriter(const Figure& figure, std::string prefix = {}, bool is_element = false)
      : figure_(figure), number_(out_, figure.decimals), prefix_(std::move(prefix)), is_element_(is_element) {}

  Expected<std::string> write() {
    begin();
    for (const FigureLayer& layer : figure_.layers)
      if (const auto good = write(layer); !good) return std::unexpected(good.error());
    legend();
    out_ += "</svg>\n";
    return std::move(out_);
  }

 private:
  void attribute(const char* name, double value) {
    out_ += ' ';
    out_ += name;
    out_ += "=\"";
    number_(value);
    out_ += '"';
  }
  void attribute(const char* name, const std::string& value) {
    out_ += ' ' + std::string(name) + "=\"" + value + '"';
  }
  void fraction(const char* name, double value) {
    out_ += ' ' + std::string(name) + "=\"";
    append_decimal(out_, value, kOpacityDecimals);
    out_ += '"';
  }
  void rectangle(Vec2 corner, double width, double height) {
    out_ += "<rect";
    if (corner.x != 0.0) attribute("x", corner.x);
    if (corner.y != 0.0) attribute("y", corner.y);
    attribute("width", width);
    attribute("height", height);
  }

  std::string clip_of(const FigureLayer& layer) const {
    return prefix_ + (layer.clip ? "part-" + escaped_xml(layer.id) : kClip);
  }

  void begin() {
    constexpr double kMillimeters = kMillimetersPerInch / kPointsPerInch;
    constexpr int kSizeDecimals = 4;
    if (!is_element_) out_ += "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
    out_ +=
        "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" "
        "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" version=\"1.1\" width=\"";
    append_decimal(out_, kMillimeters * figure_.width, kSizeDecimals);
    out_ += "mm\" height=\"";
    append_decimal(out_, kMillimeters * figure_.height, kSizeDecimals);
    out_ += "mm\" viewBox=\"0 0 ";
    number_({figure_.width, figure_.height});
    out_ += "\" fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n<defs><clipPath id=\"";
    out_ += prefix_ + kClip;
    out_ += "\">";
    rectangle({}, figure_.width, figure_.height);
    out_ += "/></clipPath>";
    for (const FigureLayer& layer : figure_.layers) {
      if (!layer.clip) continue;
      out_ += "<clipPath id=\"" + clip_of(layer) + "\">";
      rectangle(layer.clip->corner, layer.clip->width, layer.clip->height);
      out_ += "/></clipPath>";
    }
    out_ += "</defs>\n";
    if (!figure_.session.empty() && !is_element_) {
      const std::string name(kCarriedSession);
      out_ += "<metadata><" + name + " xmlns=\"urn:mesecina:session\">" + base64(figure_.session) + "</" + name +
              "></metadata>\n";
    }
    if (figure_.background) {
      rectangle({}, figure_.width, figure_.height);
      attribute("fill", hex(*figure_.background));
      out_ += "/>\n";
    }
  }

  Expected<void> write(const FigureLayer& layer) {
    out_ += "<g";
    attribute("id", prefix_ + escaped_xml(layer.id));
    attribute("inkscape:groupmode", std::string("layer"));
    attribute("inkscape:label", escaped_xml(layer.title));
    attribute("clip-path", "url(#" + clip_of(layer) + ')');
    attribute("stroke-width", layer.line_width);
    out_ += ">\n";
    if (layer.image)
      if (const auto good = image(*layer.image); !good) return good;
    for (const Group& group : layer.groups) {
      if (group.opacity < 1.0) {
        out_ += "<g";
        fraction("opacity", group.opacity);
        out_ += ">\n";
      }
      for (const Run& run : group.runs) write(run);
      if (group.opacity < 1.0) out_ += "</g>\n";
    }
    for (const Text& text : layer.texts) write(text);
    out_ += "</g>\n";
    return {};
  }

  Expected<void> image(const PlacedImage& image) {
    const auto png = render::encode_png(image.image, render::kPngSmall);
    if (!png) return std::unexpected(png.error());
    out_ += "<image";
    attribute("x", image.corner.x);
    attribute("y", image.corner.y);
    attribute("width", image.width);
    attribute("height", image.height);
    if (image.opacity < 1.0) fraction("opacity", image.opacity);
    attribute("preserveAspectRatio", std::string("none"));
    out_ += " xlink:href=\"data:image/png;base64,";
    out_ += base64({reinterpret_cast<const char*>(png->data()), png->size()});
    out_ += "\"/>\n";
    return {};
  }

  void paint(const Run& run) {
    const char* const what = run.is_filled ? "fill" : "stroke";
    attribute(what, hex(run.color));
    if (run.opacity < 1.0) fraction(run.is_filled ? "fill-opacity" : "stroke-opacity", run.opacity);
    if (run.dashes == Dashes{}) return;
    attribute("stroke-linecap", std::string("butt"));
    out_ += " stroke-dasharray=\"";
    number_({run.dashes.on, run.dashes.off});
    out_ += '"';
    if (run.dashes.offset != 0.0) attribute("stroke-dashoffset", run.dashes.offset);
  }

  /// Circles and disks are separate elements; everything else is a path, one for all if overlaps are invisible.
  void write(const Run& run) {
    const bool is_one_path = run.opacity >= 1.0;
    std::size_t elements = 0;
    bool has_path = false;
    for (const Shape& shape : run.shapes) {
      const bool is_round = shape.kind == ShapeKind::disk || shape.kind == ShapeKind::circle;
      elements += is_round || !is_one_path || !has_path ? 1 : 0;
      has_path = has_path || !is_round;
    }
    const bool in_group = elements > 1;
    if (in_group) {
      out_ += "<g";
      paint(run);
      out_ += ">\n";
    }
    const auto open = [&](const char* name) {
      out_ += '<';
      out_ += name;
      if (!in_group) paint(run);
    };
    const std::span<const Shape> shapes(run.shapes);
    bool in_path = false;
    for (std::size_t i = 0; i < shapes.size();) {
      const Shape& shape = shapes[i];
      if (shape.kind == ShapeKind::disk || shape.kind == ShapeKind::circle) {
        open("circle");
        attribute("cx", shape.p[0].x);
        attribute("cy", shape.p[0].y);
        attribute("r", shape.radius);
        out_ += "/>\n";
        ++i;
        continue;
      }
      if (is_one_path && has_path && !in_path) {
        // Writes all of them here, whatever their positions in the run: it is opaque and of one colour.
        open("path");
        out_ += " d=\"";
        for (std::size_t k = i; k < shapes.size();) k += path(shapes, k, true);
        out_ += "\"/>\n";
        in_path = true;
      }
      if (is_one_path) {
        ++i;
        continue;
      }
      open("path");
      out_ += " d=\"";
      i += path(shapes, i, false);
      out_ += "\"/>\n";
    }
    if (in_group) out_ += "</g>\n";
  }

  void move(Vec2 p) {
    out_ += 'M';
    number_(p);
  }
  void line(Vec2 p) {
    out_ += 'L';
    number_(p);
  }

  /// Writes the shape at `i`, or the chain of segments that begins there; returns the number of shapes.
  std::size_t path(std::span<const Shape> shapes, std::size_t i, bool with_chains) {
    const Shape& shape = shapes[i];
    switch (shape.kind) {
      case ShapeKind::disk:
      case ShapeKind::circle: return 1;
      case ShapeKind::parabola:
      case ShapeKind::segment: {
        const std::size_t count = with_chains ? chain_length(shapes, i) : 1;
        const std::span<const Shape> chain = shapes.subspan(i, count);
        move(shape.p[0]);
        for (const Shape& side : chain) {
          if (side.kind == ShapeKind::segment) {
            line(side.p[1]);
            continue;
          }
          out_ += 'Q';
          number_(side.p[2]);
          out_ += ' ';
          number_(side.p[1]);
        }
        if (is_loop(chain)) out_ += 'Z';
        return count;
      }
      case ShapeKind::triangle:
        move(shape.p[0]);
        line(shape.p[1]);
        line(shape.p[2]);
        out_ += 'Z';
        return 1;
      case ShapeKind::arc: arc(shape); return 1;
      case ShapeKind::curve:
      case ShapeKind::rim:
        move(shape.p[0]);
        out_ += 'C';
        number_(shape.p[1]);
        out_ += ' ';
        number_(shape.p[2]);
        out_ += ' ';
        number_(shape.p[3]);
        if (shape.kind == ShapeKind::rim) {
          line(shape.p[4]);
          line(shape.p[5]);
          out_ += 'Z';
        }
        return 1;
    }
    return 1;
  }

  /// Writes pieces of at most two radians: the centre of a longer piece would depend on the last digit of its ends.
  void arc(const Shape& shape) {
    constexpr double kLongest = 2.0;
    const auto pieces = static_cast<int>(std::ceil(shape.sweep / kLongest));
    const Vec2 center = shape.p[2];
    const double first = std::atan2(center.y - shape.p[0].y, shape.p[0].x - center.x);
    move(shape.p[0]);
    for (int piece = 1; piece <= pieces; ++piece) {
      const double angle = first + shape.sweep * piece / pieces;
      const Vec2 end = piece == pieces ? shape.p[1] : center + shape.radius * Vec2{std::cos(angle), -std::sin(angle)};
      out_ += 'A';
      number_({shape.radius, shape.radius});
      out_ += " 0 0 0 ";
      number_(end);
    }
  }

  void legend() {
    const Legend& legend = figure_.legend;
    if (legend.is_empty()) return;
    out_ += "<g id=\"" + prefix_ + "legend\" inkscape:groupmode=\"layer\" inkscape:label=\"Legend\">\n";
    for (const Box& box : legend.boxes) {
      rectangle(box.corner, box.width, box.height);
      attribute("fill", hex(box.color));
      if (box.opacity < 1.0) fraction("fill-opacity", box.opacity);
      out_ += "/>\n";
    }
    for (const Run& run : legend.runs) write(run);
    for (const Text& text : legend.texts) write(text);
    out_ += "</g>\n";
  }

  void write(const Text& text) {
    if (text.text.empty()) return;
    out_ += "<text";
    attribute("x", text.start.x);
    attribute("y", text.start.y);
    attribute("font-size", kEmOfSize * text.size);
    if (text.width > 0.0) attribute("textLength", text.width);
    attribute("font-family", std::string("Inter, Helvetica, Arial, sans-serif"));
    if (text.is_bold) attribute("font-weight", std::string("600"));
    if (text.is_italic) attribute("font-style", std::string("italic"));
    attribute("fill", hex(text.color));
    if (text.opacity < 1.0) fraction("fill-opacity", text.opacity);
    // Spaces at the ends are part of the width.
    if (text.text.front() == ' ' || text.text.back() == ' ') attribute("xml:space", std::string("preserve"));
    out_ += '>' + escaped_xml(text.text) + "</text>\n";
  }

  const Figure& figure_;
  std::string out_;
  NumberWriter number_;
  std::string prefix_;  // prefix of ids
  bool is_element_;
};

}  // namespace

Expected<std::string> svg_of(const Figure& figure) {
  return SvgWriter(figure).write();
}

Expected<std::string> svg_element_of(const Figure& figure, std::string_view prefix) {
  return SvgWriter(figure, std::string(prefix), true).write();
}

}  // namespace mes::figure
