// SPDX-License-Identifier: GPL-3.0-or-later
// From a silhouette or a photograph to curves: the outlines of what is lighter or darker than a threshold.
//
// Smallest use:
//     const auto tracing = trace(image, {});
//     if (tracing) use(tracing->curves);
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include "core/base/error.h"
#include "core/curves/curve.h"
#include "core/curves/sampling.h"
#include "core/raster/contours.h"
#include "core/raster/gray_image.h"
#include "core/raster/trace_request.h"

namespace mes {

/// What there is to trace.
struct TraceCounts {
  std::size_t outlines = 0;  ///< and holes
  std::size_t specks = 0;    ///< figures left out
  std::size_t pinholes = 0;  ///< holes left out
  double blur = 0.0;         ///< pixels: the deviation of the blur of a noisy picture
  friend bool operator==(const TraceCounts&, const TraceCounts&) = default;
};

/// One outline or hole a curve: an ellipse, or lines between corners and cubic pieces that go on smoothly.
struct Tracing {
  CurveSet curves{};
  Level level{};
  bool is_figure_light = false;
  double speck_size = 0.0;  ///< square pixels
  TraceCounts counts{};
  bool is_two_valued = false;  ///< hardly any value along the outlines is in between
};

/// Pixels by value.
using Histogram = std::array<std::size_t, 256>;
Histogram histogram_of(const GrayImage& image);

/// The level between two classes of values whose means differ most, in proportion to their sizes: the maximum of the
/// variance between them (Otsu 1979), decided in integers but for one quotient; the middle where several are equal.
/// Nothing if all pixels have the same value. Exchanging light and dark gives the level exchanged.
std::optional<Level> otsu_level(const Histogram& histogram);

/// Sixteen square pixels, or the ten-thousandth part of a picture that is larger.
double default_specks(const GrayImage& image);

/// Which side is the figure at a level.
bool is_figure_light(const GrayImage& image, Level level, FigureSide side);

/// A picture whose outlines leave more than `kManyGrains` specks and pinholes, and whose noise
/// (core/raster/internal/noise.h) is more than `kLeastNoise` grey values, is blurred first, the more the larger its noise
/// is beside the difference of the two sides: else each grain beside the threshold is a speck or a bay. Not where the noise
/// is more than `kMostNoise` of that difference, for then the grains are the picture, nor where blurring would change the
/// area of a side by more than a twentieth, as it does where figures are thin. Silhouettes have no noise, nor do pictures
/// of which half has none.
///
/// An outline is the stiffest curve that the edges of the pixels allow (core/raster/internal/run_fit.h). A single edge may
/// be off by `kSharpNoise` where there are no values in between, or the picture was blurred, and by `kSoftNoise` elsewhere,
/// or more as it turns out; the mean of many edges by a third of that. Where values lie in between, their sums say where an
/// edge is, so that areas are kept. What ellipses explain is an ellipse. Corners stay corners. Single pixels that stand out
/// are passed over. Curvature has as few extremes as the edges allow (core/raster/internal/curvature.h), for each of them may
/// be a branch of the axis. No edge is farther from its outline than `kMostAway`.
/// Cost: O(pixels); any thread. Error: `bad_input` if nothing stands out, or nothing larger than a speck; `usage` for a
/// threshold out of range. Throws `Cancelled` if there is a job.
Expected<Tracing> trace(const GrayImage& image, const TraceRequest& request, const JobControl* job = nullptr);
/// The same of a picture that is blurred by so many pixels first, whatever its noise; 0: not at all.
Expected<Tracing> trace_blurred(const GrayImage& image, const TraceRequest& request, double blur,
                                const JobControl* job = nullptr);
/// The counts of `trace`, without its curves. A reduced picture has to be blurred by as much, in proportion, to show the
/// same, and has fewer specks. O(pixels); otherwise as `trace`, but it is no error that only specks stand out.
Expected<TraceCounts> counts_of_tracing(const GrayImage& image, const TraceRequest& request,
                                        const JobControl* job = nullptr);
inline constexpr double kSharpNoise = 0.45;
inline constexpr double kSoftNoise = 0.08;
inline constexpr double kMostAway = 2.0;  ///< pixels: an edge from its outline
inline constexpr std::size_t kManyGrains = 100;
inline constexpr double kLeastNoise = 1.4;
inline constexpr double kMostNoise = 0.2;

/// What a tracing is sampled by when it is opened: about 400 samples, at least eight on each curve, more where parts of it
/// are near to each other; but no more than one a pixel of its length, elsewhere.
SamplingRequest sampling_of_tracing(const CurveSet& curves);

/// "traced what is darker than 127.5 of 255; left out: 12 specks and 3 holes of less than 26 square pixels".
std::string remark_of(const Tracing& tracing);

}  // namespace mes
