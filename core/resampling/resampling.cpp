// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/resampling/resampling.h"

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <numbers>
#include <optional>
#include <unordered_map>
#include <utility>

#include "core/base/geometry/box_tree.h"
#include "core/curves/feature_field.h"
#include "core/curves/interpolation/smooth_curve.h"
#include "core/document/commands.h"
#include "core/document/taken_samples.h"
#include "core/evolutions/moving_curve.h"
#include "core/structures/axis/inner_balls.h"
#include "core/structures/certificate/axis_certificate.h"
#include "core/structures/crust/labels.h"
#include "core/structures/density/curve_sampling.h"
#include "core/structures/density/sample_sizes.h"

namespace mes {
namespace {

/// Two samples that are neighbours along a curve, by number.
struct SampleLink {
  std::uint32_t a = 0;
  std::uint32_t b = 0;
};

/// A crust edge between samples that are not neighbours along the curves, and the local spacing of such neighbours.
struct Rung {
  Vec2 a{}, b{};
  double spacing = 0.0;
};

/// Crust, axis and verdict of a set of samples.
class Measured {
 public:
  Measured() { certificate_.forgo_updates(); }
  /// Error: a coordinate out of range.
  static Expected<std::unique_ptr<Measured>> of(std::span<const Vec2> positions, JobControl& job) {
    auto out = std::make_unique<Measured>();
    auto delta = replace_all(out->document_, {.positions = {positions.begin(), positions.end()}});
    if (!delta) return std::unexpected(delta.error());
    out->document_.apply(*delta);
    out->samples_.post(std::make_shared<const DocumentDelta>(*std::move(delta)));
    out->make(job, {&out->samples_, &out->delaunay_, &out->crust_});
    return out;
  }
  std::vector<Finding> standing_findings(const CurveStanding& standing) const {
    std::vector<SampleSlot> slots;
    for (std::size_t i = 0; i < document_.sample_count(); ++i) slots.emplace_back(i);
    return findings_of(standing, slots, delaunay_, crust_);
  }
  /// Reports behind the theorem light, for these samples and for the curves that they stand for. The certificate is
  /// asked only if nothing else makes the light yellow: its search is long where the crust is not the curve.
  std::vector<NodeReport> judged(const CurveStanding& standing, JobControl& job) {
    std::vector<NodeReport> out(2);
    out[0].findings = standing_findings(standing);
    crust_.find(out[1].findings);
    for (NodeReport& node : out) node.state = NodeState::up_to_date;
    // A doubt asks for more samples, whether or not there are inner balls.
    const auto is_doubted = [](const NodeReport& node) {
      return std::ranges::find(node.findings, FindingLevel::doubt, &Finding::level) != node.findings.end();
    };
    if (std::ranges::any_of(out, is_doubted)) {
      out[0].is_judging = true;
      return out;
    }
    make(job, {&labels_, &vertices_, &balls_, &certificate_});
    for (const Structure* structure : std::initializer_list<const Structure*>{&labels_, &certificate_}) {
      NodeReport& node = out.emplace_back();
      node.state = NodeState::up_to_date;
      node.is_judging = structure->has_verdict();
      structure->find(node.findings);
    }
    return out;
  }
  /// Finds where parts of the curves are nearer to each other than their samples: there the crust is not the curves.
  std::vector<Rung> rungs(std::span<const SampleLink> links) const;

 private:
  static void make(JobControl& job, std::initializer_list<Structure*> structures) {
    for (Structure* structure : structures) {
      job.checkpoint();
      structure->rebuild(job);
    }
  }

