// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/balls/precision_difference.h"

#include <algorithm>
#include <map>

namespace mes {
namespace {

using Pair = std::array<FamilySlot, 2>;
using Triple = std::array<FamilySlot, 3>;

std::map<Pair, std::int8_t> edge_classes(const UnionTables& t) {
  std::map<Pair, std::int8_t> out;
  for (const DualEdge& edge : t.dual_edges)
    if (edge.is_alive())
      out[{std::min(edge.ball[0], edge.ball[1]), std::max(edge.ball[0], edge.ball[1])}] =
          static_cast<std::int8_t>(edge.kind);
  return out;
}

std::vector<Triple> sorted_faces(const UnionTables& t) {
  std::vector<Triple> out;
  for (const DualFace& face : t.dual_faces) {
    if (!face.is_alive()) continue;
    out.push_back({face.ball[0], face.ball[1], face.ball[2]});
    std::ranges::sort(out.back());
  }
  std::ranges::sort(out);
  return out;
}

}  // namespace

void PrecisionDifference::rebuild(JobControl& job) {
  edges_.clear();
  faces_.clear();
  if (union_.is_exact()) return;
  const UnionTables exact = union_.exact_dual_complex(job);
  compare_edges(exact);
  job.checkpoint();
  compare_faces(exact);
}

void PrecisionDifference::compare_edges(const UnionTables& exact) {
  const std::map<Pair, std::int8_t> chosen = edge_classes(union_.tables());
  const std::map<Pair, std::int8_t> truth = edge_classes(exact);
  constexpr auto kInterior = static_cast<std::int8_t>(DualClass::interior);
  const auto class_in = [](const std::map<Pair, std::int8_t>& edges, const Pair& pair) {
    const auto found = edges.find(pair);
    return found == edges.end() ? std::int8_t{-1} : found->second;
  };
  const auto compare = [&](const Pair& pair, std::int8_t own, std::int8_t other_exact) {
    if (own == other_exact ||
        std::pair(std::min(own, other_exact), std::max(own, other_exact)) == std::pair(std::int8_t{-1}, kInterior))
      return;
    edges_.push_back({{pair[0], pair[1]}, own, other_exact});
  };
  for (const auto& [pair, kind] : chosen) compare(pair, kind, class_in(truth, pair));
  for (const auto& [pair, kind] : truth)
    if (!chosen.contains(pair)) compare(pair, -1, kind);
}

// The least sample that all three touch; kNoSlot if there is none.
SiteSlot PrecisionDifference::common_sample_of(const FamilySlot (&ball)[3]) const {
  if (!union_.family().touch_samples()) return kNoSlot;
  std::vector<TouchedSample> touched[3];
  for (std::size_t i = 0; i < 3; ++i) union_.family().touched_samples(ball[i], touched[i]);
  SiteSlot least;
  const auto holds = [](const std::vector<TouchedSample>& samples, SiteSlot site) {
    return std::ranges::find(samples, site, &TouchedSample::site) != samples.end();
  };
  for (const TouchedSample& sample : touched[0])
    if (holds(touched[1], sample.site) && holds(touched[2], sample.site)) least = std::min(least, sample.site);
  return least;
}

void PrecisionDifference::compare_faces(const UnionTables& exact) {
  const std::vector<Triple> chosen = sorted_faces(union_.tables());
  const std::vector<Triple> truth = sorted_faces(exact);
  std::vector<Face> found;
  const auto note_those_not_in = [&](const UnionTables& t, const std::vector<Triple>& other, bool is_exact) {
    for (const DualFace& face : t.dual_faces) {
      Triple key{face.ball[0], face.ball[1], face.ball[2]};
      std::ranges::sort(key);
      if (face.is_alive() && !std::ranges::binary_search(other, key))
        found.push_back({{face.ball[0], face.ball[1], face.ball[2]}, is_exact});
    }
  };
  note_those_not_in(exact, chosen, true);
  note_those_not_in(union_.tables(), truth, false);
  // Around a sample only the surplus of one side over the other is a difference.
  std::map<SiteSlot, int> surplus;
  std::vector<SiteSlot> sample(found.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    sample[i] = common_sample_of(found[i].ball);
    if (sample[i] != kNoSlot) surplus[sample[i]] += found[i].is_exact ? 1 : -1;
  }
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (sample[i] != kNoSlot) {
      int& left = surplus[sample[i]];
      if (found[i].is_exact ? left <= 0 : left >= 0) continue;
      left += found[i].is_exact ? -1 : 1;
    }
    faces_.push_back(found[i]);
  }
}

bool PrecisionDifference::update(JobControl&) {
  return union_.is_exact() && edges_.empty() && faces_.empty();
}

StatList PrecisionDifference::statistics() const {
  std::int64_t missed = 0;
  std::int64_t invented = 0;
  std::int64_t other_class = 0;
  for (const Edge& edge : edges_) {
    missed += edge.chosen < 0 ? 1 : 0;
    invented += edge.exact < 0 ? 1 : 0;
    other_class += edge.chosen >= 0 && edge.exact >= 0 ? 1 : 0;
  }
  const auto missed_faces = std::ranges::count(faces_, true, &Face::is_exact);
  return {{"edges_missed", missed},
          {"edges_invented", invented},
          {"edges_of_other_class", other_class},
          {"faces_missed", static_cast<std::int64_t>(missed_faces)},
          {"faces_invented", static_cast<std::int64_t>(faces_.size()) - static_cast<std::int64_t>(missed_faces)}};
}

}  // namespace mes
