// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/model/scale_events.h"

#include <array>
#include <new>
#include <utility>

#include "core/draw/layer_descriptor.h"
#include "core/engine/graph.h"

namespace mes {
namespace {

constexpr int kIntervalsBelow = 6;
constexpr int kIntervals = 32;
constexpr double kNear = 1e-3;

class ScaleSweep {
 public:
  ScaleSweep(Graph& graph, ComputationSettings settings, JobControl& job)
      : graph_(graph), settings_(std::move(settings)), job_(job) {}

  struct Topology {
    std::int64_t components = 0;
    std::int64_t holes = 0;
    friend bool operator==(const Topology&, const Topology&) = default;
  };

  /// Of the grown union: its axis has as many components, and a cycle for each hole.
  Topology at(double factor) {
    settings_[Parameter::scale_axis_factor] = factor;
    graph_.post_settings(settings_);
    if (!graph_.run(patch_, job_)) throw Cancelled{};
    Topology out;
    for (const NodeReport& node : patch_.nodes) {
      if (node.state == NodeState::failed)
        throw GeometryError("structure " + node.structure + " failed: " + node.reason);
      if (node.structure != "scale-union") continue;
      for (const Stat& stat : node.stats) {
        if (stat.key == "components") out.components = std::get<std::int64_t>(stat.value);
        if (stat.key == "cycles") out.holes = std::get<std::int64_t>(stat.value);
      }
    }
    return out;
  }

  void look_between(double low, const Topology& below, double high, const Topology& above,
                    std::vector<ScaleEvent>& out) {
    if (below == above) return;
    if (high - low <= kNear) {
      out.push_back({0.5 * (low + high), below.components, above.components, below.holes, above.holes});
      return;
    }
    const double middle = 0.5 * (low + high);
    const Topology there = at(middle);
    look_between(low, below, middle, there, out);
    look_between(middle, there, high, above, out);
  }

 private:
  Graph& graph_;
  ComputationSettings settings_;
  JobControl& job_;
  FramePatch patch_;
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

Expected<std::vector<ScaleEvent>> scale_events_of(const SampleData& data, const ComputationSettings& settings,
                                                  JobControl& job) {
  const Document document;
  auto delta = replace_all(document, {.positions = data.positions});
  if (!delta) return std::unexpected(delta.error());
  Graph graph;
  graph.set_demand(std::array{find_layer("scale-axis")});
  graph.set_want_statistics(true);
  graph.post(std::make_shared<const DocumentDelta>(std::move(*delta)));
  // Other number types would take minutes for as many unions.
  ComputationSettings fast = settings;
  fast.precision = Precision::fast;
  ScaleSweep sweep(graph, fast, job);
  std::vector<ScaleEvent> out;
  const ParameterDescriptor& range = descriptor_of(Parameter::scale_axis_factor);
  try {
    double low = range.low;
    ScaleSweep::Topology below = sweep.at(low);
    for (int i = 1 - kIntervalsBelow; i <= kIntervals; ++i) {
      const double high =
          i <= 0 ? 1.0 + (1.0 - range.low) * i / kIntervalsBelow : 1.0 + (range.high - 1.0) * i / kIntervals;
      const ScaleSweep::Topology above = sweep.at(high);
      sweep.look_between(low, below, high, above, out);
      low = high;
      below = above;
    }
  } catch (const GeometryError& error) {
    return std::unexpected(Error{ErrorCode::cannot_compute, error.what(), {}, 0, 0});
  }
  return out;
}

void ScaleEvents::follow(std::uint64_t document, const ComputationSettings& settings,
                         const std::function<SampleData()>& data) {
  // Nothing else makes a difference: all factors are looked at, with one number type.
  is_followed_ = true;
  wanted_ = {document, {}};
  wanted_.settings[Parameter::medial_sampling_angle] = settings[Parameter::medial_sampling_angle];
  if (auto found = job_.poll()) found_ = *std::move(found);
  if (job_.is_under_way() && begun_ == wanted_) return;
  if (found_ && found_->state == wanted_) return;
  // Given up where the document has changed meanwhile: it takes long. The next one begins when this one has ended.
  job_.give_up();
  if (job_.is_ending()) return;
  begun_ = wanted_;
  job_.begin([state = wanted_, samples = data()](const std::stop_token& stop) -> Found {
    Found out{state, {}, {}};
    JobControl job(stop);
    try {
      if (auto events = scale_events_of(samples, state.settings, job))
        out.events = *std::move(events);
      else
        out.problem = events.error().text;
    } catch (const Cancelled&) {
      // The result is dropped.
    } catch (const std::bad_alloc&) {
      out.events.clear();
      out.problem = "there is not enough memory";
    }
    return out;
  });
}

}  // namespace mes
