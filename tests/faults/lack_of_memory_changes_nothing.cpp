// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <catch2/catch.hpp>
#include <new>

#include "app/editing/places/place_index.h"
#include "app/window/work/memory_problem.h"
#include "core/base/rng.h"
#include "core/builtins/builtins.h"
#include "core/document/commands.h"
#include "core/document/timeline/timeline.h"
#include "core/draw/layer_mirror.h"
#include "core/draw/variant.h"
#include "core/engine/graph.h"
#include "core/engine/memory_lack.h"
#include "core/engine/theorem_light.h"
#include "core/io/format.h"
#include "core/io/session/session.h"
#include "render/device/recording_device.h"
#include "render/scene.h"
#include "tests/faults/faulty_memory.h"
#include "tests/support/added_to_registry.h"
#include "tests/support/builtin_layers.h"

using namespace mes;
using namespace mes::test;

namespace {

std::vector<Vec2> some_places(std::size_t count, std::uint64_t seed) {
  Rng random(seed);
  std::vector<Vec2> out(count);
  for (Vec2& p : out) p = {random.uniform(), random.uniform()};
  return out;
}

std::uint64_t digest_from_scratch(const Document& document) {
  Document copy;
  SampleData data;
  for (const SampleSlot slot : document.slots_in_input_order()) data.positions.push_back(document.position(slot));
  for (const BallSlot slot : document.ball_slots_in_input_order()) data.balls.push_back(document.disk(slot));
  copy.apply(replace_all(copy, data).value());
  return copy.digest();
}

}  // namespace

TEST_CASE("a delta for which there is no room leaves the document as it was") {
  Document document;
  document.apply(replace_all(document, {some_places(7, 1), {}, {{{0, 0}, 1}, {{1, 1}, 2}}}).value());
  const auto apply_all = [&](const Expected<DocumentDelta>& delta) {
    REQUIRE(delta.has_value());
    int failures = with_each_allocation_failing([&](int call) {
      const std::uint64_t revision = document.revision();
      const std::uint64_t digest = document.digest();
      try {
        const FailingMemory failing(call);
        document.apply(*delta);
        return false;
      } catch (const std::bad_alloc&) {
      }
      CHECK(document.revision() == revision);
      CHECK(document.digest() == digest);
      return true;
    });
    return failures;
  };
  int failures = apply_all(insert_samples(document, some_places(20, 2)));
  failures += apply_all(insert_balls(document, std::vector<Disk>(20, {{5, 5}, 1})));
  failures += apply_all(remove_samples(
      document, std::vector{document.id(SampleSlot(3)), document.id(SampleSlot(5)), document.id(SampleSlot(20))}));
  failures += apply_all(insert_samples(document, some_places(5, 3)));
  CHECK(document.sample_count() == 29);
  CHECK(document.ball_count() == 22);
  failures += apply_all(replace_all(document, {some_places(40, 4), {}, {{{0, 0}, 1}}}));
  CHECK(document.sample_count() == 40);
  CHECK(document.digest() == digest_from_scratch(document));
  CHECK(failures > 10);
}

TEST_CASE("an entry for which there is no room leaves the timeline as it was") {
  Rng random(3);
  TimelineLog log;
  std::size_t failures = 0;
  for (int i = 0; i < 300; ++i) {
    const TimelineEdit edit{.name = std::string(random.below(2000), 'x'),
                            .inserted = some_places(random.below(9), 5)};
    const TimelineLog before = log;
    failures += static_cast<std::size_t>(with_each_allocation_failing([&](int call) {
      try {
        const FailingMemory failing(call);
        if (i % 5 == 4)
          log.replace_back(edit);
        else
          log.push_back(edit);
        return false;
      } catch (const std::bad_alloc&) {
      }
      REQUIRE(log == before);
      return true;
    }));
    REQUIRE(log.back() == TimelineEntry(edit));
    REQUIRE(log.size() == before.size() + (i % 5 == 4 ? 0 : 1));
  }
  CHECK(failures > 100);
}

