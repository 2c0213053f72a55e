// SPDX-License-Identifier: GPL-3.0-or-later
// Orientations of Exif data, in JPEG and PNG. What each of them means is written here as the standard says it: where the
// first row and the first column of what is stored are seen.
#include <catch2/catch.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/base64.h"
#include "core/base/rng.h"
#include "core/base/zlib.h"
#include "core/raster/picture_decoder.h"
#include "tests/raster/small_jpeg.h"

using namespace mes;
using mes::test::kJpeg;
using namespace std::string_literals;

namespace {

Expected<Pixels> decoded_with_turn(const std::string& bytes, int channels = 0,
                                   PictureTurn turn = PictureTurn::upright) {
  return decode_pixels(std::as_bytes(std::span(bytes)), "a", channels, kMostPicturePixels, turn);
}

std::string ordered_number(std::uint32_t value, int bytes, bool is_little) {
  std::string out;
  for (int i = 0; i < bytes; ++i) out += static_cast<char>(value >> (8 * (is_little ? i : bytes - 1 - i)) & 0xFFU);
  return out;
}

/// A TIFF whose first directory has a maker and an orientation, and whose second, of a thumbnail, has another one.
std::string exif(std::uint32_t orientation, bool is_little, std::uint32_t type = 3, std::uint32_t count = 1) {
  const auto n = [is_little](std::uint32_t value, int bytes) { return ordered_number(value, bytes, is_little); };
  const int size = type == 3 ? 2 : type == 1 ? 1 : 4;
  const auto entry = [&](std::uint32_t tag, const std::string& value) {
    return n(tag, 2) + n(tag == 0x0112 ? type : 2, 2) + n(tag == 0x0112 ? count : 3, 4) + value +
           std::string(4 - value.size(), '\0');
  };
  const std::uint32_t next = 8 + 2 + 24 + 4;
  return (is_little ? "II*\0"s : "MM\0*"s) + n(8, 4) + n(2, 2) + entry(0x010F, "me") +
         entry(0x0112, n(orientation, size)) + n(next, 4) + n(1, 2) + entry(0x0112, n(orientation % 8 + 1, size)) +
         n(0, 4);
}

std::string segment(char marker, const std::string& contents) {
  return "\xFF"s + marker + ordered_number(static_cast<std::uint32_t>(contents.size()) + 2, 2, false) + contents;
}
std::string exif_segment(const std::string& tiff) {
  return segment('\xE1', "Exif\0\0"s + tiff);
}

std::string chunk(const std::string& name, const std::string& contents) {
  const std::string checked = name + contents;
  return ordered_number(static_cast<std::uint32_t>(contents.size()), 4, false) + checked +
         ordered_number(crc32_of(checked), 4, false);
}

/// Grey values, rows from the top, as a PNG with some chunks before its pixels and after them.
std::string png(int width, int height, const std::vector<std::uint8_t>& values, const std::string& before,
                const std::string& after = "") {
  std::string rows;
  for (int y = 0; y < height; ++y) {
    rows += '\0';
    for (int x = 0; x < width; ++x) rows += static_cast<char>(values[static_cast<std::size_t>(y * width + x)]);
  }
  const std::string header = ordered_number(static_cast<std::uint32_t>(width), 4, false) +
                             ordered_number(static_cast<std::uint32_t>(height), 4, false) + "\x08\0\0\0\0"s;
  return "\x89PNG\r\n\x1a\n"s + chunk("IHDR", header) + before + chunk("IDAT", zlib_compressed(rows)) + after +
         chunk("IEND", "");
}

/// Where something of the first row or column is seen.
enum class Side { top, bottom, left, right };
struct Orientation {
  Side row;
  Side column;
};
constexpr Orientation kOrientations[] = {
    {Side::top, Side::left}, {Side::top, Side::right}, {Side::bottom, Side::right}, {Side::bottom, Side::left},
    {Side::left, Side::top}, {Side::right, Side::top}, {Side::right, Side::bottom}, {Side::left, Side::bottom},
};

/// What a camera that was held so stores of the scene, which is `width` wide and `height` high.
struct Stored {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> values{};
};
Stored stored(const std::vector<std::uint8_t>& scene, int width, int height, int orientation) {
  const Orientation way = kOrientations[orientation - 1];
  const bool is_turned = way.row == Side::left || way.row == Side::right;
  Stored out{is_turned ? height : width, is_turned ? width : height, {}};
  for (int row = 0; row < out.height; ++row)
    for (int column = 0; column < out.width; ++column) {
      int x = 0;
      int y = 0;
      const auto put = [&](Side first, int steps) {
        if (first == Side::top) y = steps;
        if (first == Side::bottom) y = height - 1 - steps;
        if (first == Side::left) x = steps;
        if (first == Side::right) x = width - 1 - steps;
      };
      put(way.row, row);
      put(way.column, column);
      out.values.push_back(scene[static_cast<std::size_t>(y * width + x)]);
    }
  return out;
}

std::vector<std::uint8_t> scene_of(int width, int height) {
  Rng random(7);
  std::vector<std::uint8_t> out;
  for (int i = 0; i < width * height; ++i) out.push_back(static_cast<std::uint8_t>(random.below(256)));
  return out;
}

std::string jpeg_with(const std::string& segments) {
  const std::string plain = from_base64(kJpeg);
  return plain.substr(0, 2) + segments + plain.substr(2);
}

}  // namespace

