// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/store/looks/bundles.h"

#include <fmt/core.h>
#include <algorithm>

#include "core/base/assert.h"
#include "core/io/text/text_numbers.h"

namespace mes {
namespace {

constexpr std::size_t kMostBundleSteps = 50;
constexpr std::size_t kLongestName = 200;
constexpr std::size_t kMostLooks = 16;

const Bundle* find_in(std::span<const Bundle> bundles, std::string_view name) {
  const auto found = std::ranges::find(bundles, name, &Bundle::name);
  return found == bundles.end() ? nullptr : &*found;
}

/// The name itself if it is free, else the first free one of "name (2)", "name (3)"...
template <class IsTaken>
std::string free_name(const std::string& name, const IsTaken& is_taken) {
  std::string out = name;
  for (int number = 2; is_taken(out); ++number) out = fmt::format("{} ({})", name, number);
  return out;
}

}  // namespace

Expected<std::string> checked_bundle_name(std::string_view name) {
  constexpr std::string_view kBlanks = " \t\r\n";
  const std::size_t begin = name.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return std::unexpected(Error{ErrorCode::usage, "a bundle needs a name"});
  name = name.substr(begin, name.find_last_not_of(kBlanks) - begin + 1);
  if (name.size() > kLongestName) return std::unexpected(Error{ErrorCode::usage, "this name is too long"});
  return std::string(name);
}

const Bundle* BundleList::find(std::string_view name) const {
  return find_in(bundles_, name);
}

void BundleList::begin_step(std::string name) {
  if (steps_.size() == 2 * kMostBundleSteps) steps_.erase(steps_.begin(), steps_.begin() + kMostBundleSteps);
  steps_.push_back({std::move(name), bundles_});
  ++revision_;
}

Expected<void> BundleList::save(const std::string& name, LayerConfiguration layers) {
  auto checked = checked_bundle_name(name);
  if (!checked) return std::unexpected(checked.error());
  const auto found = std::ranges::find(bundles_, *checked, &Bundle::name);
  begin_step((found == bundles_.end() ? "Saved " : "Overwrote ") + in_quotes(*checked));
  if (found == bundles_.end())
    bundles_.push_back({std::move(*checked), std::move(layers)});
  else
    // Drops the old description, which may not fit the new layers.
    *found = {std::move(*checked), std::move(layers)};
  return {};
}

Expected<void> BundleList::rename(std::size_t index, const std::string& name) {
  auto checked = checked_bundle_name(name);
  if (!checked) return std::unexpected(checked.error());
  if (bundles_[index].name == *checked) return {};
  if (find(*checked) != nullptr)
    return std::unexpected(Error{ErrorCode::usage, "there is a bundle " + in_quotes(*checked) + " already"});
  begin_step("Renamed " + in_quotes(bundles_[index].name));
  bundles_[index].name = std::move(*checked);
  return {};
}

void BundleList::move(std::size_t index, std::size_t to) {
  MES_ASSERT(index < bundles_.size() && to < bundles_.size());
  if (index == to) return;
  begin_step("Moved " + in_quotes(bundles_[index].name));
  const auto at = [this](std::size_t i) { return bundles_.begin() + static_cast<std::ptrdiff_t>(i); };
  if (index < to)
    std::rotate(at(index), at(index) + 1, at(to) + 1);
  else
    std::rotate(at(to), at(index), at(index) + 1);
}

void BundleList::remove(std::size_t index) {
  begin_step("Deleted " + in_quotes(bundles_[index].name));
  bundles_.erase(bundles_.begin() + static_cast<std::ptrdiff_t>(index));
}

std::vector<std::string> BundleList::import(std::span<const Bundle> bundles) {
  std::vector<std::string> names;
  std::vector<Bundle> fresh;
  for (Bundle bundle : bundles) {
    bool is_here = false;
    bundle.name = free_name(bundle.name, [&](const std::string& name) {
      const Bundle* const own = find(name);
      const Bundle* const twin = own != nullptr ? own : find_in(fresh, name);
      is_here = twin != nullptr && twin->layers == bundle.layers;
      return twin != nullptr && !is_here;
    });
    names.push_back(bundle.name);
    if (!is_here) fresh.push_back(std::move(bundle));
  }
  if (fresh.empty()) return names;
  begin_step(fresh.size() == 1 ? fmt::format("Imported {}", in_quotes(fresh.front().name))
                               : fmt::format("Imported {} bundles", fresh.size()));
  bundles_.insert(bundles_.end(), fresh.begin(), fresh.end());
  return names;
}

void BundleList::replace(std::vector<Bundle> bundles) {
  for (Step& step : steps_) step.before = merge_bundles(bundles_, step.before, bundles);
  bundles_.clear();
  for (Bundle& bundle : bundles)
    if (!bundle.name.empty() && find(bundle.name) == nullptr) bundles_.push_back(std::move(bundle));
  ++revision_;
}

void BundleList::undo() {
  if (steps_.empty()) return;
  bundles_ = std::move(steps_.back().before);
  steps_.pop_back();
  ++revision_;
}

std::vector<Bundle> merge_bundles(std::span<const Bundle> base, std::span<const Bundle> mine,
                                  std::span<const Bundle> theirs) {
  std::vector<Bundle> out;
  for (const Bundle& bundle : mine) {
    const Bundle* const before = find_in(base, bundle.name);
    const Bundle* const other = find_in(theirs, bundle.name);
    const bool is_untouched = before != nullptr && *before == bundle;
    if (!is_untouched)
      out.push_back(bundle);
    else if (other != nullptr)
      out.push_back(*other);
  }
  for (Bundle bundle : theirs) {
    const Bundle* const before = find_in(base, bundle.name);
    if (before != nullptr && *before == bundle) continue;
    const Bundle* const here = find_in(out, bundle.name);
    if (here != nullptr && *here == bundle) continue;
    bundle.name = free_name(bundle.name, [&](const std::string& name) {
      return find_in(out, name) != nullptr || (name != bundle.name && find_in(theirs, name) != nullptr);
    });
    out.push_back(std::move(bundle));
  }
  return out;
}

void CurrentBundle::choose(const std::string& name, const LayerConfiguration& as, LayerStack& layers) {
  remember(layers);
  layers.set_configuration(as);
  note_saved(name, layers);
  remember(layers);
}

void CurrentBundle::remember(const LayerStack& layers) {
  LayerConfiguration now = layers.configuration();
  std::erase_if(looks_, [&](const Look& look) { return look.layers == now; });
  if (looks_.size() == kMostLooks) looks_.erase(looks_.begin());
  looks_.push_back({std::move(now), name_, as_chosen_});
}

void CurrentBundle::follow(const LayerStack& layers) {
  if (followed_ == layers.revision() || looks_.empty()) return;
  followed_ = layers.revision();
  const auto look = std::ranges::find(looks_, layers.configuration(), &Look::layers);
  if (look == looks_.end() || look->name == name_) return;
  name_ = look->name;
  as_chosen_ = look->as_chosen;
  compared_ = 0;
}

void CurrentBundle::note_renamed(std::string name) {
  for (Look& look : looks_)
    if (look.name == name_) look.name = name;
  name_ = std::move(name);
}

void CurrentBundle::note_saved(std::string name, const LayerStack& layers) {
  name_ = std::move(name);
  as_chosen_ = layers.configuration();
  compared_ = layers.revision();
  is_changed_ = false;
}

bool CurrentBundle::is_changed(const LayerStack& layers) const {
  if (compared_ == layers.revision()) return is_changed_;
  compared_ = layers.revision();
  return is_changed_ = layers.configuration() != as_chosen_;
}

}  // namespace mes
