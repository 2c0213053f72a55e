// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/work_keeper.h"

#include <chrono>
#include <utility>

#include "core/io/temporary.h"

namespace mes {

WorkKeeper::WorkKeeper(Workspace& work, Messages& messages, std::function<Session()> session_now,
                       std::function<void()> wake)
    : work_(work),
      messages_(messages),
      session_now_(std::move(session_now)),
      autosave_(default_autosave_folder(), wake),
      left_work_(std::async(std::launch::async, [folder = default_autosave_folder(), wake] {
        remove_abandoned_scratch();
        FoundWork found = find_left_work(folder);
        wake();
        return found;
      })) {}

void WorkKeeper::follow(const Rest& rest, const Box2& view) {
  Editor& editor = work_.editor();
  if (rest.controls) editor.note_layers();
  if (rest.all) notes_.follow(editor, surroundings(view));
  autosave_.follow(editor, session_now_);
  if (const std::string problem = autosave_.take_problem(); !problem.empty()) messages_.problem(problem);
}

void WorkKeeper::take_as_noted(const Box2& view) {
  notes_.take_as_noted(work_.editor(), surroundings(view));
}

std::optional<FoundWork> WorkKeeper::take_left_work() {
  const bool is_there =
      left_work_.valid() && left_work_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
  return is_there ? std::optional(left_work_.get()) : std::nullopt;
}

}  // namespace mes
