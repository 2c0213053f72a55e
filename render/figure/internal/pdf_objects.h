// SPDX-License-Identifier: GPL-3.0-or-later
// The object structure of a PDF file.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/zlib.h"

namespace mes::figure {

/// The objects of a file, numbered from 1, and their offsets.
class PdfObjects {
 public:
  std::size_t reserve() {
    bodies_.emplace_back();
    return bodies_.size();
  }
  void set(std::size_t number, std::string body) { bodies_[number - 1] = std::move(body); }
  std::size_t add(std::string body) {
    bodies_.push_back(std::move(body));
    return bodies_.size();
  }
  /// Makes a stream; `dictionary` has no brackets.
  static std::string stream(const std::string& dictionary, std::string_view bytes) {
    return packed_stream(dictionary, zlib_compressed(bytes));
  }
  static std::string packed_stream(const std::string& dictionary, const std::string& packed) {
    return "<<" + dictionary + "/Filter/FlateDecode/Length " + std::to_string(packed.size()) + ">>\nstream\n" +
           packed + "\nendstream";
  }
  static std::string reference(std::size_t number) { return std::to_string(number) + " 0 R"; }

  std::string file(std::size_t catalog, std::size_t info) const {
    // The comment with bytes above 127 marks the file as binary.
    std::string out = "%PDF-1.5\n%\xE2\xE3\xCF\xD3\n";
    std::vector<std::size_t> offsets;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      offsets.push_back(out.size());
      out += std::to_string(i + 1) + " 0 obj\n" + bodies_[i] + "\nendobj\n";
    }
    const std::size_t table = out.size();
    out += "xref\n0 " + std::to_string(bodies_.size() + 1) + "\n0000000000 65535 f \n";
    for (const std::size_t offset : offsets) {
      const std::string digits = std::to_string(offset);
      out += std::string(10 - std::min<std::size_t>(digits.size(), 10), '0') + digits + " 00000 n \n";
    }
    out += "trailer\n<</Size " + std::to_string(bodies_.size() + 1) + "/Root " + reference(catalog) + "/Info " +
           reference(info) + ">>\nstartxref\n" + std::to_string(table) + "\n%%EOF\n";
    return out;
  }

 private:
  std::vector<std::string> bodies_;
};

/// Appends sixteen bits in the notation of PDF between angle brackets.
inline void append_hex(std::string& out, std::uint32_t value) {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  for (const unsigned shift : {12U, 8U, 4U, 0U}) out += kDigits[value >> shift & 15U];
}

/// Appends a letter in UTF-16, in the same notation.
inline void append_utf16(std::string& out, std::uint32_t letter) {
  if (letter < 0x10000U) {
    append_hex(out, letter);
    return;
  }
  append_hex(out, 0xD800U + ((letter - 0x10000U) >> 10U));
  append_hex(out, 0xDC00U + ((letter - 0x10000U) & 0x3FFU));
}

}  // namespace mes::figure