  Document document_;
  Samples samples_;
  Delaunay delaunay_{samples_};
  OneStepCrust crust_{delaunay_};
  Labels labels_{delaunay_, crust_};
  VoronoiVertices vertices_{delaunay_, crust_};
  InnerBalls balls_{delaunay_, vertices_, labels_};
  AxisCertificate certificate_{delaunay_, labels_, balls_};
};

std::vector<Rung> Measured::rungs(std::span<const SampleLink> links) const {
  const auto site = [&](std::uint32_t sample) { return delaunay_.site_of_sample(SampleSlot(sample)); };
  // Curves that meet in a sample have more than two neighbours there; the further ones are kept in `rest`.
  Table<SiteSlot, std::array<SiteSlot, 2>> beside;
  beside.resize(delaunay_.site_rows(), {kNoSlot, kNoSlot});
  std::unordered_multimap<SiteSlot, SiteSlot> rest;
  const auto note = [&](SiteSlot from, SiteSlot to) {
    for (SiteSlot& slot : beside[from])
      if (slot == kNoSlot || slot == to) {
        slot = to;
        return;
      }
    rest.emplace(from, to);
  };
  for (const auto& [a, b] : links) {
    note(site(a), site(b));
    note(site(b), site(a));
  }
  std::vector<Rung> out;
  for (const EdgeSlot edge : delaunay_.edge_slots()) {
    if (!delaunay_.edge(edge).is_alive() || !crust_.is_crust(edge)) continue;
    const auto& [a, b] = delaunay_.edge(edge).v;
    const auto& near = beside[a];
    if (near[0] == kNoSlot || beside[b][0] == kNoSlot || near[0] == b || near[1] == b) continue;
    const auto [first, end] = rest.equal_range(a);
    if (std::any_of(first, end, [b = b](const auto& link) { return link.second == b; })) continue;
    const auto place = [&](SiteSlot at) { return delaunay_.site_position(at); };
    out.push_back({place(a), place(b), distance(place(a), place(near[0]))});
  }
  return out;
}

/// Positions numbered in the order of insertion, with nearest-neighbour search. Cost: typically O(log n) for each call.
class PlaceTree {
 public:
  void add(Vec2 at) {
    places_.push_back({at, static_cast<std::uint32_t>(places_.size())});
    if (tree_.is_worn())
      tree_.build(std::span<const Place>(places_), bounds_of, [](const Place&, std::uint32_t) {});
    else
      tree_.insert(places_.back(), bounds_of, [](const Place&, std::uint32_t) {});
  }

  /// The nearest position within `reach`; of equally near ones the first.
  std::optional<std::uint32_t> nearest(Vec2 to, double reach) const {
    std::optional<std::uint32_t> out;
    double away = reach;
    double bound = reach * reach;  // of squared distances; slightly too large does no harm
    tree_.visit_near(to, bound, [&](const Place& place) {
      const double d = distance(place.at, to);
      if (!(d < away || (d == away && out && place.number < *out))) return;
      away = d;
      bound = d * d * (1.0 + 0x1p-40);
      out = place.number;
    });
    return out;
  }

 private:
  struct Place {
    Vec2 at{};
    std::uint32_t number = 0;
  };
  static TreeBounds bounds_of(const Place& place) { return {{place.at, place.at}}; }

