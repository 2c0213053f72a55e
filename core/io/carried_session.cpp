// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/carried_session.h"

#include <array>
#include <cstdint>
#include <utility>

#include "core/base/base64.h"
#include "core/base/carried_session.h"
#include "core/base/zlib.h"
#include "core/io/files/read_file.h"
#include "core/io/text/text_numbers.h"

namespace mes {
namespace {

constexpr std::string_view kPngBeginning = "\x89PNG\r\n\x1a\n";
constexpr std::string_view kPdfBeginning = "%PDF-";

std::unexpected<Error> damaged(std::string text, const std::string& file) {
  return bad_input("the session that it carries cannot be read: " + std::move(text), file, 0, 0);
}

Expected<std::optional<std::string>> expanded(std::string_view stream, const std::string& file) {
  auto text = zlib_expanded(stream, kMostCarriedBytes);
  if (!text) return damaged(text.error().text, file);
  return std::move(*text);
}

std::uint32_t big_endian(std::string_view bytes) {
  std::uint32_t out = 0;
  for (const char byte : bytes.substr(0, 4)) out = out << 8U | static_cast<std::uint8_t>(byte);
  return out;
}

/// Source: PNG (ISO/IEC 15948), 5.3 and 11.3.4.5. Checksums are not verified: viewers do that.
Expected<std::optional<std::string>> in_png(std::string_view bytes, const std::string& file) {
  constexpr std::size_t kFrame = 12;  // length, kind and checksum
  for (std::size_t at = kPngBeginning.size(); at + kFrame <= bytes.size();) {
    const std::size_t length = big_endian(bytes.substr(at));
    const std::string_view kind = bytes.substr(at + 4, 4);
    const std::string_view rest = bytes.substr(at + 8);
    const bool is_ours =
        kind == "iTXt" && rest.starts_with(kCarriedSession) && rest.substr(kCarriedSession.size()).starts_with('\0');
    if (is_ours) {
      if (length > rest.size()) return damaged("the file is cut", file);
      std::string_view body = rest.substr(0, length);
      // Keyword, zero, compression flag, compression method, language, zero, translated keyword, zero.
      body.remove_prefix(kCarriedSession.size() + 1);
      if (body.size() < 4 || body[0] != 1 || body[1] != 0)
        return damaged("it is not compressed as it should be", file);
      body.remove_prefix(2);
      for (int names = 0; names < 2; ++names) {
        const std::size_t end = body.find('\0');
        if (end == std::string_view::npos) return damaged("the file is cut", file);
        body.remove_prefix(end + 1);
      }
      return expanded(body, file);
    }
    if (kind == "IEND" || length > rest.size()) break;
    at += kFrame + length;
  }
  return std::nullopt;
}

/// The content of an element, or the value of an attribute. The same name inside a text would lack the bracket or the
/// quotation mark, so it cannot match.
Expected<std::optional<std::string>> in_xml(std::string_view bytes, const std::string& file) {
  struct Place {
    char before, begin, end;
    std::size_t at = std::string_view::npos;
  };
  std::array<Place, 2> places{{{'<', '>', '<'}, {'"', ':', '"'}}};
  // Searches in chunks that fit a near cache, because most drawings carry no session.
  constexpr std::size_t kPart = std::size_t{1} << 16U;
  for (std::size_t begin = 0; begin < bytes.size() && places[0].at == std::string_view::npos; begin += kPart)
    for (Place& place : places) {
      if (place.at != std::string_view::npos) continue;
      const std::string_view part = bytes.substr(begin, kPart + kCarriedSession.size());
      if (const std::size_t at = part.find(place.before + std::string(kCarriedSession)); at != part.npos)
        place.at = begin + at;
    }
  for (const Place place : places) {
    const std::size_t at = place.at;
    if (at == std::string_view::npos) continue;
    const std::size_t begin = bytes.find(place.begin, at);
    const std::size_t end = begin == std::string_view::npos ? begin : bytes.find(place.end, begin + 1);
    if (end == std::string_view::npos) return damaged("the file is cut", file);
    return expanded(from_base64(bytes.substr(begin + 1, end - begin - 1)), file);
  }
  return std::nullopt;
}

/// Source: PDF 32000-1:2008, 7.3.8.
Expected<std::optional<std::string>> in_pdf(std::string_view bytes, const std::string& file) {
  const std::size_t at = bytes.find("/" + std::string(kCarriedSession) + " true");
  if (at == std::string_view::npos) return std::nullopt;
  constexpr std::string_view kStream = ">>\nstream\n";
  const std::size_t begin = bytes.find(kStream, at);
  if (begin == std::string_view::npos) return damaged("the file is cut", file);
  return expanded(bytes.substr(begin + kStream.size()), file);
}

/// The value of a key. Inside a text its quotation marks would be escaped, so the search cannot match there.
Expected<std::optional<std::string>> in_manifest(std::string_view bytes, const std::string& file) {
  const std::string key = '"' + std::string(kCarriedSession) + '"';
  const std::size_t at = bytes.find(key);
  if (at == std::string_view::npos) return std::nullopt;
  const std::size_t begin = bytes.find('"', at + key.size());
  const std::size_t end = begin == std::string_view::npos ? begin : bytes.find('"', begin + 1);
  if (end == std::string_view::npos) return damaged("the file is cut", file);
  return expanded(from_base64(bytes.substr(begin + 1, end - begin - 1)), file);
}

bool is_xml(std::string_view bytes) {
  bytes = without_bom(bytes);
  const std::size_t at = bytes.find_first_not_of(" \t\r\n");
  return at != std::string_view::npos && bytes[at] == '<';
}

}  // namespace

bool looks_like_manifest(std::string_view bytes) {
  return bytes.starts_with(kManifestBeginning);
}

bool may_carry_session(std::string_view bytes) {
  return bytes.starts_with(kPngBeginning) || bytes.starts_with(kPdfBeginning) || is_xml(bytes) ||
         looks_like_manifest(bytes);
}

bool is_picture_with_session(const std::filesystem::path& file) {
  constexpr std::size_t kBeginning = 4096;
  const auto bytes = read_regular_file(file, {.is_enough = [](std::string_view read) {
                                         return read.size() >= kBeginning ||
                                                !kPngBeginning.starts_with(read.substr(0, kPngBeginning.size()));
                                       }});
  if (!bytes || !bytes->starts_with(kPngBeginning)) return false;
  return bytes->find("iTXt" + std::string(kCarriedSession) + '\0') != std::string::npos;
}

Expected<std::optional<std::string>> carried_session(std::string_view bytes, const std::string& file) {
  if (bytes.starts_with(kPngBeginning)) return in_png(bytes, file);
  if (bytes.starts_with(kPdfBeginning)) return in_pdf(bytes, file);
  if (is_xml(bytes)) return in_xml(bytes, file);
  if (looks_like_manifest(bytes)) return in_manifest(bytes, file);
  return std::nullopt;
}

}  // namespace mes