TEST_CASE("a file that finds no room is refused in one line, and read when there is") {
  const std::string poff = "POFF\n3 0 0\n0 0\n1 0\n0 1\n";
  Session session;
  session.data =
      std::make_shared<const SampleData>(SampleData{some_places(30, 6), {{true, {0, 1, 2}}}, {{{0, 0}, 1}}});
  session.entries = {TimelineEdit{.name = "Insert a few of them", .inserted = some_places(30, 7)}, Undone{},
                     Redone{}};
  const std::array<std::pair<std::string, const char*>, 2> files{
      {{poff, "a.poff"}, {write_session(session), "a.json"}}};
  for (const auto& [text, name] : files) {
    const int failures = with_each_allocation_failing([&, &text = text, name = name](int call) {
      bool has_failed = false;
      Expected<LoadedFile> read;
      {
        const FailingMemory failing(call);
        read = read_sample_bytes(text, name);
        has_failed = failing.has_failed();
      }
      if (!has_failed) {
        CHECK(read.has_value());
        return false;
      }
      if (!read) {
        CHECK(read.error().code == ErrorCode::out_of_memory);
        CHECK(read.error().message() == std::string(name) + ": there is not enough memory to read it");
      }
      return true;
    });
    CHECK(failures > 3);
  }
}

TEST_CASE("an index without room finds what there is all the same, and has room again later") {
  Document document;
  SampleIndex index(document);
  std::uint64_t seed = 1;
  int failures = 0;
  const auto insert = [&](std::size_t count) {
    const auto delta = insert_samples(document, some_places(count, ++seed));
    document.apply(delta.value());
    return *delta;
  };
  for (int call = 0; call < 40; ++call) {
    const DocumentDelta delta = insert(30);
    {
      const FailingMemory failing(call);
      index.follow(delta);
      failures += failing.has_failed() ? 1 : 0;
    }
    CHECK(index.size() == document.sample_count());
    CHECK(index.in_box({{0, 0}, {0.5, 1}}) == SampleIndex(document).in_box({{0, 0}, {0.5, 1}}));
    CHECK(index.nearest({0.3, 0.7}, 1) == SampleIndex(document).nearest({0.3, 0.7}, 1));
  }
  CHECK(failures > 20);
}

TEST_CASE("where variants find no room, the main computation goes on, and they come when they are asked for again") {
  const LayerIndex boundary = find_layer("a-union-boundary");
  const std::vector<VariantRequest> wanted(2);
  const std::vector<VariantLayer> layers{find_layer("points"), boundary, layer_in(1, false, boundary),
                                         layer_in(2, false, boundary)};
  const int failures = with_each_allocation_failing([&](int call) {
    Document document;
    Graph graph{builtins()};
    LayerMirror mirror;
    FramePatch patch;
    JobControl job;
    const auto run = [&] {
      graph.set_demand(layers);
      REQUIRE(graph.run(patch, job));
      mirror.apply(patch);
    };
    const DocumentDelta delta = insert_samples(document, some_places(20, 8)).value();
    graph.post(std::make_shared<const DocumentDelta>(delta));
    bool has_failed = false;
    {
      const FailingMemory failing(call, false);
      graph.set_variants(wanted);
      has_failed = failing.has_failed();
    }
    run();
    CHECK(mirror.count(find_layer("points"), PrimitiveKind::point) == 20);
    const LayerDigest expected = mirror.digest(boundary);
    graph.set_variants(wanted);
    run();
    CHECK(mirror.digest(layer_in(1, false, boundary)) == expected);
    CHECK(mirror.digest(layer_in(2, false, boundary)) == expected);
    return has_failed;
  });
  CHECK(failures > 20);
}

TEST_CASE("where a registry finds no room, the graph goes on with the one that it has") {
  const Registry& before = registry_of_one_layer();
  const LayerIndex layer = before.find_layer("doubled-points");
  Registry after = before;
  REQUIRE(after.remove_layer("doubled-points"));
  const int failures = with_each_allocation_failing([&](int call) {
    Document document;
    Graph graph{before};
    LayerMirror mirror;
    FramePatch patch;
    JobControl job;
    const auto add = [&](std::size_t count) {
      const DocumentDelta delta = insert_samples(document, some_places(count, 8 + count)).value();
      document.apply(delta);
      graph.post(std::make_shared<const DocumentDelta>(delta));
      REQUIRE(graph.run(patch, job));
      mirror.apply(patch);
    };
    graph.set_demand(std::array{layer});
    add(20);
    bool has_failed = true;
    try {
      const FailingMemory failing(call, false);
      graph.set_registry(after);
      has_failed = failing.has_failed();
    } catch (const std::bad_alloc&) {
    }
    graph.set_demand(std::array{layer});
    add(5);
    // The other one does not have the layer.
    CHECK(patch.layer_count == (has_failed ? 1 : 0));
    CHECK(mirror.count(layer, PrimitiveKind::point) == (has_failed ? 25 : 20));
    return has_failed;
  });
  CHECK(failures > 20);
}

