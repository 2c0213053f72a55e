// SPDX-License-Identifier: GPL-3.0-or-later
// Panes beside the main one: what they ask the engine for, where they lie, and the pointer in them.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>

#include "app/canvas/canvas.h"
#include "app/export/computation.h"
#include "app/panes/engine_demand.h"
#include "app/panes/pane_documents.h"
#include "app/panes/pane_list.h"
#include "app/panes/pane_places.h"
#include "app/picture/paper/pane_sheet.h"
#include "app/store/sample_shapes.h"
#include "core/base/rng.h"
#include "core/builtins/builtins.h"
#include "core/draw/layer_mirror.h"
#include "core/draw/variant.h"
#include "core/evolutions/evolution_states.h"
#include "tests/support/bell.h"
#include "tests/support/builtin_layers.h"

using namespace mes;
using mes::test::Bell;

namespace {

LayerStack stack_with_only(std::initializer_list<std::string_view> shown) {
  LayerStack layers(layer_descriptors());
  for (const LayerIndex layer : std::vector<LayerIndex>(layers.order().begin(), layers.order().end()))
    layers.set_visible(layer, false);
  for (const std::string_view id : shown) {
    REQUIRE(find_layer(id) != kNoLayer);
    layers.set_visible(find_layer(id), true);
  }
  return layers;
}

std::vector<VariantLayer> layers_of(const ShownPanes::Layers& pane) {
  std::vector<VariantLayer> out;
  for (const auto& [layer, style] : pane) out.push_back(layer);
  return out;
}

struct PaneBench {
  Editor editor{{}};
  double spacing = 10.0;
  AnnotationEditor annotations{editor};
  ToolContext context{editor, annotations, spacing, [](const Error&) {}};
  Canvas canvas{context};

  PaneBench() {
    canvas.view().set_viewport(800, 600);
    canvas.set_panes(PanePlaces::divide({100, 50, 602, 400}, 2, 2, 50));
  }
  Vec2 world(double x, double y) const { return canvas.view().camera().to_world({x, y}); }
};

}  // namespace

TEST_CASE("panes with settings of their own share the layers that do not depend on these") {
  const LayerStack layers = stack_with_only({"points", "curve", "a-union-boundary"});
  const LayerIndex boundary = find_layer("a-union-boundary");
  ComputationSettings settings;
  PaneList list;
  list.add(Precision::exact);
  list.add(ParameterChoice{Parameter::a_scale, 1.5});
  list.add(settings.precision);
  const ShownPanes shown = shown_panes(builtins(), list, layers, settings);
  CHECK(words_of(list.panes()[1]) == "Inner balls: scale 1.5");
  REQUIRE(shown.variants.size() == 2);
  CHECK(shown.variants[0].settings.precision == Precision::exact);
  CHECK(shown.variants[1].settings[Parameter::a_scale] == 1.5);
  CHECK(shown.variants[1].settings.precision == settings.precision);
  REQUIRE(shown.panes.size() == 3);
  for (VariantIndex pane = 0; pane < 2; ++pane) {
    const std::vector<VariantLayer> numbers = layers_of(shown.panes[pane]);
    CHECK(std::ranges::count(numbers, find_layer("points")) == 1);
    CHECK(std::ranges::count(numbers, layer_in(pane + 1, false, boundary)) == 1);
    CHECK(std::ranges::count(numbers, boundary) == 0);
  }
  // What has the settings of the main pane is the main computation.
  CHECK(layers_of(shown.panes[2]) == main_layers(layers.visible_layers()));
  CHECK(shown.demand.size() == 5);
}

