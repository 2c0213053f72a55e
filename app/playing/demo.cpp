// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/playing/demo.h"

#include <fmt/core.h>
#include <algorithm>
#include <initializer_list>
#include <string_view>
#include <utility>

#include "app/layers/layer_stack.h"
#include "core/base/jobs/job_control.h"
#include "core/evolutions/evolution_states.h"
#include "core/graph/registry.h"

namespace mes {
namespace {

constexpr std::size_t kStrokes = 24;       // strokes in which the samples appear
constexpr std::uint64_t kSmoothings = 40;  // steps of the last scene
constexpr double kNoise = 0.22;  // times the distance of both neighbours: spurious branches, but the curve is found
constexpr double kRead = 3.0;    // reading time of a caption in seconds

/// Writes the script of a session, and keeps the document as of its present point.
class Script {
 public:
  Script(const Registry& registry, const SampleData& data) : registry_(registry), layers_(registry.layers()) {
    session_.title = "Demo";
    session_.lesson.title = kDemoTitle;
    session_.data = std::make_shared<const SampleData>(data);
    // Replaying an empty timeline cannot fail.
    static_cast<void>(replay_.begin(data));
  }

  void look_at(const Box2& box) { note(ViewChanged{box}); }

  /// Shows exactly these layers, bottom first.
  void show(std::initializer_list<std::string_view> ids) {
    LayerStack layers = layers_;
    for (const LayerIndex layer : layers_.order()) layers.set_visible(layer, false);
    LayerIndex below = kNoLayer;
    for (const std::string_view id : ids) {
      const LayerIndex layer = layers_.find(id);
      if (layer == kNoLayer) continue;
      layers.set_visible(layer, true);
      if (below != kNoLayer) layers.move(layer, below, true);
      below = layer;
    }
    change(std::move(layers));
  }

  template <class Change>
  void style(std::string_view id, Change with) {
    LayerStack layers = layers_;
    const LayerIndex layer = layers_.find(id);
    if (layer == kNoLayer) return;
    LayerStyle style = layers.style(layer);
    with(style);
    layers.set_style(layer, style);
    change(std::move(layers));
  }

  void compute_in(Precision precision, bool with_shortcut) {
    settings_.precision = precision;
    settings_[Parameter::union_shortcut] = with_shortcut ? 1.0 : 0.0;
    note(SettingsChanged{settings_});
  }

  void say(std::string text, double seconds = kRead) { note(Captioned{std::move(text), seconds}); }

  /// Makes everything shown so far a step of the lesson.
  void mark(std::string_view heading, std::string_view words) {
    session_.lesson.steps.push_back(
        {.caption = fmt::format("# {}\n{}", heading, words), .position = session_.entries.size()});
  }

  Expected<void> edit(TimelineEdit edit) {
    if (auto done = replay_.apply(edit); !done) return done;
    note(std::move(edit));
    return {};
  }

  /// Takes one step after the other, with a caption for each.
  template <class Words>
  Expected<void> evolve(EvolutionChoice choice, std::uint64_t steps, Words words) {
    EvolutionStates states(state_of(replay_.document()), choice);
    JobControl job;
    for (std::uint64_t k = 1; k <= steps; ++k) {
      const auto state = states.at(k, job);
      if (!state) return std::unexpected(state.error());
      TimelineEdit moves{.name = choice.evolution->descriptor.name};
      for (std::size_t i = 0; i < (*state)->positions.size(); ++i)
        moves.moved.emplace_back((*(*state)->numbers)[i], (*state)->positions[i]);
      if (const std::string text = words(k); !text.empty()) say(text, 0.0);
      if (auto done = edit(std::move(moves)); !done) return done;
    }
    return {};
  }

  /// A missing evolution refuses each step.
  std::shared_ptr<const Evolution> evolution(const std::string& id) const {
    auto found = registry_.evolutions().find(id);
    return found ? found : missing_evolution(id);
  }

  Session finish() && {
    session_.layers = layers_.configuration();
    session_.settings = settings_;
    return std::move(session_);
  }

