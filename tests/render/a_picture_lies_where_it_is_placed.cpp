// SPDX-License-Identifier: GPL-3.0-or-later
// The picture to trace: read from any bytes, and drawn where doubles say.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <cstring>
#include <fstream>

#include "core/base/rng.h"
#include "core/base/zlib.h"
#include "render/device/recording_device.h"
#include "render/image/picture_file.h"
#include "render/image/png.h"
#include "tests/render/drawing.h"
#include "tests/render/images.h"

using namespace mes;
using namespace mes::test;
using render::Image;
using render::LayerView;

namespace {

/// Left half black, right half white, the upper left quarter red.
Image three_fields(int width, int height) {
  Image image{width, height, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const bool is_right = 2 * x >= width;
      const bool is_upper = 2 * y < height;
      const std::uint8_t other = is_right ? 255 : 0;
      image.rgba.insert(image.rgba.end(),
                        {is_right || is_upper ? std::uint8_t{255} : std::uint8_t{0}, other, other, 255});
    }
  }
  return image;
}

constexpr Rgb kRed{255, 0, 0};
constexpr Rgb kBlack{0, 0, 0};

}  // namespace

TEST_CASE("a picture covers exactly its place, upright, below the other layers") {
  Drawing drawing;
  drawing.scene().set_picture(3, three_fields(64, 32));
  drawing.scene().place_picture({{50.0, 30.0}, 60.0});
  drawing.set(1, PrimitiveKind::disk, {40, 25, 4});
  LayerStyle style;
  const std::vector<LayerView> views{{3, style}, {1, {.color = palette::green}}};
  const Image image = drawing.draw(pixel_camera(100, 60), views, {.background = palette::blue});
  // From x = 20 to 80 and y = 15 to 45, counted from below.
  CHECK(pixel(image, 19, 30) == palette::blue);
  CHECK(pixel(image, 20, 40) == kBlack);
  CHECK(pixel(image, 79, 30) == kWhite);
  CHECK(pixel(image, 80, 30) == palette::blue);
  CHECK(pixel(image, 30, 14) == palette::blue);
  CHECK(pixel(image, 30, 15) == kRed);
  CHECK(pixel(image, 30, 44) == kBlack);
  CHECK(pixel(image, 30, 45) == palette::blue);
  CHECK(pixel(image, 40, 34) == palette::green);

  // Tiles show the same, but for what a graphics card rounds where it reads between two pixels of a picture.
  const Image tiled = drawing.draw(pixel_camera(100, 60), views, {.background = palette::blue, .tile_px = 32});
  REQUIRE(tiled.rgba.size() == image.rgba.size());
  int most = 0;
  for (std::size_t i = 0; i < image.rgba.size(); ++i) most = std::max(most, std::abs(tiled.rgba[i] - image.rgba[i]));
  CHECK(most <= 1);

  std::vector<LayerView> pale = views;
  pale[0].style.opacity = 0.5;
  CHECK(pixel(drawing.draw(pixel_camera(100, 60), pale, {.background = kWhite}), 30, 44).r == Approx(128).margin(1));
  // Nothing without the layer, without a width, or taken away.
  const Image plain = drawing.draw(pixel_camera(100, 60), {views[1]}, {.background = palette::blue});
  drawing.scene().place_picture({{50.0, 30.0}, 0.0});
  CHECK(drawing.draw(pixel_camera(100, 60), views, {.background = palette::blue}) == plain);
  drawing.scene().place_picture({{50.0, 30.0}, 60.0});
  drawing.scene().clear_picture();
  CHECK(drawing.draw(pixel_camera(100, 60), views, {.background = palette::blue}) == plain);
}

TEST_CASE("the edge of a picture stays where it is at any zoom") {
  Drawing drawing;
  drawing.scene().set_picture(0, three_fields(64, 64));
  for (const double offset : {0.0, 1e6}) {
    drawing.scene().place_picture({{offset + 0.25, 0.0}, 0.5});
    for (double zoom = 4.0; zoom < 1e9; zoom *= 13.0) {
      render::Camera camera;
      camera.set_viewport(80, 60);
      // The left edge in the middle of the view.
      camera.look_at({offset, -0.1}, 0.01 / zoom);
      const Image image = drawing.draw(camera, {{0, {}}}, {.background = palette::blue});
      CAPTURE(offset, zoom);
      CHECK(pixel(image, 39, 30) == palette::blue);
      CHECK(pixel(image, 40, 50).r <= 2);
      CHECK(pixel(image, 40, 50).b <= 2);
    }
  }
}

TEST_CASE("moving the view uploads no pixel, and nonsense places are not drawn") {
  render::RecordingDevice device;
  render::Scene scene(device);
  scene.set_picture(0, three_fields(8, 8));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double width : {1.0, 1e300, 1e-300, 0.0, -1.0, nan, std::numeric_limits<double>::infinity()}) {
    for (const double x : {0.0, 1e300, -1e-300, nan}) {
      scene.place_picture({{x, 0.0}, width});
      scene.draw(pixel_camera(100, 60), std::vector<LayerView>{{0, {}}}, {});
    }
  }
  CHECK_FALSE(device.picture_calls().empty());
  CHECK(device.textures_alive() == 1);
  CHECK(device.counters().bytes_uploaded == 0);
  scene.clear_picture();
  CHECK(device.textures_alive() == 0);
}

TEST_CASE("a picture larger than the hardware takes is reduced, and keeps its proportions") {
  const Image small = render::reduced(three_fields(1000, 500), 256);
  CHECK(small.width == 250);
  CHECK(small.height == 125);
  CHECK(pixel(small, 10, 10) == kRed);
  CHECK(pixel(small, 10, 120) == kBlack);
  CHECK(pixel(small, 240, 60) == kWhite);
  CHECK(render::reduced(three_fields(7, 1), 1).width == 1);
  // Clear pixels have no say in the colour.
  const Image half{2, 1, {200, 100, 0, 255, 0, 0, 255, 0}};
  CHECK(render::reduced(half, 1).rgba == std::vector<std::uint8_t>{200, 100, 0, 128});
}

