// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/curves/internal/network.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

#include "core/base/disjoint_sets.h"
#include "core/curves/curve_bounds.h"
#include "core/curves/internal/contacts.h"
#include "core/curves/joined_ends.h"

namespace mes {
namespace {

/// A piece, or a part of one, between two possible nodes.
struct Part {
  Piece piece{};
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  std::uint32_t kind = 0;  ///< index of the first part with the same path, in either direction
  bool is_forward = true;  ///< whether it has the direction of that part
};

/// Moves the end of a piece.
void set_end(Piece& piece, Vec2 to) {
  piece.points[piece.kind == PieceKind::cubic ? 3 : piece.kind == PieceKind::quadratic ? 2 : 1] = to;
}

class NetworkMaker {
 public:
  NetworkMaker(const std::vector<PlaneCurve>& curves, Contacts contacts, JobControl* job)
      : curves_(curves), contacts_(std::move(contacts)), job_(job) {}

  bool has_contacts() const;
  CurveNetwork make() {
    join_vertices();
    divide_pieces();
    compare_parts();
    find_breaks();
    for (std::uint32_t c = 0; c < curves_.size(); ++c) walk(c);
    drop_repeated_walks();
    measure();
    return std::move(out_);
  }

 private:
  void checkpoint() const {
    if (job_ != nullptr && job_->stop_requested()) throw Cancelled{};
  }
  void join_vertices();
  void divide_pieces();
  void compare_parts();
  void find_breaks();
  void walk(std::uint32_t curve);
  void walk_alone(const PlaneCurve& curve);
  void add_arc(const std::vector<Part>& parts, std::size_t first, std::size_t count, const PlaneCurve& curve);
  void drop_repeated_walks();
  void measure();
  std::uint32_t node_of(std::uint32_t point);

