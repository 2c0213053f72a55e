// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/map_shapes.h"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/base/box2.h"
#include "core/io/curve_samples.h"

namespace mes {
namespace {

// Mean radius of the Earth by the International Union of Geodesy and Geophysics, in kilometres.
constexpr double kEarthRadius = 6371.0088;
constexpr std::size_t kTriangleAndRepetition = 4;

Box2 box_of(const std::vector<Vec2>& positions) {
  Box2 box;
  for (const Vec2 p : positions) box.add(p);
  return box;
}

/// West of the 180th meridian becomes east of it where the map is narrower so.
void join_across_the_antimeridian(std::vector<Vec2>& positions) {
  const auto eastern = [](Vec2 p) { return p.x < 0.0 ? Vec2{p.x + 360.0, p.y} : p; };
  const Box2 box = box_of(positions);
  Box2 turned;
  for (const Vec2 p : positions) turned.add(eastern(p));
  if (turned.high.x - turned.low.x < box.high.x - box.low.x)
    std::ranges::transform(positions, positions.begin(), eastern);
}

std::string in_degrees(double value, char positive, char negative) {
  return fmt::format("{:.4g} {}", std::abs(value), value < 0.0 ? negative : positive);
}

}  // namespace

void MapShapes::end(Kind kind) {
  const std::size_t begin = parts_.empty() ? 0 : parts_.back().end;
  if (begin == positions_.size()) return;
  const bool is_repeated =
      positions_.size() - begin >= kTriangleAndRepetition && positions_[begin] == positions_.back();
  if (kind == Kind::line && is_repeated) kind = Kind::ring;
  parts_.push_back({kind, positions_.size()});
}

bool MapShapes::is_on_earth() const {
  const auto is_position = [](Vec2 p) { return std::abs(p.x) <= 180.0 && std::abs(p.y) <= 90.0; };
  return !positions_.empty() && std::ranges::all_of(positions_, is_position);
}

std::string MapShapes::project() {
  join_across_the_antimeridian(positions_);
  const Box2 box = box_of(positions_);
  const Vec2 middle{0.5 * (box.low.x + box.high.x), 0.5 * (box.low.y + box.high.y)};
  constexpr double kRadian = std::numbers::pi / 180.0;
  const double north = kEarthRadius * kRadian;
  const double east = north * std::cos(middle.y * kRadian);
  for (Vec2& p : positions_) p = {east * (p.x - middle.x), north * (p.y - middle.y)};
  const double longitude = middle.x > 180.0 ? middle.x - 360.0 : middle.x;
  return fmt::format("degrees are projected to kilometres about {}, {}", in_degrees(longitude, 'E', 'W'),
                     in_degrees(middle.y, 'N', 'S'));
}

Expected<LoadedFile> MapShapes::load(const std::string& name, Unit unit, MapDegrees degrees, ReadJob& job) && {
  const bool has_degrees = unit == Unit::degrees && is_on_earth();
  std::string remark;
  if (has_degrees)
    remark = degrees == MapDegrees::projected ? project() : "degrees are kept as coordinates of the plane";
  CurveSet curves;
  std::size_t begin = 0;
  for (const Part& part : parts_) {
    job.checkpoint();
    if (part.kind == Kind::points) {
      for (std::size_t i = begin; i < part.end; ++i) curves.points.push_back(positions_[i]);
    } else {
      PlaneCurve& curve = curves.curves.emplace_back(positions_[begin]);
      for (std::size_t i = begin + 1; i < part.end; ++i) curve.line_to(positions_[i]);
      if (part.kind == Kind::ring) curve.close();
    }
    begin = part.end;
  }
  positions_ = {};
  auto file = load_samples(std::move(curves), {.rule = SamplingRule::vertices}, name, job);
  if (file && has_degrees) {
    file->degrees = degrees;
    file->warnings.push_back(Error{ErrorCode::bad_input, remark, name}.message());
  }
  return file;
}

}  // namespace mes
