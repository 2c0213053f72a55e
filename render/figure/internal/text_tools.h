// SPDX-License-Identifier: GPL-3.0-or-later
// Text helpers shared by several writers.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/base64.h"
#include "core/base/color.h"
#include "render/figure/figure.h"

namespace mes::figure {

/// "#0072b2".
inline std::string hex(Rgb color) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string out = "#";
  for (const std::uint8_t channel : {color.r, color.g, color.b}) {
    out += kDigits[channel / 16U];
    out += kDigits[channel % 16U];
  }
  return out;
}

/// Escapes attributes and text of XML; drops bytes that XML forbids.
inline std::string escaped_xml(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&': out += "&amp;"; break;
      case '<': out += "&lt;"; break;
      case '>': out += "&gt;"; break;
      case '"': out += "&quot;"; break;
      default:
        if (static_cast<unsigned char>(c) >= 0x20) out += c;
    }
  }
  return out;
}

/// Escapes letters that are commands of LaTeX.
inline std::string escaped_tex(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '\\': out += "\\textbackslash{}"; break;
      case '~': out += "\\textasciitilde{}"; break;
      case '^': out += "\\textasciicircum{}"; break;
      case '&':
      case '%':
      case '$':
      case '#':
      case '_':
      case '{':
      case '}': out += '\\'; [[fallthrough]];
      default: out += c;
    }
  }
  return out;
}

/// A text as TeX should typeset it.
struct TexText {
  const Text& text;
  std::string look;  ///< commands that choose series and shape
  std::string content;
};

/// The texts for TeX. A text with its own TeX source replaces itself and all texts that continue it; the source selects
/// its own series and shape.
inline std::vector<TexText> tex_texts(std::span<const Text> texts) {
  std::vector<TexText> out;
  bool is_said = false;
  for (const Text& text : texts) {
    is_said = is_said && text.continues;
    if (is_said) continue;
    is_said = !text.latex.empty();
    if (is_said)
      out.push_back({text, {}, text.latex});
    else if (!text.text.empty())
      out.push_back({text, std::string(text.is_bold ? "\\bfseries" : "") + (text.is_italic ? "\\itshape" : ""),
                     escaped_tex(text.text)});
  }
  return out;
}

}  // namespace mes::figure
