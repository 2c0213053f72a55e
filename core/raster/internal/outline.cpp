// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/raster/internal/outline.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <span>
#include <utility>

#include "core/base/jobs/parallel.h"
#include "core/raster/internal/fitting/ellipse_fit.h"
#include "core/raster/internal/fitting/node_curve.h"
#include "core/raster/internal/smoothing.h"
#include "core/raster/trace.h"

namespace mes {
namespace {

// All in pixels.
constexpr double kTurnReach = 2.5;     // on both sides of a corner, to measure its turn
constexpr double kCornerReach = 3.0;   // the fit before corners are known rounds the curve this far around one
constexpr double kBesideCorner = 1.2;  // edges nearer to a corner see both of its sides
constexpr double kJudged = 7.0;        // edges up to this distance decide whether it is a corner
constexpr double kFarthestCorner = 4.0;
constexpr double kClear = 32.0;     // at this distance from a corner, the curve without it is as stiff as with it
constexpr double kStraight = 0.03;  // a run that deviates less from its chord is a line
constexpr std::size_t kLeastNodes = 16;
constexpr std::size_t kLeastRunNodes = 6;

Vec2 unit_vector(Vec2 v) {
  const double size = length(v);
  return size > 0.0 ? (1.0 / size) * v : Vec2{};
}

double turn_of_corner(Vec2 a, Vec2 b) {
  return std::atan2(cross(a, b), dot(a, b));
}

/// For a closed row of nodes: the turn of the curve at each, to the left.
std::vector<double> turns_of(std::span<const Vec2> nodes) {
  const std::size_t count = nodes.size();
  std::vector<double> out(count);
  for (std::size_t k = 0; k < count; ++k)
    out[k] = turn_of_corner(nodes[k] - nodes[(k + count - 1) % count], nodes[(k + 1) % count] - nodes[k]);
  return out;
}

double spacing_of(std::span<const Vec2> nodes) {
  double out = 0.0;
  for (std::size_t k = 0; k < nodes.size(); ++k) out += distance(nodes[k], nodes[(k + 1) % nodes.size()]);
  return out / static_cast<double>(nodes.size());
}

/// Nodes that may be corners: those with the largest turn within reach.
std::vector<std::size_t> sharp_bends(const Run& run, double spacing, double least_stiffness) {
  std::vector<std::size_t> out;
  const std::size_t count = run.nodes.size();
  // Nodes at which even two or four times the least stiffness did not fit.
  constexpr double kTight = 2.02;
  const auto reach = static_cast<std::size_t>(std::max(1L, std::lround(kTurnReach / spacing)));
  if (2 * reach + 1 >= count) return out;
  // For each node, the number of such held nodes up to it.
  std::vector<std::size_t> tight(count + 1, 0);
  for (std::size_t k = 0; k < count; ++k) {
    const bool is_tight = run.is_held[k] && run.stiffness[k] <= kTight * least_stiffness;
    tight[k + 1] = tight[k] + (is_tight ? 1U : 0U);
  }
  if (tight.back() == 0) return out;
  const auto is_tight_near = [&](std::size_t k) {
    const std::size_t from = k > reach ? k - reach : 0;
    return tight[std::min(k + reach + 1, count)] != tight[from];
  };
  const std::vector<double> turns = turns_of(run.nodes);
  std::vector<double> near(count);
  for (std::size_t k = 0; k < count; ++k)
    for (std::size_t i = 0; i <= 2 * reach; ++i) near[k] += turns[(k + count + i - reach) % count];
  for (std::size_t k = 0; k < count; ++k) {
    if (!is_tight_near(k) || std::abs(near[k]) < kLeastCorner) continue;
    // The first of equal ones; among those, where the turn itself is largest.
    bool is_largest = true;
    for (std::size_t i = 1; i <= reach + 1 && is_largest; ++i) {
      const std::size_t before = (k + count - i) % count;
      const std::size_t after = (k + i) % count;
      is_largest = std::abs(near[k]) > std::abs(near[before]) && std::abs(near[k]) >= std::abs(near[after]);
    }
    if (is_largest) out.push_back(k);
  }
  return out;
}

/// Extends the nodes between two corners, without those near the corners, straight to slightly beyond the corners.
std::vector<Vec2> stretched(std::span<const Vec2> nodes, double spacing, std::size_t from, std::size_t count) {
  const std::size_t all = nodes.size();
  const auto at = [&](std::size_t i) { return nodes[(from + i) % all]; };
  auto cut = static_cast<std::size_t>(std::lround(kCornerReach / spacing));
  cut = std::min(cut, count / 3);
  std::vector<Vec2> out;
  for (std::size_t i = cut; i + cut <= count; ++i) out.push_back(at(i));
  if (out.size() < 2) return {at(0), at(count)};
  const std::size_t look = std::min<std::size_t>(out.size() - 1, 4);
  constexpr double kFarther = 1.0;
  const double extra = static_cast<double>(cut) * spacing + kFarther;
  const Vec2 back = unit_vector(out[0] - out[look]);
  const Vec2 on = unit_vector(out[out.size() - 1] - out[out.size() - 1 - look]);
  out.insert(out.begin(), out[0] + extra * back);
  out.push_back(out.back() + extra * on);
  double length = 0.0;
  for (std::size_t i = 1; i < out.size(); ++i) length += distance(out[i - 1], out[i]);
  return respaced(out, false, std::max(kLeastRunNodes, static_cast<std::size_t>(std::lround(length / spacing)) + 1));
}

/// The intersection of the lines through the last two nodes of a run and the first two of the next.
std::optional<Vec2> meeting(const std::vector<Vec2>& before, const std::vector<Vec2>& after) {
  const Vec2 p = before[before.size() - 2];
  const Vec2 on = unit_vector(before.back() - p);
  const Vec2 q = after[1];
  const Vec2 back = unit_vector(after[0] - q);
  const double sine = cross(on, back);
  constexpr double kLeastSine = 0.2;
  if (std::abs(sine) < kLeastSine) return std::nullopt;
  return p + (cross(q - p, back) / sine) * on;
}

struct Corner {
  std::size_t node = 0;  // index in the closed run
  Vec2 at{};
};

/// A contour divided into runs at its corners.
struct CornerCut {
  std::vector<Corner> corners;
  std::vector<Run> runs;  // from each corner to the next
};

void end_at(std::vector<Vec2>& nodes, std::vector<double>& stiffness, Vec2 corner) {
  // A node beside the corner would make a piece of no length, and one beyond it a loop.
  constexpr double kLeastPiece = 0.4;
  while (nodes.size() > 1) {
    const Vec2 on = unit_vector(nodes.back() - nodes[nodes.size() - 2]);
    if (dot(corner - nodes.back(), on) > kLeastPiece) break;
    nodes.pop_back();
    stiffness.pop_back();
  }
  nodes.push_back(corner);
  stiffness.push_back(stiffness.back());
}

/// Computes the corner between each two successive runs; a corner is bad if they do not meet near its node.
bool join(CornerCut& cut, std::span<const Vec2> nodes, std::vector<bool>& is_good) {
  const std::size_t count = cut.corners.size();
  bool are_all = true;
  for (std::size_t i = 0; i < count; ++i) {
    const auto& before = cut.runs[(i + count - 1) % count].nodes;
    const auto found = meeting(before, cut.runs[i].nodes);
    is_good[i] = found && distance(*found, nodes[cut.corners[i].node]) < kFarthestCorner;
    if (is_good[i]) cut.corners[i].at = *found;
    are_all = are_all && is_good[i];
  }
  if (!are_all) return false;
  for (std::size_t i = 0; i < count; ++i) {
    Run& run = cut.runs[i];
    end_at(run.nodes, run.stiffness, cut.corners[(i + 1) % count].at);
    std::ranges::reverse(run.nodes);
    std::ranges::reverse(run.stiffness);
    end_at(run.nodes, run.stiffness, cut.corners[i].at);
    std::ranges::reverse(run.nodes);
    std::ranges::reverse(run.stiffness);
  }
  return true;
}

double square_to(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 side = b - a;
  const double t = std::clamp(dot(p - a, side) / std::max(dot(side, side), 1e-30), 0.0, 1.0);
  const Vec2 away = p - a - t * side;
  return dot(away, away);
}

double square_to(Vec2 p, std::span<const Vec2> nodes) {
  double out = 1e30;
  for (std::size_t i = 1; i < nodes.size(); ++i) out = std::min(out, square_to(p, nodes[i - 1], nodes[i]));
  return out;
}

/// Whether the curve lies in the picture, up to half a pixel.
bool lies_in(const Box2& picture, const PlaneCurve& curve) {
  constexpr double kBeside = 0.5;
  return std::ranges::all_of(curve.points(), [&](Vec2 p) {
    return p.x >= picture.low.x - kBeside && p.y >= picture.low.y - kBeside && p.x <= picture.high.x + kBeside &&
           p.y <= picture.high.y + kBeside;
  });
}

class Outliner {
 public:
  Outliner(const PixelContour& contour, const EdgeNoise& noise, const JobControl* job)
      : contour_(contour), noise_(noise), job_(job), is_hole_(contour.area < 0.0) {
    edges_.reserve(contour.points.size());
    for (std::size_t i = 0; i < contour.points.size(); ++i)
      edges_.push_back({contour.points[i], contour.is_along_y[i] != 0, contour.variance[i]});
    ellipse_ = ellipse_of(edges_, noise_);
    if (ellipse_ && is_as_much((is_hole_ ? -2.0 : 2.0) * std::numbers::pi * cross(ellipse_->u, ellipse_->v))) return;
    ellipse_.reset();
    whole_ = fitted(softened(contour.points, noise.least_stiffness), true, edges_, noise_, job_);
    // Figures thinner than a pixel, or that wind within a few pixels, may have no smooth curve near them.
    if (whole_.farthest <= kMostAway) return;
    use_plain();
  }

