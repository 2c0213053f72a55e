// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/settings/panel_choice.h"

#include <algorithm>

namespace mes {
namespace {

constexpr std::size_t kMostPanels = 2;

// In the order of `PanelPage`.
constexpr std::array<std::string_view, kPanelPages> kPanelIds{
    "layers",      "bundles",    "selection",  "curves",      "sampling", "branches",
    "persistence", "statistics", "parameters", "experiments", "lesson",   "log"};

}  // namespace

std::string_view id_of(PanelPage page) {
  return kPanelIds[static_cast<std::size_t>(page)];
}

std::optional<PanelPage> find_panel(std::string_view id) {
  const auto found = std::ranges::find(kPanelIds, id);
  return found == kPanelIds.end() ? std::nullopt : std::optional(static_cast<PanelPage>(found - kPanelIds.begin()));
}

PanelChoice::PanelChoice(std::span<const PanelPage> open, std::optional<PanelPage> pinned) : pinned_(pinned) {
  open_.clear();
  for (const PanelPage page : open)
    if (open_.size() < kMostPanels && std::ranges::count(open_, page) == 0) open_.push_back(page);
  if (!open_.empty()) last_ = open_.back();
  lift_pinned();
}

std::span<const PanelPage> PanelChoice::shown() const {
  const std::span<const PanelPage> all(open_);
  if (room_ == 0 && !is_wanted_without_room_) return {};
  if (room_ >= kMostPanels || all.size() < 2) return all;
  return all.subspan(all.front() == last_ ? 0 : 1, 1);
}

bool PanelChoice::is_shown(PanelPage page) const {
  return std::ranges::count(shown(), page) != 0;
}

void PanelChoice::set_room(std::size_t panels) {
  room_ = panels;
  if (room_ != 0) is_wanted_without_room_ = false;
}

void PanelChoice::open(PanelPage page) {
  last_ = page;
  is_wanted_without_room_ = room_ == 0;
  if (std::ranges::count(open_, page) != 0) return;
  // The pinned panel returns above the other one.
  if (page != pinned_) std::erase_if(open_, [&](PanelPage other) { return other != pinned_; });
  while (open_.size() >= kMostPanels) open_.pop_back();
  open_.push_back(page);
  lift_pinned();
}

void PanelChoice::close(PanelPage page) {
  std::erase(open_, page);
  is_wanted_without_room_ = false;
  if (!open_.empty()) last_ = open_.front();
}

void PanelChoice::toggle(PanelPage page) {
  if (is_shown(page))
    close(page);
  else
    open(page);
}

void PanelChoice::toggle_pin(PanelPage page) {
  pinned_ = pinned_ == page ? std::nullopt : std::optional(page);
  lift_pinned();
}

void PanelChoice::lift_pinned() {
  std::ranges::stable_partition(open_, [&](PanelPage page) { return page == pinned_; });
}

}  // namespace mes
