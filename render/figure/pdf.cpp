// SPDX-License-Identifier: GPL-3.0-or-later
// Portable Document Format 1.5, ISO 32000-1:2008: layers as optional content groups (8.11), translucent groups as
// transparency group XObjects (11.6.6), an outline (12.3.3), streams compressed.
//
// A custom writer, because the usual PDF library has no optional content.
#include <algorithm>
#include <iterator>
#include <list>
#include <map>
#include <memory>
#include <new>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/base/carried_session.h"
#include "render/figure/internal/bezier_arcs.h"
#include "render/figure/internal/chains.h"
#include "render/figure/internal/grid.h"
#include "render/figure/internal/pdf_fonts.h"
#include "render/figure/internal/pdf_objects.h"
#include "render/figure/pdf_book.h"
#include "render/figure/writers.h"

namespace mes::figure {
namespace {

constexpr int kSheetDecimals = 3;

/// A PDF string in UTF-16, so that any title is possible.
std::string text_string(std::string_view utf8) {
  std::string out = "<FEFF";
  for (std::size_t i = 0; i < utf8.size();) {
    const auto first = static_cast<unsigned char>(utf8[i++]);
    std::uint32_t code = first;
    int more = 0;
    if (first >= 0xF0) {
      code = first & 7U;
      more = 3;
    } else if (first >= 0xE0) {
      code = first & 15U;
      more = 2;
    } else if (first >= 0xC0) {
      code = first & 31U;
      more = 1;
    }
    for (; more > 0 && i < utf8.size(); --more) code = code << 6U | (static_cast<unsigned char>(utf8[i++]) & 63U);
    append_utf16(out, code);
  }
  return out + '>';
}

}  // namespace

class PdfBook::Writer {
 public:
  explicit Writer(BookInfo info) : info_(std::move(info)), fonts_(info_.fonts) {
    for (std::size_t* const number : {&catalog_, &pages_, &resources_}) *number = objects_.reserve();
  }

  void add(const Sheet& sheet) {
    // Lengths of the page have the decimals of its first figure.
    decimals_ = sheet.figures.empty() ? kSheetDecimals : sheet.figures.front().figure->decimals;
    std::string content = "1 0 0 -1 0 ";
    decimal(content, sheet.height);
    content += " cm\n1 J 1 j\n";
    background(sheet.background, sheet.width, sheet.height, content);
    std::string box;
    point(box, {sheet.width, sheet.height});
    for (const PlacedFigure& placed : sheet.figures) {
      decimals_ = placed.figure->decimals;
      const bool fills =
          placed.corner == Vec2{} && placed.figure->width == sheet.width && placed.figure->height == sheet.height;
      if (!fills) {
        content += "q\n1 0 0 1 ";
        point(content, placed.corner);
        content += "cm\n";
        rectangle(content, {}, placed.figure->width, placed.figure->height);
        content += "W n\n";
      }
      write(*placed.figure, content);
      if (!fills) content += "Q\n";
    }
    const std::size_t stream = objects_.add(PdfObjects::stream("", content));
    const std::size_t page =
        objects_.add("<</Type/Page/Parent " + PdfObjects::reference(pages_) + "/MediaBox[0 0 " + box +
                     "]/Group<</S/Transparency/CS/DeviceRGB>>/Resources " + PdfObjects::reference(resources_) +
                     "/Contents " + PdfObjects::reference(stream) + ">>");
    page_numbers_.push_back(page);
    if (!sheet.bookmark.empty()) bookmarks_.emplace_back(sheet.bookmark, page);
  }

  std::string file() {
    finish();
    std::string info = "<</Producer(Mesecina)";
    if (!info_.title.empty()) info += "/Title" + text_string(info_.title);
    return objects_.file(catalog_, objects_.add(info + ">>"));
  }

 private:
  void decimal(std::string& out, double value) const { append_decimal(out, value, decimals_); }
  void point(std::string& out, Vec2 p) const {
    decimal(out, p.x);
    out += ' ';
    decimal(out, p.y);
    out += ' ';
  }
  void rectangle(std::string& out, Vec2 corner, double width, double height) const {
    point(out, corner);
    point(out, {width, height});
    out += "re\n";
  }
  static void paint(std::string& out, Rgb color, bool is_fill) {
    for (const std::uint8_t channel : {color.r, color.g, color.b}) {
      append_decimal(out, channel / 255.0, kColorDecimals);
      out += ' ';
    }
    out += is_fill ? "rg\n" : "RG\n";
  }
  /// Sets the opacity of the following content.
  void opacity(std::string& out, double value) {
    std::string text;
    append_decimal(text, value, kColorDecimals);
    const auto [found, is_new] = states_.try_emplace(text, "G" + std::to_string(states_.size()));
    out += '/' + found->second + " gs\n";
  }

