// SPDX-License-Identifier: GPL-3.0-or-later
// One edit, from its delta to finished patches with six layers shown, against the one CGAL call.
#include <benchmark/benchmark.h>

#include "core/base/rng.h"
#include "core/builtins/builtins.h"
#include "core/engine/engine.h"
#include "tests/bench/ratios.h"
#include "tests/bench/raw_delaunay.h"
#include "tests/bench/setup.h"
#include "tests/support/shapes/shapes_benchmark.h"

namespace mes::bench {
namespace {

constexpr std::string_view kSix[] = {"points", "delaunay",    "voronoi",
                                     "curve",  "medial-axis", "interior-voronoi-disks"};

// A document, our graph and the raw triangulation that see the same edits.
struct Track {
  Document document;
  Graph graph{builtins()};
  FramePatch patch;
  JobControl job;
  RawDelaunay raw;
  std::vector<Vec2> points;
  std::vector<SampleId> ids;
  Rng rng{42};
  std::vector<double> ours;
  std::vector<double> theirs;

  explicit Track(std::vector<Vec2> input) : points(std::move(input)) {
    graph.set_demand(layers_named({kSix[0], kSix[1], kSix[2], kSix[3], kSix[4], kSix[5]}));
    const auto delta = replace_with(document, points);
    document.apply(*delta);
    graph.post(delta);
    graph.run(patch, job);
    for (const SampleSlot slot : slots_below<SampleSlot>(points.size())) ids.push_back(document.id(slot));
    ids.emplace_back();  // of the extra sample that `insert` takes
    raw.insert_range_and_index(points);
  }

  double run(const Expected<DocumentDelta>& delta) {
    document.apply(*delta);
    auto shared = std::make_shared<const DocumentDelta>(*delta);
    const double start = own_us();
    graph.post(std::move(shared));
    graph.run(patch, job);
    const double taken = own_us() - start;
    if (!patch.complete) std::abort();
    return taken;
  }
  std::size_t pick() { return rng.below(points.size()); }
  std::size_t neighbour(std::size_t i) const { return i == 0 ? 1 : i - 1; }
  // A place a quarter of the way towards a curve neighbour, or a little aside when samples are in no order.
  Vec2 nudged(std::size_t i, bool on_curve) {
    const Vec2 p = points[i];
    if (on_curve) return p + (0.25 * (rng.uniform() - 0.5)) * (points[neighbour(i)] - p);
    const double step = 0.2 * 400.0 / std::sqrt(static_cast<double>(points.size()));
    return p + Vec2{step * (rng.uniform() - 0.5), step * (rng.uniform() - 0.5)};
  }

