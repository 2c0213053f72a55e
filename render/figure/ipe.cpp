// SPDX-License-Identifier: GPL-3.0-or-later
// Ipe 7, the XML format of the extensible drawing editor (its manual, "The Ipe file format"): an Ipe layer a layer.
//
// Ipe has no group opacity. A flat layer of one colour becomes one path with the opacity of the layer, which looks the
// same. A flat layer of several colours becomes a picture.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/base/carried_session.h"
#include "core/base/zlib.h"
#include "render/figure/internal/chains.h"
#include "render/figure/internal/grid.h"
#include "render/figure/internal/text_tools.h"
#include "render/figure/raster.h"
#include "render/figure/writers.h"

namespace mes::figure {
namespace {

/// Whether its shapes hide each other and are blended onto the page with one opacity.
bool is_flat_in_colors(const Group& group) {
  return group.opacity < 1.0 &&
         std::ranges::any_of(group.runs, [&](const Run& run) { return run.color != group.runs.front().color; });
}

class IpeWriter {
 public:
  explicit IpeWriter(const Figure& figure) : figure_(figure) {}

  std::string write() {
    std::string layers;
    std::string data;  // data attribute of the first layer
    if (!figure_.session.empty())
      data = " data=\"" + std::string(kCarriedSession) + ':' + base64(figure_.session) + '"';
    if (has_background()) layers += "<layer name=\"background\"" + std::exchange(data, "") + "/>\n";
    for (const FigureLayer& layer : figure_.layers)
      layers += "<layer name=\"" + escaped_xml(layer.id) + '"' + std::exchange(data, "") + "/>\n";
    std::string names;
    for (const FigureLayer& layer : figure_.layers) names += (names.empty() ? "" : " ") + escaped_xml(layer.id);
    background();
    for (const FigureLayer& layer : figure_.layers) write(layer);
    legend();
    std::string out =
        "<?xml version=\"1.0\"?>\n<!DOCTYPE ipe SYSTEM \"ipe.dtd\">\n"
        "<ipe version=\"70218\" creator=\"Mesecina\">\n<ipestyle name=\"mesecina\">\n<layout paper=\"" +
        pair({figure_.width, figure_.height}) + "\" origin=\"0 0\" frame=\"" + pair({figure_.width, figure_.height}) +
        "\" crop=\"no\"/>\n";
    for (const auto& [value, name] : opacities_) out += "<opacity name=\"" + name + "\" value=\"" + value + "\"/>\n";
    out += "</ipestyle>\n<page>\n";
    out += layers;
    if (has_legend()) out += "<layer name=\"legend\"/>\n";
    if (has_background()) names = "background" + (names.empty() ? "" : ' ' + names);
    if (has_legend()) names += " legend";
    const std::string active = figure_.layers.empty() ? "background" : escaped_xml(figure_.layers.back().id);
    if (!names.empty()) out += "<view layers=\"" + names + "\" active=\"" + active + "\"/>\n";
    return out + body_ + "</page>\n</ipe>\n";
  }

 private:
  bool has_background() const { return figure_.background || figure_.layers.empty(); }
  bool has_legend() const { return !figure_.legend.is_empty(); }

  std::string number(double value) const {
    std::string out;
    append_decimal(out, value, figure_.decimals);
    return out;
  }
  std::string pair(Vec2 p) const { return number(p.x) + ' ' + number(p.y); }
  /// y grows upwards in Ipe.
  std::string text(Vec2 p) const { return pair({p.x, figure_.height - p.y}); }
  static std::string color(Rgb color) {
    std::string out;
    for (const std::uint8_t channel : {color.r, color.g, color.b}) {
      if (!out.empty()) out += ' ';
      append_decimal(out, channel / 255.0, kColorDecimals);
    }
    return out;
  }
  /// Ipe knows opacities by the names in its style.
  const std::string& named_opacity(double value) {
    std::string text;
    append_decimal(text, value, kColorDecimals);
    return opacities_.try_emplace(text, "opacity-" + text).first->second;
  }
  std::string opacity(double value) {
    if (value >= 1.0) return {};
    const std::string& name = named_opacity(value);
    return " opacity=\"" + name + "\" stroke-opacity=\"" + name + '"';
  }
  std::string rectangle(Vec2 corner, double width, double height) const {
    return text(corner) + " m\n" + text(corner + Vec2{width, 0.0}) + " l\n" + text(corner + Vec2{width, height}) +
           " l\n" + text(corner + Vec2{0.0, height}) + " l\nh\n";
  }

