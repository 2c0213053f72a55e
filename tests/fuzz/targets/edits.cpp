// SPDX-License-Identifier: GPL-3.0-or-later
// Scripts of edits, undo, settings, layers and stopped runs: what the patches add up to is what a fresh computation
// of the last state gives.
#include "core/document/timeline/history.h"
#include "tests/fuzz/graph_run.h"
#include "tests/fuzz/scene.h"
#include "tests/support/builtin_layers.h"

using namespace mes;
using namespace mes::fuzz;

namespace {

constexpr std::size_t kMostSteps = 40;
// Signs of nested roots can take seconds each.
constexpr std::size_t kMostSamples = 8;
constexpr std::size_t kMostBalls = 4;
constexpr std::size_t kMostSamplesInDoubles = 30;

class Script {
 public:
  Script(ByteSource& bytes, const ComputationSettings& settings)
      : bytes_(bytes),
        is_in_doubles_(settings.precision <= Precision::fast),
        settings_(settings),
        run_(settings, !is_in_doubles_, limit_),
        places_(bytes, static_cast<Places>(bytes.below(3))) {}

  void play() {
    for (std::size_t step = 0; step < kMostSteps && !bytes_.is_at_end(); ++step) {
      do_something();
      switch (bytes_.below(8)) {
        case 0: break;  // this step and the next become one
        case 1: run_.run_and_stop(bytes_.below(100)); break;
        default: run_.run();
      }
    }
    check();
  }

 private:
  void do_something() {
    switch (bytes_.below(12)) {
      case 0:
      case 1:
      case 2: insert(); break;
      case 3: remove(); break;
      case 4:
      case 5: move(); break;
      case 6: edit_balls(); break;
      case 7: go(history_.undo()); break;
      case 8: go(history_.redo()); break;
      case 9: show_some(); break;
      case 10:
        settings_ = read_settings(bytes_);
        if (is_in_doubles_) settings_.precision = std::min(settings_.precision, Precision::fast);
        run_.choose(settings_);
        break;
      default: change(replace_all(document_, {{places_.point(), places_.point(), places_.point()}, {}, {}}));
    }
  }

  /// So many layers from one on, going on from the first after the last; most often all.
  void show_some() {
    const std::vector<LayerIndex>& all = run_.layers();
    const std::size_t first = bytes_.below(all.size());
    const std::size_t count = bytes_.flag() ? all.size() : bytes_.below(all.size());
    std::vector<LayerIndex> some;
    for (std::size_t i = 0; i < count; ++i) some.push_back(all[(first + i) % all.size()]);
    std::ranges::sort(some);
    run_.show(some);
  }
  void insert() {
    std::vector<Vec2> points(1 + bytes_.below(6));
    for (Vec2& p : points) p = places_.point();
    const std::size_t most = is_in_doubles_ ? kMostSamplesInDoubles : kMostSamples;
    if (document_.sample_count() + points.size() <= most) change(insert_samples(document_, points));
  }
  void remove() {
    const auto slots = document_.slots_in_input_order();
    if (!slots.empty())
      change(remove_samples(document_, std::vector{document_.id(slots[bytes_.below(slots.size())])}));
  }
  void move() {
    const auto slots = document_.slots_in_input_order();
    if (slots.empty()) return;
    const SampleId id = document_.id(slots[bytes_.below(slots.size())]);
    change(move_samples(document_, std::vector{std::pair{id, places_.point()}}));
  }
  void edit_balls() {
    const auto slots = document_.ball_slots_in_input_order();
    const std::size_t what = bytes_.below(3);
    if (what == 0 || slots.empty()) {
      if (slots.size() < kMostBalls) change(insert_balls(document_, std::vector{places_.disk()}));
      return;
    }
    const BallId id = document_.ball_id(slots[bytes_.below(slots.size())]);
    if (what == 1)
      change(remove_balls(document_, std::vector{id}));
    else
      change(change_balls(document_, std::vector{std::pair{id, places_.disk()}}));
  }

  void change(const Expected<DocumentDelta>& delta) {
    require(delta.has_value(), "the edit is possible: " + (delta ? std::string() : delta.error().text));
    document_.apply(*delta);
    history_.record(*delta);
    run_.post(*delta);
  }
  void go(const std::vector<DocumentDelta>& deltas) {
    for (const DocumentDelta& delta : deltas) {
      document_.apply(delta);
      run_.post(delta);
    }
  }

  void check() {
    run_.show(run_.layers());
    run_.run();
    const std::string broken = test::broken_row(run_.graph());
    require(broken.empty(), "rows refer to each other as they should: " + broken);
    const auto fresh = fresh_run(data_of(document_, true), settings_, !is_in_doubles_, limit_);
    const std::string differs = test::difference(run_.state(), fresh->state());
    require(differs.empty(), "edits equal a fresh computation: " + differs);
    check_layers();
  }

  // What plain doubles give may depend on the way there, and a layer that failed keeps its last picture.
  void check_layers() {
    if (settings_.precision == Precision::naive) return;
    const auto fresh = fresh_run(data_of(document_, false), settings_, !is_in_doubles_, limit_);
    for (const LayerIndex layer : run_.layers()) {
      const std::string_view id = layer_descriptors()[layer].id;
      if (id == "last-change") continue;
      require(run_.mirror().digest(layer) == fresh->mirror().digest(layer),
              "edits equal a fresh computation in " + std::string(id));
    }
  }

  ByteSource& bytes_;
  bool is_in_doubles_;
  ComputationSettings settings_;
  WorkLimit limit_;
  GraphRun run_;
  PlaceSource places_;
  Document document_;
  History history_;
};

}  // namespace

void mes::fuzz::run_edits(std::string_view input) try {
  ByteSource bytes(input);
  const ComputationSettings settings = read_settings(bytes);
  Script(bytes, settings).play();
} catch (const TooMuchWork&) {
  return;  // nothing is known
}