  void background(const std::optional<Rgb>& color, double width, double height, std::string& content) {
    if (!color) return;
    paint(content, *color, true);
    rectangle(content, {}, width, height);
    content += "f\n";
  }

  void write(const Figure& figure, std::string& content) {
    background(figure.background, figure.width, figure.height, content);
    page_ = {figure.width, figure.height};
    auto above = order_.begin();
    for (const FigureLayer& layer : figure.layers) write(layer, above, content);
    legend(figure.legend, content);
  }

  /// Index in `ocgs_` of the layer's group. `above` is the position in the stacking order above the previous layer; it
  /// moves above this one.
  std::size_t group_of(const FigureLayer& layer, std::list<std::size_t>::iterator& above) {
    const auto [found, is_new] = groups_.try_emplace(layer.id);
    if (is_new) {
      const std::size_t group = objects_.add("<</Type/OCG/Name" + text_string(layer.title) +
                                             "/Usage<</CreatorInfo<</Creator(Mesecina)" + "/Subtype/Artwork>>>>>>");
      found->second = {ocgs_.size(), order_.insert(above, group)};
      ocgs_.push_back(group);
    }
    above = std::next(found->second.in_order);
    return found->second.index;
  }

  void write(const FigureLayer& layer, std::list<std::size_t>::iterator& above, std::string& content) {
    content += "/OC/L" + std::to_string(group_of(layer, above)) + " BDC\nq\n";
    if (layer.clip) {
      rectangle(content, layer.clip->corner, layer.clip->width, layer.clip->height);
      content += "W n\n";
    }
    decimal(content, layer.line_width);
    content += " w\n";
    if (layer.image) image(*layer.image, content);
    for (const Group& each : layer.groups) {
      if (each.opacity >= 1.0) {
        for (const Run& run : each.runs) write(run, content);
        continue;
      }
      std::string inside;
      decimal(inside, layer.line_width);
      inside += " w 1 J 1 j\n";
      for (const Run& run : each.runs) write(run, inside);
      content += "q\n";
      opacity(content, each.opacity);
      content += '/' + form(inside) + " Do\nQ\n";
    }
    for (const Text& text : layer.texts) write(text, content);
    content += "Q\nEMC\n";
  }

  /// A form with content that is painted as a whole before it is blended onto the page.
  std::string form(const std::string& inside) {
    std::string box;
    point(box, page_);
    const std::size_t number = objects_.add(PdfObjects::stream("/Type/XObject/Subtype/Form/BBox[0 0 " + box +
                                                                   "]/Group<</S/Transparency/I true>>/Resources " +
                                                                   PdfObjects::reference(resources_),
                                                               inside));
    return external(number);
  }
  std::string external(std::size_t number) {
    externals_.push_back(number);
    return "X" + std::to_string(externals_.size() - 1);
  }

  void image(const PlacedImage& placed, std::string& content) {
    const render::Image& image = placed.image;
    std::string colors;
    std::string alphas;
    bool is_opaque = true;
    for (std::size_t i = 0; i + 3 < image.rgba.size(); i += 4) {
      for (std::size_t channel = i; channel < i + 3; ++channel) colors += static_cast<char>(image.rgba[channel]);
      alphas += static_cast<char>(image.rgba[i + 3]);
      is_opaque = is_opaque && image.rgba[i + 3] == 255;
    }
    const std::string size = "/Type/XObject/Subtype/Image/Width " + std::to_string(image.width) + "/Height " +
                             std::to_string(image.height) + "/BitsPerComponent 8/Interpolate true";
    std::string mask;
    if (!is_opaque)
      mask = "/SMask " +
             PdfObjects::reference(objects_.add(PdfObjects::stream(size + "/ColorSpace/DeviceGray", alphas)));
    const std::string name =
        external(objects_.add(PdfObjects::stream(size + "/ColorSpace/DeviceRGB" + mask, colors)));
    content += "q\n";
    opacity(content, placed.opacity);
    decimal(content, placed.width);
    content += " 0 0 ";
    decimal(content, -placed.height);
    content += ' ';
    point(content, placed.corner + Vec2{0.0, placed.height});
    content += "cm /" + name + " Do\nQ\n";
  }

