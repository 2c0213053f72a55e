// SPDX-License-Identifier: GPL-3.0-or-later
// Where the number type of the settings judges the dual complex of a union differently from exact arithmetic.
#pragma once

#include <array>
#include <vector>

#include "core/structures/balls/ball_union.h"

namespace mes {

/// Compares the classes of dual edges (none, singular, regular, interior), and which triangles belong to the dual
/// complex. Where more than three balls have a point of equal power, as around every sample that several balls touch,
/// the triangulation of their centres is arbitrary: there an edge between two triangles counts as none, and triangles
/// are compared by number.
///
/// Nothing is compared while the union is exact; otherwise a dual complex in rationals, or from the certificate.
class PrecisionDifference : public Structure {
 public:
  struct Edge {
    FamilySlot ball[2]{};
    std::int8_t chosen = -1, exact = -1;  ///< number of dual triangles at it; -1 = not in the dual complex
  };
  struct Face {
    FamilySlot ball[3]{};
    bool is_exact = false;  ///< true: missing from the chosen dual complex; false: only in the chosen one
  };
  const BallUnion& balls() const { return union_; }
  const std::vector<Edge>& edges() const { return edges_; }
  const std::vector<Face>& faces() const { return faces_; }

  void rebuild(JobControl& job) override;
  bool update(JobControl& job) override;
  void clear_changes() override {}
  std::size_t touched() const override { return 0; }
  StatList statistics() const override;
  std::vector<TableColumns> table_columns() const override;

 protected:
  PrecisionDifference(std::string_view id, BallUnion& balls) : Structure(id, {&balls}), union_(balls) {}

 private:
  void compare_edges(const UnionTables& exact);
  void compare_faces(const UnionTables& exact);
  SiteSlot common_sample_of(const FamilySlot (&ball)[3]) const;

  const BallUnion& union_;
  std::vector<Edge> edges_;
  std::vector<Face> faces_;
};

class APrecisionDifference final : public PrecisionDifference {
 public:
  explicit APrecisionDifference(AUnion& balls) : PrecisionDifference("a-precision-difference", balls) {}
};

class BPrecisionDifference final : public PrecisionDifference {
 public:
  explicit BPrecisionDifference(BUnion& balls) : PrecisionDifference("b-precision-difference", balls) {}
};

}  // namespace mes