  PlaneCurve curve() {
    if (ellipse_) return in_arcs(*ellipse_);
    std::vector<std::size_t> bends;
    if (!is_plain_) {
      fine_ = evened(whole_);
      spacing_ = spacing_of(fine_.nodes);
      bends = sharp_bends(fine_, spacing_, noise_.least_stiffness);
    }
    // Each round removes false corners.
    while (!bends.empty()) {
      CornerCut cut;
      std::vector<bool> is_good(bends.size(), true);
      if (cut_at(bends, cut, is_good) && judge(cut, is_good)) {
        if (!encloses_as_much(cut)) break;
        CornerCut calm;
        return is_calmed(cut, calm) ? joined(calm) : joined(cut);
      }
      std::size_t kept = 0;
      for (std::size_t i = 0; i < bends.size(); ++i)
        if (is_good[i]) bends[kept++] = bends[i];
      if (kept == bends.size()) break;
      bends.resize(kept);
    }
    if (!is_plain_) {
      if (Run finer = refined(whole_, edges_, noise_, job_); finer.farthest <= kMostAway) whole_ = std::move(finer);
      if (Run calm = with_few_extremes(whole_, edges_, noise_, job_); calm.farthest <= kMostAway)
        whole_ = std::move(calm);
    }
    if (!is_plain_ && !is_as_much(twice_area(whole_.nodes))) use_plain();
    return smooth_curve();
  }
  /// The contour after mere softening.
  PlaneCurve plain_curve() {
    use_plain();
    return smooth_curve();
  }

