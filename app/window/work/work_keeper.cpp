// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/work/work_keeper.h"

#include <utility>

#include "core/io/files/temporary.h"

namespace mes {

WorkKeeper::WorkKeeper(Workspace& work, Messages& messages, std::function<Session()> session_now,
                       std::function<std::optional<SourceFile>()> kept_in, Waker wake)
    : work_(work),
      messages_(messages),
      session_now_(std::move(session_now)),
      kept_in_(std::move(kept_in)),
      autosave_(default_autosave_folder(), wake),
      left_work_(wake) {
  left_work_.begin([folder = default_autosave_folder()](const std::stop_token& stop) {
    remove_abandoned_scratch();
    return find_left_work(folder, stop);
  });
}

void WorkKeeper::follow(const Rest& rest, const Box2& view) {
  Editor& editor = work_.editor();
  if (rest.controls) editor.note_layers();
  if (rest.all) notes_.follow(editor, surroundings(view));
  autosave_.follow(editor, session_now_, kept_in_);
  if (const std::string problem = autosave_.take_problem(); !problem.empty()) messages_.problem(problem);
}

void WorkKeeper::take_as_noted(const Box2& view) {
  notes_.take_as_noted(work_.editor(), surroundings(view));
}

}  // namespace mes