TEST_CASE("panes of another family or a bundle show other layers of the same computation") {
  LayerStack layers = stack_with_only({"points", "a-union-boundary"});
  LayerStyle style = layers.style(find_layer("points"));
  style.point_size_px = 11.0;
  layers.set_style(find_layer("points"), style);
  PaneList list;
  list.add(FamilyKind::polar);
  Bundle bundle{.name = "Axis"};
  bundle.layers = stack_with_only({"medial-axis"}).configuration();
  list.add(bundle);
  const ShownPanes shown = shown_panes(builtins(), list, layers, {});
  CHECK(shown.variants.empty());
  REQUIRE(shown.panes.size() == 2);
  const std::vector<VariantLayer> polar = layers_of(shown.panes[0]);
  CHECK(std::ranges::count(polar, find_layer("p-union-boundary")) == 1);
  CHECK(std::ranges::count(polar, find_layer("a-union-boundary")) == 0);
  const auto points =
      std::ranges::find(shown.panes[0], find_layer("points"), &std::pair<VariantLayer, LayerStyle>::first);
  REQUIRE(points != shown.panes[0].end());
  CHECK(points->second.point_size_px == 11.0);
  CHECK(layers_of(shown.panes[1]) == std::vector<VariantLayer>{find_layer("medial-axis")});
  // The layers themselves are as they were.
  CHECK(layers.is_visible(find_layer("a-union-boundary")));
}

TEST_CASE("the list has three panes at most, and each number type once") {
  PaneList list;
  std::uint64_t revision = list.revision();
  for (int i = 0; i < 5; ++i) list.add(next_choice(list, {}));
  CHECK(list.is_full());
  REQUIRE(list.panes().size() == PaneList::kMost);
  for (std::size_t i = 0; i < list.panes().size(); ++i) {
    CHECK(std::ranges::count(list.panes(), list.panes()[i]) == 1);
    CHECK(words_of(list.panes()[i]) != words_of(ComputationSettings{}.precision));
  }
  CHECK(list.revision() > revision);
  revision = list.revision();
  list.change(1, list.panes()[1]);
  CHECK(list.revision() == revision);
  list.close(0);
  CHECK(list.panes().size() == 2);
  CHECK(list.revision() > revision);
  list.close_all();
  CHECK(list.is_empty());
}

TEST_CASE("the engine follows panes as they come, change and go") {
  Engine engine(builtins(), {});
  LayerStack layers = stack_with_only({"points", "a-union-boundary"});
  PaneList list;
  ComputationSettings settings;
  EngineDemand demand;
  Editor editor([&](std::shared_ptr<const DocumentDelta> delta) { engine.post(std::move(delta)); });
  SampleData data;
  for (int i = 0; i < 40; ++i) data.positions.push_back({std::cos(0.157 * i), 0.7 * std::sin(0.157 * i)});
  REQUIRE(editor.load(data));
  LayerMirror mirror;
  const auto follow = [&] {
    const EngineDemand::Wanted wanted{builtins(), layers, list, settings, editor.document().revision()};
    const bool is_news = demand.follow(engine, wanted, false);
    CHECK(demand.is_told(wanted));
    CHECK_FALSE(demand.follow(engine, wanted, false));
    while (auto patch = engine.sync()) {
      mirror.apply(*patch);
      engine.recycle(std::move(patch));
    }
    return is_news;
  };
  const auto arcs = [&](VariantIndex variant) {
    return mirror.digest(layer_in(variant, false, find_layer("a-union-boundary")));
  };
  CHECK(follow());
  CHECK_FALSE(follow());
  list.add(ParameterChoice{Parameter::a_scale, 1.25});
  CHECK(follow());
  CHECK(arcs(1) != arcs(0));
  const LayerDigest scaled = arcs(1);
  // The main computation takes the value of the pane, which then shows the same.
  settings[Parameter::a_scale] = 1.25;
  engine.set_settings(settings);
  CHECK(follow());
  CHECK(arcs(0) == scaled);
  // A change of style asks the engine for nothing.
  LayerStyle style = layers.style(find_layer("points"));
  style.opacity = 0.5;
  layers.set_style(find_layer("points"), style);
  CHECK_FALSE(follow());
  REQUIRE(demand.shown().panes.size() == 1);
  CHECK(demand.shown().panes[0].back().second == layers.style(demand.shown().panes[0].back().first.layer));
  list.close_all();
  CHECK(follow());
  CHECK(demand.shown().panes.empty());
  settings.precision = Precision::exact;
  CHECK_FALSE(follow());
}

