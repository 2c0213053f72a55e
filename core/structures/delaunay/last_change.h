// SPDX-License-Identifier: GPL-3.0-or-later
// Faces and edges that the last edit touched.
#pragma once

#include <vector>

#include "core/base/change_set.h"
#include "core/graph/structure.h"
#include "core/structures/delaunay/delaunay.h"

namespace mes {

/// Remembers the triangulation's last change sets until the next edit. Rows are Delaunay rows. After a rebuild
/// nothing counts as touched. This is the one structure that is about history.
class LastChange final : public Structure {
 public:
  explicit LastChange(Delaunay& delaunay);

  bool is_touched_face(Slot face) const { return face < faces_.size() && faces_[face] != 0; }
  bool is_touched_edge(Slot edge) const { return edge < edges_.size() && edges_[edge] != 0; }
  const ChangeSet& face_changes() const { return face_changes_; }
  const ChangeSet& edge_changes() const { return edge_changes_; }

  void rebuild(JobControl& job) override;
  bool update(JobControl& job) override;
  void clear_changes() override;
  std::size_t touched() const override { return shown_faces_.size() + shown_edges_.size(); }
  StatList statistics() const override;

 private:
  Delaunay& delaunay_;
  std::vector<std::uint8_t> faces_;
  std::vector<std::uint8_t> edges_;
  std::vector<Slot> shown_faces_;
  std::vector<Slot> shown_edges_;
  ChangeRecorder recorder_;
  ChangeSet face_changes_;
  ChangeSet edge_changes_;
};

}  // namespace mes
