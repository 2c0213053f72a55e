// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/insight/scale_events.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "core/workbench/workbench.h"

namespace mes {
namespace {

constexpr int kIntervalsBelow = 6;
constexpr int kIntervals = 32;
constexpr double kNear = 1e-3;
constexpr double kLargestAngle = 175.0;
constexpr int kMostUnions = 400;
constexpr std::int64_t kMostBalls = 40'000'000;

double angle_for_events(const ComputationSettings& settings) {
  return std::min(kLargestAngle, settings[Parameter::medial_sampling_angle]);
}

class ScaleSweep {
 public:
  ScaleSweep(Workbench& bench, ComputationSettings settings, JobControl& job)
      : bench_(bench), settings_(std::move(settings)), job_(job) {}

  std::vector<ScaleEvent> events() {
    const Parameter& range = Parameter::scale_axis_factor;
    const Topology whole = at(1.0);
    look_on(whole, 1.0, range.high, kIntervals);
    if (!is_certified_) {
      try {
        look_on(whole, 1.0, range.low, kIntervalsBelow);
      } catch (const GeometryError&) {
        // Keep the events of larger factors.
      }
    }
    halve();
    std::ranges::sort(events_, {}, &ScaleEvent::factor);
    return std::move(events_);
  }

 private:
  struct Topology {
    std::int64_t components = 0;
    std::int64_t holes = 0;
    friend bool operator==(const Topology&, const Topology&) = default;
  };
  struct Interval {
    double low = 0.0, high = 0.0;
    Topology below, above;
    double width() const { return high - low; }
    /// Puts wide intervals first in a heap, and the lowest of equally wide ones.
    friend bool operator<(const Interval& a, const Interval& b) {
      return a.width() != b.width() ? a.width() < b.width() : a.low > b.low;
    }
  };

  /// The topology of the scaled union: its axis has as many components, and a cycle for each hole.
  Topology at(double factor) {
    settings_[Parameter::scale_axis_factor] = factor;
    bench_.choose(settings_);
    const auto done = bench_.run_or_throw(job_);
    ++unions_;
    if (!done) throw GeometryError(done.error().text);
    balls_ += count("balls");
    if (factor == 1.0) {
      const auto rung = bench_.statistic("scale-union", "rung");
      is_certified_ = rung && std::get<std::string>(*rung) == "shortcut";
    }
    return {count("components"), count("cycles")};
  }
  /// Returns zero if the union has no such number.
  std::int64_t count(std::string_view key) const {
    const auto found = bench_.statistic("scale-union", key);
    return found ? std::get<std::int64_t>(*found) : 0;
  }
  bool may_go_on() const { return unions_ < kMostUnions && balls_ < kMostBalls; }

  /// Examines equal intervals from one factor to another.
  void look_on(const Topology& there, double from, double to, int count) {
    double last = from;
    Topology before = there;
    for (int i = 1; i <= count; ++i) {
      if (!may_go_on()) throw GeometryError("it takes too many balls");
      const double next = from + (to - from) * i / count;
      const Topology after = at(next);
      add(last < next ? Interval{last, next, before, after} : Interval{next, last, after, before});
      last = next;
      before = after;
    }
  }

  void add(const Interval& interval) {
    if (interval.below == interval.above) return;
    intervals_.push_back(interval);
    std::ranges::push_heap(intervals_, std::less{});
  }

  void halve() {
    while (!intervals_.empty()) {
      std::ranges::pop_heap(intervals_, std::less{});
      const Interval at_hand = intervals_.back();
      intervals_.pop_back();
      const double middle = 0.5 * (at_hand.low + at_hand.high);
      if (at_hand.width() <= kNear || !may_go_on()) {
        events_.push_back({middle, 0.5 * at_hand.width(), at_hand.below.components, at_hand.above.components,
                           at_hand.below.holes, at_hand.above.holes});
        continue;
      }
      Topology there;
      try {
        there = at(middle);
      } catch (const GeometryError&) {
        unions_ = kMostUnions;  // keep the events found so far
        intervals_.push_back(at_hand);
        continue;
      }
      add({at_hand.low, middle, at_hand.below, there});
      add({middle, at_hand.high, there, at_hand.above});
    }
  }

  Workbench& bench_;
  ComputationSettings settings_;
  JobControl& job_;
  bool is_certified_ = false;
  int unions_ = 0;
  std::int64_t balls_ = 0;
  std::vector<Interval> intervals_;  // a heap
  std::vector<ScaleEvent> events_;
};

}  // namespace

std::string ScaleEvent::words() const {
  const auto change = [](const char* what, std::int64_t before, std::int64_t after) {
    return std::string(what) + ' ' + std::to_string(before) + " to " + std::to_string(after);
  };
  std::string out;
  if (components_before != components_after) out = change("components", components_before, components_after);
  if (holes_before != holes_after) out += (out.empty() ? "" : ", ") + change("holes", holes_before, holes_after);
  return out;
}

Expected<std::vector<ScaleEvent>> scale_events_of(const Registry& registry, const SampleData& data,
                                                  const ComputationSettings& settings, JobControl& job) {
  Workbench bench(registry, {.keeps_document = false});
  bench.need({"scale-union"});
  bench.set_want_statistics(true);
  if (auto good = bench.load({.positions = data.positions}); !good) return std::unexpected(good.error());
  // Other number types would take minutes for this many unions.
  ComputationSettings fast = settings;
  fast.precision = Precision::fast;
  fast[Parameter::medial_sampling_angle] = angle_for_events(settings);
  try {
    return ScaleSweep(bench, fast, job).events();
  } catch (const GeometryError& error) {
    return std::unexpected(Error{ErrorCode::cannot_compute, error.what(), {}, 0, 0});
  }
}

void ScaleEvents::follow(std::uint64_t document, const ComputationSettings& settings,
                         const std::function<SampleData()>& data) {
  // No other setting matters: all factors are examined, with one number type.
  State wanted{document, {}};
  wanted.settings[Parameter::medial_sampling_angle] = angle_for_events(settings);
  latest_.follow(wanted, [&] {
    return [registry = registry_.share(), settings = wanted.settings, samples = data()](JobControl& job) {
      return scale_events_of(*registry, samples, settings, job);
    };
  });
}

}  // namespace mes