TEST_CASE("whichever allocation of a computation fails, the next edit brings the right picture") {
  const std::vector<LayerIndex> layers{find_layer("points"), find_layer("curve"), find_layer("medial-axis"),
                                       find_layer("delaunay")};
  int failures = 0;
  int reported = 0;
  bool gets_by = false;
  for (int call = 0; !gets_by; call += 1 + call / 40) {
    INFO("allocation " << call);
    Document document;
    Graph graph{builtins()};
    graph.set_demand(layers);
    graph.set_want_findings(true);
    LayerMirror mirror;
    FramePatch patch;
    JobControl job;
    const auto run = [&] {
      REQUIRE(graph.run(patch, job));
      mirror.apply(patch);
    };
    const auto post = [&](const Expected<DocumentDelta>& delta) {
      document.apply(delta.value());
      graph.post(std::make_shared<const DocumentDelta>(*delta));
    };
    post(insert_samples(document, some_places(12, 8)));
    run();
    post(insert_samples(document, some_places(60, 9)));
    {
      const FailingMemory failing(call, true);
      REQUIRE(graph.run(patch, job));
      gets_by = !failing.has_failed();
    }
    mirror.apply(patch);
    if (!gets_by) {
      ++failures;
      if (lacks_memory(patch.nodes, patch.reports)) {
        ++reported;
        CHECK(light_of(patch.nodes) != TheoremLight::red);
        // What could not be made anew is what it was.
        CHECK(mirror.count(find_layer("delaunay"), PrimitiveKind::segment) > 0);
      }
    }
    post(insert_samples(document, some_places(1, 10)));
    run();
    CHECK_FALSE(lacks_memory(patch.nodes, patch.reports));
    Graph fresh{builtins()};
    LayerMirror expected;
    fresh.set_demand(layers);
    Document copy;
    SampleData data;
    for (const SampleSlot slot : document.slots_in_input_order()) data.positions.push_back(document.position(slot));
    const DocumentDelta whole = replace_all(copy, data).value();
    fresh.post(std::make_shared<const DocumentDelta>(whole));
    REQUIRE(fresh.run(patch, job));
    expected.apply(patch);
    for (const LayerIndex layer : layers)
      for (const PrimitiveKind kind : kAllPrimitiveKinds)
        CHECK(mirror.count(layer, kind) == expected.count(layer, kind));
  }
  CHECK(failures > 50);
  CHECK(reported > failures / 2);
}

TEST_CASE("instances for which there is no room leave those that are there, or none") {
  const auto points = [](std::uint32_t count, bool reset) {
    FramePatch patch;
    patch.layer_count = 1;
    patch.layers.emplace_back();
    KindPatch& kind = patch.layers[0][PrimitiveKind::point];
    kind.reset = reset;
    kind.count = count;
    kind.count_changed = true;
    for (std::uint32_t i = 0; i < count && !reset; ++i) kind.index.push_back(i);
    kind.data.assign(std::size_t{count} * stride_of(PrimitiveKind::point), 0.25);
    return patch;
  };
  for (const bool reset : {true, false}) {
    const FramePatch few = points(3, true);
    const FramePatch many = points(5000, reset);
    const int failures = with_each_allocation_failing([&](int call) {
      render::RecordingDevice device;
      render::Scene scene(device);
      scene.apply(few);
      try {
        const FailingMemory failing(call);
        scene.apply(many);
        return failing.has_failed();
      } catch (const std::bad_alloc&) {
      }
      const std::uint32_t left = scene.instances(0, PrimitiveKind::point);
      CHECK((left == 0 || left == 3));
      scene.apply(points(5000, true));
      CHECK(scene.instances(0, PrimitiveKind::point) == 5000);
      return true;
    });
    CHECK(failures > 0);
  }
}

TEST_CASE("what is said about memory gives the reason and what to do") {
  CHECK(
      memory_problem(1'000'000, 0) ==
      "Out of memory: 1,000,000 samples need more than is free. Grey layers show the last picture. Undo, hide layers "
      "or open a smaller file");
  CHECK(is_memory_problem(memory_problem(1, 1)));
  CHECK_FALSE(is_memory_problem("No space left on device"));
}
