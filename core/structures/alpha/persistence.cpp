// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/alpha/persistence.h"

#include <numeric>
#include <utility>

namespace mes {
namespace {

/// Disjoint sets, each represented by one element.
class Parts {
 public:
  explicit Parts(std::size_t count) : above_(count), size_(count, 1), chief_(count) {
    std::iota(above_.begin(), above_.end(), 0U);
    std::iota(chief_.begin(), chief_.end(), 0U);
  }
  std::uint32_t find(std::uint32_t i) {
    while (above_[i] != i) i = above_[i] = above_[above_[i]];
    return i;
  }
  std::uint32_t chief(std::uint32_t root) const { return chief_[root]; }
  void join(std::uint32_t a, std::uint32_t b, std::uint32_t chief) {
    if (size_[a] < size_[b]) std::swap(a, b);
    above_[b] = a;
    size_[a] += size_[b];
    chief_[a] = chief;
  }

 private:
  std::vector<std::uint32_t> above_;
  std::vector<std::uint32_t> size_;
  std::vector<std::uint32_t> chief_;
};

}  // namespace

std::vector<PersistentClass> persistent_classes(const PlaneFiltration& plane) {
  std::vector<PersistentClass> out;
  Parts components(plane.corners.size());
  std::vector<std::uint32_t> closing;  // edges whose ends were connected already
  for (std::uint32_t i = 0; i < plane.edges.size(); ++i) {
    const PlaneFiltration::Edge& edge = plane.edges[i];
    const std::uint32_t a = components.find(edge.end[0]);
    const std::uint32_t b = components.find(edge.end[1]);
    if (a == b) {
      closing.push_back(i);
      continue;
    }
    std::uint32_t older = components.chief(a);
    std::uint32_t younger = components.chief(b);
    if (plane.corners[younger].place < plane.corners[older].place) std::swap(older, younger);
    components.join(a, b, older);
    if (plane.corners[younger].rank < edge.rank)
      out.push_back({false, younger, i, plane.corners[younger].rank, edge.rank});
  }

  // The outside counts as one more triangle, later than all others.
  const auto outside = static_cast<std::uint32_t>(plane.triangles.size());
  const auto number_of = [outside](std::uint32_t side) { return side == PlaneFiltration::kOutside ? outside : side; };
  Parts holes(plane.triangles.size() + 1);
  for (auto i = closing.rbegin(); i != closing.rend(); ++i) {
    const PlaneFiltration::Edge& edge = plane.edges[*i];
    const std::uint32_t a = holes.find(number_of(edge.side[0]));
    const std::uint32_t b = holes.find(number_of(edge.side[1]));
    if (a == b) continue;
    std::uint32_t stays = holes.chief(a);
    std::uint32_t ends = holes.chief(b);
    if (ends == outside || (stays != outside && plane.triangles[stays].place < plane.triangles[ends].place))
      std::swap(stays, ends);
    holes.join(a, b, stays);
    if (edge.rank < plane.triangles[ends].rank)
      out.push_back({true, *i, ends, edge.rank, plane.triangles[ends].rank});
  }

  for (std::uint32_t i = 0; i < plane.corners.size(); ++i)
    if (const std::uint32_t root = components.find(i); components.chief(root) == i)
      out.push_back({false, i, PersistentClass::kNever, plane.corners[i].rank, PersistentClass::kNever});
  return out;
}

}  // namespace mes