  void write(const Run& run, std::string& content) {
    const bool needs_state = run.opacity < 1.0 || run.dashes != Dashes{};
    if (needs_state) content += "q\n";
    if (run.opacity < 1.0) opacity(content, run.opacity);
    if (run.dashes != Dashes{}) {
      content += "0 J [";
      point(content, {run.dashes.on, run.dashes.off});
      content += "] ";
      decimal(content, run.dashes.offset);
      content += " d\n";
    }
    paint(content, run.color, run.is_filled);
    // If overlaps are invisible, one stroke or fill serves all; disks stay separate, so that they can be edited.
    const bool is_one_path = run.opacity >= 1.0;
    const char* const ending = run.is_filled ? "f\n" : "S\n";
    const std::span<const Shape> shapes(run.shapes);
    bool is_open = false;
    for (std::size_t i = 0; i < shapes.size();) {
      const bool is_disk = shapes[i].kind == ShapeKind::disk;
      i += path(shapes, i, is_one_path, content);
      is_open = is_one_path && !is_disk;
      if (!is_open) content += ending;
    }
    if (is_open) content += ending;
    if (needs_state) content += "Q\n";
  }

  void curve(const Bezier& bezier, std::string& out) const {
    point(out, bezier.first_handle);
    point(out, bezier.second_handle);
    point(out, bezier.end);
    out += "c\n";
  }

  /// Writes the shape at `i`, or the chain that begins there; returns the number of shapes.
  std::size_t path(std::span<const Shape> shapes, std::size_t i, bool with_chains, std::string& out) const {
    const Shape& shape = shapes[i];
    const auto move = [&](Vec2 p) {
      point(out, p);
      out += "m\n";
    };
    const auto line = [&](Vec2 p) {
      point(out, p);
      out += "l\n";
    };
    switch (shape.kind) {
      case ShapeKind::disk:
      case ShapeKind::circle:
        move(shape.p[0] + Vec2{shape.radius, 0.0});
        for (const Bezier& bezier : circle_curves(shape, decimals_)) curve(bezier, out);
        out += "h\n";
        return 1;
      case ShapeKind::parabola:
      case ShapeKind::segment: {
        const std::size_t count = with_chains ? chain_length(shapes, i) : 1;
        const std::span<const Shape> chain = shapes.subspan(i, count);
        move(shape.p[0]);
        for (const Shape& side : chain) {
          if (side.kind == ShapeKind::segment)
            line(side.p[1]);
          else
            curve(parabola_curve(side), out);
        }
        if (is_loop(chain)) out += "h\n";
        return count;
      }
      case ShapeKind::triangle:
        move(shape.p[0]);
        line(shape.p[1]);
        line(shape.p[2]);
        out += "h\n";
        return 1;
      case ShapeKind::arc:
        move(shape.p[0]);
        for (const Bezier& bezier : arc_curves(shape, decimals_)) curve(bezier, out);
        return 1;
      case ShapeKind::curve:
      case ShapeKind::rim:
        move(shape.p[0]);
        curve({shape.p[1], shape.p[2], shape.p[3]}, out);
        if (shape.kind == ShapeKind::rim) {
          line(shape.p[4]);
          line(shape.p[5]);
          out += "h\n";
        }
        return 1;
    }
    return 1;
  }

  void legend(const Legend& legend, std::string& content) {
    for (const Box& box : legend.boxes) {
      content += "q\n";
      if (box.opacity < 1.0) opacity(content, box.opacity);
      paint(content, box.color, true);
      rectangle(content, box.corner, box.width, box.height);
      content += "f\nQ\n";
    }
    for (const Run& run : legend.runs) write(run, content);
    for (const Text& text : legend.texts) write(text, content);
  }

  void write(const Text& text, std::string& content) {
    if (text.text.empty()) return;
    if (text.opacity < 1.0) {
      content += "q\n";
      opacity(content, text.opacity);
    }
    paint(content, text.color, true);
    content += "BT 1 0 0 -1 ";
    point(content, text.start);
    content += "Tm " + fonts_.shown(text) + "ET\n";
    if (text.opacity < 1.0) content += "Q\n";
  }

