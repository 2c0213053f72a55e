// SPDX-License-Identifier: GPL-3.0-or-later
// Faces and edges that the last edit touched.
#pragma once

#include <vector>

#include "core/base/change_set.h"
#include "core/graph/structure.h"
#include "core/structures/delaunay/delaunay.h"

namespace mes {

/// Remembers the triangulation's last change sets until the next edit. Rows are Delaunay rows. After a rebuild nothing
/// counts as touched. No other structure depends on history.
class LastChange final : public Structure {
 public:
  explicit LastChange(Delaunay& delaunay);

  bool is_touched_face(FaceSlot face) const { return faces_.is_touched.has(face) && faces_.is_touched[face] != 0; }
  bool is_touched_edge(EdgeSlot edge) const { return edges_.is_touched.has(edge) && edges_.is_touched[edge] != 0; }
  const ChangeSet<FaceSlot>& face_changes() const { return faces_.changes; }
  const ChangeSet<EdgeSlot>& edge_changes() const { return edges_.changes; }

  void rebuild(JobControl& job) override;
  bool update(JobControl& job) override;
  void clear_changes() override;
  std::size_t touched() const override { return faces_.shown.size() + edges_.shown.size(); }
  StatList statistics() const override;
  std::vector<TableColumns> table_columns() const override;

 private:
  /// The record of one table.
  template <class Row>
  struct Touched {
    Table<Row, std::uint8_t> is_touched;
    std::vector<Row> shown;
    ChangeRecorder<Row> recorder;
    ChangeSet<Row> changes;
    void forget(std::size_t rows);
    template <class IsAlive>
    void follow(const ChangeSet<Row>& last, std::size_t rows, IsAlive is_alive);
  };

  Delaunay& delaunay_;
  Touched<FaceSlot> faces_;
  Touched<EdgeSlot> edges_;
};

}  // namespace mes
