// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/delaunay/last_change.h"

namespace mes {

LastChange::LastChange(Delaunay& delaunay) : Structure("last-change", {&delaunay}), delaunay_(delaunay) {}

void LastChange::clear_changes() {
  faces_.changes.clear();
  edges_.changes.clear();
}

template <class Row>
void LastChange::Touched<Row>::forget(std::size_t rows) {
  shown.clear();
  is_touched.assign(rows, 0);
}

template <class Row>
template <class IsAlive>
void LastChange::Touched<Row>::follow(const ChangeSet<Row>& last, std::size_t rows, IsAlive is_alive) {
  is_touched.resize(rows, 0);
  recorder.begin(rows);
  for (const Row row : shown) {
    is_touched[row] = 0;
    recorder.note(row, true);
  }
  for (const Row row : last.touched) {
    is_touched[row] = 1;
    recorder.note(row, true);
  }
  for (const Row row : last.removed) recorder.note(row, true);
  shown.assign(last.touched.begin(), last.touched.end());
  recorder.finish(changes, is_alive);
}

void LastChange::rebuild(JobControl&) {
  clear_changes();
  faces_.forget(delaunay_.face_rows());
  edges_.forget(delaunay_.edge_rows());
}

bool LastChange::update(JobControl&) {
  faces_.follow(delaunay_.face_changes(), delaunay_.face_rows(),
                [this](FaceSlot face) { return delaunay_.face(face).is_alive(); });
  edges_.follow(delaunay_.edge_changes(), delaunay_.edge_rows(),
                [this](EdgeSlot edge) { return delaunay_.edge(edge).is_alive(); });
  return true;
}

StatList LastChange::statistics() const {
  return {{"faces", static_cast<std::int64_t>(faces_.shown.size())},
          {"edges", static_cast<std::int64_t>(edges_.shown.size())}};
}

}  // namespace mes
