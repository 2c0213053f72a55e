// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/balls/local_balls.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/jobs/parallel.h"
#include "core/kernel/circumcircle.h"
#include "core/structures/triangulation/hilbert.h"

namespace mes {
namespace {

std::array<Vec2, 3> corners_in_order(const BallFamily& family, FamilySlot row) {
  std::array<Vec2, 3> out = family.corners(row);
  std::ranges::sort(out, lexicographically_less);
  return out;
}

// Neighbours in the plane are consecutive, and so are their rows in all tables made from them.
std::vector<FamilySlot> rows_by_place(const BallFamily& family, JobControl& job) {
  struct Found {
    std::vector<Keyed<FamilySlot>> rows;
    std::vector<Vec2> centers;
    Box2 box;
  };
  std::vector<Found> parts(chunk_count(family.rows()));
  parallel_for(family.rows(), [&](std::size_t begin, std::size_t end, std::size_t part) {
    job.checkpoint();
    Found found;
    for (const FamilySlot row : slots_between<FamilySlot>(begin, end)) {
      if (!family.is_ball(row)) continue;
      found.rows.push_back({0, row});
      found.centers.push_back(family.disk(row).center);
      if (is_finite(found.centers.back())) found.box.add(found.centers.back());
    }
    parts[part] = std::move(found);
  });
  Box2 box;
  for (const Found& part : parts) {
    if (part.box.is_empty()) continue;
    box.add(part.box.low);
    box.add(part.box.high);
  }
  const HilbertGrid grid(box);
  run_tasks(parts.size(), [&](std::size_t part) {
    Found& found = parts[part];
    for (std::size_t i = 0; i < found.rows.size(); ++i)
      if (is_finite(found.centers[i])) found.rows[i].key = grid.key(found.centers[i]);
  });
  std::vector<Keyed<FamilySlot>> order;
  order.reserve(family.rows());
  for (const Found& part : parts) order.insert(order.end(), part.rows.begin(), part.rows.end());
  std::vector<Keyed<FamilySlot>> scratch;
  radix_sort(order, scratch, 32);
  job.checkpoint();
  // A ball far away makes the grid coarse, so that many balls have the same key.
  constexpr std::uint32_t kOften = 1U << 16U;
  std::uint32_t compared = 0;
  // The order decides ties, so it must not depend on the numbers of rows.
  for (auto begin = order.begin(); begin != order.end();) {
    const auto end =
        std::find_if(begin, order.end(), [&](const Keyed<FamilySlot>& item) { return item.key != begin->key; });
    if (end - begin > 1) {
      std::ranges::sort(begin, end, [&](const Keyed<FamilySlot>& a, const Keyed<FamilySlot>& b) {
        if (++compared % kOften == 0) job.checkpoint();
        const Disk p = family.disk(a.slot);
        const Disk q = family.disk(b.slot);
        if (p.center != q.center) return lexicographically_less(p.center, q.center);
        if (p.radius != q.radius) return p.radius < q.radius;
        // Different circles may be rounded to one disk; the first of the two then stands for both.
        return std::ranges::lexicographical_compare(corners_in_order(family, a.slot),
                                                    corners_in_order(family, b.slot), lexicographically_less);
      });
    }
    begin = end;
  }
  std::vector<FamilySlot> rows(order.size());
  std::ranges::transform(order, rows.begin(), &Keyed<FamilySlot>::slot);
  return rows;
}

/// The balls of some rows as they are.
struct PlainBalls {
  std::vector<PipelineBall> balls;
  std::vector<TouchedSample> samples;
  std::vector<std::size_t> first_sample;  // by ball
  std::size_t ignored = 0;
  FrameExtent extent;
};

void add_to_extent(const PipelineBall& ball, FrameExtent& extent) {
  if (ball.origin == BallOrigin::circumdisk) {
    for (const Vec2 corner : ball.corner) extent.add_position(corner);
  } else {
    extent.add_position(ball.disk.center);
    if (ball.origin == BallOrigin::through_sample) extent.add_position(ball.corner[0]);
  }
  if (ball.origin == BallOrigin::disk) extent.add_length(ball.disk.radius);
  extent.add_derived(ball.drawn);
}

PlainBalls plain_balls(const BallFamily& family, std::span<const FamilySlot> rows, PointBalls points) {
  PlainBalls out;
  out.balls.reserve(rows.size());
  out.first_sample.reserve(rows.size());
  if (family.touch_samples()) out.samples.reserve(3 * rows.size());
  for (const FamilySlot row : rows) {
    PipelineBall ball;
    ball.row = row;
    ball.disk = family.plain_disk(row);
    ball.scale = family.scale();
    ball.origin = family.origin(row);
    if (ball.origin == BallOrigin::circumdisk) {
      std::ranges::copy(family.corners(row), ball.corner);
      std::ranges::rotate(ball.corner, std::ranges::min_element(ball.corner, lexicographically_less));
    }
    ball.drawn = {ball.disk.center, ball.radius()};
    // A ball that no double can hold cannot be drawn either.
    if (!is_finite(ball.drawn) || (!(ball.drawn.radius > 0.0) && points == PointBalls::ignored)) {
      ++out.ignored;
      continue;
    }
    out.first_sample.push_back(out.samples.size());
    if (family.touch_samples()) family.touched_samples(row, out.samples);
    if (ball.origin == BallOrigin::through_sample) ball.corner[0] = out.samples.back().position;
    add_to_extent(ball, out.extent);
    out.balls.push_back(ball);
  }
  return out;
}

// A circumdisk is rounded once more, in the frame, where there is more room for digits.
void bring_into(const LocalFrame& frame, PipelineBall& ball) {
  ball.disk = {frame.to_local(ball.disk.center), frame.to_local_length(ball.disk.radius)};
  if (ball.origin == BallOrigin::disk) return;
  for (Vec2& corner : ball.corner) corner = frame.to_local(corner);
  if (frame.origin == Vec2{}) return;
  if (ball.origin == BallOrigin::through_sample) {
    ball.disk.radius = distance(ball.disk.center, ball.corner[0]);
    return;
  }
  const Circle circle = circumcircle(ball.corner[0], ball.corner[1], ball.corner[2]);
  ball.disk = {circle.center, circle.radius};
}

}  // namespace

LocalBalls local_balls(const BallFamily& family, JobControl& job, PointBalls points) {
  const std::vector<FamilySlot> rows = rows_by_place(family, job);
  std::vector<PlainBalls> parts(chunk_count(rows.size()));
  parallel_for(rows.size(), [&](std::size_t begin, std::size_t end, std::size_t part) {
    job.checkpoint();
    parts[part] = plain_balls(family, std::span(rows).subspan(begin, end - begin), points);
  });
  LocalBalls out;
  out.rows = family.rows();
  FrameExtent extent;
  std::vector<std::size_t> first_ball{0};
  std::vector<std::size_t> first_sample{0};
  for (const PlainBalls& part : parts) {
    extent.add(part.extent);
    out.ignored += part.ignored;
    first_ball.push_back(first_ball.back() + part.balls.size());
    first_sample.push_back(first_sample.back() + part.samples.size());
  }
  out.frame = extent.frame();
  out.balls.resize(first_ball.back());
  out.samples.resize(first_sample.back());
  run_tasks(parts.size(), [&](std::size_t k) {
    job.checkpoint();
    PlainBalls& part = parts[k];
    for (TouchedSample& sample : part.samples) sample.position = out.frame.to_local(sample.position);
    const std::span<TouchedSample> here = std::span(out.samples).subspan(first_sample[k], part.samples.size());
    std::ranges::copy(part.samples, here.begin());
    part.first_sample.push_back(part.samples.size());
    for (std::size_t i = 0; i < part.balls.size(); ++i) {
      PipelineBall& ball = part.balls[i];
      bring_into(out.frame, ball);
      ball.samples = here.subspan(part.first_sample[i], part.first_sample[i + 1] - part.first_sample[i]);
      out.balls[InputSlot(first_ball[k] + i)] = ball;
    }
  });
  return out;
}

}  // namespace mes
