// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evolutions/evolution.h"

#include <fmt/core.h>
#include <algorithm>
#include <exception>

#include "core/base/assert.h"
#include "core/base/geometry/coordinate_range.h"
#include "core/document/live_corners.h"

namespace mes {
namespace {

const Parameter kFreezeChains{.id = "freeze-chains",
                              .explanation =
                                  "For documents without contours. 0: the crust of each step gives the order of the "
                                  "samples; 1: the crust of the beginning does",
                              .is_whole = true,
                              .title = "Keep the initial order",
                              .window_explanation =
                                  "For documents without contours. On: the crust of the beginning gives the order of "
                                  "the samples; off: the crust of each step does"};

std::unexpected<Error> failure(std::string text) {
  return std::unexpected(Error{ErrorCode::cannot_compute, std::move(text), {}, 0, 0});
}

Expected<std::shared_ptr<const MovingCurve>> chains_now(const std::vector<Vec2>& positions, JobControl& job) {
  try {
    return std::make_shared<const MovingCurve>(crust_curve(positions, job));
  } catch (const std::exception& error) {
    return failure(std::string("the crust failed: ") + error.what());
  }
}

}  // namespace

std::size_t EvolutionState::bytes_beside(const EvolutionState& first) const {
  std::size_t size = sizeof *this + positions.capacity() * sizeof(Vec2);
  if (numbers != first.numbers) size += numbers->capacity() * sizeof(std::uint32_t);
  if (!curve || curve == first.curve) return size;
  for (const MovingCurve::Chain& chain : curve->chains)
    size += sizeof chain + chain.points.size() * sizeof(std::uint32_t);
  return size;
}

const ParameterMove* EvolutionChoice::moved_parameter() const {
  return evolution ? evolution->moved_parameter() : nullptr;
}

bool operator==(const EvolutionChoice& a, const EvolutionChoice& b) {
  const auto id_of = [](const EvolutionChoice& choice) {
    return choice.evolution ? choice.evolution->descriptor.id : std::string();
  };
  return id_of(a) == id_of(b) && a.seed == b.seed && a.values == b.values;
}

std::shared_ptr<const Evolution> missing_evolution(const std::string& id) {
  return std::make_shared<const Evolution>(
      Evolution{{.id = id, .name = id, .tooltip = "This evolution is not available here", .is_missing = true},
                [id](const EvolutionState&, const EvolutionStep&) -> Expected<EvolutionState> {
                  return failure(fmt::format("the evolution {} is not available here", id));
                }});
}

std::vector<Parameter> parameters_of(const Evolution& evolution) {
  std::vector<Parameter> out = evolution.descriptor.parameters;
  if (evolution.moved_parameter() == nullptr) out.push_back(kFreezeChains);
  return out;
}

std::vector<Parameter> parameters_of(std::span<const std::shared_ptr<const Evolution>> evolutions) {
  std::vector<Parameter> out{kFreezeChains};
  for (const auto& evolution : evolutions)
    for (const Parameter& parameter : evolution->descriptor.parameters)
      if (std::ranges::find(out, parameter) == out.end()) out.push_back(parameter);
  return out;
}

EvolutionState state_of(const Document& document) {
  EvolutionState out;
  std::vector<std::uint32_t> numbers;
  std::vector<std::uint32_t> place(document.next_id().value - document.first_id().value, 0);
  for (const SampleSlot slot : document.slots_in_input_order()) {
    const std::uint32_t number = document.id(slot).value - document.first_id().value;
    place[number] = static_cast<std::uint32_t>(numbers.size());
    numbers.push_back(number);
    out.positions.push_back(document.position(slot));
  }
  out.numbers = std::make_shared<const std::vector<std::uint32_t>>(std::move(numbers));
  std::vector<MovingCurve::Chain> chains;
  for (const CurveOrder::Contour& contour : document.curve_order()->contours) {
    MovingCurve::Chain chain{contour.closed, {}};
    for (const SampleId id : live_corners(document, contour))
      chain.points.push_back(place[id.value - document.first_id().value]);
    if (!chain.points.empty()) chains.push_back(std::move(chain));
  }
  if (!chains.empty())
    out.curve = std::make_shared<const MovingCurve>(known_curve(std::move(chains), out.positions.size()));
  return out;
}

Expected<EvolutionState> begin_evolution(EvolutionState state, const EvolutionChoice& choice, JobControl& job) {
  if (state.curve || !choice.values.is_on(kFreezeChains)) return state;
  auto curve = chains_now(state.positions, job);
  if (!curve) return std::unexpected(curve.error());
  state.curve = std::move(*curve);
  return state;
}

Expected<EvolutionState> next_state(const EvolutionState& state, std::uint64_t k, const EvolutionChoice& choice,
                                    JobControl& job) {
  MES_ASSERT(choice.evolution != nullptr);
  auto curve = state.curve;
  if (!curve) {
    auto found = chains_now(state.positions, job);
    if (!found) return std::unexpected(found.error());
    curve = std::move(*found);
  }
  job.checkpoint();
  auto next = std::get<SampleMove>(choice.evolution->move)(state, {k, choice, *curve});
  if (!next) return next;
  // Sums that are zero up to rounding become zero. Equal points get equal bits, as in a document.
  Magnitudes all;
  for (const Vec2 p : next->positions) for_each_number(p, [&all](double x) { all.add(x); });
  for (Vec2& p : next->positions) p = {without_traces(p.x, all.most) + 0.0, without_traces(p.y, all.most) + 0.0};
  std::string fault;
  for (const Vec2 p : next->positions)
    for_each_number(p, [&fault](double x) {
      if (const auto found = range_fault_of(x); found && fault.empty()) fault = describe(*found, x);
    });
  if (!fault.empty()) return failure(fmt::format("step {} leaves the range of coordinates: {}", k + 1, fault));
  return next;
}

Expected<double> moved_value(const ParameterMove& move, double first, std::uint64_t k,
                             const ParameterValues& values) {
  const double value = move.value(first, k, values);
  const Parameter& parameter = move.parameter;
  if (parameter.low <= value && value <= parameter.high) return value;
  return failure(fmt::format("{} ends at {:.6g}, so there is no step {}", parameter.id,
                             value < parameter.low ? parameter.low : parameter.high, k));
}

std::vector<SampleData::Contour> contours_of(const EvolutionState& state) {
  return state.curve && state.curve->is_known ? state.curve->chains : std::vector<SampleData::Contour>();
}

SampleData version_of(const SampleData& data, const EvolutionState& state) {
  SampleData out = data;
  out.positions = state.positions;
  out.contours = contours_of(state);
  out.source.reset();
  const auto is_gone = [&state](std::uint32_t sample) { return sample >= state.positions.size(); };
  const auto is_without_sample = [&](const Anchor& anchor) { return std::ranges::any_of(anchor.samples, is_gone); };
  std::erase_if(out.annotations, [&](Annotation& annotation) {
    return lose_elements(annotation, is_without_sample) || std::ranges::any_of(annotation.anchors, is_without_sample);
  });
  return out;
}

}  // namespace mes
