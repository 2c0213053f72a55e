// SPDX-License-Identifier: GPL-3.0-or-later
// Evolutions: deterministic maps from one state to the next, shown on a slider. An evolution moves the samples, or it
// moves a parameter of the computation.
//
// What an evolution promises:
//  1. A step is a pure function of the state, the step's number, the seed and the parameters: the same on any number
//     of threads, in whatever order steps are asked for, and whatever was computed before.
//  2. Samples keep their places in the state's lists; new ones follow at the end. None disappears.
//  3. Samples that are not inner samples of one chain, or on one loop, stay where they are.
//  4. All numbers are doubles at every step, whatever the number type of the structures.
//  5. Where a parameter moves, its value follows from that of state 0 and the step's number; samples stay.
//
// Smallest use:
//     EvolutionStates states(state_of(document), {.evolution = registry.evolutions().find("smooth")});
//     const auto state = states.at(12, job);
//
// A new one: a file with `Evolution name_evolution()`, which core/evolutions/evolution_list.cpp adds to the registry.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "core/base/error.h"
#include "core/base/vec2.h"
#include "core/document/document.h"
#include "core/document/parameter_values.h"
#include "core/evolutions/moving_curve.h"

namespace mes {

class Registry;
struct Evolution;
struct ParameterMove;

/// What the states depend on beside the beginning.
struct EvolutionChoice {
  std::shared_ptr<const Evolution> evolution{};  ///< of a registry; null: none, which has no state but the first
  std::uint64_t seed = 1;
  ParameterValues values{};
  /// Null: it moves samples, or there is none.
  const ParameterMove* moved_parameter() const;
  /// Two choices name the same evolution if the ids are equal.
  friend bool operator==(const EvolutionChoice& a, const EvolutionChoice& b);
};

/// One state. Lists that a step does not change are shared between states.
struct EvolutionState {
  std::vector<Vec2> positions;  ///< in input order
  /// Numbers of the samples since the data were opened: what random numbers are drawn by.
  std::shared_ptr<const std::vector<std::uint32_t>> numbers;
  /// Known loops, or chains that were frozen at the beginning; null: chains are found anew at each step.
  std::shared_ptr<const MovingCurve> curve;
  /// What it takes in memory beside `first`, with which it may share lists.
  std::size_t bytes_beside(const EvolutionState& first) const;
};

/// What a step is given beside the state.
struct EvolutionStep {
  std::uint64_t number = 0;  ///< of the state it starts from
  const EvolutionChoice& choice;
  const MovingCurve& curve;
};

struct EvolutionDescriptor {
  std::string id;          ///< public name, kebab case
  std::string name;        ///< as in a menu
  std::string tooltip;     ///< one sentence, no full stop
  bool is_random = false;  ///< the seed matters
  std::vector<Parameter> parameters{};
  std::string moves = "the samples";  ///< as in "Show the samples"
  bool is_missing = false;            ///< it stands for one that is not here (`missing_evolution`)
};

/// The next state. Error: the step would make more than can be handled.
using SampleMove = std::function<Expected<EvolutionState>(const EvolutionState& state, const EvolutionStep& step)>;

struct ParameterMove {
  Parameter parameter;
  /// In state k; may leave the range.
  std::function<double(double first, std::uint64_t k, const ParameterValues& values)> value;
  /// The balls along the axis are taken anew after each step of the factor, as the scale skeleton shows.
  bool renews_balls = false;
};

struct Evolution {
  EvolutionDescriptor descriptor;
  std::variant<SampleMove, ParameterMove> move;

  /// Null: it moves samples.
  const ParameterMove* moved_parameter() const { return std::get_if<ParameterMove>(&move); }
};

/// Adds the evolutions of the program in the order in which they are offered.
void add_evolutions(Registry& registry);

/// Stands for an evolution that a file names and the registry lacks: it can be shown and saved, and has no step.
std::shared_ptr<const Evolution> missing_evolution(const std::string& id);

/// Parameters that one evolution reads.
std::vector<Parameter> parameters_of(const Evolution& evolution);
/// Parameters of several evolutions, each once; those that several share come first.
std::vector<Parameter> parameters_of(std::span<const std::shared_ptr<const Evolution>> evolutions);

/// The document as an evolution sees it; its known loops are the curve.
EvolutionState state_of(const Document& document);
/// State 0: where no loops are known, the chains of now are frozen if the choice says so. Throws `Cancelled`. Error:
/// a structure fails. From here on, for evolutions that move samples.
Expected<EvolutionState> begin_evolution(EvolutionState state, const EvolutionChoice& choice, JobControl& job);
/// State `k + 1` from state `k`. Throws `Cancelled`. Error: the step is refused, a structure fails, or a coordinate
/// leaves the range of doubles.
Expected<EvolutionState> next_state(const EvolutionState& state, std::uint64_t k, const EvolutionChoice& choice,
                                    JobControl& job);

/// Value of the parameter in state k, from that in state 0. Error: beyond the parameter's range.
Expected<double> moved_value(const ParameterMove& move, double first, std::uint64_t k, const ParameterValues& values);

/// The known loops of a state, by places; none where its curve did not come from the document.
std::vector<SampleData::Contour> contours_of(const EvolutionState& state);

/// The data with their samples and contours as they are in a state; annotations that follow samples that the state does
/// not have are left out.
SampleData version_of(const SampleData& data, const EvolutionState& state);

}  // namespace mes
