// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/curves/feature_field.h"

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <utility>

#include "core/base/geometry/infinity.h"
#include "core/curves/corners.h"
#include "core/curves/internal/feature_spacing.h"
#include "core/curves/internal/network.h"
#include "core/curves/internal/stretches.h"

namespace mes {
namespace {

/// Epsilon of the samples that show the axis: initially, and finally.
constexpr double kCoarse = 0.25;
constexpr double kFine = 0.125;
/// Error bound, in units of the square of that epsilon: the axis may be nearer than it seems by this share. At the tip
/// of a parabola the axis seems farther away by twice the square; between two samples it is nearer by half of the
/// square than linear interpolation says.
constexpr double kError = 4.0;
/// Nodes whose epsilon exceeds the target by more than this factor are already as close together as allowed.
constexpr double kMore = 1.1;
/// Near an exempt point this share of the largest size counts; on the way there the size may dip to this share of it.
constexpr double kExempt = 0.25;
constexpr double kDip = 0.8;
/// The target is slightly below the requirement: arc lengths are reproduced only to some thousandths.
constexpr double kAim = 0.99;
constexpr std::size_t kOften = 4096;
/// The sum of absolute coordinates is at most this many times the length.
constexpr double kDiagonal = std::numbers::sqrt2 * (1.0 + 1e-9);

double share_of(double epsilon) {
  const double most = std::min(epsilon, kCoarse);
  return 1.0 - kError * most * most;
}

}  // namespace

/// Walks along a line, any number of times around a closed one.
struct FeatureField::Walk {
  const Line& line;
  bool is_strict;

