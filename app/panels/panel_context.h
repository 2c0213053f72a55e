// SPDX-License-Identifier: GPL-3.0-or-later
// What panels may see and touch. Panels draw themselves from it each frame and keep nothing but their own folds.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>

#include "app/actions/action_bindings.h"
#include "app/canvas/canvas.h"
#include "app/model/editor.h"
#include "app/model/evolution_player.h"
#include "app/model/layer_stack.h"
#include "app/model/messages.h"
#include "app/model/parameter_animation.h"
#include "app/model/settings.h"
#include "app/picture/picture.h"
#include "app/recording/record_desk.h"
#include "app/store/bundle_desk.h"
#include "app/store/file_desk.h"
#include "app/store/sample_shapes.h"
#include "app/ui/frame_times.h"
#include "app/ui/gui.h"
#include "core/document/computation_settings.h"
#include "core/engine/engine.h"

namespace mes {

struct PanelContext {
  const Gui& gui;
  const ActionBindings& actions;
  Editor& editor;
  EvolutionPlayer& evolution;
  Engine& engine;
  LayerStack& layers;
  BundleDesk& bundles;
  Canvas& canvas;
  Picture& picture;
  FileDesk& files;
  Settings& settings;
  const ComputationSettings& computation;
  ParameterAnimation& animation;
  Messages& messages;
  RecordDesk& record;
  const FrameTimes& times;
  std::span<const SampleShape> shapes;
  std::function<void(const ComputationSettings&)> set_computation;
  std::function<void(const std::string&)> open_file;               ///< asks before unsaved work is lost
  std::function<void(const SampleShape&)> open_shape;              ///< the same
  std::function<void(std::optional<std::size_t>)> export_bundles;  ///< asks for a file for one or all
};

/// A rectangle of the window, in screen coordinates.
struct PanelArea {
  ImVec2 at;
  ImVec2 size;
};

/// A fixed panel without title; pair with ImGui::End().
inline bool begin_panel(const char* name, const PanelArea& area, ImGuiWindowFlags extra = 0) {
  ImGui::SetNextWindowPos(area.at);
  ImGui::SetNextWindowSize(area.size);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0F);
  const bool open = ImGui::Begin(name, nullptr,
                                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                     ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoBringToFrontOnFocus |
                                     ImGuiWindowFlags_NoNavFocus | ImGuiWindowFlags_NoSavedSettings | extra);
  ImGui::PopStyleVar();
  return open;
}

/// Explains the last item when the pointer rests on it, also when it is disabled.
inline void tooltip(const Gui& gui, const std::string& text) {
  if (text.empty() || !gui.is_resting() || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(340.0F * gui.unit());
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

}  // namespace mes