  void background() {
    if (!figure_.background) return;
    body_ += "<path layer=\"background\" fill=\"" + color(*figure_.background) + "\">\n" +
             rectangle({}, figure_.width, figure_.height) + "</path>\n";
  }

  void write(const FigureLayer& layer) {
    if (layer.groups.empty() && !layer.image && layer.texts.empty()) return;
    const PagePart part = layer.clip.value_or(PagePart{{}, figure_.width, figure_.height});
    std::string clip = rectangle(part.corner, part.width, part.height);
    for (char& c : clip)
      if (c == '\n') c = ' ';
    body_ += "<group layer=\"" + escaped_xml(layer.id) + "\" clip=\"" + clip + "\">\n";
    if (layer.image) write(*layer.image);
    for (const Group& group : layer.groups)
      for (const Run& run : group.runs) write(run, group.opacity, layer.line_width);
    write(layer.texts, {});
    body_ += "</group>\n";
  }

  void write(const PlacedImage& placed) {
    const render::Image& image = placed.image;
    // The alpha is the first byte of each pixel.
    std::string bytes;
    bytes.reserve(image.rgba.size());
    for (std::size_t i = 0; i < image.rgba.size(); i += 4)
      for (const std::size_t channel : {3U, 0U, 1U, 2U}) bytes += static_cast<char>(image.rgba[i + channel]);
    const std::string packed = zlib_compressed(bytes);
    const double bottom = figure_.height - placed.corner.y - placed.height;
    body_ += "<image rect=\"" + pair({placed.corner.x, bottom}) + ' ' +
             pair({placed.corner.x + placed.width, bottom + placed.height}) + "\" width=\"" +
             std::to_string(image.width) + "\" height=\"" + std::to_string(image.height) +
             "\" ColorSpace=\"DeviceRGBAlpha\" Filter=\"FlateDecode\" encoding=\"base64\" length=\"" +
             std::to_string(packed.size()) + '"';
    if (placed.opacity < 1.0) body_ += " opacity=\"" + named_opacity(placed.opacity) + '"';
    body_ += ">\n" + base64(packed) + "\n</image>\n";
  }

  void write(const Run& run, double group_opacity, double line_width) {
    std::string attributes = run.is_filled ? " fill=\"" + color(run.color) + "\" fillrule=\"wind\""
                                           : " stroke=\"" + color(run.color) + "\" pen=\"" + number(line_width) + '"';
    if (!run.is_filled) {
      const bool is_solid = run.dashes == Dashes{};
      attributes += is_solid ? " cap=\"1\" join=\"1\"" : " cap=\"0\" join=\"1\"";
      if (!is_solid)
        attributes += " dash=\"[" + pair({run.dashes.on, run.dashes.off}) + "] " + number(run.dashes.offset) + '"';
    }
    attributes += opacity(run.opacity * group_opacity);
    // Shapes that must not darken each other form one path.
    const bool is_together = run.opacity >= 1.0 && group_opacity < 1.0;
    const bool has_chains = run.opacity >= 1.0;
    const std::span<const Shape> shapes(run.shapes);
    if (is_together) body_ += "<path" + attributes + ">\n";
    for (std::size_t i = 0; i < shapes.size();) {
      if (!is_together) body_ += "<path" + attributes + ">\n";
      i += path(shapes, i, has_chains);
      if (!is_together) body_ += "</path>\n";
    }
    if (is_together) body_ += "</path>\n";
  }

