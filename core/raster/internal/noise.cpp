// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/raster/internal/noise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <vector>

namespace mes {

namespace {

/// Noise, assuming that it is independent from pixel to pixel.
double noise_of_pixels(const GrayImage& image) {
  if (image.width < 3 || image.height < 3) return 0.0;
  constexpr double kLooks = 1e5;
  const double pixels = static_cast<double>(image.width) * image.height;
  // An odd step avoids sampling always the same position in the blocks of a JPEG.
  const int step = std::max(1, static_cast<int>(std::sqrt(pixels / kLooks))) | 1;
  // Magnitudes are at most 8 * 255.
  std::array<std::size_t, 2041> counts{};
  std::size_t all = 0;
  for (int y = 1; y + 1 < image.height; y += step)
    for (int x = 1; x + 1 < image.width; x += step) {
      const auto second = [&](int row) { return image.at(x - 1, row) - 2 * image.at(x, row) + image.at(x + 1, row); };
      ++counts[static_cast<std::size_t>(std::abs(second(y - 1) - 2 * second(y) + second(y + 1)))];
      ++all;
    }
  std::size_t passed = 0;
  std::size_t median = 0;
  while (2 * (passed += counts[median]) < all) ++median;
  // For Gaussian noise the mask has six times the deviation, and the median magnitude is 0.6745 deviations.
  return static_cast<double>(median) / (6.0 * 0.6745);
}

}  // namespace

double noise_of(const GrayImage& image) {
  // Compression removes the finest noise and leaves wider noise. Halving a picture halves noise of single pixels.
  constexpr int kHalvings = 2;
  double out = noise_of_pixels(image);
  if (out == 0.0) return 0.0;
  GrayImage smaller;
  double factor = 1.0;
  for (int i = 0; i < kHalvings; ++i) {
    smaller = halved(i == 0 ? image : smaller);
    factor *= 2.0;
    out = std::max(out, factor * noise_of_pixels(smaller));
  }
  return out;
}

GrayImage blurred(const GrayImage& image, double sigma, const JobControl* job) {
  constexpr double kReach = 2.5;
  const int reach = static_cast<int>(std::ceil(kReach * sigma));
  std::vector<float> weights;
  double sum = 0.0;
  for (int i = -reach; i <= reach; ++i) sum += std::exp(-0.5 * i * i / (sigma * sigma));
  for (int i = -reach; i <= reach; ++i)
    weights.push_back(static_cast<float>(std::exp(-0.5 * i * i / (sigma * sigma)) / sum));

  GrayImage out{image.width, image.height, {}};
  if (image.values.empty()) return out;
  out.values.resize(image.values.size());
  const auto width = static_cast<std::size_t>(image.width);
  const auto margin = static_cast<std::size_t>(reach);
  std::vector<float> column_sums(width + 2 * margin);
  std::vector<float> row(width);
  for (int y = 0; y < image.height; ++y) {
    if (job != nullptr && y % 16 == 0 && job->stop_requested()) throw Cancelled{};
    const auto middle = column_sums.begin() + reach;
    std::fill(middle, middle + image.width, 0.0F);
    for (int i = -reach; i <= reach; ++i) {
      const int from = std::clamp(y + i, 0, image.height - 1);
      const std::uint8_t* const values = image.values.data() + static_cast<std::size_t>(from) * width;
      const float weight = weights[static_cast<std::size_t>(i + reach)];
      float* const sums = column_sums.data() + margin;
      for (std::size_t x = 0; x < width; ++x) sums[x] += weight * static_cast<float>(values[x]);
    }
    std::fill(column_sums.begin(), middle, *middle);
    std::fill(middle + image.width, column_sums.end(), *(middle + image.width - 1));
    std::ranges::fill(row, 0.5F);
    for (std::size_t i = 0; i < weights.size(); ++i) {
      const float* const sums = column_sums.data() + i;
      for (std::size_t x = 0; x < width; ++x) row[x] += weights[i] * sums[x];
    }
    std::uint8_t* const to = out.values.data() + static_cast<std::size_t>(y) * width;
    for (std::size_t x = 0; x < width; ++x) to[x] = static_cast<std::uint8_t>(std::min(row[x], 255.0F));
  }
  return out;
}

}  // namespace mes