TEST_CASE("a scene is the same however the camera was held") {
  for (const auto& [width, height] : {std::pair{3, 2}, {1, 5}, {1, 1}, {70, 131}}) {
    const std::vector<std::uint8_t> scene = scene_of(width, height);
    for (int orientation = 1; orientation <= 8; ++orientation)
      for (const bool is_little : {false, true}) {
        INFO(width << " x " << height << ", " << orientation << (is_little ? ", little-endian" : ""));
        const Stored held = stored(scene, width, height, orientation);
        const std::string said = chunk("eXIf", exif(static_cast<std::uint32_t>(orientation), is_little));
        for (const bool is_before : {true, false}) {
          const std::string bytes =
              png(held.width, held.height, held.values, is_before ? said : "", is_before ? "" : said);
          const auto pixels = decoded_with_turn(bytes);
          REQUIRE(pixels.has_value());
          CHECK(pixels->width == width);
          CHECK(pixels->height == height);
          CHECK(pixels->values == scene);
          const auto as_they_are = decoded_with_turn(bytes, 0, PictureTurn::as_stored);
          REQUIRE(as_they_are.has_value());
          CHECK(as_they_are->width == held.width);
          CHECK(as_they_are->values == held.values);
        }
      }
  }
}

TEST_CASE("pixels of any number of channels are turned whole") {
  const std::vector<std::uint8_t> scene = scene_of(5, 3);
  for (int channels = 1; channels <= 4; ++channels)
    for (int orientation = 1; orientation <= 8; ++orientation) {
      const Stored held = stored(scene, 5, 3, orientation);
      const auto plain = decoded_with_turn(png(5, 3, scene, ""), channels);
      const auto turned = decoded_with_turn(png(held.width, held.height, held.values,
                                                chunk("eXIf", exif(static_cast<std::uint32_t>(orientation), true))),
                                            channels);
      REQUIRE(plain.has_value());
      REQUIRE(turned.has_value());
      CHECK(turned->channels == channels);
      CHECK(turned->values == plain->values);
    }
}

