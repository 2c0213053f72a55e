// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/raster/contours.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <utility>

#include "core/base/assert.h"

namespace mes {
namespace {

using Word = std::uint64_t;
constexpr int kWordBits = 64;

/// A pixel by column and row, counted from below, or a step between pixels.
struct Cell {
  int x = 0;
  int y = 0;
  friend constexpr Cell operator+(Cell a, Cell b) { return {a.x + b.x, a.y + b.y}; }
  friend constexpr Cell operator-(Cell a) { return {-a.x, -a.y}; }
  friend constexpr bool operator==(Cell, Cell) = default;
};

constexpr Cell turned_left(Cell step) {
  return {-step.y, step.x};
}

/// One bit a pixel, rows from below, with a margin of one pixel on all sides.
class BitPlane {
 public:
  BitPlane(int width, int height)
      : words_(static_cast<std::size_t>((width + 2 + kWordBits - 1) / kWordBits)),
        bits_(words_ * static_cast<std::size_t>(height + 2), 0) {}

  bool at(Cell cell) const { return (bits_[word(cell)] >> shift(cell) & 1U) != 0; }
  void set(Cell cell) { bits_[word(cell)] |= Word{1} << shift(cell); }
  std::size_t words() const { return words_; }
  Word* row(int y) { return &bits_[static_cast<std::size_t>(y + 1) * words_]; }

 private:
  std::size_t word(Cell cell) const {
    return static_cast<std::size_t>(cell.y + 1) * words_ + static_cast<std::size_t>(cell.x + 1) / kWordBits;
  }
  static unsigned shift(Cell cell) { return static_cast<unsigned>(cell.x + 1) % kWordBits; }

  std::size_t words_;
  std::vector<Word> bits_;
};

/// Packs 64 bytes of value 0 or 1 into bits.
Word packed(const std::uint8_t* flags) {
  constexpr Word kGather = 0x0102040810204080;
  Word out = 0;
  for (unsigned i = 0; i < 8; ++i) {
    Word eight = 0;
    for (unsigned k = 0; k < 8; ++k) eight |= Word{flags[8 * i + k]} << (8 * k);
    out |= (eight * kGather >> 56U) << (8 * i);
  }
  return out;
}

BitPlane figure_of(const GrayImage& image, const ContourRequest& request) {
  BitPlane out(image.width, image.height);
  const auto below = static_cast<std::uint8_t>(request.level.below);
  // One more for the margin; the bits behind the row are zeros, whichever side the figure is.
  std::vector<std::uint8_t> flags(out.words() * kWordBits, 0);
  for (int y = 0; y < image.height; ++y) {
    const std::uint8_t* const values =
        &image.values[static_cast<std::size_t>(image.height - 1 - y) * static_cast<std::size_t>(image.width)];
    std::uint8_t* const to = flags.data() + 1;
    if (request.is_figure_light)
      for (int x = 0; x < image.width; ++x) to[x] = values[x] > below ? 1 : 0;
    else
      for (int x = 0; x < image.width; ++x) to[x] = values[x] <= below ? 1 : 0;
    for (std::size_t i = 0; i < out.words(); ++i) out.row(y)[i] = packed(&flags[i * kWordBits]);
  }
  return out;
}

class Tracer {
 public:
  Tracer(const GrayImage& image, const ContourRequest& request, const JobControl* job)
      : image_(image),
        job_(job),
        level_twice_(2 * request.level.below + 1),
        figure_(figure_of(image, request)),
        passed_(image.width, image.height),
        dark_below_(request.dark + kClear * (request.light - request.dark)),
        light_above_(request.light - kClear * (request.light - request.dark)),
        dark_enough_(request.dark + kFaint * (request.light - request.dark)),
        light_enough_(request.light - kFaint * (request.light - request.dark)) {}

  /// Calls `use` once for each contour. Contours are found by steps from outside to inside, rows from below; every
  /// contour has such a step, because each row of pixels that it encloses enters the figure on one side.
  template <class Use>
  void for_each(Use use) {
    constexpr int kRows = 16;
    for (int y = 0; y < image_.height; ++y) {
      if (y % kRows == 0) look();
      Word before = 0;
      for (std::size_t i = 0; i < figure_.words(); ++i) {
        const Word here = figure_.row(y)[i];
        Word steps = here & ~(here << 1U | before >> (kWordBits - 1));
        before = here;
        for (; steps != 0; steps &= steps - 1) {
          const Cell inside{static_cast<int>(i) * kWordBits + std::countr_zero(steps) - 1, y};
          if (passed_.at(inside)) continue;
          follow(inside);
          use(contour_);
        }
      }
    }
  }

 private:
  static constexpr std::size_t kOften = std::size_t{1} << 16U;  // points
  static constexpr int kLongestTransition = 4;                  // pixels on each side of the threshold
  static constexpr double kFaint = 0.25;                        // share of the contrast
  static constexpr double kClear =
      0.15;  // share of the contrast: a value this near to the mean of a side belongs to the side

  void look() const {
    if (job_ != nullptr && job_->stop_requested()) throw Cancelled{};
  }
  bool is_in_picture(Cell cell) const {
    return cell.x >= 0 && cell.y >= 0 && cell.x < image_.width && cell.y < image_.height;
  }
  int value(Cell cell) const { return image_.at(cell.x, image_.height - 1 - cell.y); }
  /// Twice the distance of a value from the threshold: never zero.
  int excess(Cell cell) const { return std::abs(2 * value(cell) - level_twice_); }

