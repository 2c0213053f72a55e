// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/raster/trace.h"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <utility>

#include "core/base/counted.h"
#include "core/base/jobs/parallel.h"
#include "core/raster/internal/noise.h"
#include "core/raster/internal/outline.h"

namespace mes {
namespace {

// If at least this share of all contour points lies between values of the two sides, the picture is two-valued.
constexpr double kShareOfSharp = 0.6;

std::unexpected<Error> no_trace(ErrorCode code, std::string text) {
  return std::unexpected(Error{code, std::move(text)});
}

/// The threshold is the number that the user chooses, not the point halfway to the next value.
std::string side_words(Level level, bool is_light) {
  return is_light ? fmt::format("lighter than grey value {}", level.below)
                  : fmt::format("of grey value {} or darker", level.below);
}

struct Sides {
  std::size_t dark = 0;  // number of dark pixels
  std::size_t light = 0;
  double dark_mean = 0.0;
  double light_mean = 255.0;
};

Sides sides_of(const Histogram& histogram, Level level) {
  Sides out;
  double dark = 0.0;
  double light = 0.0;
  for (std::size_t value = 0; value < histogram.size(); ++value) {
    const double sum = static_cast<double>(value) * static_cast<double>(histogram[value]);
    const bool is_dark = value <= static_cast<std::size_t>(level.below);
    (is_dark ? out.dark : out.light) += histogram[value];
    (is_dark ? dark : light) += sum;
  }
  if (out.dark != 0) out.dark_mean = dark / static_cast<double>(out.dark);
  if (out.light != 0) out.light_mean = light / static_cast<double>(out.light);
  return out;
}

/// The requested threshold, or the best one.
Expected<Level> chosen_level(const Histogram& histogram, const TraceRequest& request) {
  if (request.threshold) {
    if (*request.threshold < 0 || *request.threshold > 254)
      return no_trace(ErrorCode::usage, "a threshold is a grey value from 0 to 254");
    return Level{*request.threshold};
  }
  if (const auto level = otsu_level(histogram)) return *level;
  const auto only = std::ranges::find_if(histogram, [](std::size_t count) { return count != 0; });
  return no_trace(ErrorCode::bad_input,
                  fmt::format("no figure stands out: every pixel has the grey value {}", only - histogram.begin()));
}

/// Blur in pixels for a noisy picture; 0 if it is not noisy, or if the grains are the picture.
double blur_for(const GrayImage& picture, const Sides& sides) {
  constexpr double kLeastBlur = 0.8;
  constexpr double kPerNoise = 24.0;
  const double noise = noise_of(picture);
  const double share = noise / (sides.light_mean - sides.dark_mean);
  return noise >= kLeastNoise && share < kMostNoise ? std::max(kLeastBlur, kPerNoise * share) : 0.0;
}

std::size_t light_pixels(const GrayImage& image, Level level) {
  return static_cast<std::size_t>(
      std::ranges::count_if(image.values, [&](std::uint8_t value) { return value > level.below; }));
}

/// Whether blurring keeps the area of the sides: it would spread thin figures and close narrow gaps. Grains cancel out.
bool keeps_area(const GrayImage& picture, const GrayImage& smooth, Level level) {
  constexpr double kMostChange = 0.05;
  const auto before = static_cast<double>(light_pixels(picture, level));
  const auto after = static_cast<double>(light_pixels(smooth, level));
  const auto all = static_cast<double>(picture.values.size());
  return std::abs(after - before) <= kMostChange * std::min({before, after, all - before, all - after});
}

bool is_two_valued(const PixelContours& contours) {
  std::size_t sharp = 0;
  std::size_t all = 0;
  for (const PixelContour& contour : contours.kept) {
    sharp += contour.sharp;
    all += contour.points.size();
  }
  return static_cast<double>(sharp) > kShareOfSharp * static_cast<double>(all);
}

EdgeNoise noise_of_edges(const PixelContour& contour, double blur) {
  const bool is_sharp =
      static_cast<double>(contour.sharp) > kShareOfSharp * static_cast<double>(contour.points.size());
  if (is_sharp || blur > 0.0) return {.one = kSharpNoise};
  return {.one = kSoftNoise, .is_blurred = true, .least_stiffness = 1.0};
}

/// Contours at the level, and the tracing without its curves.
struct Outlined {
  Tracing tracing{};
  PixelContours contours{};
};
Outlined counted(Outlined found) {
  TraceCounts& counts = found.tracing.counts;
  counts.outlines = found.contours.kept.size();
  counts.specks = found.contours.specks;
  counts.pinholes = found.contours.pinholes;
  return found;
}

Expected<Outlined> outlined(const GrayImage& image, const TraceRequest& request, std::optional<double> blur,
                            const JobControl* job) {
  const Histogram histogram = histogram_of(image);
  const auto level = chosen_level(histogram, request);
  if (!level) return std::unexpected(level.error());
  const Sides sides = sides_of(histogram, *level);
  Outlined out{.tracing = {.level = *level,
                           .is_figure_light = is_figure_light(image, *level, request.figure),
                           .speck_size = request.specks.value_or(default_specks(image))}};
  const ContourRequest asked{.level = *level,
                             .is_figure_light = out.tracing.is_figure_light,
                             .least_area = out.tracing.speck_size,
                             .dark = sides.dark_mean,
                             .light = sides.light_mean};
  if (blur && *blur > 0.0) {
    out.contours = contours_of(blurred(image, *blur, job), asked, job);
    out.tracing.counts.blur = *blur;
    return counted(std::move(out));
  }
  out.contours = contours_of(image, asked, job);
  if (blur || out.contours.specks + out.contours.pinholes <= kManyGrains) return counted(std::move(out));
  if (const double found = blur_for(image, sides); found > 0.0) {
    const GrayImage smooth = blurred(image, found, job);
    if (keeps_area(image, smooth, *level)) {
      out.contours = contours_of(smooth, asked, job);
      out.tracing.counts.blur = found;
    }
  }
  return counted(std::move(out));
}

/// Fits the contours on several threads, each with a batch of many points.
std::vector<PlaneCurve> outlines_of(const std::vector<PixelContour>& contours, double blur, const Box2& picture,
                                    const JobControl* job) {
  constexpr std::size_t kPointsEach = std::size_t{1} << 14U;
  std::vector<std::size_t> ends;
  std::size_t points = 0;
  for (std::size_t i = 0; i < contours.size(); ++i) {
    points += contours[i].points.size();
    if (points < kPointsEach && i + 1 < contours.size()) continue;
    ends.push_back(i + 1);
    points = 0;
  }
  std::vector<PlaneCurve> out(contours.size(), PlaneCurve({}));
  run_tasks(ends.size(), [&](std::size_t task) {
    for (std::size_t i = task == 0 ? 0 : ends[task - 1]; i < ends[task]; ++i) {
      if (job != nullptr && job->stop_requested()) throw Cancelled{};
      out[i] = outline_of(contours[i], noise_of_edges(contours[i], blur), picture, job);
    }
  });
  return out;
}

/// Completes a tracing with the curves of its contours.
Expected<Tracing> traced(Expected<Outlined> found, const GrayImage& image, const TraceRequest& request,
                         const JobControl* job) {
  if (!found) return std::unexpected(std::move(found.error()));
  Tracing out = std::move(found->tracing);
  const PixelContours& contours = found->contours;
  const std::string side = side_words(out.level, out.is_figure_light);
  if (contours.kept.empty() && contours.specks == 0)
    return no_trace(ErrorCode::bad_input, "no figure stands out: nothing is " + side);
  if (contours.kept.empty())
    return no_trace(
        ErrorCode::bad_input,
        fmt::format("no figure stands out: there are only specks {}, the largest of {:.4g} square pixels; "
                    "specks are figures below {:.4g}",
                    side, contours.largest_speck * request.pixel_area,
                    request.specks.value_or(default_specks(image)) * request.pixel_area));
  out.is_two_valued = is_two_valued(contours);
  const Box2 picture{{0.0, 0.0}, {static_cast<double>(image.width), static_cast<double>(image.height)}};
  out.curves.curves = outlines_of(contours.kept, out.counts.blur, picture, job);
  return out;
}

}  // namespace

Histogram histogram_of(const GrayImage& image) {
  // Most of a silhouette is runs of one value. Elsewhere two tables keep equal neighbours from waiting for each other.
  constexpr std::size_t kRun = 8;
  constexpr std::uint64_t kEach = 0x0101010101010101;
  Histogram out{};
  Histogram other{};
  const std::uint8_t* at = image.values.data();
  const std::uint8_t* const end = at + image.values.size();
  for (; end - at >= static_cast<std::ptrdiff_t>(kRun); at += kRun) {
    std::uint64_t run = 0;
    std::memcpy(&run, at, kRun);
    if (run == kEach * *at) {
      out[*at] += kRun;
    } else {
      for (std::size_t i = 0; i < kRun; i += 2) {
        ++out[at[i]];
        ++other[at[i + 1]];
      }
    }
  }
  for (; at != end; ++at) ++out[*at];
  for (std::size_t value = 0; value < out.size(); ++value) out[value] += other[value];
  return out;
}

std::optional<Level> otsu_level(const Histogram& histogram) {
  std::int64_t all = 0;
  std::int64_t sum = 0;
  for (std::size_t value = 0; value < histogram.size(); ++value) {
    all += static_cast<std::int64_t>(histogram[value]);
    sum += static_cast<std::int64_t>(value * histogram[value]);
  }
  std::int64_t below = 0;
  std::int64_t sum_below = 0;
  double best = 0.0;
  int first = -1;
  int last = -1;
  for (int level = 0; level < 255; ++level) {
    const auto count = static_cast<std::int64_t>(histogram[static_cast<std::size_t>(level)]);
    below += count;
    sum_below += level * count;
    if (below == 0 || below == all) continue;
    const auto difference = static_cast<double>(std::abs(sum * below - sum_below * all));
    const double variance = difference / static_cast<double>(below) * (difference / static_cast<double>(all - below));
    if (variance > best) {
      best = variance;
      first = level;
    }
    if (variance == best) last = level;
  }
  if (first < 0) return std::nullopt;
  return Level{(first + last) / 2};
}

double default_specks(const GrayImage& image) {
  constexpr double kUsual = 16.0;
  constexpr double kShareOfSmall = 1.0 / 16.0;
  constexpr double kShareOfLarge = 1e-4;
  const double area = static_cast<double>(image.width) * image.height;
  return std::max(std::min(kUsual, kShareOfSmall * area), kShareOfLarge * area);
}

bool is_figure_light(const GrayImage& image, Level level, FigureSide side) {
  if (side != FigureSide::found) return side == FigureSide::light;
  std::int64_t excess = 0;  // number of light pixels minus dark ones
  const auto count = [&](int x, int y) { excess += image.at(x, y) > level.below ? 1 : -1; };
  for (int x = 0; x < image.width; ++x) {
    count(x, 0);
    count(x, image.height - 1);
  }
  for (int y = 1; y + 1 < image.height; ++y) {
    count(0, y);
    count(image.width - 1, y);
  }
  if (excess != 0) return excess < 0;
  const Sides sides = sides_of(histogram_of(image), level);
  return sides.light < sides.dark;
}

Expected<Tracing> trace(const GrayImage& image, const TraceRequest& request, const JobControl* job) {
  return traced(outlined(image, request, std::nullopt, job), image, request, job);
}

Expected<Tracing> trace_blurred(const GrayImage& image, const TraceRequest& request, double blur,
                                const JobControl* job) {
  return traced(outlined(image, request, blur, job), image, request, job);
}

Expected<TraceCounts> counts_of_tracing(const GrayImage& image, const TraceRequest& request, const JobControl* job) {
  const auto found = outlined(image, request, std::nullopt, job);
  if (!found) return std::unexpected(found.error());
  return found->tracing.counts;
}

SamplingRequest sampling_of_tracing(const CurveSet& curves) {
  constexpr double kSamples = 400.0;
  constexpr std::size_t kLeastEach = 8;
  double length = 0.0;
  for (const PlaneCurve& curve : curves.curves)
    curve.for_each_piece([&](const Piece& piece) {
      if (length >= kSamples) return;
      const Vec2 middle = piece.at(0.5);
      length += distance(piece.from(), middle) + distance(middle, piece.to());
    });
  const double count = std::clamp(length, static_cast<double>(kLeastEach), kSamples);
  return {.rule = SamplingRule::adaptive, .count = static_cast<std::size_t>(count), .least_each = kLeastEach};
}

std::string left_out_text(const TraceCounts& counts) {
  std::string out;
  if (counts.specks != 0) out = counted(counts.specks, "speck");
  if (counts.specks != 0 && counts.pinholes != 0) out += " and ";
  if (counts.pinholes != 0) out += counted(counts.pinholes, "hole");
  return out;
}

std::string remark_of(const Tracing& tracing) {
  std::string out = "traced all pixels " + side_words(tracing.level, tracing.is_figure_light);
  if (tracing.counts.blur > 0.0)
    out += fmt::format(", blurred by {:.2g} pixels because of noise", tracing.counts.blur);
  const std::string left_out = left_out_text(tracing.counts);
  return left_out.empty()
             ? out
             : out + fmt::format("; left out: {} smaller than {:.4g} square pixels", left_out, tracing.speck_size);
}

}  // namespace mes
