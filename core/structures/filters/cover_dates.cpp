// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/filters/cover_dates.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/base/geometry/disk.h"
#include "core/base/jobs/parallel.h"
#include "core/structures/filters/internal/cover_search.h"

namespace mes {
namespace {

constexpr double kNoNode = -1.0;

}  // namespace

CoverDates::CoverDates(Delaunay& delaunay, InnerBalls& balls)
    : Structure("cover-dates", {&delaunay, &balls}), delaunay_(delaunay), balls_(balls) {}

void CoverDates::rebuild(JobControl& job) {
  date_.assign(delaunay_.face_rows(), kNoNode);
  std::vector<FaceSlot> nodes;
  std::vector<Disk> balls;
  Table<FaceSlot, std::uint32_t> number_of(delaunay_.face_rows(), CoverSearch::kNone);
  for (const FaceSlot face : delaunay_.face_slots()) {
    if (!delaunay_.is_finite_face(face) || !is_node(face)) continue;
    const Disk ball{delaunay_.circumcenter(face), delaunay_.circumradius(face)};
    // A ball that no double can hold swallows nothing that can be shown.
    if (!is_finite(ball)) continue;
    number_of[face] = static_cast<std::uint32_t>(nodes.size());
    nodes.push_back(face);
    balls.push_back(ball);
  }
  // Hints: where nothing else is known, a ball is swallowed by one beside it.
  std::vector<CoverSearch::Hints> hints(nodes.size());
  parallel_for(nodes.size(), [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i) {
      hints[i].fill(CoverSearch::kNone);
      std::size_t count = 0;
      for (const EdgeSlot edge : delaunay_.face(nodes[i]).e) {
        if (edge == kNoSlot) continue;
        for (const FaceSlot face : delaunay_.edge(edge).f) {
          if (face == kNoSlot || face == nodes[i]) continue;
          std::uint32_t number = number_of[face];
          if (number == CoverSearch::kNone && balls_.is_ball(face)) number = number_of[balls_.ball(face)];
          hints[i][count++] = number;
        }
      }
    }
  });
  job.checkpoint();
  const CoverSearch search(balls, hints);
  std::vector<double> dates(nodes.size());
  run_tasks(search.part_count(), [&](std::size_t part) { search.search(part, dates, job); });
  for (std::size_t i = 0; i < nodes.size(); ++i) date_[nodes[i]] = dates[i];
}

bool CoverDates::update(JobControl&) {
  return balls_.changes().is_empty();
}

StatList CoverDates::statistics() const {
  std::vector<double> dates;
  std::int64_t never = 0;
  for (const FaceSlot face : date_.rows()) {
    if (!has_date(face)) continue;
    if (date_[face] == CoverSearch::kNever)
      ++never;
    else
      dates.push_back(date_[face]);
  }
  StatList out{{"balls", static_cast<std::int64_t>(dates.size()) + never}, {"never_covered", never}};
  if (dates.empty()) return out;
  const auto middle = dates.begin() + static_cast<std::ptrdiff_t>(dates.size() / 2);
  std::ranges::nth_element(dates, middle);
  out.push_back({"date_median", *middle});
  out.push_back({"date_largest", *std::ranges::max_element(dates)});
  return out;
}

}  // namespace mes
