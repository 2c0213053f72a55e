// SPDX-License-Identifier: GPL-3.0-or-later
// Ratios measured side by side, and the table of them at the end of a run.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace mes::bench {

/// One line of the final table: what was measured against what.
struct Ratio {
  std::string what;
  std::size_t samples = 0;
  double ours_us = 0.0;  ///< median
  double raw_us = 0.0;   ///< median, in the same loop
  double goal = 0.0;     ///< 0: none, only reported
  std::string against;
};

class RatioTable {
 public:
  void add(Ratio ratio) { ratios_.push_back(std::move(ratio)); }
  void add_note(std::string note) { notes_.push_back(std::move(note)); }
  const Ratio* find(const std::string& what, std::size_t samples) const {
    for (const Ratio& ratio : ratios_)
      if (ratio.what == what && ratio.samples == samples) return &ratio;
    return nullptr;
  }
  const std::vector<Ratio>& ratios() const { return ratios_; }
  const std::vector<std::string>& notes() const { return notes_; }

 private:
  std::vector<Ratio> ratios_;
  std::vector<std::string> notes_;
};

inline double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Registers the benchmarks of each file; their results go to the table, which outlives them.
void register_scratch(RatioTable& table);
void register_edits(RatioTable& table);
void register_drawing(RatioTable& table);
void register_dragging(RatioTable& table);
void register_recording(RatioTable& table);
void register_figures(RatioTable& table);
void register_unions(RatioTable& table);
void register_evolving(RatioTable& table);
void register_tracing(RatioTable& table);
void register_cities(RatioTable& table);
void register_outlines(RatioTable& table);
void register_importing(RatioTable& table);
void register_sampling(RatioTable& table);
void register_panes(RatioTable& table);
void register_insight(RatioTable& table);
void register_experiments(RatioTable& table);
void register_reloading(RatioTable& table);

}  // namespace mes::bench