 private:
  PlaneCurve smooth_curve() const {
    PlaneCurve out(whole_.nodes.front());
    std::vector<Vec2> nodes = whole_.nodes;
    std::vector<double> stiffness = whole_.stiffness;
    nodes.push_back(nodes.front());
    stiffness.push_back(stiffness.front());
    add_pieces(nodes, stiffness, true, out);
    out.close();
    return out;
  }

  void use_plain() {
    // Spacing is half the least stiffness.
    const double apart = 0.5 * noise_.least_stiffness;
    const std::vector<Vec2> soft = softened(contour_.points, noise_.least_stiffness);
    const auto wanted = static_cast<std::size_t>(std::lround(static_cast<double>(soft.size()) / apart));
    whole_.nodes = respaced(soft, true, std::max(kLeastNodes, wanted));
    whole_.stiffness.assign(whole_.nodes.size(), noise_.least_stiffness);
    whole_.is_held.assign(whole_.nodes.size(), false);
    is_plain_ = true;
  }

  /// Twice the area of the polygon of nodes; an open one is closed through the origin.
  static double twice_area(std::span<const Vec2> nodes, bool is_closed = true) {
    double out = is_closed ? cross(nodes.back(), nodes.front()) : 0.0;
    for (std::size_t k = 1; k < nodes.size(); ++k) out += cross(nodes[k - 1], nodes[k]);
    return out;
  }
  /// Whether the curve encloses about the area of the contour; a curve that winds around itself does not.
  bool is_as_much(double twice_area) const {
    constexpr double kMostBeside = 0.1;  // pixels, in the mean along the contour
    constexpr double kOfCorners = 2.0;   // square pixels
    return std::abs(0.5 * twice_area - contour_.area) <=
           kMostBeside * static_cast<double>(edges_.size()) + kOfCorners;
  }
  bool encloses_as_much(const CornerCut& cut) const {
    double out = 0.0;
    for (const Run& run : cut.runs) out += twice_area(run.nodes, false);
    return is_as_much(out);
  }

