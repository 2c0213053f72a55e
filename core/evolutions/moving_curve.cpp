// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evolutions/moving_curve.h"

#include <algorithm>

#include "core/document/commands.h"
#include "core/structures/crust/curve.h"

namespace mes {
namespace {

// A shorter loop encloses nothing: its samples have the same neighbour on both sides.
constexpr std::size_t kSmallestLoop = 3;

void find_who_moves(MovingCurve& curve, std::size_t samples) {
  std::vector<std::uint8_t> met(samples, 0);
  const auto meet = [&met](std::uint32_t sample, std::uint8_t times) {
    met[sample] = static_cast<std::uint8_t>(std::min(2, met[sample] + times));
  };
  for (const MovingCurve::Chain& chain : curve.chains) {
    const bool is_short = chain.points.size() < kSmallestLoop;
    for (std::size_t i = 0; i < chain.points.size(); ++i) {
      const bool is_end = !chain.closed && (i == 0 || i + 1 == chain.points.size());
      meet(chain.points[i], is_short || is_end ? 2 : 1);
    }
  }
  curve.may_move.assign(samples, false);
  for (std::size_t i = 0; i < samples; ++i) curve.may_move[i] = met[i] == 1;
}

}  // namespace

MovingCurve known_curve(std::vector<MovingCurve::Chain> chains, std::size_t samples) {
  MovingCurve out;
  out.chains = std::move(chains);
  out.is_known = true;
  find_who_moves(out, samples);
  return out;
}

MovingCurve crust_curve(const std::vector<Vec2>& positions, JobControl& job) {
  Document document;
  const auto delta = replace_all(document, {.positions = positions});
  if (!delta) throw GeometryError(delta.error().text);
  Samples samples;
  Delaunay delaunay(samples);
  OneStepCrust crust(delaunay);
  Labels labels(delaunay, crust);
  Curve curve(delaunay, crust, labels);
  samples.post(std::make_shared<const DocumentDelta>(*delta));
  for (Structure* structure :
       {static_cast<Structure*>(&samples), static_cast<Structure*>(&delaunay), static_cast<Structure*>(&crust),
        static_cast<Structure*>(&labels), static_cast<Structure*>(&curve)})
    structure->rebuild(job);

  MovingCurve out;
  // Equal samples are represented by the first of them.
  constexpr std::uint32_t kNone = 0xffffffffU;
  Table<SiteSlot, std::uint32_t> first(delaunay.site_rows(), kNone);
  for (std::uint32_t i = 0; i < positions.size(); ++i) {
    std::uint32_t& leader = first[delaunay.site_of_sample(SampleSlot(i))];
    if (leader == kNone)
      leader = i;
    else
      out.followers.emplace_back(i, leader);
  }
  for (const Curve::Chain& chain : curve.chains()) {
    if (chain.sites.empty()) continue;
    MovingCurve::Chain& to = out.chains.emplace_back(MovingCurve::Chain{chain.closed, {}});
    to.points.reserve(chain.sites.size());
    for (const SiteSlot site : chain.sites) to.points.push_back(first[site]);
  }
  // Sort, because the rows of structures are in no fixed order.
  std::ranges::sort(out.chains, {}, &MovingCurve::Chain::points);
  find_who_moves(out, positions.size());
  return out;
}

void gather_followers(const MovingCurve& curve, std::vector<Vec2>& positions) {
  for (const auto& [follower, leader] : curve.followers) positions[follower] = positions[leader];
}

}  // namespace mes
