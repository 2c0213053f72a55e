// SPDX-License-Identifier: GPL-3.0-or-later
// Contours of the grey values of a picture at a threshold: closed curves between pixels.
//
// The plane has a unit of one pixel, y up, and the lower left corner of the picture at the origin, so the pixel of
// column x and row y has its centre at (x + 1/2, height - y - 1/2). Between two neighbouring pixels on different sides,
// the curve crosses where linear interpolation of their values meets the threshold; figures that reach the edge of the
// picture have their contour along the edge.
//
// Source: marching squares (Lorensen and Cline 1987, in the plane); for cells with opposite corners on one side, the
// asymptotic decider (Nielson and Hamann 1991).
//
// Smallest use:
//     const auto contours = contours_of(image, {.level = Level{127}, .is_figure_light = true});
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/base/geometry/vec2.h"
#include "core/base/jobs/job_control.h"
#include "core/raster/gray_image.h"

namespace mes {

/// A threshold halfway between two values, so that every pixel is on one side.
struct Level {
  int below = 127;  ///< the largest value below it, from 0 to 254; users know the threshold by this number
  friend bool operator==(Level, Level) = default;
};

struct PixelContour {
  std::vector<Vec2>
      points{};  ///< the figure lies to the left: counter-clockwise around it, clockwise around its holes
  std::vector<std::uint8_t> is_along_y{};  ///< for each point: it lies between pixels of one column
  double area = 0.0;                       ///< enclosed area in square pixels; negative for holes
  std::size_t sharp = 0;                   ///< points between two pixels without intermediate values
  /// For each point: the variance of the transition that determined it, from value to value along its line, in square
  /// pixels; negative for a point determined by two values only.
  std::vector<float> variance{};
};

struct ContourRequest {
  Level level{};
  bool is_figure_light = true;
  double least_area = 0.0;  ///< contours around less area are left out, of figures and holes alike
  /// The means of the two sides, for `PixelContour::sharp`.
  double dark = 0.0;
  double light = 255.0;
};

struct PixelContours {
  std::vector<PixelContour> kept{};  ///< ordered by lowest row
  std::size_t specks = 0;            ///< figures that were left out
  std::size_t pinholes = 0;          ///< holes that were left out
  double largest_speck = 0.0;        ///< area in square pixels
};

/// Exchanging light and dark, and making the other side the figure, gives the same contours bit for bit. If a cell
/// could be joined either way, the values decide, and if they tie, the figure stays in one piece. Cost: O(pixels), a
/// few operations for 64 of them, and about ten nanoseconds a point; memory for one bit a pixel and the kept contours.
/// Any thread. Throws `Cancelled` if there is a job, which is polled every few rows and thousand points.
PixelContours contours_of(const GrayImage& image, const ContourRequest& request, const JobControl* job = nullptr);

}  // namespace mes