  BoxTree<Place> tree_;
  std::vector<Place> places_;
};

/// Pairs of neighbours along the contours.
std::vector<SampleLink> links_of(std::span<const SampleData::Contour> contours) {
  std::vector<SampleLink> out;
  for (const SampleData::Contour& contour : contours) {
    const std::vector<std::uint32_t>& points = contour.points;
    for (std::size_t i = 1; i < points.size(); ++i) out.push_back({points[i - 1], points[i]});
    if (contour.closed && points.size() > 2) out.push_back({points.back(), points.front()});
  }
  return out;
}

std::unexpected<Error> too_near(std::vector<Rung> rungs) {
  const auto middle = rungs.begin() + static_cast<std::ptrdiff_t>(rungs.size() / 2);
  std::ranges::nth_element(rungs, middle, {}, [](const Rung& rung) { return distance(rung.a, rung.b); });
  const Vec2 at = 0.5 * (middle->a + middle->b);
  return std::unexpected(
      Error{ErrorCode::bad_input,
            fmt::format("parts of the curves are too near to each other to be sampled by local feature size: about "
                        "{:.6g} {:.6g} they are {:.3g} apart, and samples along them {:.3g}, which is as near as "
                        "they may be",
                        at.x, at.y, distance(middle->a, middle->b), middle->spacing)});
}

/// Judges the samples of the data. Error: the samples are as dense as allowed, and most are still too far apart for the
/// crust to be the curves.
Expected<void> judge(TakenSamples& taken, const CurveSet& curves, const SamplingRequest& request,
                     const FeatureField& field, JobControl& job) {
  const auto measured = Measured::of(taken.data.positions, job);
  if (!measured) return std::unexpected(measured.error());
  taken.standing = field.standing(taken.data.positions, &job);
  const std::vector<SampleLink> links = links_of(taken.data.contours);
  const std::vector<Rung> rungs = (*measured)->rungs(links);
  // Crossings and corners have a few rungs. Many rungs are a ladder between two sides of something thin: a proof would
  // then concern another curve, and the certificate takes longest to search arcs that pass along a ladder.
  constexpr std::size_t kFew = 10;
  std::vector<Vec2> failures;
  if (kFew * rungs.size() > links.size()) {
    // The number of links when all samples are as dense as allowed.
    const double most = kFinestFeature * static_cast<double>(request.count);
    if (2.0 * static_cast<double>(links.size()) > most) return too_near(rungs);
    NodeReport node;
    node.findings = (*measured)->standing_findings(taken.standing);
    taken.verdict = sampling_verdict(std::span(&node, 1));
    taken.verdict.light = TheoremLight::yellow;
    for (const Rung& rung : rungs) failures.push_back(0.5 * (rung.a + rung.b));
  } else {
    const std::vector<NodeReport> nodes = (*measured)->judged(taken.standing, job);
    taken.verdict = sampling_verdict(nodes);
    for (const Rung& rung : rungs) taken.extra_edges.push_back(0.5 * (rung.a + rung.b));
    if (taken.is_proved()) return {};
    for (const NodeReport& node : nodes)
      for (const Finding& finding : node.findings)
        if (finding.level != FindingLevel::note)
          failures.insert(failures.end(), finding.places.begin(), finding.places.end());
  }
  // A failure belongs to the nearest corner within a few typical spacings.
  const double reach = [&] {
    Box2 extent;
    for (const Vec2 p : taken.data.positions) extent.add(p);
    constexpr double kShare = 0.02;
    return kShare * length(Vec2{extent.width(), extent.height()});
  }();
  const std::vector<CurveCorner> corners =
      request.corner_radius > 0.0 ? std::vector<CurveCorner>() : corners_of(curves, request.corner_angle);
  std::vector<bool> is_named(corners.size(), false);
  PlaceTree corner_tree;
  for (const CurveCorner& corner : corners) corner_tree.add(corner.place);
  PlaceTree other_tree;
  for (const Vec2 place : failures) {
    job.checkpoint();
    // Adjacent failures count as one.
    constexpr double kBeside = 0.1;
    if (const auto nearest = corner_tree.nearest(place, reach)) {
      is_named[*nearest] = true;
    } else if (!other_tree.nearest(place, kBeside * reach)) {
      other_tree.add(place);
      taken.other_places.push_back(place);
    }
  }
  for (std::size_t i = 0; i < corners.size(); ++i)
    if (is_named[i]) taken.corners.push_back(corners[i]);
  return {};
}

/// Keeps `asked` with the samples as their sampling method.
Expected<TakenSamples> taken_as(Expected<SampledCurves> samples, const std::shared_ptr<const CurveSet>& curves,
                                const SamplingRequest& asked) {
  if (!samples) return std::unexpected(samples.error());
  auto data = taken_from(curves, *std::move(samples), asked);
  if (!data) return std::unexpected(data.error());
  return TakenSamples{.data = *std::move(data)};
}

}  // namespace

Expected<TakenSamples> take_samples(const std::shared_ptr<const CurveSet>& curves, const SamplingRequest& request,
                                    JobControl& job) {
  if (request.rule != SamplingRule::feature_size)
    return taken_as(sample(*curves, request, {}, &job), curves, request);
  if (auto good = check(request); !good) return std::unexpected(good.error());
  SampleSizes sizes(job);
  const auto field = FeatureField::of(
      *curves, request, [&sizes](std::span<const Vec2> positions) { return sizes.of(positions); }, &job,
      request.most);
  if (!field) return std::unexpected(field.error());
  // Jittered samples lie off the curve, so a denser sampling cannot prove anything.
  const int tries = request.jitter > 0.0 ? 1 : 4;
  constexpr double kFiner = 0.63;  // three steps make about a quarter
  std::optional<TakenSamples> first;
  SamplingRequest finer = request;
  for (int i = 0; i < tries; ++i, finer.epsilon = std::max(kLeastEpsilon, kFiner * finer.epsilon)) {
    auto taken = taken_as(sample_by_field(*curves, finer, *field, &job), curves, request);
    if (!taken && first) break;  // more samples than allowed
    if (!taken) return taken;
    if (auto done = judge(*taken, *curves, finer, *field, job); !done) return std::unexpected(done.error());
    if (taken->is_proved()) return taken;
    if (!first) first = *std::move(taken);
    // More samples do not help if all failures are at corners.
    if (first->other_places.empty()) break;
  }
  return *std::move(first);
}

CurveSet curves_through(const std::vector<Vec2>& positions, JobControl& job) {
  // A polygon through samples that turns by more than this has a corner there.
  constexpr double kCorner = 0.9;
  const MovingCurve crust = crust_curve(positions, job);
  CurveSet out;
  std::vector<bool> is_on_curve(positions.size(), false);
  std::vector<Vec2> points;
  for (const MovingCurve::Chain& chain : crust.chains) {
    points.clear();
    for (const std::uint32_t i : chain.points) {
      points.push_back(positions[i]);
      is_on_curve[i] = true;
    }
    out.curves.push_back(smooth_curve(points, chain.closed, kCorner));
  }
  for (const auto& [follower, leader] : crust.followers) is_on_curve[follower] = true;
  for (std::size_t i = 0; i < positions.size(); ++i)
    if (!is_on_curve[i]) out.points.push_back(positions[i]);
  return out;
}

std::string remark_of(const TakenSamples& taken, const SamplingRequest& request) {
  if (request.rule != SamplingRule::feature_size) return {};
  std::string out = taken.standing.off_curve != 0  ? "samples off the curves; "
                    : taken.standing.epsilon > 0.0 ? ""
                                                   : "no axis; ";
  out += taken.verdict.text();
  if (taken.is_proved()) {
    if (taken.extra_edges.empty()) return out;
    const std::size_t count = taken.extra_edges.size();
    const Vec2 first = taken.extra_edges.front();
    return out + fmt::format(", but the crust has {} {} off the curves ({}at {:.6g} {:.6g})", count,
                             count == 1 ? "edge" : "edges", count == 1 ? "" : "the first ", first.x, first.y);
  }
  if (!taken.corners.empty()) {
    const auto sharpest = std::ranges::min_element(taken.corners, {}, &CurveCorner::angle);
    constexpr double kDegrees = 180.0 / std::numbers::pi;
    out += fmt::format(" at {} {} (the sharpest, {:.3g} degrees, at {:.6g} {:.6g}), where no density suffices",
                       taken.corners.size(), taken.corners.size() == 1 ? "corner" : "corners",
                       kDegrees * sharpest->angle, sharpest->place.x, sharpest->place.y);
  }
  if (!taken.other_places.empty()) {
    constexpr std::size_t kNamed = 4;
    const std::size_t count = taken.other_places.size();
    out += fmt::format("{} at {} other {} (", taken.corners.empty() ? "" : ", and", count,
                       count == 1 ? "place" : "places");
    for (std::size_t i = 0; i < std::min(count, kNamed); ++i)
      out += fmt::format("{}{:.6g} {:.6g}", i == 0 ? "" : ", ", taken.other_places[i].x, taken.other_places[i].y);
    out += count > kNamed ? ", ...)" : ")";
  }
  return out;
}

}  // namespace mes
