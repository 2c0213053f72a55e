// SPDX-License-Identifier: GPL-3.0-or-later
// Shapes made of parameters: curves with a formula, point sets, balls.
//
// What they guarantee: equal requests give equal samples, whatever was made before. Random numbers come from
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
#include "core/base/job_control.h"
#include "core/curves/curve.h"
#include "core/document/commands.h"
#include "core/document/parameter_values.h"

namespace mes {

/// A parameter that is a formula of t.
struct FormulaParameter {
  std::string id;
  std::string explanation;
  std::string default_text;
};

/// The values that a caller chooses for a shape.
struct ShapeValues {
  ParameterValues numbers{};
  std::vector<std::string> formulas{};  ///< in the order of its formulas
  std::size_t samples = 0;              ///< of a set of points or balls: how many
  std::uint64_t seed = 1;
  friend bool operator==(const ShapeValues&, const ShapeValues&) = default;
};

/// The same for whoever makes the shape.
struct ShapeArguments {
  std::vector<double> numbers;  ///< in the order of its parameters
  std::vector<std::string> formulas;
  std::size_t samples = 0;
  std::uint64_t seed = 1;
};

/// What a shape consists of before it is sampled.
struct MadeShape {
  CurveSet curves{};
  std::vector<Disk> balls{};
};

struct ShapeDescriptor {
  std::string id;    ///< public name, kebab case
  std::string name;  ///< as shown
  std::string explanation;
  std::vector<Parameter> parameters;
  std::vector<FormulaParameter> formulas;
  std::size_t points = 0;  ///< of a set of points or balls: how many there are unless asked for; 0: curves
  std::function<Expected<MadeShape>(const ShapeArguments& arguments)> make;
};

/// Every shape of the program, curves first.
std::span<const ShapeDescriptor> shapes();
const ShapeDescriptor* find_shape(std::string_view id);

/// Its defaults.
ShapeValues values_of(const ShapeDescriptor& shape);

/// How a shape becomes samples. At most one of `samples` and `spacing`; neither: some 400 of curves, more where these
/// are near to each other, and as many as is usual of a set of points.
struct ShapeSampling {
  std::optional<std::size_t> samples{};
  std::optional<double> spacing{};  ///< along curves; of a set of points it makes no sense
  double jitter = 0.0;              ///< each sample is moved by up to so many mean spacings, in any direction
  std::uint64_t seed = 1;           ///< of jitter and of random points
  friend bool operator==(const ShapeSampling&, const ShapeSampling&) = default;
};

struct ShapeRequest {
  ShapeValues values{};
  ShapeSampling sampling{};
  friend bool operator==(const ShapeRequest&, const ShapeRequest&) = default;
};

inline constexpr std::size_t kMostShapeSamples = 10'000'000;

/// Samples with their contours, or balls. Error: `usage` for parameters that contradict each other, for a formula that
/// cannot be understood (with its place), and for a wish that makes no sense; `bad_input` for a formula whose values are
/// no numbers, and for more than `kMostShapeSamples`. Throws `Cancelled` if there is a job, which is looked at while
/// curves are sampled. Cost: O(samples), but for the Poisson disk, O(samples) on average.
Expected<SampleData> make_shape(const ShapeDescriptor& shape, const ShapeRequest& request, JobControl* job = nullptr);

/// Other curves, sampled as shapes are. Error: as `make_shape`.
Expected<SampleData> sample_curves(const CurveSet& curves, const ShapeSampling& sampling, JobControl* job = nullptr);

}  // namespace mes
