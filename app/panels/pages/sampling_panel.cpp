// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/pages/sampling_panel.h"

#include <fmt/core.h>
#include <algorithm>

#include "app/editing/places/neighborhood.h"
#include "app/layers/words/parameter_words.h"
#include "app/picture/shown_verdict.h"
#include "app/ui/screen/theme.h"
#include "app/ui/widgets/number_field.h"
#include "app/ui/widgets/paragraph.h"
#include "app/ui/widgets/widgets.h"

namespace mes {
namespace {

void wrapped(const std::string& text) {
  paragraph(text);
}

}  // namespace

void SamplingPanel::draw() {
  draw_wishes();
  if (ImGui::BeginChild("##sampling")) {
    draw_findings();
    draw_report();
  }
  ImGui::EndChild();
}

void SamplingPanel::draw_wishes() {
  const float unit = uses_.gui.unit();
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("epsilon");
  ImGui::SameLine(0, 4 * unit);
  ImGui::SetNextItemWidth(64 * unit);
  if (double epsilon = uses_.job.epsilon; number_field("##epsilon", epsilon, "%.4g")) {
    constexpr double kLeast = 0.01;
    constexpr double kMost = 1.0;
    uses_.job.epsilon = std::clamp(epsilon, kLeast, kMost);
    if (uses_.job.epsilon != epsilon) uses_.messages.remark(beyond_words("epsilon", epsilon, kLeast, kMost));
  }
  tooltip(uses_.gui,
          "Target epsilon, 0.01 to 1: half the distance of neighbours on the curve is at most this part of their "
          "distance to the axis; at 0.25 smooth curves have the axis that the theorem promises");
  for (const auto& [id, label] :
       {std::pair{ActionId::repair_sampling, "Repair"}, {ActionId::decimate_sampling, "Decimate"}}) {
    ImGui::SameLine(0, 4 * unit);
    ImGui::BeginDisabled(!uses_.actions.is_enabled(id));
    // A click after a refused number has no effect: the previous epsilon is not used and the message stays.
    if (ImGui::Button(label) && refused_number().empty()) uses_.actions.run(id);
    ImGui::EndDisabled();
    tooltip(uses_.gui, uses_.actions.tooltip_of(id));
  }
}

void SamplingPanel::draw_places(std::span<const Vec2> places, std::int64_t count) {
  const float unit = uses_.gui.unit();
  float free = 0.0F;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const std::string label = std::to_string(i + 1);
    const float width = ImGui::CalcTextSize(label.c_str()).x + 2 * ImGui::GetStyle().FramePadding.x + 4 * unit;
    if (i != 0 && free >= width) ImGui::SameLine(0, 4 * unit);
    free = (i != 0 && free >= width ? free : ImGui::GetContentRegionAvail().x) - width;
    ImGui::PushID(static_cast<int>(i));
    if (ImGui::SmallButton(label.c_str())) uses_.canvas.view().fit(neighborhood_of(uses_.document, places[i]), 0.0);
    ImGui::PopID();
    tooltip(uses_.gui, "Show this position");
  }
  if (count > static_cast<std::int64_t>(places.size()) && !places.empty()) ImGui::TextDisabled("and more");
}

// Draws the verdict, and what it is made of.
void SamplingPanel::draw_findings() {
  wrapped(shown_verdict(uses_.engine, uses_.picture).text);
  for (const NodeReport& node : uses_.picture.nodes()) {
    for (std::size_t i = 0; i < node.findings.size(); ++i) {
      ImGui::PushID(node.structure.c_str());
      ImGui::PushID(static_cast<int>(i));
      wrapped(text_of(node.findings[i], node.structure));
      draw_places(node.findings[i].places, node.findings[i].count);
      ImGui::PopID();
      ImGui::PopID();
    }
  }
}

void SamplingPanel::draw_report() {
  const ResampleJob::Report& report = uses_.job.last();
  if (uses_.job.is_under_way()) ImGui::TextDisabled("Looking for samples to insert or to remove");
  if (report.sentences.empty()) return;
  ImGui::Separator();
  for (const std::string& sentence : report.sentences) wrapped(sentence);
  std::vector<Vec2> corners;
  for (const SampledCorner& corner : std::span(report.corners).first(std::min(report.corners.size(), kMostPlaces)))
    corners.push_back(corner.place);
  ImGui::PushID("corners");
  if (!corners.empty()) ImGui::TextDisabled("Corners");
  draw_places(corners, static_cast<std::int64_t>(report.corners.size()));
  ImGui::PopID();
  if (!report.places.empty()) ImGui::TextDisabled("Overlong edges, and ends");
  draw_places(report.places, 0);
}

}  // namespace mes
