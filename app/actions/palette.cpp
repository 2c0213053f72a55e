// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/palette.h"

#include <algorithm>
#include <optional>

#include "app/actions/fuzzy_match.h"
#include "core/base/lower_case.h"

namespace mes {
namespace {

// A synonym counts as a word within a name.
constexpr double kBeginsText = 2.0;  // what a match gets at the beginning of a name
constexpr double kByOtherWords = -20.0;
constexpr double kByExplanation = -30.0;

struct Found {
  PaletteHit hit;
  double score = 0.0;
  std::size_t age = 0;
  bool is_enabled = true;
  bool is_scattered = false;
};

/// Calls `visit(word)` for each of the words, which spaces and punctuation separate.
template <class Visit>
void for_each_word(std::string_view text, Visit visit) {
  constexpr std::string_view kSeparators = " .,;:()/'\n";
  while (true) {
    text.remove_prefix(std::min(text.find_first_not_of(kSeparators), text.size()));
    if (text.empty()) return;
    const std::string_view word = text.substr(0, text.find_first_of(kSeparators));
    text.remove_prefix(word.size());
    visit(word);
  }
}

/// The score if each word of the query begins some word of the text.
std::optional<double> match_beginnings(std::string_view query, std::string_view text) {
  double score = 0.0;
  bool is_found = true;
  for_each_word(query, [&](std::string_view typed) {
    std::optional<double> best;
    for_each_word(text, [&](std::string_view word) {
      if (lower_case(word.substr(0, typed.size())) != lower_case(typed)) return;
      best = std::max(best.value_or(0.0), fuzzy_match(typed, word)->score - kBeginsText);
    });
    is_found = is_found && best;
    score += best.value_or(0.0);
  });
  return is_found ? std::optional(score) : std::nullopt;
}

std::optional<FuzzyMatch> match(const PaletteEntry& entry, std::string_view query) {
  std::optional<FuzzyMatch> out = fuzzy_match(query, entry.name);
  const auto offer = [&out](std::optional<FuzzyMatch> other, double handicap) {
    if (other && (!out || other->score + handicap > out->score))
      out = {other->score + handicap, other->letters, other->scattered};
  };
  const std::string words = std::string(entry.words) + ' ' + entry.name;
  if (const auto by_synonym = match_beginnings(query, words))
    offer(FuzzyMatch{.score = *by_synonym, .letters = {}}, 0.0);
  if (out) return out;
  auto by_all = fuzzy_match(query, entry.name + ' ' + entry.kind + ' ' + entry.more);
  if (by_all) std::erase_if(by_all->letters, [&](std::size_t at) { return at >= entry.name.size(); });
  offer(std::move(by_all), kByOtherWords);
  if (const auto by_explanation = match_beginnings(query, entry.explanation))
    offer(FuzzyMatch{.score = *by_explanation, .letters = {}}, kByExplanation);
  return out;
}

}  // namespace

std::string recent_name_of(const PaletteEntry& entry) {
  return entry.kind + ": " + entry.name;
}

std::vector<PaletteHit> find_entries(std::span<const PaletteEntry> entries, std::string_view query,
                                     std::span<const std::string> recent) {
  const bool is_empty = query.find_first_not_of(' ') == std::string_view::npos;
  std::vector<Found> found;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const auto fit = match(entries[i], query);
    if (!fit) continue;
    const auto age = std::ranges::find(recent, recent_name_of(entries[i])) - recent.begin();
    // Without a query the length of a name does not matter.
    found.push_back({{i, fit->letters},
                     is_empty ? 0.0 : fit->score + entries[i].handicap,
                     static_cast<std::size_t>(age),
                     is_empty || entries[i].is_enabled,
                     fit->scattered != 0});
  }
  // An abbreviation fits many names by accident.
  if (!std::ranges::all_of(found, &Found::is_scattered))
    std::erase_if(found, [](const Found& one) { return one.is_scattered; });
  std::ranges::stable_sort(found, [](const Found& a, const Found& b) {
    if (a.score != b.score) return a.score > b.score;
    if (a.age != b.age) return a.age < b.age;
    return a.is_enabled && !b.is_enabled;
  });
  std::vector<PaletteHit> out;
  out.reserve(found.size());
  for (Found& one : found) out.push_back(std::move(one.hit));
  return out;
}

void PaletteList::set_entries(std::vector<PaletteEntry> entries) {
  entries_ = std::move(entries);
  search();
}

void PaletteList::set_query(const std::string& query) {
  if (query == query_) return;
  query_ = query;
  search();
}

void PaletteList::search() {
  hits_ = find_entries(entries_, query_, recent_);
  marked_ = 0;
}

void PaletteList::mark(std::size_t row) {
  if (row < hits_.size()) marked_ = row;
}

void PaletteList::move(int rows) {
  if (hits_.empty()) return;
  const auto last = static_cast<std::ptrdiff_t>(hits_.size()) - 1;
  std::ptrdiff_t to = static_cast<std::ptrdiff_t>(marked_) + rows;
  const bool goes_round = rows == 1 || rows == -1;
  if (to < 0) to = goes_round ? last : 0;
  if (to > last) to = goes_round ? 0 : last;
  marked_ = static_cast<std::size_t>(to);
}

std::function<void()> PaletteList::take(std::size_t row) {
  if (row >= hits_.size()) return {};
  const PaletteEntry& entry = entries_[hits_[row].entry];
  if (!entry.is_enabled) return {};
  const std::string name = recent_name_of(entry);
  std::erase(recent_, name);
  recent_.insert(recent_.begin(), name);
  if (recent_.size() > kRecent) recent_.pop_back();
  return entry.run;
}

}  // namespace mes
