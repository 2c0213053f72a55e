// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/resampling/resampling.h"

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <unordered_map>
#include <utility>

#include "core/base/box_tree.h"
#include "core/curves/finest_feature.h"
#include "core/curves/smooth_curve.h"
#include "core/document/taken_samples.h"
#include "core/evolutions/moving_curve.h"
#include "core/structures/axis/inner_balls.h"
#include "core/structures/certificate/axis_certificate.h"
#include "core/structures/crust/labels.h"
#include "core/structures/density/feature_size.h"

namespace mes {
namespace {

/// Neighbours along a curve, by the numbers of their samples.
struct SampleLink {
  std::uint32_t a = 0;
  std::uint32_t b = 0;
};

/// An edge of the crust between samples of curves that are not neighbours along them, and how far apart such neighbours
/// are there.
struct Rung {
  Vec2 a{}, b{};
  double spacing = 0.0;
};

/// Crust, axis and what is proved of samples.
class Measured {
 public:
  Measured() { certificate_.forgo_updates(); }
  /// Error: a coordinate out of range.
  static Expected<std::unique_ptr<Measured>> of(std::span<const Vec2> positions, JobControl& job) {
    auto out = std::make_unique<Measured>();
    const SampleData data{.positions = {positions.begin(), positions.end()}};
    if (auto done = out->post(replace_all(out->document_, data)); !done) return std::unexpected(done.error());
    out->bring_up_to_date(job, {&out->samples_, &out->delaunay_, &out->crust_, &out->sizes_}, false);
    return out;
  }
  /// More samples, numbered on; what it costs depends on these and what they change. Not after `certify`. The same error.
  Expected<void> insert(std::span<const Vec2> positions, JobControl& job) {
    if (auto done = post(insert_samples(document_, positions)); !done) return done;
    // Until there have been a few insertions, the trees that an update of sizes asks cost more than all sizes anew.
    constexpr int kFew = 2;
    const bool is_updated = bring_up_to_date(job, {&samples_, &delaunay_, &crust_}, true);
    bring_up_to_date(job, {&sizes_}, is_updated && ++insertions_ > kFew);
    return {};
  }
  /// Needed for what is asked of the certificate.
  void certify(JobControl& job) { bring_up_to_date(job, {&labels_, &vertices_, &balls_, &certificate_}, false); }

  double size_at(std::uint32_t sample) const {
    const SiteSlot site = delaunay_.site_of_sample(SampleSlot(sample));
    return sizes_.has_size(site) ? sizes_.size(site) : std::numeric_limits<double>::infinity();
  }
  bool is_certified() const { return certificate_.has_verdict() && certificate_.is_certified(); }
  /// Where the proof fails: samples, and middles of edges.
  std::vector<Vec2> failures() const {
    std::vector<Vec2> out;
    for (const SiteSlot site : delaunay_.site_slots())
      if (delaunay_.is_site(site) && certificate_.is_bad_site(site)) out.push_back(delaunay_.site_position(site));
    for (const EdgeSlot edge : delaunay_.edge_slots())
      if (delaunay_.edge(edge).is_alive() && certificate_.is_bad_edge(edge)) {
        const auto& [a, b] = delaunay_.edge(edge).v;
        out.push_back(0.5 * (delaunay_.site_position(a) + delaunay_.site_position(b)));
      }
    return out;
  }
  /// Where parts of the curves are nearer to each other than their samples: there the crust is not the curves.
  std::vector<Rung> rungs(std::span<const SampleLink> links) const;
  /// Calls `use(epsilon)` for each crust edge that has an epsilon.
  template <class Use>
  void for_each_epsilon(Use use) const {
    for (const EdgeSlot edge : delaunay_.edge_slots())
      if (delaunay_.edge(edge).is_alive() && sizes_.has_epsilon(edge)) use(sizes_.epsilon(edge));
  }

 private:
  Expected<void> post(Expected<DocumentDelta> delta) {
    if (!delta) return std::unexpected(delta.error());
    document_.apply(*delta);
    samples_.post(std::make_shared<const DocumentDelta>(*std::move(delta)));
    return {};
  }
  /// False if one of them was made anew.
  static bool bring_up_to_date(JobControl& job, std::initializer_list<Structure*> structures, bool may_update) {
    for (Structure* structure : structures) structure->clear_changes();
    for (Structure* structure : structures) {
      job.checkpoint();
      may_update = may_update && structure->update(job);
      if (!may_update) structure->rebuild(job);
    }
    return may_update;
  }