  bool cut_at(const std::vector<std::size_t>& bends, CornerCut& cut, std::vector<bool>& is_good) {
    if (along_.empty()) along_ = places_along(fine_, edges_);
    const std::size_t count = fine_.nodes.size();
    const double all = static_cast<double>(count);
    const double beside = kBesideCorner / spacing_;
    for (const std::size_t node : bends) cut.corners.push_back({node, {}});
    // The edges have the order of the nodes and start at the first corner.
    const auto from_first = [&](std::size_t i) {
      const double away = along_[i] - static_cast<double>(bends.front());
      return away >= 0.0 ? away : away + all;
    };
    std::size_t first = 0;
    for (std::size_t i = 1; i < edges_.size(); ++i)
      if (from_first(i) < from_first(first)) first = i;
    std::vector<std::vector<Edge>> of_run(bends.size());
    for (std::size_t k = 0; k < edges_.size(); ++k) {
      const std::size_t i = first + k < edges_.size() ? first + k : first + k - edges_.size();
      const std::size_t run = run_at(bends, along_[i]);
      const auto begin = static_cast<double>(bends[run]);
      const auto end = static_cast<double>(bends[(run + 1) % bends.size()]);
      const double from_begin = along_[i] >= begin ? along_[i] - begin : along_[i] + all - begin;
      const double to_end = end > along_[i] ? end - along_[i] : end + all - along_[i];
      if (from_begin > beside && to_end > beside) of_run[run].push_back(edges_[i]);
    }
    std::vector<Fitted> fits(bends.size());
    of_run_ = of_run;
    run_tasks(bends.size(), [&](std::size_t i) {
      const std::size_t next = bends[(i + 1) % bends.size()];
      const auto known =
          std::ranges::find_if(fitted_, [&](const Fitted& fit) { return fit.from == bends[i] && fit.to == next; });
      fits[i] = known != fitted_.end() ? *known : fitted_between(bends[i], next, of_run[i]);
    });
    fitted_ = fits;
    for (std::size_t i = 0; i < bends.size(); ++i) {
      if (fits[i].run.nodes.empty()) is_good[i] = false;
      if (fits[i].run.nodes.empty()) return false;
      if (!(fits[i].run.farthest <= kMostAway)) {
        is_good[i] = is_good[(i + 1) % bends.size()] = false;
        return false;
      }
      cut.runs.push_back(std::move(fits[i].run));
    }
    return join(cut, fine_.nodes, is_good);
  }

  /// Fits runs with few extremes of curvature between the same corners; false if these do not meet there.
  bool is_calmed(const CornerCut& cut, CornerCut& calm) const {
    calm.corners = cut.corners;
    calm.runs.resize(fitted_.size());
    run_tasks(fitted_.size(),
              [&](std::size_t i) { calm.runs[i] = with_few_extremes(fitted_[i].run, of_run_[i], noise_, job_); });
    std::vector<bool> is_good(cut.corners.size());
    return std::ranges::all_of(calm.runs, [](const Run& run) { return run.farthest <= kMostAway; }) &&
           join(calm, fine_.nodes, is_good) && encloses_as_much(calm);
  }

  /// The run between two successive corners, both nodes of the closed run.
  struct Fitted {
    std::size_t from = 0;
    std::size_t to = 0;
    Run run{};  // no nodes if there are too few edges
  };

  Fitted fitted_between(std::size_t from, std::size_t to, std::span<const Edge> edges) const {
    Fitted out{.from = from, .to = to};
    const std::size_t count = fine_.nodes.size();
    const std::size_t nodes = to > from ? to - from : to + count - from;
    constexpr std::size_t kLeastEdges = 2;
    const std::vector<Vec2> start = stretched(fine_.nodes, spacing_, from, nodes);
    if (edges.size() < kLeastEdges || start.size() < kLeastRunNodes) return out;
    out.run = fitted(start, false, edges, noise_, job_);
    if (Run finer = refined(out.run, edges, noise_, job_); finer.farthest <= kMostAway) out.run = std::move(finer);
    return out;
  }

