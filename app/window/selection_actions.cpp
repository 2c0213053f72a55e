// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/selection_actions.h"

#include <memory>
#include <utility>

namespace mes {
namespace {

constexpr double kCopyStepPx = 16.0;

void report(Messages& messages, const Expected<void>& done) {
  if (!done) messages.problem(done.error().message());
}

void bind_clipboard(ActionBindings& actions, const std::shared_ptr<const SelectionUses>& u) {
  const auto has_selection = [u] { return !u->editor.selection().is_empty(); };
  const auto selected = [u] {
    const Selection& selection = u->editor.selection();
    return counted(selection.sample_count(), selection.ball_count());
  };
  // To the lower right.
  const auto step = [u] {
    const double by = kCopyStepPx * u->units_per_px();
    return Vec2{by, -by};
  };
  actions.bind(ActionId::copy, {[u, selected] {
                                  u->to_clipboard(u->desk.text());
                                  u->messages.remark("Copied " + selected());
                                },
                                has_selection});
  actions.bind(ActionId::cut, {[u, selected] {
                                 u->to_clipboard(u->desk.text());
                                 const std::string what = selected();
                                 const Expected<void> done = u->editor.remove_selection();
                                 report(u->messages, done);
                                 if (done) u->messages.remark("Cut " + what);
                               },
                               has_selection});
  actions.bind(ActionId::paste, {[u, selected, step] {
                 const auto degrees = u->settings.keep_degrees ? MapDegrees::kept : MapDegrees::projected;
                 const Expected<void> done = u->desk.paste(u->clipboard(), step(), degrees);
                 report(u->messages, done);
                 if (done) u->messages.remark("Pasted " + selected());
               }});
  actions.bind(ActionId::duplicate, {[u, selected, step] {
                                       const Expected<void> done = u->desk.duplicate(step());
                                       report(u->messages, done);
                                       if (done) u->messages.remark("Duplicated " + selected());
                                     },
                                     has_selection});
}

void bind_arrangement(ActionBindings& actions, const std::shared_ptr<const SelectionUses>& u) {
  const auto bind = [&](ActionId id, std::size_t least, auto act) {
    actions.bind(id, {[u, act] { report(u->messages, act(u->desk)); },
                      [u, least] { return u->editor.selection().size() >= least; }});
  };
  bind(ActionId::mirror_x, 2, [](SelectionDesk& desk) { return desk.mirror(Axis::x); });
  bind(ActionId::mirror_y, 2, [](SelectionDesk& desk) { return desk.mirror(Axis::y); });
  for (std::size_t i = 0; i < kAlignments; ++i)
    bind(nth(ActionId::first_alignment, i), 2,
         [i](SelectionDesk& desk) { return desk.align(static_cast<Alignment>(i)); });
  bind(ActionId::distribute_x, 3, [](SelectionDesk& desk) { return desk.distribute(Axis::x); });
  bind(ActionId::distribute_y, 3, [](SelectionDesk& desk) { return desk.distribute(Axis::y); });
  bind(ActionId::add_circle, 3, [](SelectionDesk& desk) { return desk.add_circle(); });
  const auto bind_exact = [&](ActionId id, std::size_t least, auto act) {
    actions.bind(id, {[u, act] {
                        const Expected<std::string> done = act(u->desk);
                        if (done)
                          u->messages.remark(*done);
                        else
                          u->messages.problem(done.error().message());
                      },
                      [u, least] { return u->editor.selection().size() >= least; }});
  };
  bind_exact(ActionId::put_on_line, 3, [](SelectionDesk& desk) { return desk.put_on_line(); });
  bind_exact(ActionId::put_on_circle, 4, [](SelectionDesk& desk) { return desk.put_on_circle(); });
}

}  // namespace

void bind_selection(ActionBindings& actions, SelectionUses uses) {
  const auto shared = std::make_shared<const SelectionUses>(std::move(uses));
  bind_clipboard(actions, shared);
  bind_arrangement(actions, shared);
}

}  // namespace mes