TEST_CASE("panes divide what is free into equal parts") {
  CHECK(PanePlaces::divide({0, 0, 900, 600}, 1, 4, 100).is_empty());
  const PanePlaces three = PanePlaces::divide({10, 20, 908, 600}, 3, 4, 100);
  REQUIRE(three.places().size() == 3);
  CHECK(three.places()[0] == PanePlace{10, 20, 300, 600});
  CHECK(three.places()[2] == PanePlace{618, 20, 300, 600});
  const PanePlaces high = PanePlaces::divide({0, 0, 400, 804}, 2, 4, 100);
  CHECK(high.places()[1] == PanePlace{0, 404, 400, 400});
  const PanePlaces four = PanePlaces::divide({0, 0, 804, 604}, 4, 4, 100);
  CHECK(four.places()[3] == PanePlace{404, 304, 400, 300});
  CHECK(four.at({500, 400}) == 3);
  CHECK(four.at({-5, 900}) == 0);
  CHECK(four.shift(3) == Vec2{404, 304});
  CHECK(PanePlaces::divide({0, 0, 250, 250}, 3, 4, 100).is_empty());
}

TEST_CASE("whichever pane the pointer is in, tools meet the plane as in the main one") {
  PaneBench bench;
  bench.canvas.choose_tool(ToolId::insert);
  for (const double shift : {0.0, 302.0}) {
    bench.canvas.press(PointerButton::left, {200 + shift, 150}, {});
    bench.canvas.release(PointerButton::left, {200 + shift, 150}, {});
  }
  REQUIRE(bench.editor.document().sample_count() == 2);
  CHECK(bench.editor.document().position(SampleSlot(0)) == bench.world(200, 150));
  CHECK(bench.editor.document().position(SampleSlot(1)) == bench.world(200, 150));
  // A gesture stays in the pane where it began, wherever the pointer goes.
  bench.canvas.press(PointerButton::left, {450, 150}, {});
  bench.canvas.move({250, 160}, {});
  CHECK(bench.canvas.pane() == 1);
  CHECK(bench.canvas.pointer_px() == Vec2{250 - 302, 160});
  bench.canvas.release(PointerButton::left, {250, 160}, {});
  CHECK(bench.editor.document().position(SampleSlot(2)) == bench.world(250 - 302, 160));
  bench.canvas.move({250, 160}, {});
  CHECK(bench.canvas.pane() == 0);
  // The wheel zooms at the point that is shown there.
  const Vec2 under = bench.world(200, 150);
  bench.canvas.wheel({502, 150}, 1.0);
  bench.canvas.advance(10.0);
  CHECK(bench.world(200, 150).x == Approx(under.x).margin(1e-9));
  CHECK(bench.world(200, 150).y == Approx(under.y).margin(1e-9));
  // Without panes, places are what they are.
  bench.canvas.set_panes({});
  bench.canvas.move({502, 150}, {});
  CHECK(bench.canvas.pointer_px() == Vec2{502, 150});
}