  /// Index of the run that contains a position on the closed run.
  static std::size_t run_at(const std::vector<std::size_t>& bends, double along) {
    const auto after =
        std::ranges::upper_bound(bends, along, {}, [](std::size_t node) { return static_cast<double>(node); });
    return after == bends.begin() ? bends.size() - 1 : static_cast<std::size_t>(after - bends.begin()) - 1;
  }

  struct Verdict {
    double with = 0.0;  // sum of squared distances
    double without = 0.0;
    double edges = 0.0;
  };

  /// Whether the edges beside each corner lie within their noise of the runs, or about as near to them as to the curve
  /// without corners.
  bool judge(const CornerCut& cut, std::vector<bool>& is_good) const {
    const std::size_t count = fine_.nodes.size();
    const std::size_t corners = cut.corners.size();
    const double reach = kJudged / spacing_;
    std::vector<std::size_t> bends;
    for (const Corner& corner : cut.corners) bends.push_back(corner.node);
    std::vector<Verdict> verdicts(corners);
    const auto look = [&](std::size_t c, std::size_t i) {
      const Corner& corner = cut.corners[c];
      double away = std::abs(along_[i] - static_cast<double>(corner.node));
      away = std::min(away, static_cast<double>(count) - away);
      const Vec2 p = edges_[i].at;
      if (away > reach || distance(p, corner.at) <= kBesideCorner) return;
      const auto nodes = static_cast<std::size_t>(std::ceil(reach)) + 2;
      const std::vector<Vec2>& after = cut.runs[c].nodes;
      const std::vector<Vec2>& before = cut.runs[(c + corners - 1) % corners].nodes;
      const std::span first = std::span(after).first(std::min(nodes, after.size()));
      const std::span last = std::span(before).last(std::min(nodes, before.size()));
      verdicts[c].with += std::min(square_to(p, first), square_to(p, last));
      const auto here = static_cast<std::size_t>(along_[i]);
      double without = square_to(p, fine_.nodes[here % count], fine_.nodes[(here + 1) % count]);
      without = std::min(without, square_to(p, fine_.nodes[(here + count - 1) % count], fine_.nodes[here % count]));
      verdicts[c].without += without;
      verdicts[c].edges += 1.0;
    };
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      const std::size_t c = run_at(bends, along_[i]);
      look(c, i);
      if (corners > 1) look((c + 1) % corners, i);
    }
    bool are_all = true;
    for (std::size_t c = 0; c < corners; ++c) {
      constexpr double kMostWorse = 2.0;
      constexpr double kShareOfNoise = 0.6;
      const double allowed = kShareOfNoise * noise_.one;
      const Verdict& found = verdicts[c];
      is_good[c] =
          found.edges > 0.0 && found.with <= std::max(kMostWorse * found.without, found.edges * allowed * allowed);
      are_all = are_all && is_good[c];
    }
    return are_all;
  }

  /// The ellipse as two halves.
  PlaneCurve in_arcs(const Ellipse& ellipse) const {
    constexpr double kHalf = std::numbers::pi;
    EllipticArc arc{ellipse.center, ellipse.u, is_hole_ ? -ellipse.v : ellipse.v, 0.0, kHalf};
    PlaneCurve out(ellipse.center + ellipse.u);
    out.arc_to(arc, ellipse.center - ellipse.u);
    arc.start = kHalf;
    out.arc_to(arc, ellipse.center + ellipse.u);
    out.close();
    return out;
  }

  static PlaneCurve joined(const CornerCut& cut) {
    PlaneCurve out(cut.corners.front().at);
    for (const Run& run : cut.runs) add_pieces(run.nodes, run.stiffness, false, out);
    out.close();
    return out;
  }

