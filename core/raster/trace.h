// SPDX-License-Identifier: GPL-3.0-or-later
// Traces a silhouette or a photograph: curves around everything lighter or darker than a threshold.
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

/// The amount of content to trace.
struct TraceCounts {
  std::size_t outlines = 0;  ///< including holes
  std::size_t specks = 0;    ///< figures that are left out
  std::size_t pinholes = 0;  ///< holes that are left out
  double blur = 0.0;         ///< deviation of the blur of a noisy picture, in pixels
  friend bool operator==(const TraceCounts&, const TraceCounts&) = default;
};

/// Each curve is an outline or a hole: an ellipse, or lines between corners and smoothly joined cubic pieces.
struct Tracing {
  CurveSet curves{};
  Level level{};
  bool is_figure_light = false;
  double speck_size = 0.0;  ///< square pixels
  TraceCounts counts{};
  bool is_two_valued = false;  ///< hardly any value along the outlines is intermediate
};

/// Number of pixels by value.
using Histogram = std::array<std::size_t, 256>;
Histogram histogram_of(const GrayImage& image);

/// Otsu's threshold (1979): the level that maximises the variance between the two classes of values. Computed in
/// integers except one quotient; the middle if several are equal. Nothing if all pixels have the same value. Exchanging
/// light and dark gives the level exchanged.
std::optional<Level> otsu_level(const Histogram& histogram);

/// Sixteen square pixels; a sixteenth of the area for pictures below 256 pixels, a ten-thousandth for those above 160,000.
double default_specks(const GrayImage& image);

/// Whether the light side is the figure at a level.
bool is_figure_light(const GrayImage& image, Level level, FigureSide side);

/// A noisy picture is blurred first, the more the larger its noise is relative to the difference of the two sides:
/// otherwise each grain near the threshold is a speck or a bay. A picture is noisy if its outlines leave more than
/// `kManyGrains` specks and pinholes and its noise (core/raster/internal/noise.h) exceeds `kLeastNoise` grey values. It
/// is not blurred if the noise exceeds `kMostNoise` of that difference, for then the grains are the picture, or if
/// blurring would change the area of a side by more than a twentieth, as with thin figures. Silhouettes have no noise,
/// nor do pictures half of which has none.
///
/// An outline is the stiffest curve that the edges of the pixels allow (core/raster/internal/fitting/run_fit.h). A single edge
/// may be off by `kSharpNoise` if there are no intermediate values, or the picture was blurred, and otherwise by
/// `kSoftNoise`, or by more if the picture shows more; the mean of many edges by a third of that. Intermediate values
/// give the edge by their sums, so that areas are kept. An outline that an ellipse explains is an ellipse. Corners stay
/// corners. Single deviating pixels are ignored. Curvature has as few extremes as the edges allow
/// (core/raster/internal/fitting/curvature.h), because each may be a branch of the axis. No edge is farther from its outline
/// than `kMostAway`.
/// Cost: O(pixels); any thread. Error: `bad_input` if nothing stands out, or nothing larger than a speck; `usage` for a
/// threshold out of range. Throws `Cancelled` if there is a job.
Expected<Tracing> trace(const GrayImage& image, const TraceRequest& request, const JobControl* job = nullptr);
/// The same for a picture that is first blurred by `blur` pixels, whatever its noise; 0: no blur.
Expected<Tracing> trace_blurred(const GrayImage& image, const TraceRequest& request, double blur,
                                const JobControl* job = nullptr);
/// The counts of `trace`, without its curves. A reduced picture must be blurred in proportion to give the same result,
/// and has fewer specks. O(pixels); otherwise as `trace`, but a picture with only specks is not an error.
Expected<TraceCounts> counts_of_tracing(const GrayImage& image, const TraceRequest& request,
                                        const JobControl* job = nullptr);
inline constexpr double kSharpNoise = 0.45;
inline constexpr double kSoftNoise = 0.08;
inline constexpr double kMostAway = 2.0;  ///< largest distance of an edge from its outline, in pixels
inline constexpr std::size_t kManyGrains = 100;
inline constexpr double kLeastNoise = 1.4;
inline constexpr double kMostNoise = 0.2;

/// The sampling of a tracing that is opened: about 400 samples, at least eight on each curve, more where parts of it
/// are near to each other; elsewhere at most one a pixel of its length.
SamplingRequest sampling_of_tracing(const CurveSet& curves);

/// The outlines that are left out, as every dialog and message counts them: "12 specks and 3 holes"; empty if there are
/// none.
std::string left_out_text(const TraceCounts& counts);

/// "traced all pixels darker than 127.5 of 255; left out: 12 specks and 3 holes smaller than 26 square pixels".
std::string remark_of(const Tracing& tracing);

}  // namespace mes
