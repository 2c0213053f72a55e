// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evolutions/evolution.h"

#include <fmt/core.h>
#include <algorithm>
#include <exception>

#include "core/base/assert.h"
#include "core/base/coordinate_range.h"
#include "core/document/live_corners.h"

namespace mes {
namespace {

constexpr ParameterDescriptor kFreezeChains{
    .id = "freeze-chains",
    .explanation =
        "Where the document has no contours. 0: the crust says at each step who follows whom; 1: the crust "
        "of the beginning does",
    .is_whole = true,
    .title = "Keep the order of the beginning",
    .window_explanation =
        "Where the document has no contours. On: the crust of the beginning says who follows whom; "
        "off: the crust of each step does"};

std::unexpected<Error> failure(std::string text) {
  return std::unexpected(Error{ErrorCode::cannot_compute, std::move(text), {}, 0, 0});
}

std::size_t index_of(std::string_view id) {
  const auto all = evolution_parameters();
  const auto found = std::ranges::find(all, id, &ParameterDescriptor::id);
  MES_ASSERT(found != all.end());
  return static_cast<std::size_t>(found - all.begin());
}

Expected<std::shared_ptr<const MovingCurve>> chains_now(const std::vector<Vec2>& positions, JobControl& job) {
  try {
    return std::make_shared<const MovingCurve>(crust_curve(positions, job));
  } catch (const std::exception& error) {
    return failure(std::string("the crust failed: ") + error.what());
  }
}

}  // namespace

EvolutionValues::EvolutionValues() {
  for (const ParameterDescriptor& parameter : evolution_parameters()) values_.push_back(parameter.default_value);
}
double EvolutionValues::operator[](std::string_view id) const {
  return values_[index_of(id)];
}
void EvolutionValues::set(std::string_view id, double value) {
  values_[index_of(id)] = value;
}

std::size_t EvolutionState::bytes_beside(const EvolutionState& first) const {
  std::size_t size = sizeof *this + positions.capacity() * sizeof(Vec2);
  if (numbers != first.numbers) size += numbers->capacity() * sizeof(std::uint32_t);
  if (!curve || curve == first.curve) return size;
  for (const MovingCurve::Chain& chain : curve->chains)
    size += sizeof chain + chain.points.size() * sizeof(std::uint32_t);
  return size;
}

std::optional<EvolutionIndex> find_evolution(std::string_view id) {
  for (EvolutionIndex i = 0; i < evolutions().size(); ++i)
    if (evolutions()[i].descriptor.id == id) return i;
  return std::nullopt;
}

std::span<const ParameterDescriptor> evolution_parameters() {
  static const std::vector<ParameterDescriptor> all = [] {
    std::vector<ParameterDescriptor> out{kFreezeChains};
    for (const Evolution& evolution : evolutions())
      for (const ParameterDescriptor& parameter : evolution.descriptor.parameters)
        if (std::ranges::find(out, parameter.id, &ParameterDescriptor::id) == out.end()) out.push_back(parameter);
    return out;
  }();
  return all;
}

std::vector<ParameterDescriptor> parameters_of(EvolutionIndex evolution) {
  std::vector<ParameterDescriptor> out = evolutions()[evolution].descriptor.parameters;
  if (evolutions()[evolution].moved_parameter() == nullptr) out.push_back(kFreezeChains);
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
  if (state.curve || choice.values[kFreezeChains.id] == 0.0) return state;
  auto curve = chains_now(state.positions, job);
  if (!curve) return std::unexpected(curve.error());
  state.curve = std::move(*curve);
  return state;
}

Expected<EvolutionState> next_state(const EvolutionState& state, std::uint64_t k, const EvolutionChoice& choice,
                                    JobControl& job) {
  auto curve = state.curve;
  if (!curve) {
    auto found = chains_now(state.positions, job);
    if (!found) return std::unexpected(found.error());
    curve = std::move(*found);
  }
  job.checkpoint();
  auto next = std::get<SampleMove>(evolutions()[choice.evolution].move)(state, {k, choice, *curve});
  if (!next) return next;
  // Traces that rounding leaves where a sum is zero are none. Equal points have equal bits, as in a document.
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
                             const EvolutionValues& values) {
  const double value = move.value(first, k, values);
  const ParameterDescriptor& parameter = descriptor_of(move.parameter);
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
