// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/playing/step_events.h"

#include <algorithm>

#include "app/playing/evolution_layers.h"

namespace mes {
namespace {

struct Happened {
  std::uint64_t joins = 0;
  std::uint64_t closes = 0;
  std::uint64_t fills = 0;
  bool is_nothing() const { return joins == 0 && closes == 0 && fills == 0; }
};

/// `come(value)` returns the number of ranks reached, `count(low, high)` the events of the ranks in [low, high).
template <class Come, class Count>
std::vector<StepEvent> events_between(const StepRange& range, const Come& come, const Count& count) {
  std::vector<StepEvent> out;
  const ParameterMove* const move = range.choice.moved_parameter();
  if (move == nullptr || range.end == 0) return out;
  const std::uint64_t stride = (range.end - 1) / kMostStepEvents + 1;
  std::uint32_t before = come(range.first);
  for (std::uint64_t k = 0; k < range.end;) {
    const std::uint64_t last = k;
    k += std::min(stride, range.end - k);
    const auto value = moved_value(*move, range.first, k, range.choice.values);
    if (!value) break;
    const std::uint32_t now = come(*value);
    const Happened happened = count(std::min(before, now), std::max(before, now));
    if (!happened.is_nothing())
      out.push_back({last, k, happened.joins, happened.closes, happened.fills, now < before});
    before = now;
  }
  return out;
}

void add_words(std::string& out, std::uint64_t count, const char* what) {
  if (count == 0) return;
  out += (out.ends_with(':') ? " " : ", ") + std::string(what) + ": " + std::to_string(count);
}

}  // namespace

std::string StepEvent::words() const {
  std::string out = k - before == 1 ? "Step " + std::to_string(k) + ':'
                                    : "Steps " + std::to_string(before + 1) + " to " + std::to_string(k) + ':';
  add_words(out, joins, is_undone ? "components parted" : "components joined");
  add_words(out, closes, is_undone ? "holes opened" : "holes closed");
  add_words(out, fills, is_undone ? "holes that come back" : "holes filled");
  return out;
}

std::vector<StepEvent> step_events_of(const StepRange& range, const PersistenceTable& table) {
  const auto number = [](const std::vector<GrowthEvent>& events, std::uint32_t low, std::uint32_t high) {
    const auto first = std::ranges::lower_bound(events, low, {}, &GrowthEvent::rank);
    return static_cast<std::uint64_t>(std::ranges::lower_bound(first, events.end(), high, {}, &GrowthEvent::rank) -
                                      first);
  };
  return events_between(range, table.ranks_within, [&](std::uint32_t low, std::uint32_t high) {
    return Happened{number(table.joins, low, high), number(table.closes, low, high), number(table.fills, low, high)};
  });
}

std::vector<StepEvent> step_events_of(const StepRange& range, const std::vector<ScaleEvent>& events) {
  const auto come = [&](double factor) {
    return static_cast<std::uint32_t>(std::ranges::upper_bound(events, factor, {}, &ScaleEvent::factor) -
                                      events.begin());
  };
  return events_between(range, come, [&](std::uint32_t low, std::uint32_t high) {
    Happened out;
    const auto lost = [](std::int64_t before, std::int64_t after) {
      return before > after ? static_cast<std::uint64_t>(before - after) : 0;
    };
    for (std::uint32_t i = low; i < high; ++i) {
      out.joins += lost(events[i].components_before, events[i].components_after);
      out.closes += lost(events[i].holes_after, events[i].holes_before);
      out.fills += lost(events[i].holes_before, events[i].holes_after);
    }
    return out;
  });
}

void StepEvents::forget() {
  has_place_ = knows_factors_ = false;
  problem_.clear();
  table_.reset();
  factors_.clear();
  events_.clear();
}

void StepEvents::follow_growth(const StepRange& range) {
  LatestPersistence& latest = uses_.persistence;
  const auto shown = shown_growth(uses_.layers, latest.growth());
  if (!shown) return forget();
  // An open page has already chosen the family.
  if (!latest.is_followed())
    latest.choose_growth(*shown);
  else if (latest.growth() != *shown)
    return forget();
  latest.follow(uses_.editor.document(), uses_.computation.settings());
  if (!latest.is_current()) {
    forget();
    problem_ = latest.problem();
  } else if (table_ != latest.shared_table() || range_ != range) {
    forget();
    table_ = latest.shared_table();
    range_ = range;
    events_ = step_events_of(range, *table_);
  }
  has_place_ = true;
}

void StepEvents::follow_factors(const StepRange& range) {
  const bool is_shown = std::ranges::any_of(uses_.layers.visible_layers(), [this](LayerIndex layer) {
    return uses_.layers.descriptor(layer).group == LayerGroup::scale_axis;
  });
  if (!is_shown) return forget();
  const Document& document = uses_.editor.document();
  uses_.scale_events.follow(document.revision(), uses_.computation.settings(), [&] { return data_of(document); });
  const std::vector<ScaleEvent>* const found = uses_.scale_events.events();
  if (found == nullptr) {
    forget();
    problem_ = uses_.scale_events.problem();
  } else if (!knows_factors_ || range_ != range || factors_ != *found) {
    forget();
    knows_factors_ = true;
    factors_ = *found;
    range_ = range;
    events_ = step_events_of(range, factors_);
  }
  has_place_ = true;
}

void StepEvents::follow() {
  const EvolutionPlayer& player = uses_.player;
  const ParameterMove* const move = player.choice().moved_parameter();
  if (move == nullptr) return forget();
  const StepRange range{player.choice(), player.first_value(), player.end()};
  if (move->parameter == Parameter::alpha_radius) return follow_growth(range);
  if (move->parameter == Parameter::scale_axis_factor) return follow_factors(range);
  forget();
}

}  // namespace mes
