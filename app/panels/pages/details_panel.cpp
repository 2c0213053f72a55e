// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/pages/details_panel.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

#include "app/actions/actions.h"
#include "app/ui/icons.h"

namespace mes {
namespace {

struct Page {
  DetailsPage page;
  const char* title;
  ActionId toggle;
};
constexpr std::array<Page, 10> kPages{{{DetailsPage::statistics, "Statistics", ActionId::toggle_statistics},
                                       {DetailsPage::parameters, "Parameters", ActionId::toggle_parameters},
                                       {DetailsPage::log, "Log", ActionId::toggle_log},
                                       {DetailsPage::selection, "Selection", ActionId::toggle_selection},
                                       {DetailsPage::curves, "Curves", ActionId::toggle_curves},
                                       {DetailsPage::sampling, "Sampling", ActionId::toggle_sampling},
                                       {DetailsPage::branches, "Branches", ActionId::toggle_branches},
                                       {DetailsPage::persistence, "Persistence", ActionId::toggle_persistence},
                                       {DetailsPage::lesson, "Lesson", ActionId::toggle_lesson},
                                       {DetailsPage::experiments, "Experiments", ActionId::toggle_experiments}}};

/// The column widths that the titles need in this many rows.
std::vector<float> column_widths(std::size_t rows, float around) {
  std::vector<float> out((kPages.size() + rows - 1) / rows, 0.0F);
  for (std::size_t i = 0; i < kPages.size(); ++i) {
    float& width = out[i % out.size()];
    width = std::max(width, ImGui::CalcTextSize(kPages[i].title).x + around);
  }
  return out;
}

}  // namespace

// Draws the titles in as few rows as possible; the columns share the remaining width.
void DetailsPanel::draw_titles() {
  const float unit = gui_.unit();
  const float gap = 2 * unit;
  const float close_size = ImGui::GetFrameHeight();
  const float left = ImGui::GetCursorPosX();
  const float top = ImGui::GetCursorPosY();
  const float right = ImGui::GetContentRegionMax().x - close_size;
  ImGui::PushFont(gui_.small());
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {3 * unit, 4 * unit});
  const float around = 2 * ImGui::GetStyle().FramePadding.x + gap;
  const auto total = [](const std::vector<float>& widths) {
    return std::accumulate(widths.begin(), widths.end(), 0.0F);
  };
  std::size_t rows = 1;
  std::vector<float> widths = column_widths(rows, around);
  while (total(widths) > right - left && rows < kPages.size()) widths = column_widths(++rows, around);
  const float share = std::max(0.0F, right - left - total(widths)) / static_cast<float>(widths.size());
  const float height = ImGui::GetFrameHeight();
  float x = left;
  float y = top;
  for (std::size_t i = 0; i < kPages.size(); ++i) {
    const Page& page = kPages[i];
    const float width = widths[i % widths.size()] + share;
    ImGui::SetCursorPos({x, y});
    if (choice_button(page.title, shown_ == page.page, width - gap)) shown_ = page.page;
    tooltip(gui_, actions_.tooltip_of(page.toggle));
    x += width;
    if ((i + 1) % widths.size() == 0) {
      x = left;
      y += height + gap;
    }
  }
  ImGui::PopStyleVar();
  ImGui::PopFont();
  ImGui::SetCursorPos({right, top});
  if (icon_button("close", Icon::close, close_size)) shown_ = DetailsPage::none;
  tooltip(gui_, "Hide this panel");
  const std::size_t used = (kPages.size() + widths.size() - 1) / widths.size();
  ImGui::SetCursorPosY(top + static_cast<float>(used) * (height + gap));
}

void DetailsPanel::draw(const PanelArea& area) {
  if (begin_panel("##details", area)) {
    draw_titles();
    ImGui::Separator();
    switch (shown_) {
      case DetailsPage::statistics: statistics_.draw(); break;
      case DetailsPage::parameters: parameters_.draw(); break;
      case DetailsPage::log: log_.draw(); break;
      case DetailsPage::lesson: lesson_.draw(); break;
      case DetailsPage::selection: selection_.draw(); break;
      case DetailsPage::curves: curves_.draw(); break;
      case DetailsPage::branches: branches_.draw(); break;
      case DetailsPage::persistence: persistence_.draw(); break;
      case DetailsPage::sampling: sampling_.draw(); break;
      case DetailsPage::experiments: experiments_.draw(); break;
      case DetailsPage::none: break;
    }
  }
  ImGui::End();
}

}  // namespace mes
