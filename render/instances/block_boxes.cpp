// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/instances/block_boxes.h"

#include <cmath>
#include <limits>

#include "render/instances/instance_encoder.h"

namespace mes::render {
namespace {

Box2 around(Vec2 center, double reach) {
  return {center - Vec2{reach, reach}, center + Vec2{reach, reach}};
}

bool is_invisible(Vec2 p) {
  return p.x == kDrawingLimit && p.y == kDrawingLimit;
}

bool meet(const Box2& a, const Box2& b) {
  return !(a.high.x < b.low.x || a.low.x > b.high.x || a.high.y < b.low.y || a.low.y > b.high.y);
}

/// The part of the disk above a chord is at most half of it; ends may be off their circle by some bits.
Box2 box_of_arc(std::span<const double> encoded) {
  const Vec2 center{encoded[0], encoded[1]};
  const Vec2 from{encoded[2], encoded[3]};
  const Vec2 to{encoded[4], encoded[5]};
  const double radius = encoded[6];
  const double slack = std::abs(distance(center, from) - radius) + std::abs(distance(center, to) - radius);
  if (encoded[7] != 0.0) return around(center, radius + slack);
  constexpr double kBits = 0x1p-40;
  return around(0.5 * (from + to), 0.5 * distance(from, to) + 2.0 * slack + kBits * radius);
}

}  // namespace

Box2 box_of_instance(PrimitiveKind kind, std::span<const double> encoded) {
  const Vec2 first{encoded[0], encoded[1]};
  switch (kind) {
    case PrimitiveKind::point: return is_invisible(first) ? Box2{} : Box2{first, first};
    case PrimitiveKind::disk:
    case PrimitiveKind::circle: return encoded[2] >= 0.0 ? around(first, encoded[2]) : Box2{};
    case PrimitiveKind::segment: {
      // A long segment may be cut at exactly the corner that stands for invisible ones.
      const Vec2 second{encoded[2], encoded[3]};
      if (is_invisible(first) && is_invisible(second)) return {};
      Box2 out{first, first};
      out.add(second);
      return out;
    }
    case PrimitiveKind::parabola:
    case PrimitiveKind::triangle: {
      if (is_invisible(first)) return {};
      Box2 out{first, first};
      out.add(Vec2{encoded[2], encoded[3]});
      out.add(Vec2{encoded[4], encoded[5]});
      return out;
    }
    case PrimitiveKind::arc: return encoded[6] >= 0.0 ? box_of_arc(encoded) : Box2{};
    case PrimitiveKind::ray:
    case PrimitiveKind::line: break;
  }
  return around({}, std::numeric_limits<double>::infinity());
}

void BlockBoxes::add(std::size_t instance, const Box2& box) {
  const std::size_t block = instance / kBlock;
  if (boxes_.size() <= block) boxes_.resize(block + 1);
  boxes_[block].add(box);
}

std::span<const BlockBoxes::Run> BlockBoxes::runs(std::uint32_t count, const Box2& view) {
  runs_.clear();
  for (std::uint32_t first = 0; first < count; first += kBlock) {
    const std::size_t block = first / kBlock;
    if (block >= boxes_.size()) break;
    if (boxes_[block].is_empty() || !meet(boxes_[block], view)) continue;
    const std::uint32_t end = std::min(count, first + kBlock);
    // Another draw call costs about as much as a block of invisible instances.
    if (!runs_.empty() && first - (runs_.back().first + runs_.back().count) <= kBlock)
      runs_.back().count = end - runs_.back().first;
    else
      runs_.push_back({first, end - first});
  }
  return runs_;
}

}  // namespace mes::render