TEST_CASE("a pane with a camera of its own is moved alone, and tools work at its view") {
  PaneBench bench;
  PaneList list;
  list.add(Precision::exact);
  const auto follow = [&] { bench.canvas.views().follow(list.keys(), list.has_free_cameras()); };
  follow();
  CHECK(&bench.canvas.views().of(1) == &bench.canvas.view());
  std::uint64_t revision = list.revision();
  list.set_free_cameras(true);
  CHECK(list.revision() > revision);
  follow();
  // It begins with the view that it had.
  REQUIRE(bench.canvas.views().is_own(1));
  CHECK(bench.canvas.views().of(1).camera() == bench.canvas.view().camera());
  const render::Camera main = bench.canvas.view().camera();
  bench.canvas.wheel({502, 150}, 3.0);
  bench.canvas.advance(10.0);
  CHECK(bench.canvas.view().camera() == main);
  CHECK(bench.canvas.views().of(1).camera().units_per_pixel() < 0.6 * main.units_per_pixel());
  bench.canvas.choose_tool(ToolId::insert);
  for (const double x : {200.0, 502.0}) {
    bench.canvas.press(PointerButton::left, {x, 250}, {});
    bench.canvas.release(PointerButton::left, {x, 250}, {});
  }
  REQUIRE(bench.editor.document().sample_count() == 2);
  CHECK(bench.editor.document().position(SampleSlot(0)) == main.to_world({200, 250}));
  CHECK(bench.editor.document().position(SampleSlot(1)) == bench.canvas.views().of(1).camera().to_world({200, 250}));
  // The middle button pans the pane that it is pressed in.
  const render::Camera zoomed = bench.canvas.views().of(1).camera();
  bench.canvas.press(PointerButton::middle, {450, 150}, {});
  bench.canvas.move({470, 150}, {});
  bench.canvas.release(PointerButton::middle, {470, 150}, {});
  CHECK(bench.canvas.views().of(1).camera() != zoomed);
  CHECK(bench.canvas.view().camera() == main);
  // Windows change their size for all.
  bench.canvas.views().set_viewport(1000, 700);
  CHECK(bench.canvas.views().of(1).camera().width() == 1000);
  list.set_free_cameras(false);
  follow();
  CHECK(&bench.canvas.views().of(1) == &bench.canvas.view());
}

TEST_CASE("a view stays with its pane when another one closes") {
  PaneList list;
  for (int i = 0; i < 3; ++i) list.add(next_choice(list, {}));
  PaneViews views;
  views.set_viewport(800, 600);
  list.set_free_cameras(true);
  views.follow(list.keys(), true);
  for (std::size_t i = 1; i <= 3; ++i) views.of(i).pan({100.0 * static_cast<double>(i), 0.0});
  const render::Camera third = views.of(3).camera();
  list.close(0);
  views.follow(list.keys(), true);
  CHECK(views.of(2).camera() == third);
  CHECK_FALSE(views.is_own(3));
  // Another choice in its place is the same pane, and a new one begins with the view of the main one.
  list.change(1, BeforeLastEdit{});
  list.add(Precision::naive);
  views.follow(list.keys(), true);
  CHECK(views.of(2).camera() == third);
  CHECK(views.of(3).camera() == views.main().camera());
  CHECK_FALSE(views.is_moving());
  views.of(2).zoom_at({0, 0}, 2.0);
  CHECK(views.is_moving());
  views.advance(10.0);
  CHECK_FALSE(views.is_moving());
}

TEST_CASE("each pane is called by what it shows, the main one by what the first beside it has otherwise") {
  ComputationSettings settings;
  settings[Parameter::a_scale] = 1.25;
  const MainPane main{settings, FamilyKind::polar, "Crust"};
  PaneList list;
  list.add(Precision::exact);
  CHECK(words_of(list, main) == std::vector<std::string>{words_of(settings.precision), "Exact"});
  list.change(0, ParameterChoice{Parameter::a_scale, 1.5});
  list.add(FamilyKind::inner);
  CHECK(words_of(list, main) ==
        std::vector<std::string>{"Inner balls: scale 1.25", "Inner balls: scale 1.5", words_of(FamilyKind::inner)});
  list.close(0);
  CHECK(words_of(list, main).front() == words_of(FamilyKind::polar));
  list.change(0, Bundle{.name = "Axis"});
  CHECK(words_of(list, main) == std::vector<std::string>{"Crust", "Axis"});
  CHECK(words_of(list, {settings, FamilyKind::polar, {}}).front() == "Layers of the list");
}

