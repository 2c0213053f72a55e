// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/delaunay/last_change.h"

namespace mes {

LastChange::LastChange(Delaunay& delaunay) : Structure("last-change", {&delaunay}), delaunay_(delaunay) {}

void LastChange::clear_changes() {
  face_changes_.clear();
  edge_changes_.clear();
}

void LastChange::rebuild(JobControl&) {
  clear_changes();
  shown_faces_.clear();
  shown_edges_.clear();
  faces_.assign(delaunay_.face_rows(), 0);
  edges_.assign(delaunay_.edge_rows(), 0);
}

bool LastChange::update(JobControl&) {
  const auto follow = [this](const ChangeSet& changes, std::vector<std::uint8_t>& marks, std::vector<Slot>& shown,
                             ChangeSet& out, std::size_t rows, auto is_alive) {
    marks.resize(rows, 0);
    recorder_.begin(rows);
    for (const Slot row : shown) {
      marks[row] = 0;
      recorder_.note(row, true);
    }
    for (const Slot row : changes.touched) {
      marks[row] = 1;
      recorder_.note(row, true);
    }
    for (const Slot row : changes.removed) recorder_.note(row, true);
    shown.assign(changes.touched.begin(), changes.touched.end());
    recorder_.finish(out, is_alive);
  };
  follow(delaunay_.face_changes(), faces_, shown_faces_, face_changes_, delaunay_.face_rows(),
         [this](Slot face) { return delaunay_.face(face).is_alive(); });
  follow(delaunay_.edge_changes(), edges_, shown_edges_, edge_changes_, delaunay_.edge_rows(),
         [this](Slot edge) { return delaunay_.edge(edge).is_alive(); });
  return true;
}

StatList LastChange::statistics() const {
  return {{"faces", static_cast<std::int64_t>(shown_faces_.size())},
          {"edges", static_cast<std::int64_t>(shown_edges_.size())}};
}

}  // namespace mes
