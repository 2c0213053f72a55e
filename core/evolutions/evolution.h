// SPDX-License-Identifier: GPL-3.0-or-later
// Evolutions: deterministic maps from one state to the next, shown on a slider. An evolution moves the samples, or
// changes a parameter of the computation.
//
// An evolution promises:
//  1. A step is a pure function of the state, the step's number, the seed and the parameters: it does not depend on the
//     number of threads, the order of requests, or earlier computations.
//  2. Samples keep their indices in the state's lists; new ones are appended. No sample disappears.
//  3. Samples that are not inner samples of exactly one chain, or on one loop, do not move.
//  4. All numbers are doubles at every step, whatever the number type of the structures.
//  5. If a parameter changes, its value follows from that of state 0 and the step's number; samples stay.
//
// Smallest use:
//     EvolutionStates states(state_of(document), {.evolution = registry.evolutions().find("smooth")});
//     const auto state = states.at(12, job);
//
// To add one, define `Evolution name_evolution()` in a file, and list it in core/evolutions/evolution_list.cpp.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "core/base/error.h"
#include "core/base/geometry/vec2.h"
#include "core/document/settings/parameter_values.h"
#include "core/evolutions/moving_curve.h"

namespace mes {

class Document;
class Registry;
struct Evolution;
struct ParameterMove;

/// The data that determine all states, besides the initial one.
struct EvolutionChoice {
  std::shared_ptr<const Evolution> evolution{};  ///< registry entry; null: no evolution, only state 0 exists
  std::uint64_t seed = 1;
  ParameterValues values{};
  /// Null if it moves samples, or if there is no evolution.
  const ParameterMove* moved_parameter() const;
  /// Two choices name the same evolution if the ids are equal.
  friend bool operator==(const EvolutionChoice& a, const EvolutionChoice& b);
};

/// One state. States share lists that a step does not change.
struct EvolutionState {
  std::vector<Vec2> positions;  ///< in input order
  /// Indices of the samples since the data were opened; they select the random numbers.
  std::shared_ptr<const std::vector<std::uint32_t>> numbers;
  /// Known loops, or chains that were frozen at the beginning; null: chains are computed again for each step.
  std::shared_ptr<const MovingCurve> curve;
  /// Memory that it needs in addition to `first`, with which it may share lists.
  std::size_t bytes_beside(const EvolutionState& first) const;
};

/// Input of a step in addition to the state.
struct EvolutionStep {
  std::uint64_t number = 0;  ///< number of the state that it starts from
  const EvolutionChoice& choice;
  const MovingCurve& curve;
};

struct EvolutionDescriptor {
  std::string id;          ///< public name, kebab case
  std::string name;        ///< name in a menu
  std::string tooltip;     ///< one sentence, no full stop
  bool is_random = false;  ///< the seed matters
  std::vector<Parameter> parameters{};
  std::string moves = "the samples";  ///< object of a sentence: "Show the samples"
  bool is_missing = false;            ///< placeholder for an evolution that is not registered (`missing_evolution`)
};

/// Computes the next state. Error: the step would create more samples than can be handled.
using SampleMove = std::function<Expected<EvolutionState>(const EvolutionState& state, const EvolutionStep& step)>;

struct ParameterMove {
  Parameter parameter;
  /// Value in state k; may leave the range.
  std::function<double(double first, std::uint64_t k, const ParameterValues& values)> value;
  /// The balls along the axis are replaced after each step of the factor, by those that the scale skeleton shows.
  bool renews_balls = false;
};

struct Evolution {
  EvolutionDescriptor descriptor;
  std::variant<SampleMove, ParameterMove> move;

  /// Null if it moves samples.
  const ParameterMove* moved_parameter() const { return std::get_if<ParameterMove>(&move); }
};

/// Adds the evolutions of the program, in the order of the menu.
void add_evolutions(Registry& registry);

/// Placeholder for an evolution that a file names and the registry lacks: it can be shown and saved, and has no step.
std::shared_ptr<const Evolution> missing_evolution(const std::string& id);

/// Parameters that one evolution reads.
std::vector<Parameter> parameters_of(const Evolution& evolution);
/// Parameters of several evolutions, without duplicates; shared ones come first.
std::vector<Parameter> parameters_of(std::span<const std::shared_ptr<const Evolution>> evolutions);

/// The document in the form that evolutions use; its known loops are the curve.
EvolutionState state_of(const Document& document);
/// State 0: without known loops, freezes the present chains if the choice says so. Throws `Cancelled`. Error: a
/// structure fails. This and the following functions are for evolutions that move samples.
Expected<EvolutionState> begin_evolution(EvolutionState state, const EvolutionChoice& choice, JobControl& job);
/// State `k + 1` from state `k`. Throws `Cancelled`. Error: the step is refused, a structure fails, or a coordinate
/// leaves the range of doubles.
Expected<EvolutionState> next_state(const EvolutionState& state, std::uint64_t k, const EvolutionChoice& choice,
                                    JobControl& job);

/// Value of the parameter in state k, from that in state 0. Error: outside the parameter's range.
Expected<double> moved_value(const ParameterMove& move, double first, std::uint64_t k, const ParameterValues& values);

/// The known loops of a state, by sample index; empty if its curve did not come from the document.
std::vector<SampleData::Contour> contours_of(const EvolutionState& state);

/// The data with the samples and contours of a state; annotations on samples that the state does not have are dropped.
SampleData version_of(const SampleData& data, const EvolutionState& state);

}  // namespace mes