  /// Adds pieces from the first node, where `out` ends, to the last.
  static void add_pieces(const std::vector<Vec2>& nodes, const std::vector<double>& stiffness, bool is_closed,
                         PlaneCurve& out) {
    const std::size_t last = nodes.size() - 1;
    if (!is_closed && is_straight(nodes)) return out.line_to(nodes.back());
    std::vector<Vec2> tangents(nodes.size());
    const NodeCurve curve(std::span<const Vec2>(nodes).first(is_closed ? last : last + 1), is_closed);
    // The tangent of the circle through three nodes is corrected for the change of curvature along them. Otherwise the
    // curvature within each piece would change in the opposite direction.
    const auto through = [&](std::size_t before, std::size_t at, std::size_t after) {
      const Vec2 in = nodes[at] - nodes[before], on = nodes[after] - nodes[at];
      const double a = mes::length(in), b = mes::length(on);
      const Vec2 tangent = unit_vector(b * unit_vector(in) + a * unit_vector(on));
      const double change = curve.curvature(before) - curve.curvature(after == last && is_closed ? 0 : after);
      const double turn = a + b > 0.0 ? a * b * change / (6.0 * (a + b)) : 0.0;
      return std::cos(turn) * tangent + std::sin(turn) * perpendicular(tangent);
    };
    for (std::size_t k = 1; k < last; ++k) tangents[k] = through(k - 1, k, k + 1);
    if (is_closed) {
      tangents.front() = tangents.back() = through(last - 1, 0, 1);
    } else {
      // End tangents mirror the next ones, as on a circle.
      const auto mirrored = [](Vec2 tangent, Vec2 chord) {
        const Vec2 on = unit_vector(chord);
        return 2.0 * dot(on, tangent) * on - tangent;
      };
      tangents.front() = mirrored(tangents[1], nodes[1] - nodes[0]);
      tangents.back() = mirrored(tangents[last - 1], nodes[last] - nodes[last - 1]);
    }
    double length = 0.0;
    for (std::size_t k = 1; k <= last; ++k) length += distance(nodes[k - 1], nodes[k]);
    const double most_turned = most_turn(length);
    constexpr double kShare = 0.5;  // share of the stiffness
    std::size_t from = 0;
    while (from < last) {
      std::size_t to = from + 1;
      double passed = distance(nodes[from], nodes[to]);
      double turned = std::abs(turn_of_corner(tangents[from], tangents[to]));
      while (to < last) {
        const double next = passed + distance(nodes[to], nodes[to + 1]);
        const double turn = turned + std::abs(turn_of_corner(tangents[to], tangents[to + 1]));
        if (next > kShare * std::min(stiffness[from], stiffness[to + 1]) || turn > most_turned) break;
        passed = next;
        turned = turn;
        ++to;
      }
      const Vec2 chord = nodes[to] - nodes[from];
      const double quarter = std::cos(0.25 * turn_of_corner(tangents[from], tangents[to]));
      const double handle = std::sqrt(dot(chord, chord)) / (3.0 * quarter * quarter);
      out.cubic_to(nodes[from] + handle * tangents[from], nodes[to] - handle * tangents[to], nodes[to]);
      from = to;
    }
  }

  static bool is_straight(const std::vector<Vec2>& nodes) {
    const Vec2 chord = nodes.back() - nodes.front();
    double length = 0.0;
    for (std::size_t k = 1; k < nodes.size(); ++k) length += distance(nodes[k - 1], nodes[k]);
    constexpr double kDetour = 1.01;
    if (length > kDetour * std::sqrt(dot(chord, chord))) return false;
    const Vec2 along = unit_vector(chord);
    return std::ranges::all_of(nodes, [&](Vec2 p) { return std::abs(cross(along, p - nodes.front())) <= kStraight; });
  }

  const PixelContour& contour_;
  EdgeNoise noise_;
  const JobControl* job_;
  bool is_hole_;
  std::vector<Edge> edges_;
  std::optional<Ellipse> ellipse_;
  bool is_plain_ = false;
  Run whole_;
  Run fine_;  // nodes at equal distances
  double spacing_ = 0.0;
  std::vector<Fitted> fitted_;  // runs of the last round
  std::vector<std::vector<Edge>> of_run_;
  std::vector<double> along_;
};

}  // namespace

PlaneCurve outline_of(const PixelContour& contour, const EdgeNoise& noise, const Box2& picture,
                      const JobControl* job) {
  Outliner outliner(contour, noise, job);
  PlaneCurve out = outliner.curve();
  return lies_in(picture, out) ? out : outliner.plain_curve();
}

}  // namespace mes