  int insertions_ = 0;
  Document document_;
  Samples samples_;
  Delaunay delaunay_{samples_};
  OneStepCrust crust_{delaunay_};
  FeatureSize sizes_{delaunay_, crust_};
  Labels labels_{delaunay_, crust_};
  VoronoiVertices vertices_{delaunay_, crust_};
  InnerBalls balls_{delaunay_, vertices_, labels_};
  AxisCertificate certificate_{delaunay_, labels_, balls_};
};

std::vector<Rung> Measured::rungs(std::span<const SampleLink> links) const {
  const auto site = [&](std::uint32_t sample) { return delaunay_.site_of_sample(SampleSlot(sample)); };
  // Curves that meet in a sample have more than two neighbours there, which are looked for among the rest.
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

/// Of places, the number of the first of each; the two zeros are equal. The places outlive it. Cost: linear, expected.
class PlaceNumbers {
 public:
  explicit PlaceNumbers(std::span<const Vec2> places)
      : places_(places),
        bits_(static_cast<unsigned>(std::bit_width(2 * places.size() + 1))),
        slots_(std::size_t{1} << bits_, kFree) {
    for (std::uint32_t i = 0; i < places.size(); ++i) {
      std::uint32_t& slot = slots_[slot_of(places[i])];
      if (slot != kFree) continue;
      slot = i;
      ++distinct_count_;
    }
  }
  std::size_t distinct_count() const { return distinct_count_; }
  /// The number of the place; none if it is not among them.
  std::optional<std::uint32_t> number_of(Vec2 place) const {
    const std::uint32_t number = slots_[slot_of(place)];
    return number != kFree ? std::optional(number) : std::nullopt;
  }

 private:
  static constexpr std::uint32_t kFree = 0xffffffffU;

  /// Where the place is, or would be.
  std::size_t slot_of(Vec2 place) const {
    constexpr std::uint64_t kOdd = 0x9e3779b97f4a7c15;
    constexpr std::uint64_t kOther = 0xc2b2ae3d27d4eb4f;
    std::uint64_t mixed =
        (std::bit_cast<std::uint64_t>(place.x + 0.0) * kOdd) ^ (std::bit_cast<std::uint64_t>(place.y + 0.0) * kOther);
    mixed = (mixed ^ (mixed >> 32U)) * kOdd;
    std::size_t at = mixed >> (64U - bits_);
    while (slots_[at] != kFree && places_[slots_[at]] != place) at = (at + 1) & (slots_.size() - 1);
    return at;
  }

  std::span<const Vec2> places_;
  unsigned bits_;
  std::vector<std::uint32_t> slots_;
  std::size_t distinct_count_ = 0;
};

/// Measures lists of samples one after the other, each of which may be the one before and some more.
class Meter {
 public:
  explicit Meter(JobControl& job) : job_(job) {}

  /// Feature sizes; infinite where there is none.
  Expected<std::vector<double>> sizes(std::span<const Vec2> positions) {
    std::vector<Vec2> places(positions.begin(), positions.end());
    if (std::string fault = bring_into_range(places); !fault.empty())
      return std::unexpected(Error{ErrorCode::bad_input, "of the samples, " + fault});
    if (auto done = measure(std::move(places)); !done) return std::unexpected(done.error());
    std::vector<double> out;
    out.reserve(places_.size());
    for (std::uint32_t i = 0; i < places_.size(); ++i) out.push_back(measured_->size_at(i));
    return out;
  }

  /// Of these positions, in whatever order and however often each. Valid until the next call.
  Expected<Measured*> measured(const std::vector<Vec2>& positions) {
    if (!measured_ || !find_numbers(positions)) {
      if (auto done = measure(positions); !done) return std::unexpected(done.error());
      numbers_.resize(positions.size());
      std::iota(numbers_.begin(), numbers_.end(), 0U);
    }
    places_.clear();  // it may be certified, and then no more can be inserted
    return measured_.get();
  }
  /// Of each position of that call, the number of its sample.
  const std::vector<std::uint32_t>& numbers() const { return numbers_; }

 private:
  /// False unless the positions are those that were measured.
  bool find_numbers(const std::vector<Vec2>& positions) {
    const PlaceNumbers had(places_);
    std::vector<bool> is_wanted(places_.size(), false);
    std::size_t count = 0;
    numbers_.clear();
    numbers_.reserve(positions.size());
    for (const Vec2 p : positions) {
      const auto number = had.number_of(p);
      if (!number) return false;
      numbers_.push_back(*number);
      count += is_wanted[*number] ? 0U : 1U;
      is_wanted[*number] = true;
    }
    return count == had.distinct_count();
  }

  Expected<void> measure(std::vector<Vec2> places) {
    // Beyond such a share making it anew is quicker.
    constexpr std::size_t kMany = 32;
    const std::size_t before = places_.size();
    const bool goes_on = before != 0 && before <= places.size() && kMany * (places.size() - before) < before &&
                         std::equal(places_.begin(), places_.end(), places.begin());
    if (goes_on) {
      if (auto done = measured_->insert(std::span(places).subspan(before), job_); !done) return done;
    } else {
      measured_.reset();
      auto made = Measured::of(places, job_);
      if (!made) return std::unexpected(made.error());
      measured_ = *std::move(made);
    }
    places_ = std::move(places);
    return {};
  }

  JobControl& job_;
  std::unique_ptr<Measured> measured_;
  std::vector<Vec2> places_;
  std::vector<std::uint32_t> numbers_;
};

/// Places, numbered as they come, and which of them is nearest. Cost: O(log n) typically, a place and a question.
class PlaceTree {
 public:
  void add(Vec2 at) {
    places_.push_back({at, static_cast<std::uint32_t>(places_.size())});
    if (tree_.is_worn())
      tree_.build(std::span<const Place>(places_), bounds_of, [](const Place&, std::uint32_t) {});
    else
      tree_.insert(places_.back(), bounds_of, [](const Place&, std::uint32_t) {});
  }

  /// Of those nearer than `reach`, the nearest; of equal ones the first.
  std::optional<std::uint32_t> nearest(Vec2 to, double reach) const {
    std::optional<std::uint32_t> out;
    double away = reach;
    double bound = reach * reach;  // of squares; a little more than what is asked for does no harm
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

/// Neighbours along the contours; `numbers` says which sample a position is.
std::vector<SampleLink> links_of(std::span<const SampleData::Contour> contours,
                                 std::span<const std::uint32_t> numbers) {
  std::vector<SampleLink> out;
  for (const SampleData::Contour& contour : contours) {
    const std::vector<std::uint32_t>& points = contour.points;
    for (std::size_t i = 1; i < points.size(); ++i) out.push_back({numbers[points[i - 1]], numbers[points[i]]});
    if (contour.closed && points.size() > 2) out.push_back({numbers[points.back()], numbers[points.front()]});
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

/// What the samples of the data give. Error: samples that are as near as they may be, and of which most are too far
/// apart for the crust to be the curves.
Expected<void> judge(TakenSamples& taken, const SamplingRequest& request, const std::vector<CurveCorner>& corners,
                     Meter& meter, JobControl& job) {
  const auto measured = meter.measured(taken.data.positions);
  if (!measured) return std::unexpected(measured.error());
  (*measured)->for_each_epsilon([&](double epsilon) {
    if (epsilon <= request.epsilon)
      taken.epsilon = std::max(taken.epsilon, epsilon);
    else
      ++taken.sparse_intervals;
  });
  const std::vector<SampleLink> links = links_of(taken.data.contours, meter.numbers());
  const std::vector<Rung> rungs = (*measured)->rungs(links);
  // At crossings and corners there are some. Many are a ladder between two sides of something thin: then a proof would
  // be of another curve, and arcs that pass along a ladder are what the certificate takes longest to search.
  constexpr std::size_t kFew = 10;
  std::vector<Vec2> failures;
  if (kFew * rungs.size() > links.size()) {
    // Where all samples are as near as they may be, there are so many.
    const double most = kFinestFeature * static_cast<double>(request.count);
    if (2.0 * static_cast<double>(links.size()) > most) return too_near(rungs);
    for (const Rung& rung : rungs) failures.push_back(0.5 * (rung.a + rung.b));
  } else {
    (*measured)->certify(job);
    taken.is_certified = (*measured)->is_certified();
    for (const Rung& rung : rungs) taken.extra_edges.push_back(0.5 * (rung.a + rung.b));
    if (taken.is_certified) return {};
    failures = (*measured)->failures();
  }
  // A failure belongs to the nearest corner if that is within a few of the spacings that are usual.
  const double reach = [&] {
    Box2 extent;
    for (const Vec2 p : taken.data.positions) extent.add(p);
    constexpr double kShare = 0.02;
    return kShare * length(Vec2{extent.width(), extent.height()});
  }();
  std::vector<bool> is_named(corners.size(), false);
  PlaceTree corner_tree;
  for (const CurveCorner& corner : corners) corner_tree.add(corner.place);
  PlaceTree other_tree;
  for (const Vec2 place : failures) {
    job.checkpoint();
    // Failures side by side are one place.
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

/// `asked` stays with the samples as the way in which they were taken.
Expected<TakenSamples> take_once(const std::shared_ptr<const CurveSet>& curves, const SamplingRequest& request,
                                 const SamplingRequest& asked, const FeatureSizes& sizes, JobControl& job) {
  auto samples = sample(*curves, request, sizes, &job);
  if (!samples) return std::unexpected(samples.error());
  auto data = taken_from(curves, *std::move(samples), asked);
  if (!data) return std::unexpected(data.error());
  return TakenSamples{.data = *std::move(data)};
}

}  // namespace

Expected<TakenSamples> take_samples(const std::shared_ptr<const CurveSet>& curves, const SamplingRequest& request,
                                    JobControl& job) {
  if (request.rule != SamplingRule::feature_size) return take_once(curves, request, request, {}, job);
  Meter meter(job);
  const FeatureSizes sizes = [&meter](std::span<const Vec2> positions) { return meter.sizes(positions); };
  const std::vector<CurveCorner> corners =
      request.corner_radius > 0.0 ? std::vector<CurveCorner>() : corners_of(*curves, request.corner_angle);
  // A jitter is what is not on the curve: there is nothing to prove by being denser.
  const int tries = request.jitter > 0.0 ? 1 : 4;
  constexpr double kFiner = 0.63;  // three times make a quarter
  std::optional<TakenSamples> first;
  SamplingRequest finer = request;
  for (int i = 0; i < tries; ++i, finer.epsilon = std::max(kLeastEpsilon, kFiner * finer.epsilon)) {
    auto taken = take_once(curves, finer, request, sizes, job);
    if (!taken && first) break;  // more samples than there may be
    if (!taken) return taken;
    if (auto done = judge(*taken, finer, corners, meter, job); !done) return std::unexpected(done.error());
    if (taken->is_certified) return taken;
    if (!first) first = *std::move(taken);
    // More samples do not help where nothing but corners is in the way.
    if (first->other_places.empty()) break;
  }
  return *std::move(first);
}

CurveSet curves_through(const std::vector<Vec2>& positions, JobControl& job) {
  // Where a polygon through samples turns by more, it is taken to have a corner.
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
  std::string epsilon = taken.epsilon > 0.0 ? fmt::format("epsilon {:.3g}", taken.epsilon) : "no axis";
  if (taken.sparse_intervals != 0)
    epsilon += fmt::format(", but for {} {} at corners and bends", taken.sparse_intervals,
                           taken.sparse_intervals == 1 ? "interval" : "intervals");
  if (taken.is_certified) {
    std::string out = epsilon + "; the theorem is proved for these samples";
    if (taken.extra_edges.empty()) return out;
    const std::size_t count = taken.extra_edges.size();
    const Vec2 first = taken.extra_edges.front();
    return out + fmt::format(", whose crust has {} {} beside the curves ({}at {:.6g} {:.6g})", count,
                             count == 1 ? "edge" : "edges", count == 1 ? "" : "the first ", first.x, first.y);
  }
  if (taken.corners.empty() && taken.other_places.empty()) return epsilon + "; there is nothing to prove";
  std::string out = epsilon + "; the theorem is not proved";
  if (!taken.corners.empty()) {
    const auto sharpest = std::ranges::min_element(taken.corners, {}, &CurveCorner::angle);
    constexpr double kDegrees = 180.0 / std::numbers::pi;
    out += fmt::format(" at {} {} (the sharpest, {:.3g} degrees, at {:.6g} {:.6g}), where no density is enough",
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
