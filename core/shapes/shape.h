// SPDX-License-Identifier: GPL-3.0-or-later
// Parametric shapes: curves with a formula, point sets, balls.
//
// Guarantees: equal requests give equal samples, whatever was made before. Random numbers come from
// core/base/rng.h; sine, cosine and powers from libm.
//
// Smallest use:
//     const ShapeDescriptor* star = find_shape("star");
//     const auto data = make_shape(*star, {.values = values_of(*star), .sampling = {.samples = 300}});
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/jobs/job_control.h"
#include "core/curves/curve.h"
#include "core/document/sample_data.h"
#include "core/document/settings/parameter_values.h"

namespace mes {

/// A parameter whose value is a formula of t.
struct FormulaParameter {
  std::string id;
  std::string explanation;
  std::string default_text;
};

/// Parameter values that a caller chooses for a shape.
struct ShapeValues {
  ParameterValues numbers{};
  std::vector<std::string> formulas{};  ///< in the order of the shape's formulas
  std::size_t samples = 0;              ///< number of points or balls of a set
  std::uint64_t seed = 1;
  friend bool operator==(const ShapeValues&, const ShapeValues&) = default;
};

/// The same values as seen by the code that makes the shape.
struct ShapeArguments {
  std::vector<double> numbers;  ///< in the order of the shape's parameters
  std::vector<std::string> formulas;
  std::size_t samples = 0;
  std::uint64_t seed = 1;
};

/// The curves, points or balls of a shape before sampling.
struct MadeShape {
  CurveSet curves{};
  std::vector<Disk> balls{};
};

struct ShapeDescriptor {
  std::string id;    ///< public name, kebab case
  std::string name;  ///< shown name
  std::string explanation;
  std::vector<Parameter> parameters;
  std::vector<FormulaParameter> formulas;
  std::size_t points = 0;  ///< default number of points or balls of a set; 0: curves
  std::function<Expected<MadeShape>(const ShapeArguments& arguments)> make;
};

/// Every shape of the program, curves first.
std::span<const ShapeDescriptor> shapes();
const ShapeDescriptor* find_shape(std::string_view id);

/// Default values of the shape.
ShapeValues values_of(const ShapeDescriptor& shape);

/// Sampling of a shape. At most one of `samples` and `spacing` is given; with neither, curves get about 400 samples,
/// more where they are near to each other, and point sets their default number.
struct ShapeSampling {
  std::optional<std::size_t> samples{};
  std::optional<double> spacing{};  ///< along curves; meaningless for a set of points
  double jitter = 0.0;              ///< each sample moves by up to this many mean spacings, in any direction
  std::uint64_t seed = 1;           ///< for jitter and random points
  friend bool operator==(const ShapeSampling&, const ShapeSampling&) = default;
};

struct ShapeRequest {
  ShapeValues values{};
  ShapeSampling sampling{};
  friend bool operator==(const ShapeRequest&, const ShapeRequest&) = default;
};

inline constexpr std::size_t kMostShapeSamples = 10'000'000;

/// Samples with their contours, or balls. Error: `usage` for parameters that contradict each other, for a formula that
/// cannot be parsed (with the position), and for a meaningless sampling; `bad_input` for a formula whose values are not
/// numbers, and for more than `kMostShapeSamples`. Throws `Cancelled` if there is a job; the job is polled while curves
/// are sampled. Cost: O(samples); for the Poisson disk, O(samples) on average.
Expected<SampleData> make_shape(const ShapeDescriptor& shape, const ShapeRequest& request, JobControl* job = nullptr);

/// Samples other curves in the same way as shapes. Error: as `make_shape`.
Expected<SampleData> sample_curves(const CurveSet& curves, const ShapeSampling& sampling, JobControl* job = nullptr);

}  // namespace mes