  /// Writes the shape at `i`, or the chain that begins there; returns the number of shapes.
  std::size_t path(std::span<const Shape> shapes, std::size_t i, bool with_chains) {
    const Shape& shape = shapes[i];
    const auto line = [&](Vec2 p) { body_ += text(p) + " l\n"; };
    const std::string r = number(shape.radius);
    if (shape.kind == ShapeKind::disk || shape.kind == ShapeKind::circle) {
      body_ += r + " 0 0 " + r + ' ' + text(shape.p[0]) + " e\n";
      return 1;
    }
    body_ += text(shape.p[0]) + " m\n";
    switch (shape.kind) {
      case ShapeKind::disk:
      case ShapeKind::circle: return 1;
      case ShapeKind::parabola:
      case ShapeKind::segment: {
        const std::size_t count = with_chains ? chain_length(shapes, i) : 1;
        const std::span<const Shape> chain = shapes.subspan(i, count);
        const bool closed = is_loop(chain);
        for (const Shape& side : chain) {
          const bool is_last = &side == &chain.back();
          if (side.kind == ShapeKind::parabola)
            body_ += text(side.p[2]) + ' ' + text(side.p[1]) + " q\n";
          else if (!closed || !is_last)
            line(side.p[1]);
        }
        if (closed) body_ += "h\n";
        return count;
      }
      case ShapeKind::triangle:
        line(shape.p[1]);
        line(shape.p[2]);
        body_ += "h\n";
        return 1;
      case ShapeKind::arc:
        body_ += r + " 0 0 " + r + ' ' + text(shape.p[2]) + ' ' + text(shape.p[1]) + " a\n";
        return 1;
      case ShapeKind::curve:
      case ShapeKind::rim:
        body_ += text(shape.p[1]) + ' ' + text(shape.p[2]) + ' ' + text(shape.p[3]) + " c\n";
        if (shape.kind == ShapeKind::rim) {
          line(shape.p[4]);
          line(shape.p[5]);
          body_ += "h\n";
        }
        return 1;
    }
    return 1;
  }

  void legend() {
    for (const Box& box : figure_.legend.boxes)
      body_ += "<path layer=\"legend\" fill=\"" + color(box.color) + '"' + opacity(box.opacity) + ">\n" +
               rectangle(box.corner, box.width, box.height) + "</path>\n";
    if (!figure_.legend.runs.empty()) {
      body_ += "<group layer=\"legend\">\n";
      for (const Run& run : figure_.legend.runs) write(run, 1.0, 1.0);
      body_ += "</group>\n";
    }
    write(figure_.legend.texts, " layer=\"legend\"");
  }

  /// `layer`: the attribute with the layer's name, with a leading space; empty inside a group.
  void write(std::span<const Text> texts, const std::string& layer) {
    for (const TexText& each : tex_texts(texts))
      body_ += "<text" + layer + " pos=\"" + text(each.text.start) + "\" stroke=\"" + color(each.text.color) +
               "\" type=\"label\" valign=\"baseline\" size=\"" + number(kEmOfSize * each.text.size) + '"' +
               opacity(each.text.opacity) + ">\\textsf{" +
               escaped_xml(each.look.empty() ? each.content : each.look + ' ' + each.content) + "}</text>\n";
  }

  const Figure& figure_;
  std::string body_;
  std::map<std::string, std::string> opacities_;
};

}  // namespace

Expected<std::string> ipe_of(const Figure& figure) {
  std::vector<std::string> pictures;
  for (const FigureLayer& layer : figure.layers)
    if (std::ranges::any_of(layer.groups, is_flat_in_colors)) pictures.push_back(layer.id);
  if (pictures.empty()) return IpeWriter(figure).write();
  Figure drawn = figure;
  if (auto done = rasterize_layers(drawn, pictures, kDotsPerInch); !done) return std::unexpected(done.error());
  return IpeWriter(drawn).write();
}

}  // namespace mes::figure