TEST_CASE("what was written as PNG is read back, and broken bytes are an error of one line") {
  const Image image = three_fields(37, 21);
  const auto png = render::encode_png(image);
  REQUIRE(png);
  const auto back = render::decode_picture(*png, "a.png");
  REQUIRE(back);
  CHECK(*back == image);

  Rng random(3);
  for (int round = 0; round < 3000; ++round) {
    std::vector<std::byte> bytes(png->begin(),
                                 png->begin() + static_cast<std::ptrdiff_t>(random.below(png->size() + 1)));
    for (std::uint64_t i = random.below(4); i > 0 && !bytes.empty(); --i)
      bytes[random.below(bytes.size())] = static_cast<std::byte>(random.below(256));
    const auto read = render::decode_picture(bytes, "a.png");
    if (read) {
      CHECK(read->rgba.size() == 4 * static_cast<std::size_t>(read->width) * static_cast<std::size_t>(read->height));
    } else {
      CHECK(read.error().message().starts_with("a.png: "));
      CHECK(read.error().message().find('\n') == std::string::npos);
    }
  }
  CHECK(render::decode_picture({}, "a.png").error().message() ==
        "a.png: this is not a PNG, JPEG, BMP or PGM picture");
  CHECK(render::read_picture("/nowhere/a.png").error().message() == "/nowhere/a.png: there is no such file");
  CHECK(render::read_picture("/dev/zero").error().message() == "/dev/zero: not a regular file");
  CHECK(render::is_picture_file("a.PNG"));
  CHECK(render::is_picture_file("b.jpeg"));
  CHECK_FALSE(render::is_picture_file("png"));

  // A header that promises more than anybody traces.
  std::vector<std::byte> huge = *png;
  constexpr std::size_t kHeader = 12;  // its name, behind the signature and the length
  constexpr std::size_t kHeaderSize = 17;
  const auto put = [&huge](std::size_t at, std::uint32_t value) {
    for (std::size_t i = 0; i < 4; ++i) huge[at + i] = static_cast<std::byte>(value >> (24U - 8U * i) & 0xFFU);
  };
  put(kHeader + 4, 28784);
  put(kHeader + 8, 8192);
  put(kHeader + kHeaderSize, crc32_of({reinterpret_cast<const char*>(&huge[kHeader]), kHeaderSize}));
  CHECK(render::decode_picture(huge, "a.png").error().message() ==
        "a.png: a picture of 28784x8192 pixels is too large to trace");
}

TEST_CASE("a picture that announces more than it can hold is refused") {
  const auto refused = [](std::span<const std::byte> bytes) {
    const auto read = render::decode_picture(bytes, "a");
    return !read && read.error().message().starts_with("a: the picture is broken: ");
  };
  const auto jpeg = [](std::initializer_list<int> values) {
    std::vector<std::byte> out{std::byte{0xFF}, std::byte{0xD8}};
    for (const int value : values) out.push_back(static_cast<std::byte>(value));
    return out;
  };
  // A table of 255 + 2 symbols, also behind fill bytes, behind another segment, and at the end of its segment.
  CHECK(refused(jpeg({0xFF, 0xC4, 0x01, 0x14, 0, 255, 2})));
  CHECK(refused(jpeg({0xFF, 0xFF, 0xC4, 0x01, 0x14, 0, 255, 2})));
  CHECK(refused(jpeg({0xFF, 0xFE, 0x00, 0x03, 0xFF, 0xFF, 0xC4, 0x01, 0x14, 0, 255, 2})));
  CHECK(refused(jpeg({0xFF, 0xC4, 0x00, 0x14, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 255, 2})));

  const auto png = render::encode_png(three_fields(5, 4));
  REQUIRE(png);
  CHECK_FALSE(refused(*png));
  std::vector<std::byte> longer = *png;
  constexpr std::size_t kLengthOfData = 33;  // behind the signature and the header
  longer[kLengthOfData] = std::byte{0x3F};
  CHECK(refused(longer));
}

TEST_CASE("the place is named where a PNG is cut or damaged") {
  const auto png = render::encode_png(three_fields(5, 4));
  REQUIRE(png);
  const auto message_of = [](std::span<const std::byte> bytes) {
    const auto read = render::decode_picture(bytes, "a");
    return read ? std::string() : read.error().message();
  };
  const std::string broken = "a: the picture is broken: ";
  constexpr std::size_t kData = 33;  // the chunk behind the signature and the header
  const std::size_t length = std::to_integer<std::size_t>((*png)[kData + 3]);
  REQUIRE(length > 10);
  const std::span<const std::byte> whole(*png);
  // Shorter ones are no PNG: they lack the size.
  for (std::size_t size = kData; size + 1 < whole.size(); ++size) {
    const std::string message = message_of(whole.first(size));
    INFO(size << ": " << message);
    // The decoder does not need the end.
    const bool holds_data = size >= kData + 8 + length;
    CHECK((message.empty() ? holds_data : message.starts_with(broken) && message.contains(" byte ")));
  }
  CHECK(message_of(whole.first(kData + 8 + length - 1)) == broken + "the file ends within the chunk at byte 33");
  // Of the compressed data a byte is wrong.
  std::vector<std::byte> damaged = *png;
  damaged[kData + 8] = std::byte{0xFF};
  CHECK(message_of(damaged) == broken + "the chunk at byte 33 does not fit its checksum");
}
