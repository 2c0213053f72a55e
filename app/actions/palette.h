// SPDX-License-Identifier: GPL-3.0-or-later
// Finds everything that has a name by some of its letters or by other words for it, and runs it.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace mes {

struct PaletteEntry {
  std::string kind{};         ///< "Layer"; searched too, but weighs less than the name
  std::string name{};         ///< "Voronoi"
  std::string key{};          ///< shown at the right; may be empty
  std::string explanation{};  ///< one sentence
  std::string more{};         ///< an id and the like, of which some letters are enough
  std::string_view words{};   ///< synonyms, of which the beginnings of words count
  std::string place{};        ///< where else it is: "Layers > Samples"; empty if `kind` says it
  double handicap = 0.0;      ///< added to what counts for it; below 0: others of the same name come first
  bool is_enabled = true;
  std::string missing{};  ///< the reason why it is disabled, as in "nothing is selected"
  bool is_checked = false;
  std::function<void()> run{};
};

struct PaletteHit {
  std::size_t entry = 0;
  std::vector<std::size_t> letters;  ///< letters of the name to emphasise
  friend bool operator==(const PaletteHit&, const PaletteHit&) = default;
};

/// Finds entries, the best first: by letters of their names, by beginnings of synonyms, by letters of kind and id, and
/// last by beginnings of words of the explanation. If some of them have the words of the query whole, or their letters
/// at the beginnings of words, then those are left out whose letters are only scattered. Of equal ones, recently run
/// ones come first (`recent`: kinds and names, newest first), then enabled ones, then the given order. Without a query
/// it returns everything, recently run entries first. Cost: O(|query| * letters of all texts).
std::vector<PaletteHit> find_entries(std::span<const PaletteEntry> entries, std::string_view query,
                                     std::span<const std::string> recent);

/// The text for an entry in `recent`.
std::string recent_name_of(const PaletteEntry& entry);

/// The list under the field: the entries found, and the row that Enter takes.
class PaletteList {
 public:
  /// Sets the entries that are available now; searches again.
  void set_entries(std::vector<PaletteEntry> entries);
  void set_query(const std::string& query);
  const std::string& query() const { return query_; }
  std::span<const PaletteEntry> entries() const { return entries_; }
  std::span<const PaletteHit> hits() const { return hits_; }

  /// The marked row, 0 if nothing is found. Moving up from the first row leads to the last.
  std::size_t marked() const { return marked_; }
  void mark(std::size_t row);
  /// Moves by rows; a single step wraps around at the ends, longer ones stop there.
  void move(int rows);
  /// The action of the row, if it is enabled; makes the entry the most recent one.
  std::function<void()> take(std::size_t row);

 private:
  void search();

  static constexpr std::size_t kRecent = 20;
  std::vector<PaletteEntry> entries_;
  std::vector<std::string> recent_;
  std::string query_;
  std::vector<PaletteHit> hits_;
  std::size_t marked_ = 0;
};

}  // namespace mes
