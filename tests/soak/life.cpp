// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/soak/life.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/builtins/builtins.h"
#include "core/evolutions/evolution.h"
#include "tests/support/builtin_layers.h"

namespace mes::test {
namespace {

constexpr double kTurn = 6.283185307179586;

bool is_costly(const LayerDescriptor& layer) {
  return std::ranges::any_of(layer.structures,
                             [](std::string_view id) { return id.ends_with("precision-difference"); });
}

}  // namespace

Life::Life(std::uint64_t seed)
    : rng_(seed),
      source_(static_cast<Source>(seed % 6)),
      is_exact_(seed / 6 % 8 == 7),
      most_(is_exact_ ? 12 : 16 + rng_.below(40)),
      editor_([this](std::shared_ptr<const DocumentDelta> delta) { consumer_.graph.post(std::move(delta)); }) {
  SampleData data;
  const std::size_t samples = source_ == Source::balls ? rng_.below(6) : most_ / 2;
  for (std::size_t i = 0; i < samples; ++i) data.positions.push_back(place());
  if (rng_.below(2) == 0 && samples > 5) data.contours = {{true, {0, 1, 2, 3, 4}}};
  const std::size_t balls = source_ == Source::balls ? most_ / 2 : rng_.below(4);
  for (std::size_t i = 0; i < balls; ++i) data.balls.push_back(disk());
  static_cast<void>(editor_.load(data));
  choose_layers();
  consumer_.run();
}

Vec2 Life::place() {
  const double t = kTurn * rng_.uniform();
  const auto whole = [this](std::uint64_t count) { return static_cast<double>(rng_.below(count)); };
  switch (source_) {
    case Source::curve:
    case Source::noise: {
      const double width = source_ == Source::curve ? 0.0 : 12.0;
      const double r = 100.0 * (1.0 + 0.3 * std::cos(5.0 * t)) + width * rng_.uniform();
      return {r * std::cos(t), r * std::sin(t)};
    }
    case Source::grid: return {whole(8), whole(8)};
    case Source::circle:
      // Twelve exactly cocircular places, and their images in a grid.
      return std::array<Vec2, 12>{{{5, 0},
                                   {4, 3},
                                   {3, 4},
                                   {0, 5},
                                   {-3, 4},
                                   {-4, 3},
                                   {-5, 0},
                                   {-4, -3},
                                   {-3, -4},
                                   {0, -5},
                                   {3, -4},
                                   {4, -3}}}[rng_.below(12)] +
             Vec2{10.0 * whole(3), 10.0 * whole(2)};
    case Source::square:
    case Source::balls: break;
  }
  return {100.0 * rng_.uniform(), 100.0 * rng_.uniform()};
}

Disk Life::disk() {
  const bool is_whole = source_ == Source::grid || source_ == Source::circle;
  if (is_whole) return {place(), static_cast<double>(rng_.below(4))};
  return {place(), rng_.below(8) == 0 ? 0.0 : 30.0 * rng_.uniform()};
}

SampleId Life::some_sample() {
  const auto slots = editor_.document().slots_in_input_order();
  return editor_.document().id(slots[rng_.below(slots.size())]);
}

void Life::show(std::vector<LayerIndex> layers) {
  LayerConfiguration now;
  for (LayerIndex layer = 0; layer < layer_descriptors().size(); ++layer)
    now.layers.push_back({std::string(layer_descriptors()[layer].id), std::ranges::count(layers, layer) != 0,
                          layer_descriptors()[layer].style});
  editor_.note(difference(configuration_, now));
  configuration_ = std::move(now);
  shown_ = std::move(layers);
  consumer_.graph.set_demand(shown_);
}

void Life::choose_layers() {
  const std::uint64_t most = 1 + rng_.below(20);
  std::vector<LayerIndex> layers;
  for (LayerIndex layer = 0; layer < layer_descriptors().size(); ++layer)
    if (rng_.below(layer_descriptors().size()) < most && (is_exact_ || !is_costly(layer_descriptors()[layer])))
      layers.push_back(layer);
  show(std::move(layers));
}

void Life::choose_settings() {
  if (is_exact_) settings_.precision = rng_.below(2) == 0 ? Precision::fast : Precision::exact;
  settings_[Parameter::union_shortcut] = static_cast<double>(rng_.below(2));
  settings_[Parameter::pole_propagation] = static_cast<double>(rng_.below(2));
  settings_[Parameter::medial_sampling_angle] = rng_.below(2) == 0 ? 120.0 : 150.0;
  for (const Parameter& scale : {Parameter::a_scale, Parameter::p_scale, Parameter::b_scale})
    settings_[scale] = is_exact_ ? 1.0 : std::array{1.0, 1.0, 0.5, 1.1}[rng_.below(4)];  // roots take minutes
  settings_[Parameter::scale_axis_factor] = is_exact_ ? 1.0 : std::array{1.0, 0.7, 1.1, 1.5}[rng_.below(4)];
  settings_[Parameter::scale_skeleton_step] = rng_.below(2) == 0 ? 10.0 : 30.0;
  settings_[Parameter::lambda_limit] = std::array{0.0, 0.5, 5.0}[rng_.below(3)];
  settings_[Parameter::alpha_radius] = std::array{0.0, 0.5, 2.0, 50.0}[rng_.below(4)];
  settings_[Parameter::angle_limit] = std::array{0.0, 30.0, 45.0, 80.0}[rng_.below(4)];
  settings_[Parameter::angle_mode] = static_cast<double>(rng_.below(3));
  settings_[Parameter::keep_topology] = static_cast<double>(rng_.below(2));
  editor_.note(SettingsChanged{settings_});
  consumer_.graph.post_settings(settings_);
}

// One sample, or all about it.
void Life::drag() {
  const Document& document = editor_.document();
  const SampleId id = some_sample();
  std::vector<SampleId> held{id};
  if (rng_.below(3) == 0) {
    const Vec2 middle = document.position(document.slot_of(id));
    const double reach = distance(middle, place());
    for (const SampleSlot slot : document.slots_in_input_order())
      if (document.id(slot) != id && distance(document.position(slot), middle) < reach)
        held.push_back(document.id(slot));
  }
  editor_.begin_gesture("Move");
  for (std::uint64_t i = 1 + rng_.below(5); i != 0; --i) {
    const Vec2 p = document.position(document.slot_of(id));
    const Vec2 way = rng_.below(4) == 0 ? place() - p : Vec2{rng_.uniform(-1.0, 1.0), rng_.uniform(-1.0, 1.0)};
    std::vector<std::pair<SampleId, Vec2>> targets;
    for (const SampleId each : held) targets.emplace_back(each, document.position(document.slot_of(each)) + way);
    static_cast<void>(editor_.move(targets, "Move"));
    if (rng_.below(2) == 0) consumer_.run();
  }
  if (rng_.below(5) == 0)
    editor_.cancel_gesture();
  else
    editor_.end_gesture();
}

void Life::change_balls() {
  const Document& document = editor_.document();
  const auto slots = document.ball_slots_in_input_order();
  const std::uint64_t action = slots.size() < 2 ? 0 : rng_.below(3);
  if (action == 0 && slots.size() < most_) {
    static_cast<void>(editor_.insert_balls(std::array{disk()}, "Ball"));
    return;
  }
  const BallId id = document.ball_id(slots[rng_.below(slots.size())]);
  if (action == 1)
    static_cast<void>(editor_.move({}, std::array{std::pair{id, disk()}}, "Ball"));
  else
    static_cast<void>(editor_.remove({}, std::array{id}, "Ball"));
}

// A few states of one evolution, each in the place of the one before.
void Life::evolve() {
  if (editor_.document().sample_count() > most_ || editor_.document().sample_count() == 0) return;
  std::vector<std::shared_ptr<const Evolution>> moving;
  for (const auto& evolution : builtins().evolutions().all())
    if (evolution->moved_parameter() == nullptr) moving.push_back(evolution);
  const EvolutionChoice choice{.evolution = moving[rng_.below(moving.size())], .seed = rng_.below(1000)};
  JobControl job;
  auto state = begin_evolution(state_of(editor_.document()), choice, job);
  const std::uint64_t steps = 1 + rng_.below(3);
  for (std::uint64_t k = 0; state && k < steps; ++k) {
    state = next_state(*state, k, choice, job);
    if (!state || state->positions.size() > 2 * most_) return;
    static_cast<void>(editor_.evolve(state->positions, contours_of(*state), "Evolve"));
    if (rng_.below(2) == 0) consumer_.run();
  }
}

void Life::edit() {
  const std::size_t count = editor_.document().sample_count();
  switch (rng_.below(24)) {
    case 0:
    case 1:
    case 2:
    case 3:
      if (count >= most_) break;
      static_cast<void>(editor_.insert(std::array{place()}, "Insert"));
      return;
    case 4:
      if (count >= most_) break;
      static_cast<void>(editor_.insert(std::array{place(), place(), place()}, "Insert"));
      return;
    case 5:
    case 6:
    case 7:
      if (count == 0) break;
      static_cast<void>(editor_.move(std::array{std::pair{some_sample(), place()}}, "Move"));
      return;
    case 8:
    case 9:
      if (count == 0) break;
      return drag();
    case 10:
    case 11:
    case 12:
    case 13: return change_balls();
    case 14:
    case 15:
      for (std::uint64_t i = 1 + rng_.below(6); i != 0; --i) editor_.undo();
      return;
    case 16:
      for (std::uint64_t i = 1 + rng_.below(6); i != 0; --i) editor_.redo();
      return;
    case 17: return choose_layers();
    case 18: return choose_settings();
    case 19: return evolve();
    case 20: consumer_.graph.set_want_findings(rng_.below(2) == 0); return;
    case 21: consumer_.graph.set_want_statistics(rng_.below(8) == 0); return;
    default: break;
  }
  if (count != 0) static_cast<void>(editor_.remove(std::array{some_sample()}, "Remove"));
}

void Life::step() {
  edit();
  switch (rng_.below(4)) {
    case 0: break;  // the next edit comes before the picture
    case 1: consumer_.run(static_cast<std::int64_t>(1 + rng_.below(1 + rng_.below(60)))); break;
    default: consumer_.run(); break;
  }
}

std::string Life::check() {
  if (!consumer_.run()) return "a run that nothing stops is not complete";
  return difference_from_fresh(consumer_, editor_.document(), settings_, shown_);
}

Session Life::session() const {
  Session out;
  out.title = "soak";
  out.data = editor_.timeline().data();
  out.entries = editor_.timeline().entries();
  out.layers = configuration_;
  out.settings = settings_;
  return out;
}

}  // namespace mes::test
