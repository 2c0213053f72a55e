// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/layers/image_controls.h"

#include <filesystem>

#include "app/store/background_loader.h"
#include "app/ui/screen/theme.h"
#include "app/ui/widgets/number_field.h"
#include "app/ui/widgets/paragraph.h"
#include "app/ui/widgets/widgets.h"
#include "core/base/geometry/coordinate_range.h"

namespace mes {
namespace {

constexpr float kImageFieldWidth = 150.0F;

/// Returns true when the user has typed a number that a document can hold; a length must be above 0.
bool place_field(const Gui& gui, const char* label, double& value, bool is_length, const char* explanation) {
  ImGui::SetNextItemWidth(kImageFieldWidth * gui.unit());
  const bool is_new = number_field(label, value, "%.6g", [&](double typed) -> std::optional<std::string> {
    if (const auto fault = range_fault_of(typed)) return describe(*fault, typed);
    if (is_length && !(typed > 0.0)) return "a width must be above zero";
    return std::nullopt;
  });
  tooltip(gui, explanation);
  return is_new;
}

}  // namespace

void ImageControls::draw() const {
  const auto choose = [&](const char* label) {
    if (!ImGui::Button(label)) return;
    ImGui::CloseCurrentPopup();
    actions.run(ActionId::trace_picture);
  };
  BackgroundImage image = layers.image();
  if (image.file.empty()) {
    ImGui::TextUnformatted("There is no picture underneath");
    choose("Choose a picture...");
    tooltip(gui, "PNG, JPEG, BMP or PGM; it can also be dropped on the window");
    return;
  }
  const float unit = gui.unit();
  paragraph(std::filesystem::path(image.file).filename().string(), 250 * unit);
  tooltip(gui, image.file);
  const double aspect = picture.background_aspect();
  if (aspect == 0.0) ImGui::TextDisabled("Not shown: it is still being read, or cannot be read");
  bool is_new =
      place_field(gui, "Width", image.width, true, "From its left to its right edge, in units of the samples");
  is_new = place_field(gui, "Middle, x", image.center.x, false, "Position of its middle") || is_new;
  is_new = place_field(gui, "Middle, y", image.center.y, false, "Position of its middle") || is_new;
  if (is_new) layers.set_image(image);
  ImGui::BeginDisabled(aspect == 0.0);
  if (ImGui::Button("Fit to view")) layers.set_image(placed_in(canvas.view().free_box(), image, aspect));
  ImGui::EndDisabled();
  tooltip(gui, "As large as fits in the present view");
  ImGui::SameLine(0, 4 * unit);
  choose("Replace...");
  tooltip(gui, "Choose another picture");
  ImGui::SameLine(0, 4 * unit);
  if (ImGui::Button("Remove")) {
    layers.set_image({});
    ImGui::CloseCurrentPopup();
  }
  tooltip(gui, "Remove the picture; its file stays");
}

}  // namespace mes