TEST_CASE("a sheet has each picture in its place, with nothing between them") {
  const auto fonts = PaperFonts::read(find_assets({}));
  REQUIRE(fonts);
  PaneSheet sheet{.scale = 2.0, .background = Rgb{255, 255, 255}, .grid = lay_out_panes_of(40, 30, 3, 2, 2.0)};
  CHECK(sheet.grid.rows == 2);
  CHECK(sheet.grid.extent() == Vec2{40 + 32 + 40, 2 * (30 + 60) + 32});
  sheet.width = 112;
  sheet.height = 212;
  sheet.labels = {"", "", ""};
  std::vector<render::Image> pictures;
  for (const std::uint8_t shade : std::array<std::uint8_t, 3>{50, 100, 150})
    pictures.push_back({40, 30, std::vector<std::uint8_t>(4 * 40 * 30, shade)});
  const render::Image image = sheet.with(pictures, *fonts);
  const auto at = [&](int x, int y) { return image.rgba[image.offset(x, y)]; };
  CHECK(at(20, 15) == 50);
  CHECK(at(72 + 20, 15) == 100);
  CHECK(at(20, 122 + 15) == 150);
  CHECK(at(56, 15) == 255);
  CHECK(at(72 + 20, 122 + 15) == 255);
}

namespace {

/// Where an anchor follows samples, its place says nothing.
Annotations without_followed_places(Annotations annotations) {
  for (Annotation& annotation : annotations)
    for (Anchor& anchor : annotation.anchors)
      if (!anchor.samples.empty()) anchor.at = {};
  return annotations;
}

/// A window's parts that show panes with documents of their own.
struct Versions {
  Bell bell;
  Engine engine{builtins(), {}};
  Editor editor{[this](std::shared_ptr<const DocumentDelta> delta) { engine.post(std::move(delta)); }};
  ComputationSettings settings;
  EvolutionPlayer evolution{builtins(),
                            editor,
                            {[this](const Parameter& parameter) { return settings[parameter]; },
                             [this](const Parameter& parameter, double value) { settings[parameter] = value; }},
                            bell.ring()};
  LayerStack layers = stack_with_only({"points", "medial-axis", "curve"});
  PaneList list;
  PaneDocuments documents{editor, evolution, bell.ring()};
  EngineDemand demand;
  LayerMirror mirror;
  bool is_held = false;

  Versions() {
    SampleData data;
    for (int i = 0; i < 60; ++i)
      data.positions.push_back({std::cos(0.105 * i) + 0.02 * (i % 3), 0.7 * std::sin(0.105 * i)});
    data.balls = {{{3.0, 0.0}, 0.5}};
    data.annotations = {{.kind = AnnotationKind::distance, .anchors = {{{}, {7}}, {{}, {20}}}},
                        {.kind = AnnotationKind::leader, .text = "fifty", .anchors = {{{}, {50}}}}};
    REQUIRE(editor.load(data));
  }
  EngineDemand::Wanted wanted() const {
    return {builtins(),
            layers,
            list,
            settings,
            editor.document().revision(),
            {evolution.choice(), evolution.first_value()},
            is_held};
  }
  /// As the window does, frame by frame, until all panes show what they are to.
  void settle() {
    bell.wait_until([&] {
      evolution.follow(true, 0.0);
      demand.follow(engine, wanted(), false, &documents);
      return documents.is_complete() && !evolution.is_waiting();
    });
    CHECK_FALSE(documents.take_problem());
    for (VariantIndex variant = 1; variant <= demand.shown().variants.size(); ++variant) {
      const Document* const own = documents.document_of(variant);
      if (own == nullptr) continue;
      // In the order of the version, which numbers the samples.
      CHECK(data_of(*own).positions == documents.data_of(variant)->positions);
      CHECK(data_of(*own).balls == documents.data_of(variant)->balls);
      CHECK(without_followed_places(data_of(*own).annotations) ==
            without_followed_places(documents.data_of(variant)->annotations));
    }
    while (auto patch = engine.sync()) {
      mirror.apply(*patch);
      engine.recycle(std::move(patch));
    }
  }
  std::vector<LayerDigest> digests(VariantIndex variant) const {
    std::vector<LayerDigest> out;
    for (const std::string_view id : {"points", "medial-axis", "curve"})
      out.push_back(mirror.digest(layer_in(variant, variant != kMainVariant, find_layer(id))));
    return out;
  }
};

/// The layers of a document, computed afresh.
std::vector<LayerDigest> digests_of(const SampleData& data) {
  LayerMirror mirror;
  const std::vector<VariantLayer> layers{find_layer("points"), find_layer("medial-axis"), find_layer("curve")};
  REQUIRE(run_computation(
      builtins(), data,
      {.layers = layers, .settings = {}, .on_patch = [&](const FramePatch& patch) { mirror.apply(patch); }}));
  std::vector<LayerDigest> out;
  for (const VariantLayer layer : layers) out.push_back(mirror.digest(layer));
  return out;
}

SampleData without_order(SampleData data) {
  data.contours.clear();
  return data;
}

SampleData evolved(const Document& document, const EvolutionChoice& choice, std::uint64_t steps) {
  JobControl job;
  EvolutionStates states(state_of(document), choice);
  SampleData out = without_order(data_of(document));
  out.positions = (*states.at(steps, job))->positions;
  return out;
}

}  // namespace