 private:
  template <class Entry>
  void note(Entry entry) {
    session_.entries.emplace_back(std::move(entry));
  }
  void change(LayerStack layers) {
    const LayerConfiguration before = has_noted_layers_ ? layers_.configuration() : LayerConfiguration{};
    LayersChanged changed = difference(before, layers.configuration());
    layers_ = std::move(layers);
    has_noted_layers_ = true;
    if (!changed.is_empty()) note(std::move(changed));
  }

  const Registry& registry_;
  Session session_;
  DocumentReplay replay_;
  LayerStack layers_;
  ComputationSettings settings_;
  bool has_noted_layers_ = false;
};

// The samples in the order in which a pen would draw them.
std::vector<std::uint32_t> pen_order(const SampleData& shape) {
  std::vector<std::uint32_t> out;
  for (const SampleData::Contour& contour : shape.contours)
    out.insert(out.end(), contour.points.begin(), contour.points.end());
  return out;
}

void set_styles(Script& script) {
  script.style("points", [](LayerStyle& style) { style.point_size_px = 3.5; });
  script.style("voronoi", [](LayerStyle& style) { style.opacity = 0.55; });
  script.style("delaunay", [](LayerStyle& style) { style.opacity = 0.7; });
  script.style("medial-axis", [](LayerStyle& style) { style.line_width_px = 3.0; });
  script.style("a-ball-medial-axis", [](LayerStyle& style) {
    style.color = palette::black;
    style.line_width_px = 1.5;
  });
}

Expected<void> sample_the_curve(Script& script, const SampleData& shape, const std::vector<std::uint32_t>& order) {
  script.say("A curve is known only by samples on it", 2.0);
  for (std::size_t stroke = 0; stroke < kStrokes; ++stroke) {
    const std::size_t begin = stroke * order.size() / kStrokes;
    const std::size_t end = (stroke + 1) * order.size() / kStrokes;
    TimelineEdit edit{.name = "Spray samples"};
    for (std::size_t i = begin; i < end; ++i) edit.inserted.push_back(shape.positions[order[i]]);
    if (stroke + 1 == kStrokes) {
      // The order along the curve, by the present indices of the samples.
      std::uint32_t next = 0;
      auto& curve = edit.curve.emplace();
      for (const SampleData::Contour& contour : shape.contours) {
        SampleData::Contour& to = curve.emplace_back(SampleData::Contour{contour.closed, {}});
        for (std::size_t i = 0; i < contour.points.size(); ++i) to.points.push_back(next++);
      }
    }
    if (auto done = script.edit(std::move(edit)); !done) return done;
  }
  script.mark("A sampled curve", "The curve is known only by the samples $P$ on it.");
  return {};
}

/// Shows these layers with a caption, and marks a step.
void show_scene(Script& script, std::string_view heading, const std::string& words,
                std::initializer_list<std::string_view> layers) {
  script.say(words, 0.0);
  script.show(layers);
  script.say(words);
  script.mark(heading, words);
}

void take_the_short_way(Script& script) {
  show_scene(script, "Voronoi diagram", "The Voronoi diagram of the samples ...", {"voronoi", "points"});
  show_scene(script, "Crust", "... and its dual, the Delaunay triangulation, which contains the curve: the crust",
             {"delaunay", "curve", "points"});
  show_scene(script, "Inner Voronoi balls",
             "Voronoi vertices inside the curve are the centres of the inner Voronoi balls",
             {"interior-voronoi-disks", "interior-voronoi-circles", "curve", "interior-voronoi-vertices", "points"});
  show_scene(script, "One step more", "One step more: Voronoi edges between them are the medial axis of their union",
             {"interior-voronoi-disks", "curve", "medial-axis", "points"});
}

void take_the_general_way(Script& script) {
  script.compute_in(Precision::exact, true);
  show_scene(script, "The general way", "The general way knows nothing but the balls",
             {"a-inner-disks", "a-inner-circles", "a-inner-centers"});
  show_scene(script, "Regular triangulation", "Their regular triangulation, the dual of the power diagram",
             {"a-inner-disks", "a-ball-triangulation"});
  show_scene(
      script, "Dual complex", "What of it the union covers: the dual complex",
      {"a-inner-disks", "a-dual-faces", "a-dual-interior-edges", "a-dual-regular-edges", "a-dual-singular-edges"});
  show_scene(script, "V-points", "Points where circles cross on the boundary of the union: the v-points",
             {"a-inner-disks", "a-union-boundary", "a-dual-singular-edges", "a-v-points"});
  show_scene(script, "Voronoi diagram of the v-points", "The Voronoi diagram of the v-points ...",
             {"a-inner-disks", "a-v-voronoi", "a-v-points"});
  show_scene(script, "The axis, the general way", "... cut by the dual complex: the medial axis, the general way",
             {"a-inner-disks", "a-ball-medial-axis", "a-v-points"});
}

void compare_the_numbers(Script& script) {
  const std::string lost = "The same in plain doubles: v-points are lost and found, and the axis with them";
  script.say(lost, 0.0);
  script.compute_in(Precision::naive, false);
  script.say(lost, 4.0);
  script.mark("Plain doubles", lost);
  const std::string naive = "Edges of the dual complex that doubles miss, invent or misjudge";
  script.say(naive, 0.0);
  script.show({"a-inner-disks", "precision-difference"});
  script.say(naive, 4.0);
  script.mark("What doubles get wrong", naive);
  const std::string exact = "In exact numbers nothing differs, and both ways give the same axis";
  script.say(exact, 0.0);
  script.compute_in(Precision::exact, true);
  script.say(exact);
  script.style("medial-axis", [](LayerStyle& style) { style.line_width_px = 6.0; });
  script.show({"a-inner-disks", "curve", "medial-axis", "a-ball-medial-axis", "axis-difference"});
  script.say(exact, 4.0);
  script.mark("Exact numbers", exact);
  script.style("medial-axis", [](LayerStyle& style) { style.line_width_px = 3.0; });
  script.compute_in(Precision::fast, true);
}

Expected<void> smooth_noise(Script& script) {
  script.show({"interior-voronoi-disks", "curve", "medial-axis", "points"});
  const std::string noisy = "A little noise on the samples, and the axis grows hairs";
  script.say(noisy, 1.0);
  EvolutionChoice noise{.evolution = script.evolution("noise")};
  noise.values.keep("noise-factor", kNoise);
  if (auto done = script.evolve(noise, 1, [&](std::uint64_t) { return noisy; }); !done) return done;
  script.say(noisy, 4.0);
  script.mark("Noise", noisy);
  const EvolutionChoice smooth{.evolution = script.evolution("smooth")};
  auto done = script.evolve(smooth, kSmoothings, [](std::uint64_t k) {
    return fmt::format("Laplacian smoothing, step {}: the hairs go, what is essential stays", k);
  });
  if (!done) return done;
  script.mark("Smoothing", fmt::format("After {} steps of Laplacian smoothing the hairs are gone; what is essential "
                                       "stays.",
                                       kSmoothings));
  script.say("Mesecina: sample-based geometry, live", 4.0);
  return {};
}

}  // namespace

Expected<Session> demo_session(const Registry& registry, const SampleData& shape) {
  const std::vector<std::uint32_t> order = pen_order(shape);
  if (order.empty()) return std::unexpected(Error{ErrorCode::bad_input, "the shape of the demo has no contour"});
  Box2 box;
  for (const Vec2 p : shape.positions) box.add(p);
  // Leaves room for samples displaced by the noise, and for the caption below.
  const Vec2 room{0.08 * box.width(), 0.08 * box.height()};
  box.add(box.low - Vec2{room.x, 2.2 * room.y});
  box.add(box.high + room);

  Script script(registry, {});
  set_styles(script);
  script.show({"points"});
  script.compute_in(Precision::fast, true);
  script.look_at(box);
  if (auto done = sample_the_curve(script, shape, order); !done) return std::unexpected(done.error());
  take_the_short_way(script);
  take_the_general_way(script);
  compare_the_numbers(script);
  if (auto done = smooth_noise(script); !done) return std::unexpected(done.error());
  return std::move(script).finish();
}

}  // namespace mes
