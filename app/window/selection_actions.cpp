// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/selection_actions.h"

#include <array>
#include <memory>
#include <string>
#include <utility>

#include "app/actions/refusal.h"

namespace mes {
namespace {

constexpr double kCopyStepPx = 16.0;

struct Bound {
  SelectionUses uses;
  Refusal refusal{uses.messages};

  /// Reports an error; returns whether the action succeeded.
  template <class T>
  bool report(const Expected<T>& done) {
    if (done)
      refusal.forget();
    else
      refusal.say(done.error());
    return done.has_value();
  }
  std::string selected() const {
    const Selection& selection = uses.editor.selection();
    return counted(selection.sample_count(), selection.ball_count());
  }
};
using Shared = std::shared_ptr<Bound>;

void bind_clipboard(ActionBindings& actions, const Shared& shared) {
  const ActionBindings::Condition has_selection{[shared] { return !shared->uses.editor.selection().is_empty(); },
                                                "nothing is selected"};
  // Copies move to the lower right.
  const auto step = [shared] {
    const double by = kCopyStepPx * shared->uses.units_per_px();
    return Vec2{by, -by};
  };
  actions.bind(ActionId::copy, {[shared] {
                                  const SelectionUses& u = shared->uses;
                                  u.to_clipboard(u.commands.text());
                                  u.messages.remark("Copied " + shared->selected());
                                },
                                has_selection});
  actions.bind(ActionId::cut, {[shared] {
                                 const SelectionUses& u = shared->uses;
                                 u.to_clipboard(u.commands.text());
                                 const std::string what = shared->selected();
                                 if (shared->report(u.editor.remove_selection())) u.messages.remark("Cut " + what);
                               },
                               has_selection});
  actions.bind(ActionId::paste, {[shared, step] {
                 const SelectionUses& u = shared->uses;
                 const auto degrees = u.settings.keep_degrees ? MapDegrees::kept : MapDegrees::projected;
                 std::string text = u.clipboard();
                 if (u.commands.begins_document(text, degrees)) return u.open_text(std::move(text));
                 const auto done = u.commands.paste(text, step(), degrees);
                 if (!shared->report(done)) return;
                 u.messages.notices(done->warnings);
                 std::string remark = "Pasted " + shared->selected();
                 if (!done->without.empty()) remark += ", without " + done->without;
                 if (!u.commands.numbers().is_in(u.view())) remark += ", outside the view";
                 u.messages.remark(std::move(remark));
               }});
  actions.bind(ActionId::duplicate, {[shared, step] {
                                       const SelectionUses& u = shared->uses;
                                       if (shared->report(u.commands.duplicate(step())))
                                         u.messages.remark("Duplicated " + shared->selected());
                                     },
                                     has_selection});
}

ActionBindings::Condition at_least(const Shared& shared, std::size_t least) {
  constexpr std::array<const char*, 5> kNumbers{"", "one", "two", "three", "four"};
  return {[shared, least] { return shared->uses.editor.selection().size() >= least; },
          std::string("fewer than ") + kNumbers[least] + " samples or balls are selected"};
}

ActionBindings::Condition exactly_three(const Shared& shared) {
  const auto size = [shared] { return shared->uses.editor.selection().size(); };
  return {{[size] { return size() >= 3; }, "fewer than three samples or balls are selected"},
          {[size] { return size() <= 3; }, "more than three samples or balls are selected"}};
}

void bind_arrangement(ActionBindings& actions, const Shared& shared) {
  const auto bind = [&](ActionId id, std::size_t least, auto act) {
    actions.bind(id, {[shared, act] { shared->report(act(shared->uses.commands)); }, at_least(shared, least)});
  };
  bind(ActionId::mirror_x, 2, [](SelectionCommands& commands) { return commands.mirror(Axis::x); });
  bind(ActionId::mirror_y, 2, [](SelectionCommands& commands) { return commands.mirror(Axis::y); });
  for (std::size_t i = 0; i < kAlignments; ++i)
    bind(nth(ActionId::first_alignment, i), 2,
         [i](SelectionCommands& commands) { return commands.align(static_cast<Alignment>(i)); });
  bind(ActionId::distribute_x, 3, [](SelectionCommands& commands) { return commands.distribute(Axis::x); });
  bind(ActionId::distribute_y, 3, [](SelectionCommands& commands) { return commands.distribute(Axis::y); });
  actions.bind(ActionId::add_circle,
               {[shared] { shared->report(shared->uses.commands.add_circle()); }, exactly_three(shared)});
  const auto bind_exact = [&](ActionId id, std::size_t least, auto act) {
    actions.bind(id, {[shared, act] {
                        const Expected<std::string> done = act(shared->uses.commands);
                        if (shared->report(done)) shared->uses.messages.remark(*done);
                      },
                      at_least(shared, least)});
  };
  bind_exact(ActionId::put_on_line, 3, [](SelectionCommands& commands) { return commands.put_on_line(); });
  bind_exact(ActionId::put_on_circle, 4, [](SelectionCommands& commands) { return commands.put_on_circle(); });
}

}  // namespace

void bind_selection(ActionBindings& actions, SelectionUses uses) {
  const auto shared = std::make_shared<Bound>(std::move(uses));
  bind_clipboard(actions, shared);
  bind_arrangement(actions, shared);
}

}  // namespace mes