  const std::vector<PlaneCurve>& curves_;
  Contacts contacts_;
  JobControl* job_;
  std::vector<std::uint32_t> point_of_;    // for each vertex
  std::vector<std::vector<Part>> parts_;   // for each curve
  std::vector<std::uint32_t> first_part_;  // for each curve, the index of its first part among all parts
  std::vector<bool> is_break_;             // for each point
  std::vector<std::uint32_t> node_of_point_;
  std::vector<std::uint32_t> arc_of_part_;  // indexed by kind
  std::vector<bool> is_forward_in_arc_;     // indexed by kind
  std::uint32_t node_count_ = 0;
  CurveNetwork out_;
};

// Two curves touch if a vertex of one lies on a piece of the other, or coincides with a vertex of the other.
bool NetworkMaker::has_contacts() const {
  std::vector<std::uint32_t> curve_at(contacts_.vertices.size(), CurveNetwork::kNoNode);
  for (const TouchingPiece& piece : contacts_.pieces)
    for (const std::uint32_t vertex : {piece.from, piece.to}) {
      if (curve_at[vertex] != CurveNetwork::kNoNode && curve_at[vertex] != piece.curve) return true;
      curve_at[vertex] = piece.curve;
    }
  return std::ranges::any_of(contacts_.contacts, [&](const Contact& contact) {
    return contacts_.pieces[contact.piece].curve != curve_at[contact.vertex];
  });
}

void NetworkMaker::join_vertices() {
  const std::size_t count = contacts_.vertices.size();
  DisjointSets<std::uint32_t> sets(count);
  for (const Contact& contact : contacts_.contacts) {
    const TouchingPiece& piece = contacts_.pieces[contact.piece];
    if (contact.parameter == 0.0) sets.join(sets.root(contact.vertex), sets.root(piece.from));
    if (contact.parameter == 1.0) sets.join(sets.root(contact.vertex), sets.root(piece.to));
  }
  // The first vertex represents all.
  std::vector<std::uint32_t> first(count, CurveNetwork::kNoNode);
  point_of_.resize(count);
  for (std::uint32_t v = 0; v < count; ++v) {
    std::uint32_t& point = first[sets.root(v)];
    if (point == CurveNetwork::kNoNode) point = v;
    point_of_[v] = point;
  }
}

void NetworkMaker::divide_pieces() {
  std::ranges::sort(contacts_.contacts, {}, [](const Contact& c) { return std::pair(c.piece, c.parameter); });
  parts_.resize(curves_.size());
  const auto place = [this](std::uint32_t point) { return contacts_.vertices[point]; };
  std::size_t next = 0;
  for (std::uint32_t number = 0; number < contacts_.pieces.size(); ++number) {
    const TouchingPiece& whole = contacts_.pieces[number];
    std::vector<Part>& parts = parts_[whole.curve];
    std::uint32_t at = point_of_[whole.from];
    const std::uint32_t end = point_of_[whole.to];
    double begin = 0.0;
    const auto add = [&](double to, std::uint32_t point) {
      Part part{begin == 0.0 && to == 1.0 ? whole.piece : whole.piece.part(begin, to), at, point};
      part.piece.points[0] = place(at);
      set_end(part.piece, place(point));
      begin = to;
      at = point;
      // A line between two merged vertices is dropped.
      if (part.from != part.to || part.piece.kind != PieceKind::line) parts.push_back(part);
    };
    for (; next < contacts_.contacts.size() && contacts_.contacts[next].piece == number; ++next) {
      const Contact& contact = contacts_.contacts[next];
      const std::uint32_t point = point_of_[contact.vertex];
      if (contact.parameter <= begin || contact.parameter >= 1.0 || point == at || point == end) continue;
      add(contact.parameter, point);
    }
    add(1.0, end);
  }
}

void NetworkMaker::compare_parts() {
  std::vector<Part*> all;
  for (std::vector<Part>& parts : parts_)
    for (Part& part : parts) {
      part.kind = static_cast<std::uint32_t>(all.size());
      all.push_back(&part);
    }
  arc_of_part_.assign(all.size(), CurveNetwork::kNoNode);
  is_forward_in_arc_.assign(all.size(), true);
  std::vector<std::uint32_t> order(all.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  const auto key = [&](std::uint32_t i) {
    const Part& part = *all[i];
    return std::tuple(std::min(part.from, part.to), std::max(part.from, part.to), i);
  };
  std::ranges::sort(order, {}, key);
  const auto is_same = [this](const Part& a, const Part& b, bool is_forward) {
    constexpr double kQuarter = 0.25;
    constexpr double kOfSize = 1.0 / 64.0;
    const Box2 box = bounds_of(a.piece);
    const double tolerance = std::min(2.0 * contacts_.tolerance, kOfSize * std::max(box.width(), box.height()));
    for (const double t : {kQuarter, 2.0 * kQuarter, 3.0 * kQuarter})
      if (!(distance(a.piece.at(t), b.piece.at(is_forward ? t : 1.0 - t)) <= tolerance)) return false;
    return true;
  };
  for (std::size_t begin = 0; begin < order.size();) {
    const auto [low, high, first] = key(order[begin]);
    std::size_t end = begin;
    // Different paths between two points, each named by its first part. Only malicious input reaches the limit.
    constexpr std::size_t kMostWays = 64;
    std::vector<std::uint32_t> ways;
    for (; end < order.size(); ++end) {
      Part& part = *all[order[end]];
      if (std::pair(std::min(part.from, part.to), std::max(part.from, part.to)) != std::pair(low, high)) break;
      const auto takes = [&](std::uint32_t way) {
        const Part& other = *all[way];
        // A part that starts and ends at one point is compared in both directions.
        for (const bool is_forward : {true, false}) {
          if (part.from != part.to && is_forward != (part.from == other.from)) continue;
          if (!is_same(part, other, is_forward)) continue;
          part.kind = way;
          part.is_forward = is_forward;
          return true;
        }
        return false;
      };
      if (std::ranges::none_of(ways, takes) && ways.size() < kMostWays) ways.push_back(order[end]);
    }
    begin = end;
  }
}

// Finds breaks: points where an open curve ends, or where more or fewer than two paths meet.
void NetworkMaker::find_breaks() {
  const std::size_t count = contacts_.vertices.size();
  std::vector<std::uint8_t> ways(count, 0);
  is_break_.assign(count, false);
  std::uint32_t number = 0;
  for (std::uint32_t c = 0; c < curves_.size(); ++c) {
    for (const Part& part : parts_[c]) {
      if (part.kind == number++)
        for (const std::uint32_t point : {part.from, part.to})
          ways[point] = static_cast<std::uint8_t>(std::min(ways[point] + 1, 3));
    }
    if (curves_[c].is_closed() || parts_[c].empty()) continue;
    is_break_[parts_[c].front().from] = true;
    is_break_[parts_[c].back().to] = true;
  }
  for (std::size_t point = 0; point < count; ++point)
    if (ways[point] != 0 && ways[point] != 2) is_break_[point] = true;
  node_of_point_.assign(count, CurveNetwork::kNoNode);
}

std::uint32_t NetworkMaker::node_of(std::uint32_t point) {
  std::uint32_t& node = node_of_point_[point];
  if (node == CurveNetwork::kNoNode) node = node_count_++;
  return node;
}

/// Adds a curve that touches no other.
void NetworkMaker::walk_alone(const PlaneCurve& curve) {
  const auto arc = static_cast<std::uint32_t>(out_.arcs.size());
  out_.arcs.push_back(curve);
  std::array<std::uint32_t, 2> ends{CurveNetwork::kNoNode, CurveNetwork::kNoNode};
  if (!curve.is_closed())
    for (std::uint32_t& end : ends) end = node_count_++;
  out_.nodes.push_back(ends);
  out_.walks.push_back({{{arc, false}}, curve.is_closed()});
}

void NetworkMaker::add_arc(const std::vector<Part>& parts, std::size_t first, std::size_t count,
                           const PlaneCurve& curve) {
  const auto arc = static_cast<std::uint32_t>(out_.arcs.size());
  PlaneCurve& made = out_.arcs.emplace_back(parts[first].piece.from());
  made.name = curve.name;
  for (std::size_t i = 0; i < count; ++i) {
    const Part& part = parts[(first + i) % parts.size()];
    made.add(part.piece);
    arc_of_part_[part.kind] = arc;
    is_forward_in_arc_[part.kind] = part.is_forward;
  }
  const std::uint32_t from = parts[first].from;
  const std::uint32_t to = parts[(first + count - 1) % parts.size()].to;
  if (count == parts.size() && curve.is_closed()) {
    made.close();
    const std::uint32_t node = is_break_[from] ? node_of(from) : CurveNetwork::kNoNode;
    out_.nodes.push_back({node, node});
  } else {
    out_.nodes.push_back({node_of(from), node_of(to)});
  }
}

void NetworkMaker::walk(std::uint32_t c) {
  const PlaneCurve& curve = curves_[c];
  const std::vector<Part>& parts = parts_[c];
  if (parts.empty()) return walk_alone(curve);
  if (c % 1024 == 0) checkpoint();
  std::size_t first = 0;
  if (curve.is_closed())
    while (first < parts.size() && !is_break_[parts[first].from]) ++first;
  if (first == parts.size()) first = 0;
  CurveNetwork::Walk& walk = out_.walks.emplace_back(CurveNetwork::Walk{{}, curve.is_closed()});
  for (std::size_t done = 0; done < parts.size();) {
    std::size_t count = 1;
    const auto part = [&](std::size_t i) -> const Part& { return parts[(first + i) % parts.size()]; };
    while (done + count < parts.size() && !is_break_[part(done + count).from]) ++count;
    const Part& begin = part(done);
    if (arc_of_part_[begin.kind] == CurveNetwork::kNoNode)
      add_arc(parts, (first + done) % parts.size(), count, curve);
    walk.steps.push_back({arc_of_part_[begin.kind], begin.is_forward != is_forward_in_arc_[begin.kind]});
    done += count;
  }
}

void NetworkMaker::drop_repeated_walks() {
  using Steps = std::vector<CurveNetwork::Step>;
  const auto backwards = [](Steps steps) {
    std::ranges::reverse(steps);
    for (CurveNetwork::Step& step : steps) step.is_backwards = !step.is_backwards;
    return steps;
  };
  std::map<Steps, bool> seen;
  std::erase_if(out_.walks, [&](const CurveNetwork::Walk& walk) {
    Steps steps = walk.steps;
    if (walk.is_closed) {
      std::ranges::rotate(steps, std::ranges::min_element(steps));
    } else if (Steps other = backwards(steps); other < steps) {
      steps = std::move(other);
    }
    return !seen.try_emplace(std::move(steps), true).second;
  });
}

void NetworkMaker::measure() {
  std::vector<double> lengths;
  for (const PlaneCurve& arc : out_.arcs) {
    double sum = 0.0;
    arc.for_each_piece([&sum](const Piece& piece) {
      constexpr double kHalf = 0.5;
      const Vec2 middle = piece.at(kHalf);
      sum += distance(piece.from(), middle) + distance(middle, piece.to());
    });
    lengths.push_back(sum);
  }
  out_.whole.assign(out_.arcs.size(), std::numeric_limits<double>::infinity());
  for (const CurveNetwork::Walk& walk : out_.walks) {
    double sum = 0.0;
    for (const CurveNetwork::Step& step : walk.steps) sum += lengths[step.arc];
    for (const CurveNetwork::Step& step : walk.steps) out_.whole[step.arc] = std::min(out_.whole[step.arc], sum);
  }
}

}  // namespace

PlaneCurve curve_of(const CurveNetwork& network, const CurveNetwork::Walk& walk) {
  const auto along = [&](const CurveNetwork::Step& step) {
    return step.is_backwards ? reversed(network.arcs[step.arc]) : network.arcs[step.arc];
  };
  PlaneCurve out = along(walk.steps.front());
  if (out.is_closed()) return out;
  for (std::size_t i = 1; i < walk.steps.size(); ++i)
    along(walk.steps[i]).for_each_piece([&out](const Piece& piece) { out.add(piece); });
  if (walk.is_closed) out.close();
  return out;
}

std::optional<CurveNetwork> network_of(const std::vector<PlaneCurve>& curves, double resolution, JobControl* job,
                                       bool within_curves) {
  NetworkMaker maker(curves, contacts_of(curves, resolution, within_curves, job), job);
  if (!within_curves && !maker.has_contacts()) return std::nullopt;
  return maker.make();
}

}  // namespace mes
