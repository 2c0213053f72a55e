// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/golden_image.h"

#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#include <fmt/core.h>
#include <stb_image.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <vector>

#include "render/image/png.h"

namespace mes::test {
namespace {

struct FreePixels {
  void operator()(stbi_uc* pixels) const { stbi_image_free(pixels); }
};

std::string output_path(const std::string& name) {
  const std::filesystem::path folder(MESECINA_GOLDEN_OUTPUT);
  std::filesystem::create_directories(folder);
  return (folder / name).string();
}

}  // namespace

render::Image premultiplied(render::Image image) {
  for (std::size_t i = 0; i < image.rgba.size(); i += 4)
    for (std::size_t c = i; c < i + 3; ++c)
      image.rgba[c] = static_cast<std::uint8_t>((image.rgba[c] * image.rgba[i + 3] + 127) / 255);
  return image;
}

render::Image decode_png(const void* bytes, std::size_t size) {
  int width = 0;
  int height = 0;
  int channels = 0;
  const std::unique_ptr<stbi_uc, FreePixels> pixels(stbi_load_from_memory(
      static_cast<const stbi_uc*>(bytes), static_cast<int>(size), &width, &height, &channels, STBI_rgb_alpha));
  if (!pixels) throw std::runtime_error("not a PNG");
  const std::size_t count = std::size_t{4} * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  return {.width = width, .height = height, .rgba = {pixels.get(), pixels.get() + count}};
}

render::Image read_png(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
  if (bytes.empty()) throw std::runtime_error("cannot read " + path);
  return decode_png(bytes.data(), bytes.size());
}

void write_png(const render::Image& image, const std::string& path) {
  const auto bytes = render::encode_png(image, render::kPngSmall);
  if (!bytes) throw std::runtime_error(bytes.error().text);
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(bytes->data()), static_cast<std::streamsize>(bytes->size()));
  if (!file.flush()) throw std::runtime_error("cannot write " + path);
}

std::string compare_with_golden(const render::Image& image, const std::string& name,
                                const GoldenTolerance& tolerance) {
  const std::string golden_path = std::string(MESECINA_GOLDEN_FOLDER) + "/" + name + ".png";
  const std::string actual_path = output_path(name + ".png");
  if (!std::filesystem::exists(golden_path)) {
    write_png(image, actual_path);
    return "there is no " + golden_path + "; what was drawn is in " + actual_path;
  }
  const render::Image golden = read_png(golden_path);
  if (golden.width != image.width || golden.height != image.height) {
    write_png(image, actual_path);
    return name + " has another size than its golden picture; see " + actual_path;
  }
  const render::Image expected = premultiplied(golden);
  const render::Image drawn = premultiplied(image);
  render::Image difference = golden;
  std::size_t outliers = 0;
  int largest = 0;
  for (std::size_t i = 0; i < golden.rgba.size(); i += 4) {
    int off = 0;
    for (std::size_t c = 0; c < 4; ++c) off = std::max(off, std::abs(expected.rgba[i + c] - drawn.rgba[i + c]));
    if (off > tolerance.channel) ++outliers;
    largest = std::max(largest, off);
    const auto shade = static_cast<std::uint8_t>(255 - std::min(255, off * 8));
    difference.rgba[i] = 255;
    difference.rgba[i + 1] = difference.rgba[i + 2] = shade;
    difference.rgba[i + 3] = 255;
  }
  if (static_cast<double>(outliers) <= tolerance.outliers * static_cast<double>(golden.rgba.size() / 4)) return {};
  write_png(image, actual_path);
  const std::string difference_path = output_path(name + ".difference.png");
  write_png(difference, difference_path);
  return fmt::format("{}: {} pixels differ, by up to {}; see {} and {}", name, outliers, largest, actual_path,
                     difference_path);
}

}  // namespace mes::test