  void move(bool on_curve) {
    const std::size_t i = pick();
    const Vec2 to = nudged(i, on_curve);
    const auto delta = move_samples(document, std::vector{std::pair{ids[i], to}});
    ours.push_back(run(delta));
    const double start = own_us();
    raw.move(i, to);
    theirs.push_back(own_us() - start);
    points[i] = to;
  }
  double remove_ours(std::size_t i) { return run(remove_samples(document, std::vector{ids[i]})); }
  double remove_raw(std::size_t i) {
    const double start = own_us();
    raw.remove(i);
    return own_us() - start;
  }
  double insert_ours(std::size_t i, Vec2 at) {
    ids[i] = document.next_id();
    points[i] = at;
    return run(insert_samples(document, std::vector{at}));
  }
  double insert_raw(std::size_t i, Vec2 at, std::size_t hint) {
    const double start = own_us();
    raw.insert_near(i, at, hint);
    return own_us() - start;
  }
  // A random sample goes; it comes back unmeasured.
  void remove(bool on_curve) {
    const std::size_t i = pick();
    const Vec2 back = nudged(i, on_curve);
    ours.push_back(remove_ours(i));
    theirs.push_back(remove_raw(i));
    insert_ours(i, back);
    insert_raw(i, back, neighbour(i));
  }
  // A sample comes next to a random one and goes again, unmeasured. The raw call is given a vertex next to the place;
  // ours has to find it.
  void insert(bool on_curve) {
    const std::size_t near = pick();
    const std::size_t extra = ids.size() - 1;
    const Vec2 at = on_curve ? points[near] + (0.4 + 0.2 * rng.uniform()) * (points[neighbour(near)] - points[near])
                             : nudged(near, false);
    const SampleId id = document.next_id();
    ours.push_back(run(insert_samples(document, std::vector{at})));
    theirs.push_back(insert_raw(extra, at, near));
    run(remove_samples(document, std::vector{id}));
    remove_raw(extra);
  }
};

enum class Edit { move, remove, insert };

void edit(benchmark::State& state, RatioTable& table, const std::string& what, std::vector<Vec2> points, Edit kind,
          bool on_curve, double goal, const char* against_same_on) {
  const std::size_t n = points.size();
  Track track(std::move(points));
  for (auto _ : state) {
    if (kind == Edit::move) {
      track.move(on_curve);
    } else if (kind == Edit::remove) {
      track.remove(on_curve);
    } else {
      track.insert(on_curve);
    }
    state.SetIterationTime(1e-6 * track.ours.back());
  }
  const double ours = median(track.ours);
  double raw = median(track.theirs);
  const char* call =
      kind == Edit::move ? "move_if_no_collision" : (kind == Edit::remove ? "remove" : "insert, near hint");
  std::string against = call;
  if (against_same_on) {
    const Ratio* clean = table.find(against_same_on, n);
    if (clean) {
      raw = clean->ours_us;
      against = std::string("ours, ") + against_same_on;
    }
  }
  state.counters["raw_us"] = raw;
  state.counters["ratio"] = ours / raw;
  auto sorted = track.ours;
  std::ranges::sort(sorted);
  state.counters["p95_us"] = sorted[sorted.size() * 95 / 100];
  const double p99 = sorted[sorted.size() * 99 / 100];
  state.counters["p99_us"] = p99;
  state.counters["max_us"] = sorted.back();
  table.add({what, n, ours, raw, goal, against});
  // Most of it is the faces that such an edit turns over.
  if (against_same_on && !on_curve) table.add({what + ", 99 of 100", n, p99, raw, 400.0, against});
}

// What the way through the threads adds: from `post` on one thread to the patch in hand.
void hand_over(benchmark::State& state, RatioTable& table) {
  Document document;
  Engine engine(builtins(), {});
  engine.set_demand(main_layers(layers_named({kSix[0], kSix[1], kSix[2], kSix[3], kSix[4], kSix[5]})));
  const auto first = replace_with(document, test::benchmark_curve(10000));
  document.apply(*first);
  engine.post(first);
  while (auto patch = engine.sync()) engine.recycle(std::move(patch));
  Rng rng(7);
  std::vector<double> times;
  for (auto _ : state) {
    const SampleSlot slot(rng.below(10000));
    const Vec2 p = document.position(slot) + Vec2{1e-3 * rng.uniform(), 1e-3 * rng.uniform()};
    const auto delta =
        std::make_shared<const DocumentDelta>(*move_samples(document, std::vector{std::pair{document.id(slot), p}}));
    document.apply(*delta);
    const double start = now_us();
    engine.post(delta);
    while (auto patch = engine.sync()) engine.recycle(std::move(patch));
    times.push_back(now_us() - start);
    state.SetIterationTime(1e-6 * times.back());
  }
  table.add_note("hand-over between threads and back, one move at 10000: median " + std::to_string(median(times)) +
                 " us");
}

}  // namespace

void register_edits(RatioTable& table) {
  for (const std::size_t n : {std::size_t{1000}, std::size_t{10000}, std::size_t{100000}, std::size_t{1000000}}) {
    const double goal = n >= 100000 ? 4.0 : (n >= 10000 ? 5.0 : 0.0);
    const std::string suffix = "/" + std::to_string(n);
    const auto add = [&](const std::string& name, const std::string& what, auto input, Edit kind, bool on_curve,
                         double its_goal, const char* against, std::int64_t iterations = 20000) {
      benchmark::RegisterBenchmark(
          ("edit/" + name + suffix).c_str(),
          [&table, what, input, n, kind, on_curve, its_goal, against](benchmark::State& state) {
            edit(state, table, what, input(n, 1), kind, on_curve, its_goal, against);
          })
          ->UseManualTime()
          ->Iterations(iterations)
          ->Unit(benchmark::kMicrosecond);
    };
    add("move/curve", "move, curve", test::benchmark_curve, Edit::move, true, goal, nullptr);
    add("remove/curve", "remove, curve", test::benchmark_curve, Edit::remove, true, goal, nullptr);
    add("insert/curve", "insert, curve", test::benchmark_curve, Edit::insert, true, goal, nullptr);
    add("move/rough", "move, rough curve", test::rough_curve, Edit::move, true, 10.0, "move, curve");
    add("remove/rough", "remove, rough curve", test::rough_curve, Edit::remove, true, 10.0, "remove, curve");
    add("insert/rough", "insert, rough curve", test::rough_curve, Edit::insert, true, 10.0, "insert, curve");
    // Odd samples everywhere.
    const std::int64_t few = n <= 100000 ? 4000 : 1000;
    add("move/square", "move, uniform square", test::uniform_square, Edit::move, false, 20.0, "move, curve", few);
    add("remove/square", "remove, uniform square", test::uniform_square, Edit::remove, false, 20.0, "remove, curve",
        few);
  }
  benchmark::RegisterBenchmark("hand_over", [&table](benchmark::State& state) { hand_over(state, table); })
      ->UseManualTime()
      ->Iterations(5000)
      ->Unit(benchmark::kMicrosecond);
}

}  // namespace mes::bench
