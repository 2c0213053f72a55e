// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/balls/ball_sampling.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <vector>

namespace mes {
namespace {

constexpr double kShortest = 1e-4;  // relative to the diameter
constexpr double kThinnest = 0.1;   // relative to the smaller ball
constexpr std::size_t kBallsALook = 1024;
constexpr std::array<AxisNodeSlot, 2> kDead{};

}  // namespace

BallSampling::BallSampling(std::string_view id, SettingsSource& settings, BallUnion& balls, std::size_t most_between)
    : Structure(id, {&settings, &balls}), settings_(settings), union_(balls), most_between_(most_between) {}

void BallSampling::measure() {
  constexpr double kNone = -std::numeric_limits<double>::infinity();
  reach_.side.fill(kNone);
  reach_.ball.fill(kNoSlot);
  for (const FamilySlot ball : union_.tables().balls.rows()) add_to_reach(ball);
}

void BallSampling::add_to_reach(FamilySlot ball) {
  if (union_.tables().balls[ball] == BallState::none) return;
  const Box2 box = bounding_box_of(union_.family().disk(ball));
  const std::array side{box.high.x, box.high.y, -box.low.x, -box.low.y};
  for (std::size_t i = 0; i < side.size(); ++i) {
    if (!(side[i] > reach_.side[i])) continue;
    reach_.side[i] = side[i];
    reach_.ball[i] = ball;
  }
}

double BallSampling::diameter() const {
  return std::hypot(reach_.side[0] + reach_.side[2], reach_.side[1] + reach_.side[3]);
}

// Uses the samples, since one ball that touches three almost collinear samples may be a million times as large.
double BallSampling::diameter_of_shape() const {
  if (!union_.family().is_from_samples()) return diameter();
  Box2 box;
  std::vector<TouchedSample> touched;
  for (const FamilySlot ball : union_.tables().balls.rows()) {
    if (union_.tables().balls[ball] == BallState::none) continue;
    touched.clear();
    union_.family().touched_samples(ball, touched);
    for (const TouchedSample& sample : touched) box.add(sample.position);
  }
  return box.is_empty() ? 0.0 : distance(box.low, box.high);
}

// Rounded down to a power of two, so that an edit at the border of the data seldom affects the inside.
double BallSampling::shortest() const {
  const double length = kShortest * diameter();
  return std::isnormal(length) ? std::ldexp(1.0, std::ilogb(length)) : 0.0;
}

void BallSampling::set_ends(Sampling& sampling, LinkSlot link, const std::array<AxisNodeSlot, 2>& ends) {
  if (!sampling.ends.has(link)) sampling.ends.resize(link.index() + std::size_t{1}, kDead);
  const auto note = [this](AxisNodeSlot node) {
    if (!is_recording_) return;
    // Updates have no faces of v-points.
    const FamilySlot ball = ball_of(node);
    marks_.grow(ball.index() + std::size_t{1});
    if (marks_.insert(ball)) touched_balls_.push_back(ball);
  };
  for (const AxisNodeSlot node : sampling.ends[link]) {
    if (node == kNoSlot) continue;
    --sampling.degree[node];
    note(node);
  }
  sampling.ends[link] = ends;
  for (const AxisNodeSlot node : ends) {
    if (node == kNoSlot) continue;
    ++sampling.degree[node];
    note(node);
  }
}

void BallSampling::remake_piece(AxisPieceSlot row) {
  const UnionTables& t = union_.tables();
  const AxisPiece& piece = t.axis[row];
  medial_.between -= medial_.balls.drop(owner_of_link(row));
  set_ends(medial_, same_row<LinkSlot>(row), piece.is_alive() ? std::array{piece.node[0], piece.node[1]} : kDead);
  if (!piece.is_alive() || piece.is_zero != 0) return;
  const auto at = [&](double u) {
    Disk disk{place_between(piece.a, piece.b, u), std::numeric_limits<double>::infinity()};
    for (const VPointSlot v : piece.v)
      if (v != kNoSlot) disk.radius = std::min(disk.radius, distance(disk.center, t.v_points[v].position));
    return disk;
  };
  const auto add = [&](const Disk& disk) {
    medial_.balls.add(owner_of_link(row), disk);
    ++medial_.between;
  };
  if (shrinking() == 1.0) {
    halving_.halve(at, {piece.a, piece.radius_a}, {piece.b, piece.radius_b}, add);
    return;
  }
  const auto shrunk = [this](const Disk& disk) { return Disk{disk.center, shrinking() * disk.radius}; };
  halving_.halve([&](double u) { return shrunk(at(u)); }, shrunk({piece.a, piece.radius_a}),
                 shrunk({piece.b, piece.radius_b}),
                 [&](const Disk& disk) {
                   add({disk.center, disk.radius / shrinking()});
                 });
}

void BallSampling::remake_edge(DualEdgeSlot row) {
  const DualEdge& edge = union_.tables().dual_edges[row];
  const bool is_boundary = edge.is_alive() && edge.kind != DualClass::interior;
  convex_.between -= convex_.balls.drop(owner_of_link(row));
  set_ends(convex_, same_row<LinkSlot>(row),
           is_boundary ? std::array{node_of(edge.ball[0]), node_of(edge.ball[1])} : kDead);
  if (!is_boundary) return;
  const Disk a = union_.family().disk(edge.ball[0]);
  const Disk b = union_.family().disk(edge.ball[1]);
  const double d = distance(a.center, b.center);
  const double size = std::max({a.radius, b.radius, d});
  const auto square = [size](double length) { return (length / size) * (length / size); };
  const double least = kThinnest * std::min(a.radius, b.radius);
  const auto at = [&](double u) {
    const double weight = ((1.0 - u) * square(a.radius) + u * square(b.radius)) - u * (1.0 - u) * square(d);
    return Disk{place_between(a.center, b.center, u), std::max(least, size * std::sqrt(std::max(weight, 0.0)))};
  };
  halving_.halve(at, a, b, [&](const Disk& disk) {
    convex_.balls.add(owner_of_link(row), disk);
    ++convex_.between;
  });
}

void BallSampling::remake_ball(FamilySlot ball) {
  const bool is_isolated = union_.tables().balls[ball] == BallState::isolated;
  for (Sampling* sampling : {&medial_, &convex_}) {
    sampling->balls.drop(owner_of(node_of(ball)));
    const bool is_node = sampling->degree[node_of(ball)] != 0 || (is_isolated && sampling == &medial_);
    if (is_node) sampling->balls.add(owner_of(node_of(ball)), union_.family().disk(ball));
  }
}

// Nodes of the axis that are not centres of balls. Where more than three v-points lie on one circle, several triangles
// have this circle and are one node.
void BallSampling::add_vertices_of_axis() {
  const UnionTables& t = union_.tables();
  struct Node {
    Disk disk;
    AxisNodeSlot node;
  };
  std::vector<Node> nodes;
  for (const VFaceSlot face : t.v_faces.rows()) {
    const AxisNodeSlot node = t.node_of(face);
    const Disk disk{t.v_faces[face].center, t.v_faces[face].radius};
    if (medial_.degree[node] != 0 && is_finite(disk)) nodes.push_back({disk, node});
  }
  std::ranges::sort(nodes, {},
                    [](const Node& n) { return std::tuple(n.disk.center.x, n.disk.center.y, n.disk.radius); });
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (i == 0 || nodes[i].disk.center != nodes[i - 1].disk.center)
      medial_.balls.add(owner_of(nodes[i].node), nodes[i].disk);
}

bool BallSampling::fill(JobControl& job) {
  const UnionTables& t = union_.tables();
  for (Sampling* sampling : {&medial_, &convex_}) {
    sampling->balls.reset();
    sampling->between = 0;
    sampling->ends.clear();
    sampling->degree.assign(t.node_count(), 0);
  }
  const std::size_t all = t.axis.size() + (is_for_growing() ? 0 : t.dual_edges.size());
  std::size_t made = 0;
  const auto look = [&](std::size_t done) {
    const std::size_t now = medial_.between + convex_.between;
    if ((done & 0x3ffU) != 0 && now - made <= kBallsALook) return;
    job.checkpoint(done, all);
    made = now;
  };
  for (const AxisPieceSlot piece : t.axis.rows()) {
    look(piece.index());
    remake_piece(piece);
    if (has_too_many(medial_)) return false;
  }
  for (const DualEdgeSlot edge : t.dual_edges.rows()) {
    if (is_for_growing()) break;
    look(t.axis.size() + edge.index());
    remake_edge(edge);
    if (has_too_many(convex_)) return false;
  }
  for (const FamilySlot ball : t.balls.rows()) remake_ball(ball);
  add_vertices_of_axis();
  return true;
}

void BallSampling::rebuild(JobControl& job) {
  made_with_ = angle();
  measure();
  shortest_ = shortest();
  is_recording_ = false;
  is_bounded_ = true;
  halving_ = BallHalving(made_with_, shortest_, is_for_growing());
  while (!fill(job)) {
    const double size = diameter_of_shape();
    is_bounded_ = is_for_growing() || wider_tolerance(halving_, size);
    const double tolerance = is_bounded_ ? next_tolerance(halving_, size) : halving_.tolerance();
    halving_ = BallHalving(made_with_, shortest_, is_for_growing(), tolerance);
  }
}

// Only the certified shortcut has local updates. It has no faces of v-points, and its pieces and dual edges share rows.
bool BallSampling::update(JobControl&) {
  clear_changes();
  if (angle() != made_with_) return false;
  const UnionChanges& changes = union_.changes();
  if (changes.size() == 0) return true;
  if (union_.rung() != UnionRung::shortcut || halving_.tolerance() != 0.0 || !is_bounded_) return false;
  const UnionTables& t = union_.tables();

  bool is_reach_lost = false;
  for (const auto* rows : {&changes.balls.touched, &changes.balls.removed})
    for (const FamilySlot ball : *rows)
      is_reach_lost = is_reach_lost || std::ranges::find(reach_.ball, ball) != reach_.ball.end();
  if (is_reach_lost) {
    measure();
  } else {
    for (const FamilySlot ball : changes.balls.touched) add_to_reach(ball);
  }
  if (shortest() != shortest_) return false;

  is_recording_ = true;
  marks_.begin(t.balls.size());
  touched_balls_.clear();
  for (Sampling* sampling : {&medial_, &convex_}) {
    sampling->balls.begin();
    sampling->degree.resize(t.balls.size(), 0);
  }
  for (const auto* rows : {&changes.balls.touched, &changes.balls.removed})
    for (const FamilySlot ball : *rows)
      if (marks_.insert(ball)) touched_balls_.push_back(ball);
  for (const auto* rows : {&changes.dual_edges.touched, &changes.dual_edges.removed}) {
    for (const DualEdgeSlot edge : *rows) {
      remake_piece(same_row<AxisPieceSlot>(edge));
      remake_edge(edge);
      // Beyond this, a rebuild uses a tolerance.
      if (std::max(medial_.between, convex_.between) > 2 * most_between_) return false;
    }
  }
  for (const FamilySlot ball : touched_balls_) remake_ball(ball);
  for (Sampling* sampling : {&medial_, &convex_}) sampling->balls.finish();
  return !has_too_many(medial_) && !has_too_many(convex_);
}

void BallSampling::clear_changes() {
  medial_.balls.clear_changes();
  convex_.balls.clear_changes();
}

StatList BallSampling::statistics() const {
  return {{"medial_balls", static_cast<std::int64_t>(medial().count())},
          {"convex_balls", static_cast<std::int64_t>(convex().count())},
          {"tolerance", halving_.tolerance()}};
}

void BallSampling::find(std::vector<Finding>& out) const {
  find_tolerance(id(), halving_.tolerance(), medial().count() + convex().count(), out);
}

}  // namespace mes
