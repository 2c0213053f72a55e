// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/details_panel.h"

#include <array>

#include "app/actions/actions.h"
#include "app/ui/icons.h"

namespace mes {
namespace {

struct Page {
  DetailsPage page;
  const char* title;
  ActionId toggle;
};
constexpr std::array<Page, 8> kPages{{{DetailsPage::statistics, "Statistics", ActionId::toggle_statistics},
                                      {DetailsPage::parameters, "Parameters", ActionId::toggle_parameters},
                                      {DetailsPage::log, "Log", ActionId::toggle_log},
                                      {DetailsPage::selection, "Selection", ActionId::toggle_selection},
                                      {DetailsPage::curves, "Curves", ActionId::toggle_curves},
                                      {DetailsPage::sampling, "Sampling", ActionId::toggle_sampling},
                                      {DetailsPage::branches, "Branches", ActionId::toggle_branches},
                                      {DetailsPage::lesson, "Lesson", ActionId::toggle_lesson}}};

}  // namespace

void DetailsPanel::draw(const PanelArea& area) {
  if (begin_panel("##details", area)) {
    const float unit = gui_.unit();
    const float size = ImGui::GetFrameHeight();
    const float right = ImGui::GetContentRegionMax().x - size;
    for (const Page& page : kPages) {
      const float width = ImGui::CalcTextSize(page.title).x + 2 * ImGui::GetStyle().FramePadding.x;
      if (page.page != kPages.front().page) {
        ImGui::SameLine(0, 2 * unit);
        // In a narrow column on a line of its own.
        if (ImGui::GetCursorPosX() + width > right) ImGui::NewLine();
      }
      if (choice_button(page.title, shown_ == page.page)) shown_ = page.page;
      tooltip(gui_, actions_.tooltip_of(page.toggle));
    }
    ImGui::SameLine(right);
    if (icon_button("close", Icon::close, size)) shown_ = DetailsPage::none;
    tooltip(gui_, "Hide this panel");
    ImGui::Separator();
    switch (shown_) {
      case DetailsPage::statistics: statistics_.draw(); break;
      case DetailsPage::parameters: parameters_.draw(); break;
      case DetailsPage::log: log_.draw(); break;
      case DetailsPage::lesson: lesson_.draw(); break;
      case DetailsPage::selection: selection_.draw(); break;
      case DetailsPage::curves: curves_.draw(); break;
      case DetailsPage::branches: branches_.draw(); break;
      case DetailsPage::sampling: sampling_.draw(); break;
      case DetailsPage::none: break;
    }
  }
  ImGui::End();
}

}  // namespace mes