  void finish() {
    std::string groups;
    std::string properties;
    for (std::size_t i = 0; i < ocgs_.size(); ++i) {
      groups += PdfObjects::reference(ocgs_[i]) + ' ';
      properties += "/L" + std::to_string(i) + ' ' + PdfObjects::reference(ocgs_[i]);
    }
    // Viewers list them in this order: the topmost first.
    std::string order;
    for (auto group = order_.rbegin(); group != order_.rend(); ++group) order += PdfObjects::reference(*group) + ' ';
    std::string externals;
    for (std::size_t i = 0; i < externals_.size(); ++i)
      externals += "/X" + std::to_string(i) + ' ' + PdfObjects::reference(externals_[i]);
    std::string states;
    for (const auto& [value, name] : states_) states += '/' + name + "<</ca " + value + "/CA " + value + ">>";
    const std::string fonts = fonts_.resources(objects_);
    objects_.set(resources_, "<</ExtGState<<" + states + ">>/XObject<<" + externals + ">>/Properties<<" + properties +
                                 ">>" + fonts + ">>");
    std::string kids;
    for (const std::size_t page : page_numbers_) kids += (kids.empty() ? "" : " ") + PdfObjects::reference(page);
    objects_.set(pages_, "<</Type/Pages/Count " + std::to_string(page_numbers_.size()) + "/Kids[" + kids + "]>>");
    const std::string listed = page_numbers_.size() > 1 ? "/ListMode/VisiblePages" : "";
    objects_.set(catalog_, "<</Type/Catalog/Pages " + PdfObjects::reference(pages_) + "/OCProperties<</OCGs[" +
                               groups + "]/D<</Order[" + order + "]/ON[" + groups + "]" + listed + ">>>>" +
                               outline() + attachment() + ">>");
  }

  /// Catalogue entry with the bookmarks.
  std::string outline() {
    if (bookmarks_.empty()) return {};
    const std::size_t root = objects_.reserve();
    std::vector<std::size_t> items;
    for (std::size_t i = 0; i < bookmarks_.size(); ++i) items.push_back(objects_.reserve());
    for (std::size_t i = 0; i < items.size(); ++i) {
      const auto& [title, page] = bookmarks_[i];
      std::string item = "<</Title" + text_string(title) + "/Parent " + PdfObjects::reference(root) + "/Dest[" +
                         PdfObjects::reference(page) + "/Fit]";
      if (i > 0) item += "/Prev " + PdfObjects::reference(items[i - 1]);
      if (i + 1 < items.size()) item += "/Next " + PdfObjects::reference(items[i + 1]);
      objects_.set(items[i], item + ">>");
    }
    objects_.set(root, "<</Type/Outlines/Count " + std::to_string(items.size()) + "/First " +
                           PdfObjects::reference(items.front()) + "/Last " + PdfObjects::reference(items.back()) +
                           ">>");
    return "/Outlines " + PdfObjects::reference(root);
  }

  /// Catalogue entry with the session, as a file that viewers list and save.
  std::string attachment() {
    if (info_.session.empty()) return {};
    const std::string key(kCarriedSession);
    const std::string name = '(' + key + ".json)";
    const std::size_t stream = objects_.add(
        PdfObjects::packed_stream("/Type/EmbeddedFile/Subtype/application#2Fjson/" + key + " true", info_.session));
    const std::size_t file = objects_.add("<</Type/Filespec/F" + name + "/UF" + name + "/EF<</F " +
                                          PdfObjects::reference(stream) + ">>>>");
    return "/Names<</EmbeddedFiles<</Names[" + name + PdfObjects::reference(file) + "]>>>>";
  }

  /// An optional content group.
  struct LayerGroup {
    std::size_t index = 0;  // index in `ocgs_`
    std::list<std::size_t>::iterator in_order{};
  };

  BookInfo info_;
  PdfObjects objects_;
  std::size_t catalog_ = 0;
  std::size_t pages_ = 0;
  std::size_t resources_ = 0;
  std::vector<std::size_t> page_numbers_;
  std::vector<std::pair<std::string, std::size_t>> bookmarks_;  // titles and pages
  std::vector<std::size_t> ocgs_;
  std::list<std::size_t> order_;              // the same in stacking order, bottom first
  std::map<std::string, LayerGroup> groups_;  // by layer id
  std::vector<std::size_t> externals_;
  std::map<std::string, std::string> states_;  // opacity to name
  PdfFonts fonts_;
  // State of the figure that is being written.
  int decimals_ = kSheetDecimals;
  Vec2 page_;
};

PdfBook::PdfBook(BookInfo info) : writer_(std::make_unique<Writer>(std::move(info))) {}
PdfBook::~PdfBook() = default;
PdfBook::PdfBook(PdfBook&& other) noexcept = default;
PdfBook& PdfBook::operator=(PdfBook&& other) noexcept = default;

void PdfBook::add(const Sheet& sheet) {
  writer_->add(sheet);
}

std::string PdfBook::file() && {
  return writer_->file();
}

Expected<std::string> pdf_of(const Figure& figure) {
  PdfBook book({.title = {}, .fonts = figure.fonts, .session = figure.session});
  book.add(
      {.width = figure.width, .height = figure.height, .background = {}, .figures = {{&figure, {}}}, .bookmark = {}});
  return std::move(book).file();
}

}  // namespace mes::figure
