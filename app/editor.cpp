// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor.h"

namespace mes {

Editor::Editor(Listener listener) : index_(document_), listener_(std::move(listener)) {}

void Editor::apply(const DocumentDelta& delta) {
  document_.apply(delta);
  index_.follow(delta);
  selection_.follow(delta);
  if (listener_) listener_(std::make_shared<const DocumentDelta>(delta));
}

Expected<void> Editor::load(const SampleData& data) {
  auto delta = replace_all(document_, data);
  if (!delta) return std::unexpected(delta.error());
  if (in_gesture()) end_gesture();
  apply(*delta);
  history_.clear();
  mark_saved();
  return {};
}

Expected<std::vector<Slot>> Editor::insert(std::span<const Vec2> positions, const std::string& name) {
  auto delta = insert_samples(document_, positions);
  if (!delta) return std::unexpected(delta.error());
  std::vector<Slot> slots;
  slots.reserve(delta->edits.size());
  for (const SampleEdit& edit : delta->edits) slots.push_back(edit.slot);
  if (!delta->is_empty()) apply(*delta);
  history_.record(*delta, name);
  return slots;
}

Expected<void> Editor::move(std::span<const std::pair<SampleId, Vec2>> targets, const std::string& name) {
  auto delta = move_samples(document_, targets);
  if (!delta) return std::unexpected(delta.error());
  if (delta->is_empty()) return {};
  apply(*delta);
  history_.record(*delta, name);
  return {};
}

Expected<void> Editor::remove(std::span<const SampleId> ids, const std::string& name) {
  auto delta = remove_samples(document_, ids);
  if (!delta) return std::unexpected(delta.error());
  if (delta->is_empty()) return {};
  apply(*delta);
  history_.record(*delta, name);
  return {};
}

Expected<void> Editor::remove_selection() {
  std::vector<SampleId> ids;
  for (const Slot slot : selection_.slots()) ids.push_back(document_.id(slot));
  return remove(ids, ids.size() == 1 ? "Delete sample" : "Delete samples");
}

Expected<void> Editor::nudge_selection(Vec2 offset) {
  std::vector<std::pair<SampleId, Vec2>> targets;
  for (const Slot slot : selection_.slots())
    targets.emplace_back(document_.id(slot), document_.position(slot) + offset);
  return move(targets, "Nudge");
}

void Editor::cancel_gesture() {
  if (!in_gesture()) return;
  const std::size_t before = history_.position();
  history_.end_gesture();
  if (history_.position() != before) undo();
}

void Editor::undo() {
  for (const DocumentDelta& delta : history_.undo()) apply(delta);
}

void Editor::redo() {
  for (const DocumentDelta& delta : history_.redo()) apply(delta);
}

}  // namespace mes