  std::size_t last() const {
    return line.is_closed ? std::numeric_limits<std::size_t>::max() : line.nodes.size() - 1;
  }
  double along(std::size_t k) const {
    const std::size_t count = line.nodes.size();
    return line.is_closed ? line.nodes[k % count].along + static_cast<double>(k / count) * line.length
                          : line.nodes[k].along;
  }
  double size(std::size_t k) const {
    const Node& node = line.nodes[k % line.nodes.size()];
    return is_strict ? node.size : node.regular;
  }
  /// The last node not beyond this arc length.
  std::size_t node_at(double place) const {
    const std::size_t turns =
        line.is_closed ? static_cast<std::size_t>(std::floor(std::max(0.0, place) / line.length)) : 0;
    const double rest = place - static_cast<double>(turns) * line.length;
    const auto next = std::ranges::upper_bound(line.nodes, rest, {}, &Node::along);
    const auto found = static_cast<std::size_t>(next - line.nodes.begin());
    const std::size_t k = turns * line.nodes.size() + (found == 0 ? 0 : found - 1);
    return last() != 0 ? std::min(k, last() - 1) : 0;
  }
  /// Interpolates between node k and the next.
  double size_at(std::size_t k, double place) const {
    const double begin = along(k);
    const double end = along(k + 1);
    if (place <= begin || end <= begin) return size(k);
    if (place >= end) return size(k + 1);
    return size(k) + (place - begin) / (end - begin) * (size(k + 1) - size(k));
  }
  double least(double from, double to) const {
    std::size_t k = node_at(from);
    double out = std::min(size_at(k, from), size_at(node_at(to), to));
    for (++k; k <= last() && along(k) < to; ++k) out = std::min(out, size(k));
    return out;
  }
  /// The farthest point, at most `to`, whose distance from `from` is at most `most` times the least size in between, or
  /// the finest distance. `k` is the node before `from`, and moves along.
  double step(std::size_t& k, double from, double to, double most) const {
    double x = from;
    double here = size_at(k, x);
    double least = here;
    double end = to;
    for (;;) {
      const double next = std::min(along(k + 1), to);
      const double there = size_at(k, next);
      const double both = std::min(least, there);
      if (next - from <= most * both) {
        if (next >= to) return to;
        least = both;
        x = next;
        here = there;
        ++k;
        continue;
      }
      end = from + most * least;
      if (there < here && next > x) {
        const double slope = (there - here) / (next - x);
        end = std::min(end, (from + most * (here - slope * x)) / (1.0 - most * slope));
      }
      break;
    }
    end = std::min({std::max(end, from + line.finest), from + line.widest, to});
    while (k + 1 < last() && along(k + 1) <= end) ++k;
    while (along(k) > end && k != 0) --k;
    return end;
  }
  /// Steps from `from` (included) to `to` (excluded). Returns the length of the last interval as a share of its allowed
  /// length; nothing if there would be more than `most` points.
  std::optional<double> march(double from, double to, double twice_epsilon, std::size_t most,
                              std::vector<double>& out) const {
    const double rounding = 1e-12 * line.length;
    std::size_t k = node_at(from);
    out.clear();
    for (double place = from; place < to - rounding;) {
      if (out.size() == most) return std::nullopt;
      out.push_back(place);
      place = std::max(step(k, place, to, twice_epsilon), place + rounding);
    }
    if (out.empty()) return 1.0;
    const double last = to - out.back();
    return std::min(1.0, last / std::clamp(twice_epsilon * least(out.back(), to), line.finest, line.widest));
  }
  /// The same, but evenly: all intervals use the same share of the epsilon, the least that needs no more points.
  bool even_march(double from, double to, double epsilon, std::size_t most, std::vector<double>& out) const {
    constexpr int kSteps = 16;
    constexpr double kEven = 1e-5;
    double high = 2.0 * kAim * epsilon;
    double low = 0.25 * high;
    std::optional<double> last = march(from, to, high, most, out);
    if (!last || out.empty()) return last.has_value();
    std::vector<double> fewer;
    for (int i = 0; i < kSteps; ++i) {
      // Shorten all intervals by the part that the last one lacks.
      const double lacking = (1.0 - *last) / static_cast<double>(out.size());
      if (lacking < kEven) break;
      const double guess = (1.0 - lacking) * high;
      const double next = i % 2 == 0 && guess > low ? guess : 0.5 * (low + high);
      if (const auto there = march(from, to, next, out.size(), fewer)) {
        high = next;
        last = there;
        out.swap(fewer);
      } else {
        low = next;
      }
    }
    return true;
  }
};

Expected<FeatureField> FeatureField::of(const CurveSet& curves, const SamplingRequest& request,
                                        const FeatureSizes& sizes, JobControl* job, std::size_t most) {
  FeatureField out;
  CurveSet set =
      request.corner_radius > 0.0 ? with_round_corners(curves, request.corner_angle, request.corner_radius) : curves;
  // Curves that touch are measured arc by arc, as they are sampled.
  const auto network = network_of(set.curves, set.resolution, job);
  if (network) set.curves = network->arcs;
  out.points_ = curves.points;

  const auto own = std::make_shared<std::vector<MeasuredCurve>>();
  std::vector<MeasuredCurve>& all = *own;
  out.measured_ = own;
  double length = 0.0;
  SamplingRequest by_size = request;
  by_size.rule = SamplingRule::feature_size;
  const double negligible = negligible_length(set, by_size);
  for (std::size_t c = 0; c < set.curves.size(); ++c) {
    const bool has_node = network && network->nodes[c][0] != CurveNetwork::kNoNode;
    all.push_back(mes::measured(set.curves[c], request.corner_angle, negligible, job, has_node));
    if (network) all.back().nodes = network->nodes[c];
    if (network) all.back().whole = network->whole[c];
    length += all.back().length();
  }
  for (std::size_t c = 0; c < all.size(); ++c)
    if (all[c].stretches.empty()) out.points_.push_back(set.curves[c].start());
  std::ranges::sort(out.points_, lexicographically_less);
  if (!std::isfinite(length))
    return std::unexpected(Error{ErrorCode::bad_input, "the curves reach beyond the range of numbers"});
  if (!(length > 0.0)) return out;

  const FeatureLimits limits = feature_limits(request, length, kCoarse);
  auto found =
      places_by_feature_size(all, spacings_of(all, limits.first, job), limits.places, kFine, most, sizes, job);
  if (!found) return std::unexpected(found.error());
  for (std::size_t c = 0; c < all.size(); ++c) {
    if (all[c].stretches.empty()) continue;
    Line& line = out.lines_.emplace_back(Line{.curve = c, .is_closed = all[c].is_closed, .length = all[c].length()});
    line.widest = std::min(limits.places.widest, line.length / limits.places.least_each);
    line.finest = std::min(limits.places.finest, line.widest);
    std::vector<double> epsilons;
    double before = 0.0;
    for (std::size_t s = 0; s < all[c].stretches.size(); ++s) {
      const std::vector<MeasuredPlace>& places = (*found)[c][s];
      if (s != 0 || (line.is_closed && all[c].has_corner_at_start)) line.corners.push_back(line.nodes.size());
      line.stretches.push_back(line.nodes.size());
      const bool is_last = s + 1 == all[c].stretches.size();
      // The end of a stretch is the beginning of the next one, or of the closed curve.
      const std::size_t count = is_last && !line.is_closed ? places.size() : places.size() - 1;
      for (std::size_t i = 0; i < count; ++i) {
        // No axis means an infinite size and so an epsilon of zero.
        out.has_axis_ = out.has_axis_ || places[i].epsilon > 0.0;
        const double size = std::min(places[i].size, length) * share_of(places[i].epsilon);
        line.nodes.push_back({places[i].position, before + places[i].at, size, size});
        epsilons.push_back(places[i].epsilon);
      }
      before += all[c].stretches[s].length;
    }
    line.length = before;
    line.stretches.push_back(line.nodes.size());
    if (network && !line.is_closed) {
      if (network->nodes[c][0] != CurveNetwork::kNoNode) line.meetings.push_back(0);
      if (network->nodes[c][1] != CurveNetwork::kNoNode) line.meetings.push_back(line.nodes.size() - 1);
    }
    find_meetings(line, epsilons);
    for (const auto* exempt : {&line.corners, &line.meetings})
      for (const std::size_t node : *exempt) {
        exempt_about(line, epsilons, node, 1);
        exempt_about(line, epsilons, node, -1);
        out.exempt_.push_back(line.nodes[node].position);
      }
  }
  std::ranges::sort(out.exempt_, lexicographically_less);
  const auto rest = std::ranges::unique(out.exempt_);
  out.exempt_.erase(rest.begin(), rest.end());
  out.make_tree();
  return out;
}

// Where samples are as close together as allowed and still exceed their epsilon, the size falls to zero. In each such
// run without a corner, the point with the least size is a meeting.
void FeatureField::find_meetings(Line& line, const std::vector<double>& epsilons) {
  const std::size_t count = line.nodes.size();
  const auto is_over = [&](std::size_t i) { return epsilons[i] > kMore * kCoarse; };
  std::vector<bool> is_corner(count, false);  // includes known meetings
  for (const auto* known : {&line.corners, &line.meetings})
    for (const std::size_t i : *known) is_corner[i] = true;
  for (std::size_t i = 0; i < count;) {
    if (!is_over(i)) {
      ++i;
      continue;
    }
    std::size_t least = i;
    bool has_corner = false;
    for (; i < count && is_over(i); ++i) {
      has_corner = has_corner || is_corner[i];
      if (line.nodes[i].size < line.nodes[least].size) least = i;
    }
    // A closed curve continues at its beginning.
    has_corner = has_corner || (i == count && line.is_closed && is_corner[0]);
    if (!has_corner) line.meetings.push_back(least);
  }
}

void FeatureField::exempt_about(Line& line, const std::vector<double>& epsilons, std::size_t node,
                                std::ptrdiff_t way) {
  const auto count = static_cast<std::ptrdiff_t>(line.nodes.size());
  const auto index = [&](std::ptrdiff_t i) { return static_cast<std::size_t>(((i % count) + count) % count); };
  const auto first = static_cast<std::ptrdiff_t>(node);
  double most = line.nodes[node].size;
  std::ptrdiff_t end = first;
  for (std::ptrdiff_t i = first + way; std::abs(i - first) < count; i += way) {
    if (!line.is_closed && (i < 0 || i >= count)) break;
    const double size = line.nodes[index(i)].size;
    // Where samples are as close together as allowed, sizes are only rounding noise.
    if (size < kDip * most && epsilons[index(i)] <= kMore * kCoarse) break;
    most = std::max(most, size);
    end = i;
  }
  for (std::ptrdiff_t i = first; i != end + way; i += way) {
    double& regular = line.nodes[index(i)].regular;
    regular = std::max(regular, kExempt * most);
  }
}

FeatureField::Part FeatureField::part_of(const Line& line, std::size_t node) {
  const std::size_t next = node + 1 < line.nodes.size() ? node + 1 : 0;
  const double end = next != 0 ? line.nodes[next].along : line.length;
  return {line.nodes[node].position, line.nodes[next].position, end - line.nodes[node].along};
}

void FeatureField::make_tree() {
  double most = 0.0;
  for (const Line& line : lines_)
    for (const Node& node : line.nodes) most = std::max({most, std::abs(node.position.x), std::abs(node.position.y)});
  constexpr double kRounding = 1e-12;
  slack_ = kRounding * most;
  constexpr std::uint32_t kEach = 4;
  std::vector<Parts> parts;
  for (std::uint32_t l = 0; l < lines_.size(); ++l) {
    const auto count = static_cast<std::uint32_t>(lines_[l].nodes.size() - (lines_[l].is_closed ? 0 : 1));
    for (std::uint32_t k = 0; k < count; k += kEach) {
      Parts& here = parts.emplace_back(Parts{{}, l, k, std::min(k + kEach, count)});
      for (std::uint32_t i = here.first; i < here.end; ++i) {
        const Part part = part_of(lines_[l], i);
        // Bounds the distance between the arc and its chord.
        const double detour = longest_detour(part);
        const double chord = distance(part.a, part.b);
        const double aside = 0.5 * std::sqrt(std::max(0.0, (detour - chord) * (detour + chord))) + slack_;
        for (const Vec2 end : {part.a, part.b}) {
          here.box.add(end - Vec2{aside, aside});
          here.box.add(end + Vec2{aside, aside});
        }
      }
    }
  }
  tree_.build(
      std::span<const Parts>(parts), [](const Parts& part) { return TreeBounds{part.box}; },
      [](const Parts&, std::uint32_t) {});
}

std::vector<FeatureField::Hit> FeatureField::hits(std::span<const Vec2> positions, std::vector<bool>& is_on,
                                                  JobControl* job) const {
  std::vector<Hit> out;
  out.reserve(positions.size());
  is_on.assign(positions.size(), false);
  for (std::uint32_t i = 0; i < positions.size(); ++i) {
    if (job != nullptr && i % kOften == 0) job->checkpoint();
    const Vec2 p = positions[i];
    if (std::ranges::binary_search(points_, p, lexicographically_less)) is_on[i] = true;
    tree_.visit_near(p, 0.0, [&](const Parts& parts) {
      if (!parts.box.contains(p)) return;
      const Line& line = lines_[parts.line];
      for (std::uint32_t k = parts.first; k < parts.end; ++k) {
        const Part part = part_of(line, k);
        const double most = longest_detour(part);
        // Quick test: most points are too far from an end.
        if (std::abs(p.x - part.a.x) + std::abs(p.y - part.a.y) > kDiagonal * most) continue;
        const double before = distance(part.a, p);
        const double all = before + distance(p, part.b);
        if (all > most) continue;
        double along = line.nodes[k].along + (all > 0.0 ? before / all * part.arc : 0.0);
        if (line.is_closed && along >= line.length) along = 0.0;
        is_on[i] = true;
        out.push_back({parts.line, along, i});
      }
    });
  }
  std::ranges::sort(out, [](const Hit& a, const Hit& b) {
    if (a.line != b.line) return a.line < b.line;
    return a.along != b.along ? a.along < b.along : a.sample < b.sample;
  });
  // A sample at the common end of two parts is found on both.
  const auto rest = std::ranges::unique(
      out, [](const Hit& a, const Hit& b) { return a.line == b.line && a.along == b.along && a.sample == b.sample; });
  out.erase(rest.begin(), rest.end());
  return out;
}

/// Calls `use(line, from, to, before, after)` with the hits at both ends. One of them is missing at an open end, and
/// both are missing for a curve without samples.
template <class Use>
void FeatureField::for_each_interval(const std::vector<Hit>& hits, Use use) const {
  auto hit = hits.begin();
  for (std::uint32_t l = 0; l < lines_.size(); ++l) {
    const Line& line = lines_[l];
    const auto first = hit;
    while (hit != hits.end() && hit->line == l) ++hit;
    if (first == hit) {
      use(line, 0.0, line.length, nullptr, nullptr);
      continue;
    }
    for (auto i = first; i + 1 != hit; ++i) use(line, i->along, (i + 1)->along, &*i, &*(i + 1));
    const Hit& last = *(hit - 1);
    if (line.is_closed) {
      use(line, last.along, line.length + first->along, &last, &*first);
    } else {
      if (first->along > 0.0) use(line, 0.0, first->along, nullptr, &*first);
      if (last.along < line.length) use(line, last.along, line.length, &last, nullptr);
    }
  }
}

std::span<const MeasuredCurve> FeatureField::measured() const {
  return *measured_;
}

bool FeatureField::is_on_curves(Vec2 position) const {
  std::vector<bool> is_on;
  hits({&position, 1}, is_on, nullptr);
  return is_on.front();
}

CurveStanding FeatureField::standing(std::span<const Vec2> positions, JobControl* job) const {
  CurveStanding out{.exempt = exempt_.size()};
  std::vector<bool> is_on;
  const std::vector<Hit> found = hits(positions, is_on, job);
  out.off_curve = static_cast<std::size_t>(std::ranges::count(is_on, false));
  for_each_interval(found, [&](const Line& line, double from, double to, const Hit* before, const Hit* after) {
    if (before != nullptr && after != nullptr && positions[before->sample] != positions[after->sample])
      out.neighbours.push_back({before->sample, after->sample});
    if (!has_axis_ || !(to > from)) return;
    const Walk walk{line, false};
    const bool has_both = before != nullptr && after != nullptr;
    const double size = walk.least(from, to);
    const double epsilon =
        before == nullptr && after == nullptr ? kInfinity : (has_both ? 0.5 : 1.0) * (to - from) / size;
    if (!(epsilon > std::min(out.epsilon, kMostEpsilon))) return;
    const double middle = 0.5 * (from + to);
    const std::size_t k = walk.node_at(middle);
    const Vec2 a = line.nodes[k % line.nodes.size()].position;
    const Vec2 b = line.nodes[(k + 1) % line.nodes.size()].position;
    const double part = walk.along(k + 1) - walk.along(k);
    const Vec2 place = a + (part > 0.0 ? (middle - walk.along(k)) / part : 0.0) * (b - a);
    if (epsilon > kMostEpsilon) out.sparse.push_back(place);
    if (!(epsilon > out.epsilon)) return;
    out.epsilon = epsilon;
    out.place = place;
  });
  return out;
}

Expected<std::vector<std::vector<std::vector<double>>>> FeatureField::places(double epsilon, std::size_t most) const {
  std::vector<std::vector<std::vector<double>>> out(measured_->size());
  std::size_t count = 0;
  for (const Line& line : lines_) {
    const Walk walk{line, true};
    for (std::size_t s = 0; s + 1 < line.stretches.size(); ++s) {
      const double from = line.nodes[line.stretches[s]].along;
      const bool is_last = s + 2 == line.stretches.size();
      const double to = is_last ? line.length : line.nodes[line.stretches[s + 1]].along;
      std::vector<double>& here = out[line.curve].emplace_back();
      if (!walk.even_march(from, to, epsilon, most - count, here))
        return std::unexpected(Error{
            ErrorCode::bad_input,
            fmt::format("the curves would have more than {} samples, which are as many as there may be", most)});
      for (double& place : here) place -= from;
      count += here.size();
    }
  }
  return out;
}

std::vector<FilledInterval> FeatureField::filled(std::span<const Vec2> positions, double epsilon, bool is_strict,
                                                 JobControl* job) const {
  /// A new sample: its arc length on the line, its interval, and its index there.
  struct Wanted {
    double along;
    std::size_t interval;
    std::size_t number;
  };
  std::vector<std::vector<Wanted>> wanted(lines_.size());
  std::vector<FilledInterval> out;
  std::vector<bool> is_on;
  const std::vector<Hit> found = hits(positions, is_on, job);
  constexpr std::size_t kMost = 1'000'000;
  std::size_t count = 0;
  std::vector<double> places;
  if (has_axis_)
    for_each_interval(found, [&](const Line& line, double from, double to, const Hit* before, const Hit* after) {
      if (before == nullptr || after == nullptr || !(to > from) || count > kMost) return;
      const Walk walk{line, is_strict};
      if (0.5 * (to - from) <= epsilon * walk.least(from, to) || to - from <= line.finest * (1.0 + 1e-9)) return;
      places.clear();
      if (!walk.even_march(from, to, epsilon, kMost - count, places) || places.size() < 2) return;
      std::vector<Wanted>& here = wanted[static_cast<std::size_t>(&line - lines_.data())];
      for (std::size_t i = 1; i < places.size(); ++i)
        here.push_back({places[i] >= line.length ? places[i] - line.length : places[i], out.size(), i - 1});
      count += places.size() - 1;
      out.push_back({before->sample, after->sample, std::vector<Vec2>(places.size() - 1)});
    });
  for (std::size_t l = 0; l < lines_.size(); ++l) {
    if (wanted[l].empty()) continue;
    std::ranges::sort(wanted[l], {}, &Wanted::along);
    const MeasuredCurve& curve = (*measured_)[lines_[l].curve];
    auto next = wanted[l].begin();
    double before = 0.0;
    for (std::size_t s = 0; s < curve.stretches.size(); ++s) {
      const Stretch& stretch = curve.stretches[s];
      places.clear();
      auto one = next;
      for (; next != wanted[l].end() && (s + 1 == curve.stretches.size() || next->along < before + stretch.length);
           ++next)
        places.push_back(next->along - before);
      for_each_place(curve, stretch, places, [&](Vec2 p) {
        out[one->interval].positions[one->number] = p;
        ++one;
      });
      before += stretch.length;
    }
  }
  return out;
}

}  // namespace mes