  /// The end of a transition, on one side of the threshold.
  struct Side {
    int value = 0;  // last value of the transition
    int pixels = 1;
  };
  Side side_from(Cell cell, Cell step) const {
    Side out{value(cell), 1};
    const bool is_figure = figure_.at(cell);
    while (out.pixels < kLongestTransition && is_in_picture(cell + step) && figure_.at(cell + step) == is_figure &&
           excess(cell + step) > excess(cell)) {
      cell = cell + step;
      out.value = value(cell);
      ++out.pixels;
    }
    return out;
  }
  /// Whether a value is as dark or light as its side of the picture, up to a part of the contrast.
  bool is_plateau(int value) const { return value <= dark_enough_ || value >= light_enough_; }

  /// The crossing between a pixel inside and its neighbour outside. If the values change from one side of the picture
  /// to the other, their sum gives the edge: exactly, for a straight edge and pixels that are means of their areas.
  Vec2 crossing(Cell inside, Cell step) {
    double share = 0.5;
    if (!is_in_picture(inside + step)) {
      contour_.variance.push_back(-1.0F);
    } else {
      const Cell outside = inside + step;
      const Side in = side_from(inside, -step);
      const Side out = side_from(outside, step);
      if (is_plateau(in.value) && is_plateau(out.value)) {
        // Both sums change sign when light and dark are exchanged, so the quotient stays.
        const int contrast = in.value - out.value;
        int sum = 0;
        int moment = 0;  // moment of the value steps about the border of the two pixels
        int second = 0;
        Cell at = inside;
        for (int i = 1; i < in.pixels; ++i) at = at + -step;
        int before = in.value;
        for (int i = 1 - in.pixels; i <= out.pixels; ++i, at = at + step) {
          const int here = value(at);
          sum += here - out.value;
          const int fall = before - here;
          moment += fall * (i - 1);
          second += fall * (i - 1) * (i - 1);
          before = here;
        }
        share = sum / static_cast<double>(contrast) - in.pixels + 0.5;
        const double mean = moment / static_cast<double>(contrast);
        contour_.variance.push_back(static_cast<float>(second / static_cast<double>(contrast) - mean * mean));
      } else {
        contour_.variance.push_back(-1.0F);
        const int near = excess(inside);
        share = near / static_cast<double>(near + excess(outside));
      }
    }
    return {inside.x + 0.5 + step.x * share, inside.y + 0.5 + step.y * share};
  }

  bool is_sharp(Cell inside, Cell step) const {
    if (!is_in_picture(inside + step)) return false;
    const auto [low, high] = std::minmax({value(inside), value(inside + step)});
    return low <= dark_below_ && high >= light_above_;
  }

  /// For a cell with opposite corners `a` and `b` inside and the others outside: whether the bilinear function of its
  /// values is on the side of the figure at its saddle. All four are in the picture.
  bool is_joined(Cell a, Cell b, Cell c, Cell d) const {
    return std::int64_t{excess(a)} * excess(b) >= std::int64_t{excess(c)} * excess(d);
  }

  void follow(Cell first) {
    contour_.points.clear();
    contour_.is_along_y.clear();
    contour_.variance.clear();
    contour_.sharp = 0;
    const Cell first_step{-1, 0};
    Cell inside = first;
    Cell step = first_step;  // from inside to outside: to the right of the contour's direction
    double area = 0.0;
    do {
      const Vec2 point = crossing(inside, step);
      if (!contour_.points.empty())
        area += cross(contour_.points.back() - contour_.points.front(), point - contour_.points.front());
      contour_.points.push_back(point);
      contour_.is_along_y.push_back(step.y != 0 ? 1 : 0);
      if (contour_.points.size() % kOften == 0) look();
      contour_.sharp += is_sharp(inside, step) ? 1U : 0U;
      if (step == first_step) passed_.set(inside);
      const Cell forward = turned_left(step);
      const Cell left = inside + forward;
      const Cell right = inside + step + forward;
      const bool left_inside = figure_.at(left);
      const bool right_inside = figure_.at(right);
      if (right_inside && (left_inside || is_joined(inside, right, left, inside + step))) {
        inside = right;
        step = -forward;
      } else if (left_inside && !right_inside) {
        inside = left;
      } else {
        step = forward;
      }
    } while (inside != first || step != first_step);
    contour_.area = 0.5 * area;
  }

  const GrayImage& image_;
  const JobControl* job_;
  int level_twice_;
  BitPlane figure_;
  BitPlane passed_;  // pixels inside whose left neighbour is outside
  double dark_below_;
  double light_above_;
  double dark_enough_;
  double light_enough_;
  PixelContour contour_;
};

}  // namespace

PixelContours contours_of(const GrayImage& image, const ContourRequest& request, const JobControl* job) {
  MES_ASSERT(request.level.below >= 0 && request.level.below < 255);
  PixelContours out;
  if (image.values.empty()) return out;
  Tracer tracer(image, request, job);
  tracer.for_each([&](const PixelContour& contour) {
    if (std::abs(contour.area) >= request.least_area) {
      out.kept.push_back(contour);
    } else {
      ++(contour.area > 0.0 ? out.specks : out.pinholes);
      if (contour.area > 0.0) out.largest_speck = std::max(out.largest_speck, contour.area);
    }
  });
  return out;
}

}  // namespace mes