TEST_CASE("a pane shows the document before the last edit, after each edit, undo and redo") {
  Versions window;
  window.list.add(BeforeLastEdit{});
  window.settle();
  // Nothing was edited yet.
  CHECK(window.digests(1) == window.digests(0));
  Rng random(7);
  std::vector<SampleData> states{data_of(window.editor.document())};
  const auto done = [&](const Expected<void>& result) { REQUIRE(result); };
  for (int round = 0; round < 60; ++round) {
    const Document& document = window.editor.document();
    const std::vector<SampleSlot> slots = document.slots_in_input_order();
    const auto id_of = [&](std::size_t i) { return document.id(slots[i]); };
    const std::uint64_t kind = random.below(8);
    const SampleData before = data_of(document);
    bool is_edit = true;
    if (kind < 3) {
      const std::pair<SampleId, Vec2> target{id_of(random.below(slots.size())),
                                             {random.uniform() * 2.0 - 1.0, random.uniform()}};
      window.editor.begin_gesture("Move");
      done(window.editor.move({{target}}, "Move"));
      window.settle();
      CHECK(window.digests(1) == digests_of(before));
      done(window.editor.move(std::vector{std::pair{target.first, Vec2{0.25, 0.125}}}, "Move"));
      window.editor.end_gesture();
    } else if (kind == 3) {
      REQUIRE(window.editor.insert(std::vector<Vec2>{{random.uniform(), random.uniform()}}, "Insert"));
    } else if (kind == 4) {
      done(window.editor.remove(std::vector{id_of(random.below(slots.size()))}, "Remove"));
    } else if (kind == 5) {
      REQUIRE(window.editor.insert_balls(std::vector<Disk>{{{random.uniform(), 2.0}, 0.25}}, "Ball"));
    } else if (kind == 6 && states.size() > 1) {
      window.editor.undo();
      states.pop_back();
      is_edit = false;
    } else if (kind == 7 && window.editor.can_redo()) {
      window.editor.redo();
    } else {
      is_edit = false;
    }
    if (is_edit) states.push_back(data_of(window.editor.document()));
    window.settle();
    INFO("round " << round << ", kind " << kind);
    CHECK(window.digests(0) == digests_of(states.back()));
    CHECK(window.digests(1) == digests_of(states[states.size() - std::min<std::size_t>(2, states.size())]));
  }
}

