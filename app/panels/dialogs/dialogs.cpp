// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/dialogs/dialogs.h"

#include <algorithm>
#include <ranges>

namespace mes {

std::vector<const Dialog*> Dialogs::open() const {
  std::vector<const Dialog*> out;
  for (const Dialog* dialog : all_)
    if (dialog->is_open()) out.push_back(dialog);
  return out;
}

bool Dialogs::take_key(const KeyChord& chord, bool repeated) {
  const auto top = std::ranges::find_if(all_.rbegin(), all_.rend(), [](const Dialog* one) { return one->is_open(); });
  if (top == all_.rend()) return false;
  if ((*top)->is_cancelled_by(chord))
    (*top)->cancel();
  else if (!repeated || chord.symbol != key::enter)
    (*top)->press(chord);
  return true;
}

void Dialogs::draw(const Gui& gui) {
  // Two popups open at one level would close each other, and neither would be seen.
  const std::vector<const Dialog*> shown = open();
  const Dialog* const top = shown.empty() ? nullptr : shown.back();
  for (Dialog* dialog : all_)
    if (dialog == top || !dialog->is_open()) dialog->draw(gui);
}

}  // namespace mes
