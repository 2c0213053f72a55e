// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/figure/internal/pdf_fonts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "render/figure/internal/grid.h"

namespace mes::figure {
namespace {

// PDF uses thousandths of the em square of a font.
constexpr double kThousandths = 1000.0;
constexpr int kDecimals = 2;
constexpr char32_t kNoLetter = 0xFFFD;

using Bytes = std::span<const unsigned char>;

/// A big-endian number; 0 if the bytes end before it.
std::size_t number_at(Bytes bytes, std::size_t at, std::size_t size) {
  if (at > bytes.size() || size > bytes.size() - at) return 0;
  std::size_t out = 0;
  for (const unsigned char byte : bytes.subspan(at, size)) out = out << 8U | byte;
  return out;
}

int signed_at(Bytes bytes, std::size_t at) {
  return static_cast<std::int16_t>(number_at(bytes, at, 2));
}

/// A sequence of data of varying lengths: "INDEX" of the Compact Font Format (Adobe Technical Note 5176).
struct CffIndex {
  std::vector<std::size_t> starts;  ///< start of each, and the end of the last one
  std::size_t end = 0;              ///< end of the whole index

  CffIndex(Bytes cff, std::size_t at) : end(at + 2) {
    const std::size_t count = number_at(cff, at, 2);
    if (count == 0) return;
    const std::size_t size = number_at(cff, at + 2, 1);
    const std::size_t before = at + 2 + (count + 1) * size;  // offsets count from 1
    for (std::size_t i = 0; i <= count; ++i)
      starts.push_back(std::min(before + number_at(cff, at + 3 + i * size, size), cff.size()));
    end = starts.back();
  }
  bool is_empty() const { return starts.empty(); }
};

/// Offset of the glyphs according to the table; 0 if it has none.
std::size_t glyphs_of_cff(Bytes cff, std::size_t dictionary, std::size_t end) {
  constexpr std::size_t kGlyphs = 17;
  std::size_t operand = 0;
  for (std::size_t at = dictionary; at < end && at < cff.size();) {
    const unsigned char first = cff[at++];
    if (first == kGlyphs) return operand;
    if (first == 12) {
      ++at;
    } else if (first == 28 || first == 29) {
      const std::size_t size = first == 28 ? 2 : 4;
      operand = number_at(cff, at, size);
      at += size;
    } else if (first == 30) {
      // Decimal digits, two a byte, up to a digit 15.
      while (at < end && at < cff.size() && (cff[at] & 15U) != 15U && cff[at] >> 4U != 15U) ++at;
      ++at;
    } else if (first >= 247 && first <= 254) {
      operand = (first - std::size_t{247}) * 256 + number_at(cff, at, 1) + 108;
      ++at;
    } else if (first >= 32) {
      operand = first - 139U;
    }
  }
  return 0;
}

/// The table of outlines reduced to the used glyphs: every byte of an unused one becomes a command that ends a glyph.
/// This keeps all offsets, and compression makes it short.
struct ReducedCff {
  std::string name;
  std::string bytes;
};
ReducedCff reduced(Bytes cff, const UsedGlyphs& used) {
  constexpr char kEndOfGlyph = 14;
  const CffIndex names(cff, number_at(cff, 2, 1));
  const CffIndex dictionaries(cff, names.end);
  ReducedCff out{{}, std::string(cff.begin(), cff.end())};
  if (names.is_empty() || dictionaries.is_empty()) return out;
  out.name = out.bytes.substr(names.starts[0], names.starts[1] - names.starts[0]);
  const std::size_t at = glyphs_of_cff(cff, dictionaries.starts[0], dictionaries.starts[1]);
  if (at == 0) return out;
  const CffIndex glyphs(cff, at);
  for (std::size_t i = 1; i + 1 < glyphs.starts.size(); ++i) {
    if (used.contains(static_cast<int>(i)) || glyphs.starts[i] >= glyphs.starts[i + 1]) continue;
    std::fill(out.bytes.begin() + static_cast<std::ptrdiff_t>(glyphs.starts[i]),
              out.bytes.begin() + static_cast<std::ptrdiff_t>(glyphs.starts[i + 1]), kEndOfGlyph);
  }
  return out;
}

/// Six letters that identify the subset of a font (ISO 32000-1, 9.6.4).
std::string part_tag(const UsedGlyphs& used) {
  std::uint32_t hash = 2166136261U;  // Fowler, Noll and Vo
  for (const auto& [index, glyph] : used)
    for (const unsigned shift : {0U, 8U})
      hash = (hash ^ (static_cast<std::uint32_t>(index) >> shift & 255U)) * 16777619U;
  std::string out;
  for (int i = 0; i < 6; ++i, hash /= 26U) out += static_cast<char>('A' + hash % 26U);
  return out;
}

/// The letters of the codes, so that text can be searched and copied.
std::string letters_of_codes(const UsedGlyphs& used) {
  constexpr std::size_t kMostInABlock = 100;
  std::string out =
      "/CIDInit /ProcSet findresource begin\n12 dict begin\nbegincmap\n"
      "/CIDSystemInfo <</Registry(Adobe)/Ordering(UCS)/Supplement 0>> def\n"
      "/CMapName /Adobe-Identity-UCS def\n/CMapType 2 def\n"
      "1 begincodespacerange\n<0000> <FFFF>\nendcodespacerange\n";
  std::size_t left = used.size();
  std::size_t in_block = 0;
  for (const auto& [index, glyph] : used) {
    if (in_block == 0) {
      in_block = std::min(left, kMostInABlock);
      out += std::to_string(in_block) + " beginbfchar\n";
    }
    out += '<';
    append_hex(out, static_cast<std::uint32_t>(index));
    out += "> <";
    append_utf16(out, glyph.letter);
    out += ">\n";
    --left;
    if (--in_block == 0) out += "endbfchar\n";
  }
  return out + "endcmap\nCMapName currentdict /CMap defineresource pop\nend\nend\n";
}

bool is_carried(const render::Font& font) {
  return !font.table("CFF ").empty();
}

/// Adds a font and returns its object number.
std::size_t add_font(PdfObjects& objects, const render::Font& font, const UsedGlyphs& used) {
  const double unit = kThousandths / font.units_per_em();
  const auto number = [](double value) {
    std::string out;
    append_decimal(out, value, kDecimals);
    return out;
  };
  const ReducedCff outlines = reduced(font.table("CFF "), used);
  const std::string name = part_tag(used) + '+' + outlines.name;
  const std::size_t file = objects.add(PdfObjects::stream("/Subtype/CIDFontType0C", outlines.bytes));

  // OpenType specification: tables "head", "hhea", "post" and "OS/2".
  const Bytes head = font.table("head");
  const Bytes hhea = font.table("hhea");
  const Bytes os2 = font.table("OS/2");
  std::string box;
  for (const std::size_t at : {36U, 38U, 40U, 42U}) box += number(unit * signed_at(head, at)) + ' ';
  const double angle =
      signed_at(font.table("post"), 4) + static_cast<double>(number_at(font.table("post"), 6, 2)) / 65536.0;
  constexpr int kSymbolic = 4;
  constexpr int kItalic = 64;
  // Fonts do not specify their stem width; it grows with the weight.
  constexpr double kStemOfWeight = 0.2;
  const double stem = kStemOfWeight * static_cast<double>(number_at(os2, 4, 2));
  const std::size_t descriptor =
      objects.add("<</Type/FontDescriptor/FontName/" + name + "/Flags " +
                  std::to_string(kSymbolic + (angle != 0.0 ? kItalic : 0)) + "/FontBBox[" + box + "]/ItalicAngle " +
                  number(angle) + "/Ascent " + number(unit * signed_at(hhea, 4)) + "/Descent " +
                  number(unit * signed_at(hhea, 6)) + "/CapHeight " + number(unit * signed_at(os2, 88)) + "/StemV " +
                  number(stem) + "/FontFile3 " + PdfObjects::reference(file) + ">>");

  std::string widths;
  for (const auto& [index, glyph] : used) widths += std::to_string(index) + '[' + number(unit * glyph.advance) + ']';
  const std::size_t glyphs =
      objects.add("<</Type/Font/Subtype/CIDFontType0/BaseFont/" + name +
                  "/CIDSystemInfo<</Registry(Adobe)/Ordering(Identity)/Supplement 0>>/FontDescriptor " +
                  PdfObjects::reference(descriptor) + "/W[" + widths + "]>>");
  const std::size_t letters = objects.add(PdfObjects::stream("", letters_of_codes(used)));
  return objects.add("<</Type/Font/Subtype/Type0/BaseFont/" + name + "/Encoding/Identity-H/DescendantFonts[" +
                     PdfObjects::reference(glyphs) + "]/ToUnicode " + PdfObjects::reference(letters) + ">>");
}

/// A string in the encoding of Helvetica; letters beyond ASCII become question marks.
std::string ascii_string(std::string_view utf8) {
  std::string out = "(";
  for (const char c : utf8) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x80 && byte < 0xC0) continue;  // a continuation byte
    if (c == '(' || c == ')' || c == '\\') out += '\\';
    out += byte >= 0x20 && byte < 0x7F ? c : '?';
  }
  return out + ')';
}

