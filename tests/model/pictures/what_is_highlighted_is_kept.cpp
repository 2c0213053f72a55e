// SPDX-License-Identifier: GPL-3.0-or-later
// What provenance highlights, kept as an annotation: it is what was shown, and after an edit what is shown then.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "app/editing/kept_highlight.h"
#include "app/picture/annotations/annotation_drawing.h"
#include "core/base/rng.h"
#include "core/draw/layer_descriptor.h"
#include "tests/support/workbench.h"

using namespace mes;
using mes::test::TestBench;

namespace {

/// A bean with a few samples inside, none of them cocircular or on one line with others.
std::vector<Vec2> some_samples() {
  std::vector<Vec2> out;
  for (int i = 0; i < 24; ++i) {
    const double angle = 0.26 * i + 0.004 * i * i;
    const double radius = 3.0 + 0.8 * std::cos(2.0 * angle) + 0.013 * i;
    out.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  out.push_back({0.31, 0.17});
  return out;
}

/// The directions of rays and lines have a length of their own.
std::array<double, 7> comparable(const ProvenanceShape& shape) {
  std::array<double, 7> out = shape.values;
  if (shape.kind == PrimitiveKind::ray || shape.kind == PrimitiveKind::line) {
    const double size = std::hypot(out[2], out[3]);
    out[2] /= size;
    out[3] /= size;
  }
  return out;
}

void check_same(const std::vector<HighlightedShape>& kept, const Provenance& shown) {
  std::size_t at = 0;
  for (const ProvenanceLine& line : shown.lines) {
    for (const ProvenanceShape& shape : line.shapes) {
      INFO(line.text << ", shape " << at);
      REQUIRE(at < kept.size());
      CHECK(kept[at].role == line.role);
      REQUIRE(kept[at].shape.kind == shape.kind);
      const auto expected = comparable(shape);
      const auto found = comparable(kept[at].shape);
      for (std::size_t i = 0; i < expected.size(); ++i)
        CHECK(found[i] == Approx(expected[i]).epsilon(1e-9).margin(1e-9));
      ++at;
    }
  }
  CHECK(at == kept.size());
}

struct Question {
  const char* layer;
  PrimitiveKind kind;
};
const std::vector<Question> kQuestions{{"points", PrimitiveKind::point},
                                       {"delaunay", PrimitiveKind::segment},
                                       {"voronoi", PrimitiveKind::segment},
                                       {"voronoi", PrimitiveKind::ray},
                                       {"curve", PrimitiveKind::segment},
                                       {"medial-axis", PrimitiveKind::segment},
                                       {"interior-voronoi-disks", PrimitiveKind::disk},
                                       {"a-dual-interior-edges", PrimitiveKind::segment},
                                       {"a-dual-faces", PrimitiveKind::triangle},
                                       {"a-power-diagram", PrimitiveKind::segment}};

const std::vector<Question> kBallQuestions{{"b-inner-centers", PrimitiveKind::point},
                                           {"b-inner-circles", PrimitiveKind::circle},
                                           {"b-inner-disks", PrimitiveKind::disk},
                                           {"b-union-boundary", PrimitiveKind::arc},
                                           {"b-dual-interior-edges", PrimitiveKind::segment},
                                           {"b-dual-faces", PrimitiveKind::triangle},
                                           {"b-ball-power-diagram", PrimitiveKind::segment},
                                           {"b-ball-power-diagram", PrimitiveKind::ray},
                                           {"b-v-points", PrimitiveKind::point},
                                           {"b-v-interior-vertices", PrimitiveKind::point},
                                           {"b-ball-medial-axis", PrimitiveKind::segment}};

/// A place on the nth instance of a layer, where a click finds it.
std::optional<Vec2> place_on(const TestBench& bench, const Question& question, std::size_t n) {
  const std::size_t stride = stride_of(question.kind);
  const auto all = bench.instances(question.layer, question.kind);
  if ((n + 1) * stride > all.size()) return std::nullopt;
  const double* const v = all.data() + n * stride;
  switch (question.kind) {
    case PrimitiveKind::segment: return Vec2{0.625 * v[0] + 0.375 * v[2], 0.625 * v[1] + 0.375 * v[3]};
    case PrimitiveKind::ray: return Vec2{v[0] + 0.375 * v[2], v[1] + 0.375 * v[3]};
    case PrimitiveKind::triangle: return Vec2{(v[0] + v[2] + v[4]) / 3.0, (v[1] + v[3] + v[5]) / 3.0};
    case PrimitiveKind::circle: return Vec2{v[0] + v[2], v[1]};
    case PrimitiveKind::arc: return Vec2{v[3], v[4]};
    default: return Vec2{v[0], v[1]};
  }
}

}  // namespace

TEST_CASE("what is kept is what was shown, and follows a move as what is shown then") {
  for (const Question& question : kQuestions) {
    for (const std::size_t n : {0U, 3U, 7U}) {
      TestBench bench(some_samples());
      const auto at = place_on(bench, question, n);
      if (!at) continue;
      INFO(question.layer << ' ' << name_of(question.kind) << ' ' << n);
      const Provenance shown = bench.ask(*at, 1e-3, {question.layer});
      if (shown.lines.empty()) continue;
      const KeptHighlight kept = highlight_of(shown, bench.document());
      CHECK(kept.left_out == 0);
      REQUIRE(fault_of(kept.annotation, bench.document().numbered_things()).empty());
      check_same(highlighted_shapes(kept.annotation, bench.document()), shown);
      // Turned by a right angle, twice as large and shifted: the same elements at other places.
      const auto moved = [](Vec2 p) { return Vec2{-2.0 * p.y + 8.0, 2.0 * p.x - 16.0}; };
      std::vector<std::pair<SampleId, Vec2>> moves;
      const std::vector<SampleId> ids = bench.ids();
      const std::vector<Vec2> positions = bench.positions();
      for (std::size_t i = 0; i < ids.size(); ++i) moves.emplace_back(ids[i], moved(positions[i]));
      bench.move(moves);
      const std::vector<HighlightedShape> after = highlighted_shapes(kept.annotation, bench.document());
      const std::vector<HighlightedShape> before = [&] {
        TestBench first(some_samples());
        return highlighted_shapes(kept.annotation, first.document());
      }();
      REQUIRE(after.size() == before.size());
      std::size_t moving = 0;
      for (std::size_t i = 0; i < after.size(); ++i) {
        const Vec2 from{before[i].shape.values[0], before[i].shape.values[1]};
        const Vec2 to{after[i].shape.values[0], after[i].shape.values[1]};
        if (from == to) continue;  // of rounded crossings, which follow no sample
        ++moving;
        CHECK(distance(to, moved(from)) < 1e-6 * (1.0 + length(from)));
        const bool is_round = after[i].shape.kind == PrimitiveKind::circle;
        if (is_round) CHECK(after[i].shape.values[2] == Approx(2.0 * before[i].shape.values[2]).epsilon(1e-9));
      }
      CHECK(moving > 0);
    }
  }
}

TEST_CASE("of one line its own shapes are kept, and of an element without samples all where they are") {
  TestBench bench(some_samples());
  const Provenance shown = bench.ask(bench.positions()[4], 1e-3, {"points"});
  REQUIRE(shown.lines.size() > 1);
  for (std::size_t i = 0; i < shown.lines.size(); ++i) {
    const KeptHighlight kept = highlight_of(shown, bench.document(), i);
    CHECK(kept.annotation.elements.size() == shown.lines[i].shapes.size());
    for (const HighlightedElement& element : kept.annotation.elements) CHECK(element.role == shown.lines[i].role);
  }
}

TEST_CASE("what is kept of the user's balls follows them") {
  // Six that overlap in a ring, one that makes a singular dual edge with the first, one alone.
  std::vector<Disk> balls;
  for (int i = 0; i < 6; ++i)
    balls.push_back({{3.0 * std::cos(1.05 * i) + 0.1 * i, 3.0 * std::sin(1.05 * i)}, 1.7 + 0.07 * i});
  balls.push_back({{5.1, 0.3}, 1.0});
  balls.push_back({{0.2, 0.1}, 1.9});
  balls.push_back({{12.0, 9.0}, 1.0});
  const auto moved_ball = [](const Disk& disk) {
    return Disk{{-2.0 * disk.center.y + 8.0, 2.0 * disk.center.x - 16.0}, 2.0 * disk.radius};
  };
  const auto moved = [](Vec2 p) { return Vec2{-2.0 * p.y + 8.0, 2.0 * p.x - 16.0}; };
  std::size_t whole_lines = 0;
  for (const double scale : {1.0, 1.125}) {
    for (const Question& question : kBallQuestions) {
      for (const std::size_t n : {0U, 1U, 4U}) {
        TestBench bench(std::vector<Vec2>{});
        ComputationSettings settings;
        settings[Parameter::b_scale] = scale;
        bench.choose(settings);
        bench.insert_balls(balls);
        const auto at = place_on(bench, question, n);
        if (!at) continue;
        INFO(question.layer << ' ' << name_of(question.kind) << ' ' << n << " scale " << scale);
        const Provenance shown = bench.ask(*at, 1e-3, {question.layer});
        REQUIRE_FALSE(shown.lines.empty());
        const KeptHighlight kept = highlight_of(shown, bench.document());
        CHECK(kept.left_out == 0);
        REQUIRE(fault_of(kept.annotation, bench.document().numbered_things()).empty());
        for (std::size_t i = 0; i < kept.annotation.anchors.size(); ++i) {
          INFO("place " << i);
          CHECK_FALSE(kept.annotation.anchors[i].is_fixed());
        }
        const auto before = highlighted_shapes(kept.annotation, bench.document());
        check_same(before, shown);
        for (const BallId id : bench.ball_ids())
          bench.change_ball(id, moved_ball(bench.document().disk(bench.document().ball_slot_of(id))));
        const auto after = highlighted_shapes(kept.annotation, bench.document());
        REQUIRE(after.size() == before.size());
        for (std::size_t i = 0; i < after.size(); ++i) {
          const auto& a = before[i].shape;
          const auto& b = after[i].shape;
          CHECK(distance(Vec2{b.values[0], b.values[1]}, moved({a.values[0], a.values[1]})) < 1e-6);
          if (a.kind == PrimitiveKind::circle || a.kind == PrimitiveKind::disk || a.kind == PrimitiveKind::arc)
            CHECK(b.values[2] == Approx(2.0 * a.values[2]).epsilon(1e-9));
          if (a.kind == PrimitiveKind::segment)
            CHECK(distance(Vec2{b.values[2], b.values[3]}, moved({a.values[2], a.values[3]})) < 1e-6);
        }
        ++whole_lines;
      }
    }
  }
  CHECK(whole_lines > 20);
}

TEST_CASE("the line of equal power of two balls alone follows them, whether they meet or not") {
  const std::array<std::array<Disk, 2>, 3> states{{{Disk{{0, 0}, 2}, Disk{{5, 1}, 1.5}},
                                                   {Disk{{1, 0}, 3}, Disk{{2, 3}, 1.25}},
                                                   {Disk{{-4, 2}, 1}, Disk{{3, -8}, 6}}}};
  for (const double scale : {1.0, 1.125}) {
    TestBench bench(std::vector<Vec2>{});
    ComputationSettings settings;
    settings[Parameter::b_scale] = scale;
    bench.choose(settings);
    bench.insert_balls({states[0].begin(), states[0].end()});
    const auto lines = bench.instances("b-ball-power-diagram", PrimitiveKind::line);
    REQUIRE(lines.size() >= 4);
    const Provenance shown = bench.ask({lines[0], lines[1]}, 1e-3, {"b-ball-power-diagram"});
    REQUIRE_FALSE(shown.lines.empty());
    const KeptHighlight kept = highlight_of(shown, bench.document());
    REQUIRE(fault_of(kept.annotation, bench.document().numbered_things()).empty());
    for (const Anchor& anchor : kept.annotation.anchors) CHECK_FALSE(anchor.is_fixed());
    check_same(highlighted_shapes(kept.annotation, bench.document()), shown);
    for (const auto& state : states) {
      const std::vector<BallId> ids = bench.ball_ids();
      REQUIRE(ids.size() == 2);
      for (std::size_t i = 0; i < 2; ++i) bench.change_ball(ids[i], state[i]);
      std::size_t found = 0;
      for (const auto& [shape, role] : highlighted_shapes(kept.annotation, bench.document())) {
        if (shape.kind != PrimitiveKind::line) continue;
        ++found;
        for (const double along : {-1.0, 0.0, 2.0}) {
          const Vec2 p = Vec2{shape.values[0], shape.values[1]} + along * Vec2{shape.values[2], shape.values[3]};
          const auto power = [&](const Disk& disk) {
            const double radius = scale * disk.radius;
            return dot(p - disk.center, p - disk.center) - radius * radius;
          };
          CHECK(power(state[0]) == Approx(power(state[1])).margin(1e-9));
        }
      }
      CHECK(found == 1);
    }
  }
}

TEST_CASE("more than can be kept is counted, and what no document can hold is left out") {
  Document document;
  Provenance many{.lines = {{ProvenanceRole::itself, "many", {}}}, .rows = {}};
  many.lines[0].shapes.assign(kMostHighlighted + 5, {PrimitiveKind::point, {1, 2}});
  const KeptHighlight kept = highlight_of(many, document);
  CHECK(kept.annotation.elements.size() == kMostHighlighted);
  CHECK(kept.left_out == 5);
  many.lines[0].shapes = {{PrimitiveKind::point, {1e300, 0}}, {PrimitiveKind::circle, {0, 0, 0}}};
  const KeptHighlight none = highlight_of(many, document);
  CHECK(none.annotation.elements.empty());
  CHECK(none.left_out == 2);
}

TEST_CASE("a highlight is found by its lines, and drawn within reach at any zoom") {
  TestBench bench(std::vector<Vec2>{{0, 0}, {4, 0}, {0, 3}});
  const auto on = [](std::vector<std::uint32_t> samples) { return Anchor{.at = {}, .samples = std::move(samples)}; };
  const Annotation highlight{
      .kind = AnnotationKind::highlight,
      .text = "words",
      .anchors = {on({0}), on({1}), on({2}), on({0, 1, 2}), on({0, 1, 2}), on({1}), on({0}), on({0}), on({1})},
      .shift = {400.0, 0.0},
      .elements = {{PrimitiveKind::triangle, ProvenanceRole::itself},
                   {PrimitiveKind::circle, ProvenanceRole::product, 1.0},
                   {PrimitiveKind::ray, ProvenanceRole::origin},
                   {PrimitiveKind::line, ProvenanceRole::product}}};
  const auto annotated = annotate(bench.document(), {highlight});
  REQUIRE(annotated);
  Document document = bench.document();
  document.apply(*annotated);
  const auto measure = [](const std::string& text, double size, Face) {
    return 0.5 * size * static_cast<double>(text.size());
  };
  const auto drawn_at = [&](double units_per_pixel) {
    return layout_annotations(place(document),
                              {.center = {2.0, 1.5}, .units_per_pixel = units_per_pixel, .width = 800, .height = 600},
                              measure, std::nullopt);
  };
  const AnnotationDrawing drawn = drawn_at(0.01);
  // (2, 1.5) is the middle; a side of the triangle, the circle about the middle, the ray down, the bisector of two.
  CHECK(annotation_at(drawn, {400.0, 452.0}, 4.0) == 0U);
  CHECK(annotation_at(drawn, {400.0, 50.0}, 4.0) == 0U);
  CHECK(annotation_at(drawn, {400.0, 590.0}, 4.0) == 0U);
  CHECK_FALSE(annotation_at(drawn, {500.0, 320.0}, 4.0));
  CHECK(drawn.highlights.arcs.size() == 1);
  CHECK(drawn.highlights.strokes.size() == 5);
  CHECK(drawn.drawing.strokes.empty());
  CHECK(drawn.drawing.lines.size() == 1);
  for (const double zoom : {1e-12, 1e-6, 1.0, 1e6, 1e12}) {
    const AnnotationDrawing far = drawn_at(zoom);
    for (const PaperDrawing::Stroke& stroke : far.highlights.strokes)
      for (const Vec2 p : stroke.points) CHECK((std::abs(p.x) <= 2300.0 && std::abs(p.y) <= 2300.0));
  }
  // In line they have no circle, which is left out.
  const auto flat = move_samples(document, std::array{std::pair{document.first_id(), Vec2{-4.0, 6.0}}});
  REQUIRE(flat);
  document.apply(*flat);
  CHECK(drawn_at(0.01).highlights.arcs.empty());
}
