// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/details_panel.h"

#include <array>

#include "app/panels/log_panel.h"
#include "app/panels/statistics_panel.h"
#include "app/ui/icons.h"

namespace mes {
namespace {

struct Page {
  DetailsPage page;
  const char* title;
  ActionId toggle;
};
constexpr std::array<Page, 3> kPages{{{DetailsPage::statistics, "Statistics", ActionId::toggle_statistics},
                                      {DetailsPage::parameters, "Parameters", ActionId::toggle_parameters},
                                      {DetailsPage::log, "Log", ActionId::toggle_log}}};

}  // namespace

void DetailsPanel::draw(const PanelContext& context, const PanelArea& area) {
  if (begin_panel("##details", area)) {
    const float unit = context.gui.unit();
    for (const Page& page : kPages) {
      if (page.page != kPages.front().page) ImGui::SameLine(0, 2 * unit);
      if (choice_button(page.title, context.settings.details == page.page)) context.settings.details = page.page;
      tooltip(context.gui, tooltip_of(page.toggle));
    }
    const float size = ImGui::GetFrameHeight();
    ImGui::SameLine(ImGui::GetContentRegionMax().x - size);
    if (icon_button("close", Icon::close, size)) context.settings.details = DetailsPage::none;
    tooltip(context.gui, "Hide this panel");
    ImGui::Separator();
    switch (context.settings.details) {
      case DetailsPage::statistics: draw_statistics(context); break;
      case DetailsPage::parameters: parameters_.draw(context); break;
      case DetailsPage::log: draw_log(context); break;
      case DetailsPage::none: break;
    }
  }
  ImGui::End();
}

}  // namespace mes