std::string resource(const render::Font* font, const Fonts& fonts) {
  return font == &fonts.plain ? "T0" : font == &fonts.bold ? "T1" : "T2";
}

std::string chosen(const std::string& name, double em) {
  std::string out = '/' + name + ' ';
  append_decimal(out, em, kDecimals + 2);
  return out + " Tf ";
}

constexpr const char* kLooks[] = {"", "-Bold", "-Oblique", "-BoldOblique"};

}  // namespace

std::string PdfFonts::shown(const Text& text) {
  const render::Font* const font = fonts_ ? &fonts_->of(text.is_bold, text.is_italic) : nullptr;
  if (font == nullptr || !is_carried(*font)) {
    const int look = (text.is_bold ? 1 : 0) + (text.is_italic ? 2 : 0);
    named_.insert(look);
    return chosen("F" + std::to_string(look), kEmOfSize * text.size) + ascii_string(text.text) + " Tj ";
  }
  UsedGlyphs& used = used_[font];
  const double unit = kThousandths / font->units_per_em();
  std::string codes = "[<";
  int end = 0;
  for (const render::Glyph& glyph : font->glyphs(text.text)) {
    const bool is_letter = glyph.index != 0 && glyph.letter < 0x110000U && glyph.letter >> 11U != 0x1BU;
    used.try_emplace(glyph.index, UsedGlyph{is_letter ? glyph.letter : kNoLetter, glyph.advance});
    if (glyph.x != end) {
      codes += '>';
      append_decimal(codes, unit * (end - glyph.x), kDecimals);
      codes += '<';
    }
    append_hex(codes, static_cast<std::uint32_t>(glyph.index));
    end = glyph.x + glyph.advance;
  }
  return chosen(resource(font, *fonts_), text.size * font->units_per_em() / font->units_per_size()) + codes +
         ">] TJ ";
}

std::string PdfFonts::resources(PdfObjects& objects) const {
  std::string out;
  for (const auto& [font, used] : used_)
    out += '/' + resource(font, *fonts_) + ' ' + PdfObjects::reference(add_font(objects, *font, used));
  for (const int look : named_)
    out += "/F" + std::to_string(look) + "<</Type/Font/Subtype/Type1/BaseFont/Helvetica" + kLooks[look] +
           "/Encoding/WinAnsiEncoding>>";
  return out.empty() ? out : "/Font<<" + out + ">>";
}

}  // namespace mes::figure
