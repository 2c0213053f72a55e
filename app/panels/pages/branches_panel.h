// SPDX-License-Identifier: GPL-3.0-or-later
// The branches of the axis as a table, with diagrams: histograms of radius and lambda, and the width along the centre
// line. The limit of lambda and the transect can be dragged.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "app/canvas/canvas.h"
#include "app/editing/editor.h"
#include "app/insight/computation_control.h"
#include "app/insight/latest_branches.h"
#include "app/layers/layer_stack.h"
#include "app/ui/screen/gui.h"

namespace mes {

/// Guarantees: a row and its branch on the canvas are chosen together. While the table does not match the display, it
/// is dimmed and says so, and none of it is drawn over the picture. Threads: the window's.
class BranchesPanel {
 public:
  struct Uses {
    const Gui& gui;
    LatestBranches& latest;
    Canvas& canvas;
    const Editor& editor;
    LayerStack& layers;
    ComputationControl& computation;
    std::function<void(Expected<std::string>)> export_csv{};  ///< asks for a file for the CSV text
  };
  explicit BranchesPanel(Uses uses) : uses_(std::move(uses)) {}

  void draw();
  /// Draws the diagram as on paper, into a window of its own.
  void draw_large();
  /// Chooses a row of the table.
  void step(std::ptrdiff_t rows);

 private:
  /// Follows the document. Returns false without a table, and then draws the reason.
  bool draw_head();
  void draw_choices();
  void draw_diagram(float height, bool is_large);
  void draw_histogram(float height, bool is_large);
  void draw_widths(float height, bool is_large);
  void draw_transect(const Station& at) const;
  void draw_table();
  void draw_row(std::size_t row);
  void draw_branch(std::size_t row, bool is_chosen) const;
  void refresh_rows();

  Uses uses_;
  BranchAxis axis_ = BranchAxis::lambda;
  bool measures_area_ = false;
  enum class Diagram : std::uint8_t { lambda, radius, width };
  Diagram diagram_ = Diagram::lambda;
  std::size_t line_ = 0;  // of which the width is shown
  double station_ = 0.0;  // part of its length
  std::string filter_text_;
  BranchFilter filter_;
  std::string filter_problem_;
  BranchColumn sorted_by_ = BranchColumn::length;
  bool is_descending_ = true;
  const BranchTable* rows_of_ = nullptr;  // the table of these rows
  std::vector<std::size_t> rows_;
  std::optional<std::size_t> shown_chosen_;  // last row that the table scrolled to
  std::optional<std::size_t> pointed_at_;
  const BranchTable* histogram_table_ = nullptr;
  bool histogram_is_of_lambda_ = false;
  ShareHistogram histogram_;
};

}  // namespace mes
