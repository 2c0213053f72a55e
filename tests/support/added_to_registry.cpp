// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/added_to_registry.h"

#include <memory>

#include "core/builtins/builtins.h"
#include "core/evolutions/evolution.h"
#include "core/graph/layer.h"
#include "core/shapes/shape.h"
#include "core/structures/inputs/samples.h"
#include "core/structures/inputs/settings_source.h"

namespace mes::test {

const Parameter kDoublingFactor{.id = "doubling-factor",
                                .explanation = "Doubled points are so many times as far from the origin",
                                .low = 0.0,
                                .high = 10.0,
                                .default_value = 2.0,
                                .title = "Doubling factor"};
const Parameter kDoublingTimes{.id = "doubling-times",
                               .explanation = "A step moves samples so many times as far from the origin",
                               .low = 1.0,
                               .high = 10.0,
                               .default_value = 2.0};

namespace {

class DoubledSamples final : public Structure {
 public:
  DoubledSamples(Samples& samples, SettingsSource& settings)
      : Structure("doubled-samples", {&samples, &settings}), samples_(samples), settings_(settings) {}

  void rebuild(JobControl&) override { factor_ = settings_.current()[kDoublingFactor]; }
  bool update(JobControl&) override { return false; }
  void clear_changes() override {}
  std::size_t touched() const override { return 0; }
  StatList statistics() const override { return {{"factor", factor_}}; }
  const Samples& samples() const { return samples_; }
  Vec2 position(SampleSlot slot) const { return factor_ * samples_.position(slot); }

 private:
  Samples& samples_;
  SettingsSource& settings_;
  double factor_ = 0.0;
};

Layer make_doubled_points_layer(const StructureSet& set) {
  const auto& samples = set.get<Samples>();
  const auto& doubled = set.get<DoubledSamples>();
  // Assigned member by member: if an allocation inside nested braces fails, GCC 12 destroys the first members twice.
  Layer layer;
  layer.descriptor = {.id = "doubled-points", .name = "Doubled points", .kinds = {PrimitiveKind::point}};
  layer.descriptor.tooltip = "Each sample, farther from the origin";
  layer.structures = {&samples, &doubled};
  layer.parts.push_back(table_part(
      {PrimitiveKind::point}, [&samples] { return samples.row_count(); }, samples.changes(),
      [&](SampleSlot row, Instance& out) {
        if (samples.is_alive(row)) out.point(doubled.position(row));
      }));
  return layer;
}

Expected<EvolutionState> doubled_state(const EvolutionState& state, const EvolutionStep& step) {
  EvolutionState out = state;
  for (Vec2& position : out.positions) position = step.choice.values[kDoublingTimes] * position;
  return out;
}

Expected<MadeShape> made_square(const ShapeArguments& arguments) {
  const double side = arguments.numbers.front();
  PlaneCurve square({0.0, 0.0});
  for (const Vec2 corner : {Vec2{side, 0.0}, Vec2{side, side}, Vec2{0.0, side}}) square.line_to(corner);
  square.close();
  MadeShape out;
  out.curves.curves.push_back(std::move(square));
  return out;
}

void add_doubled_points(Registry& registry) {
  registry.add_parameter(kDoublingFactor);
  registry.add_structure<DoubledSamples, Samples, SettingsSource>();
  registry.add_layer(make_doubled_points_layer);
}

}  // namespace

void add_additions(Registry& registry) {
  add_doubled_points(registry);
  registry.evolutions().add("doubling", std::make_shared<const Evolution>(
                                            Evolution{.descriptor = {.id = "doubling",
                                                                     .name = "Doubling",
                                                                     .tooltip = "Moves samples away from the origin",
                                                                     .parameters = {kDoublingTimes}},
                                                      .move = SampleMove(doubled_state)}));
  registry.shapes().add(
      "test-square",
      std::make_shared<const ShapeDescriptor>(ShapeDescriptor{
          .id = "test-square",
          .name = "Test square",
          .explanation = "A square at the origin",
          .parameters =
              {{.id = "side", .explanation = "Length of its sides", .low = 0.1, .high = 100.0, .default_value = 1.0}},
          .formulas = {},
          .make = made_square}));
}

void remove_additions(Registry& registry) {
  registry.remove_structure("doubled-samples");
  registry.remove_parameter(kDoublingFactor.id);
  registry.evolutions().remove("doubling");
  registry.shapes().remove("test-square");
}

const Registry& registry_with_additions() {
  static const Registry registry = [] {
    Registry out;
    add_builtins(out);
    add_additions(out);
    return out;
  }();
  return registry;
}

const Registry& registry_of_one_layer() {
  static const Registry registry = [] {
    Registry out;
    out.add_structure<Samples>();
    out.add_structure<SettingsSource>();
    add_doubled_points(out);
    return out;
  }();
  return registry;
}

}  // namespace mes::test
