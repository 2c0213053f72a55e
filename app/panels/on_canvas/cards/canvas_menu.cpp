// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/on_canvas/cards/canvas_menu.h"

#include <string>
#include <utility>

#include "app/panels/on_canvas/cards/provenance_card.h"
#include "app/ui/widgets/widgets.h"

namespace mes {
namespace {

constexpr const char* kMenuId = "##canvas-menu";

}  // namespace

void CanvasMenu::open(Engine& engine, const LayerStack& layers, Target target, bool may_ask) {
  target_ = std::move(target);
  layer_ = kNoLayer;
  is_wanted_ = true;
  ++ticket_;
  is_asking_ = may_ask && !engine.status().busy;
  if (!is_asking_) return;
  ProvenanceQuestion question = question_at(target_.pointer, layers);
  question.ticket = ticket_;
  // A question for the shape alone could replace that of the element under the pointer, or be replaced by it, and one
  // of the two would wait for ever. Only clicks ask for the story.
  question.wish = ProvenanceWish::story;
  engine.ask(std::move(question));
}

bool CanvasMenu::take(const Provenance& answer) {
  if (answer.ticket < kFirstTicket || answer.ticket >= 2 * kFirstTicket) return false;
  if (answer.ticket != ticket_ || !std::exchange(is_asking_, false)) return true;
  if (!answer.lines.empty()) layer_ = answer.layer.layer;
  return true;
}

CanvasMenu::Choice CanvasMenu::draw(const Gui& gui, const ActionBindings& actions, const LayerStack& layers,
                                    const Engine& engine) {
  if (is_asking_ && engine.status().busy) is_asking_ = false;
  // Dear ImGui closes popups at the press of the button, which may be in this frame.
  const bool is_pressed = ImGui::IsMouseDown(ImGuiMouseButton_Right) || ImGui::IsMouseClicked(ImGuiMouseButton_Right);
  if (is_wanted_ && !is_asking_ && !is_pressed) {
    is_wanted_ = false;
    ImGui::OpenPopup(kMenuId);
  }
  if (!ImGui::IsPopupOpen(kMenuId)) return Choice::none;
  ImGui::SetNextWindowPos(target_.at, ImGuiCond_Appearing);
  if (!begin_popup(gui, kMenuId)) return Choice::none;
  const Choice out = draw_rows(gui, actions, layers);
  ImGui::EndPopup();
  return out;
}

CanvasMenu::Choice CanvasMenu::draw_rows(const Gui& gui, const ActionBindings& actions,
                                         const LayerStack& layers) const {
  Choice out = Choice::none;
  const auto item = [&](const char* label, const char* shortcut, Choice choice, const char* explanation) {
    if (ImGui::MenuItem(label, shortcut)) out = choice;
    tooltip(gui, explanation);
  };
  const auto rows = [&](std::initializer_list<ActionId> ids) {
    for (const ActionId id : ids) action_item(gui, actions, id);
  };
  const auto heading = [&](const std::string& text) {
    ImGui::PushFont(gui.bold());
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopFont();
  };
  const std::string delete_key = actions.keymap().key_of(ActionId::delete_selection);
  if (target_.annotation) {
    heading("Annotation");
    item("Edit", nullptr, Choice::edit_annotation, "Choose this annotation and open its card");
    item("Delete", delete_key.c_str(), Choice::delete_annotation, "Delete this annotation");
    rows({ActionId::toggle_annotations});
    ImGui::Separator();
  } else if (!target_.selected.empty()) {
    heading(target_.selected);
    rows({ActionId::delete_selection, ActionId::copy, ActionId::cut, ActionId::duplicate});
    if (target_.has_samples) rows({ActionId::select_curve});
    rows({ActionId::toggle_selection, ActionId::fit_selection});
    ImGui::Separator();
  }
  if (layer_ != kNoLayer) {
    heading(layers.descriptor(layer_).name);
    item("Explain this element", "Ctrl+click", Choice::show_card,
         "Open a card on the element: what it derives from and what it leads to");
    item("Hide this layer", nullptr, Choice::hide_layer, "Hide the layer of this element");
    if (layers.soloed() == layer_)
      item("End solo", nullptr, Choice::end_solo, "Show the other layers again");
    else
      item("Only this layer", nullptr, Choice::show_layer_alone, "Show this layer alone, until solo ends");
    ImGui::Separator();
  }
  item("Insert a sample here", nullptr, Choice::insert_sample, "Add a sample where the menu was opened");
  item("Annotate here", nullptr, Choice::annotate, "Write words where the menu was opened");
  rows({ActionId::paste, ActionId::select_all, ActionId::undo, ActionId::fit, ActionId::export_figure});
  return out;
}

}  // namespace mes
