// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that has a name, to be found by some of its letters and done.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace mes {

struct PaletteEntry {
  std::string kind{};         ///< "Layer"; found too, but weighs less than the name
  std::string name{};         ///< "Voronoi"
  std::string key{};          ///< shown at the right; may be empty
  std::string explanation{};  ///< one sentence; not searched
  std::string more{};         ///< other words by which it is found, such as an id
  bool is_enabled = true;
  std::string missing{};  ///< why it is not enabled, as in "nothing is selected"
  bool is_checked = false;
  std::function<void()> run{};
};

struct PaletteHit {
  std::size_t entry = 0;
  std::vector<std::size_t> letters;  ///< of the name, to be emphasised
  friend bool operator==(const PaletteHit&, const PaletteHit&) = default;
};

/// Best first; of equals what was done last (`recent`, kinds and names, newest first), then what can be done now, then in
/// the order given. Without a query everything, what was done last at the top. Cost: O(|query| * letters of all names).
std::vector<PaletteHit> find_entries(std::span<const PaletteEntry> entries, std::string_view query,
                                     std::span<const std::string> recent);

/// What `recent` holds of an entry.
std::string recent_name_of(const PaletteEntry& entry);

/// The list under the field: what is found, and the row that Enter takes.
class PaletteList {
 public:
  /// What can be done now; searches anew.
  void set_entries(std::vector<PaletteEntry> entries);
  void set_query(const std::string& query);
  const std::string& query() const { return query_; }
  std::span<const PaletteEntry> entries() const { return entries_; }
  std::span<const PaletteHit> hits() const { return hits_; }

  /// The marked row, 0 when nothing is found. Up from the first leads to the last.
  std::size_t marked() const { return marked_; }
  void mark(std::size_t row);
  /// By rows; a single step goes round the ends, longer ones stop there.
  void move(int rows);
  /// What the row does, if it can be done now; it is then the first of those done last.
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