TEST_CASE("a JPEG is turned as its Exif data say, wherever they stand before the picture") {
  const auto plain = decoded_with_turn(jpeg_with(""), 1);
  REQUIRE(plain.has_value());
  const std::string other = segment('\xE1', "http://ns.adobe.com/xap/1.0/\0<x/>"s) + segment('\xFE', "a comment");
  for (int orientation = 1; orientation <= 8; ++orientation)
    for (const bool is_little : {false, true}) {
      INFO(orientation);
      const std::string said = exif_segment(exif(static_cast<std::uint32_t>(orientation), is_little));
      for (const std::string& segments : {said, other + said, "\xFF\xFF"s + said.substr(1) + other}) {
        const auto held = decoded_with_turn(jpeg_with(segments), 1);
        REQUIRE(held.has_value());
        // Held so, the scene that is seen is stored as the plain picture.
        const Stored again = stored(held->values, held->width, held->height, orientation);
        CHECK(again.width == 40);
        CHECK(again.values == plain->values);
      }
    }
  // The first that says something counts, and the thumbnail's says nothing.
  const auto two = decoded_with_turn(
      jpeg_with(exif_segment("II*\0"s) + exif_segment(exif(6, true)) + exif_segment(exif(3, true))));
  REQUIRE(two.has_value());
  CHECK(two->width == 28);
  CHECK(two->height == 40);
  const std::string without_end = jpeg_with(exif_segment(exif(8, false)));
  const auto cut = decoded_with_turn(without_end.substr(0, without_end.size() - 2));
  REQUIRE(cut.has_value());
  CHECK(cut->lacks_end);
  CHECK(cut->height == 40);
}

TEST_CASE("orientations that are none, or are said in other types, are as good as they can be") {
  const auto width_with = [](const std::string& tiff) {
    const auto pixels = decoded_with_turn(jpeg_with(exif_segment(tiff)));
    return pixels ? pixels->width : 0;
  };
  for (const std::uint32_t type : {1U, 3U, 4U})
    for (const bool is_little : {false, true}) CHECK(width_with(exif(6, is_little, type)) == 28);
  for (const std::uint32_t none : {0U, 9U, 255U}) CHECK(width_with(exif(none, true)) == 40);
  CHECK(width_with(exif(6, true, 2)) == 40);
  CHECK(width_with(exif(6, true, 77)) == 40);
  CHECK(width_with(exif(6, true, 3, 0)) == 40);
  CHECK(width_with(exif(6, true, 3, 2)) == 40);
}

TEST_CASE("Exif data that are cut or broken are ignored, and nothing is read beyond them") {
  const std::string good = exif(6, true);
  for (std::size_t size = 0; size < good.size(); ++size) {
    INFO(size);
    const auto jpeg = decoded_with_turn(jpeg_with(exif_segment(good.substr(0, size))));
    REQUIRE(jpeg.has_value());
    CHECK(jpeg->width == (size >= 32 ? 28 : 40));  // the value of the second entry ends at byte 32
    REQUIRE(decoded_with_turn(png(3, 2, scene_of(3, 2), chunk("eXIf", good.substr(0, size)))).has_value());
  }
  Rng random(11);
  for (int i = 0; i < 3000; ++i) {
    std::string bytes = good;
    for (int k = 0; k < 3; ++k) bytes[random.below(bytes.size())] = static_cast<char>(random.below(256));
    REQUIRE(decoded_with_turn(jpeg_with(exif_segment(bytes))).has_value());
  }
  // A chunk that does not fit its checksum.
  std::string said = chunk("eXIf", good);
  said.back() = static_cast<char>(said.back() + 1);
  const auto pixels = decoded_with_turn(png(3, 2, scene_of(3, 2), said));
  REQUIRE(pixels.has_value());
  CHECK(pixels->width == 3);
  // A directory far away, and one that announces more entries than there are.
  CHECK(decoded_with_turn(jpeg_with(exif_segment("II*\0\xFF\xFF\xFF\xFF"s)))->width == 40);
  CHECK(decoded_with_turn(jpeg_with(exif_segment("MM\0*\0\0\0\x08\xFF\xFF"s)))->width == 40);
}
