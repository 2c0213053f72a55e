// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/dialogs/sampling_controls.h"

#include <algorithm>
#include <vector>

#include "app/ui/screen/theme.h"
#include "app/ui/widgets/slider.h"
#include "app/ui/widgets/widgets.h"
#include "core/base/geometry/box2.h"
#include "core/base/geometry/disk.h"

namespace mes {
namespace {

constexpr double kMostSamples = 20'000.0;  // for more there is the command line
constexpr double kMostSeed = 9999.0;

Box2 extent_of(const SampleData& data) {
  Box2 out;
  for (const Vec2 p : data.positions) out.add(p);
  for (const Disk& ball : data.balls) out.add(bounding_box_of(ball));
  return out;
}

}  // namespace

void SamplingControls::draw(const Gui& gui) {
  const float width = ImGui::GetContentRegionAvail().x;
  checkbox("Number of samples", &has_samples_);
  tooltip(gui, "Evenly along curves; otherwise about 400, more where parts are close together");
  ImGui::BeginDisabled(!has_samples_);
  slider(gui, "##samples", samples_, 3.0, kMostSamples,
         {.format = "%.0f", .is_logarithmic = true, .is_whole = true, .width = width});
  ImGui::EndDisabled();
  ImGui::TextUnformatted("Jitter");
  slider(gui, "##jitter", jitter_, 0.0, 1.0, {.format = "%.2f", .width = width});
  tooltip(gui, "Each sample is moved by up to this many mean spacings, in any direction");
  ImGui::TextUnformatted("Seed");
  slider(gui, "##seed", seed_, 0.0, kMostSeed, {.format = "%.0f", .is_whole = true, .width = width});
  tooltip(gui, "Seed of random points and of the jitter");
}

ShapeSampling SamplingControls::sampling() const {
  ShapeSampling out{.jitter = jitter_, .seed = static_cast<std::uint64_t>(seed_)};
  if (has_samples_) out.samples = static_cast<std::size_t>(samples_);
  return out;
}

void draw_sample_preview(const Gui& gui, const SampleData* data) {
  const float unit = gui.unit();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 room = ImGui::GetContentRegionAvail();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, {at.x + room.x, at.y + room.y}, gui.colors().field, 4 * unit);
  if (data == nullptr) return;
  const Box2 extent = extent_of(*data);
  const float margin = 20 * unit;
  const double least = 1e-300;
  const double scale = std::min((room.x - 2 * margin) / std::max(extent.width(), least),
                                (room.y - 2 * margin) / std::max(extent.height(), least));
  const Vec2 center = extent.center();
  const auto place = [&](Vec2 p) {
    return ImVec2(at.x + 0.5F * room.x + static_cast<float>(scale * (p.x - center.x)),
                  at.y + 0.5F * room.y - static_cast<float>(scale * (p.y - center.y)));
  };
  const ImU32 ink = ImGui::GetColorU32(ImGuiCol_Text);
  list.PushClipRect(at, {at.x + room.x, at.y + room.y}, true);
  for (const Disk& ball : data->balls)
    list.AddCircle(place(ball.center), static_cast<float>(scale * ball.radius), ink, 0, unit);
  std::vector<ImVec2> points;
  for (const SampleData::Contour& contour : data->contours) {
    points.clear();
    for (const std::uint32_t i : contour.points) points.push_back(place(data->positions[i]));
    polyline(list, points, ImGui::GetColorU32(ImGuiCol_TextDisabled), contour.closed, unit);
  }
  for (const Vec2 p : data->positions) list.AddCircleFilled(place(p), 1.8F * unit, ink, 8);
  list.PopClipRect();
}

}  // namespace mes