TEST_CASE("versions in panes wait while the update is held") {
  Versions window;
  window.list.add(BeforeLastEdit{});
  window.list.add(EvolvedChoice{1});
  window.settle();
  const SampleData first = data_of(window.editor.document());
  const auto state_before = window.documents.data_of(2);
  window.is_held = true;
  const SampleSlot slot = window.editor.document().slots_in_input_order()[10];
  REQUIRE(window.editor.move(std::vector{std::pair{window.editor.document().id(slot), Vec2{0.25, 0.125}}}, "Move"));
  window.demand.follow(window.engine, window.wanted(), false, &window.documents);
  CHECK_FALSE(window.documents.is_complete());
  CHECK(window.documents.data_of(2) == state_before);
  REQUIRE(window.editor.remove(std::vector{window.editor.document().id(slot)}, "Remove"));
  window.demand.follow(window.engine, window.wanted(), false, &window.documents);
  CHECK(window.documents.data_of(1)->positions == first.positions);
  window.is_held = false;
  window.settle();
  // Before the removal, and one step from what is left.
  CHECK(window.documents.data_of(1)->positions[10] == Vec2{0.25, 0.125});
  CHECK(window.documents.data_of(2)->positions ==
        evolved(window.editor.document(), window.evolution.choice(), 1).positions);
}

TEST_CASE("panes show states of the evolution, of the document as it is") {
  Versions window;
  window.list.add(EvolvedChoice{3});
  window.list.add(EvolvedChoice{0});
  window.list.add(EvolvedChoice{12});
  const auto check = [&](const Document& beginning) {
    window.settle();
    const EvolutionChoice& choice = window.evolution.choice();
    CHECK(window.digests(1) == digests_of(evolved(beginning, choice, 3)));
    CHECK(window.digests(2) == digests_of(evolved(beginning, choice, 0)));
    CHECK(window.digests(3) == digests_of(evolved(beginning, choice, 12)));
  };
  check(window.editor.document());
  CHECK(window.digests(1) != window.digests(0));
  CHECK(window.digests(2) == window.digests(0));
  const SampleId first = window.editor.document().id(SampleSlot(0));
  REQUIRE(window.editor.move(std::vector{std::pair{first, Vec2{1.3, 0.1}}}, "Move"));
  check(window.editor.document());
  REQUIRE(window.editor.remove(std::vector{first}, "Remove"));
  check(window.editor.document());
  // While the document itself is in a later state, the others stay what they are.
  const Document beginning = window.editor.document();
  window.evolution.step_to(12);
  check(beginning);
  CHECK(window.digests(3) == window.digests(0));
  CHECK(words_of(window.list, {window.settings, FamilyKind::inner, {}, window.evolution.position()}).front() ==
        "Step 12");
  // Another evolution, which adds samples.
  window.evolution.choose(find_evolution("subdivide"));
  window.list.change(2, EvolvedChoice{2});
  window.settle();
  CHECK(window.digests(3) == digests_of(evolved(window.editor.document(), window.evolution.choice(), 2)));
  REQUIRE(window.documents.data_of(3));
  CHECK(window.documents.data_of(3)->positions.size() > window.editor.document().sample_count());
  // What is closed is not computed any more.
  window.list.close_all();
  window.settle();
  CHECK(window.documents.document_of(3) == nullptr);
}

TEST_CASE("where an evolution moves a parameter, panes share the document") {
  Versions window;
  const auto all = builtins().evolutions().all();
  const auto found =
      std::ranges::find_if(all, [](const auto& evolution) { return evolution->moved_parameter() != nullptr; });
  REQUIRE(found != all.end());
  const auto scaling = *found;
  window.evolution.choose(scaling);
  window.list.add(EvolvedChoice{5});
  window.list.add(EvolvedChoice{1'000'000'000});
  const PaneEvolution evolution{window.evolution.choice(), window.evolution.first_value()};
  const ShownPanes shown = shown_panes(builtins(), window.list, window.layers, window.settings, evolution);
  const ParameterMove& move = *scaling->moved_parameter();
  REQUIRE(shown.variants.size() >= 1);
  CHECK_FALSE(shown.variants[0].has_document);
  CHECK(shown.variants[0].settings[move.parameter] ==
        moved_value(move, evolution.first, 5, evolution.choice.values).value());
  // Beyond the range of the parameter it is the main pane.
  CHECK(shown.variant[1] == kMainVariant);
  // The states do not follow the slider.
  window.evolution.step_to(5);
  CHECK(window.evolution.first_value() == evolution.first);
}
