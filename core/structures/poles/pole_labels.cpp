// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/poles/pole_labels.h"

#include <queue>
#include <tuple>
#include <utility>

#include "core/structures/balls/deep_overlap.h"
#include "core/structures/balls/local_balls.h"
#include "core/structures/poles/internal/polar_balls.h"

namespace mes {
namespace {

/// The labels of the two poles are equal or, if `is_opposite`, different.
struct Link {
  InputSlot pole;
  bool is_opposite = false;
  double confidence = 0.0;
};

/// Spreads labels along links from poles that are certainly outside.
class PoleGraph {
 public:
  explicit PoleGraph(const Table<InputSlot, PipelineBall>& balls)
      : balls_(balls), links_(balls.size()), label_(balls.size()) {}

  void link(InputSlot a, InputSlot b, bool is_opposite, double confidence) {
    links_[a].push_back({b, is_opposite, confidence});
    links_[b].push_back({a, is_opposite, confidence});
  }
  void start_outside(InputSlot pole) { settle(pole, Label::outside); }
  void spread(JobControl& job) {
    for (std::size_t steps = 0; !queue_.empty(); ++steps) {
      if ((steps & 0x3ffU) == 0) job.checkpoint();
      const Candidate next = queue_.top();
      queue_.pop();
      if (label_[next.pole] == Label::unknown) settle(next.pole, next.label);
    }
  }
  bool is_reached(InputSlot pole) const { return label_[pole] != Label::unknown; }
  bool is_inside(InputSlot pole) const { return label_[pole] == Label::inside; }

 private:
  enum class Label : std::uint8_t { unknown, outside, inside };
  struct Candidate {
    double confidence;
    Vec2 center;
    Label label;
    InputSlot pole;
    /// Breaks ties by values that do not depend on numbering.
    friend bool operator<(const Candidate& a, const Candidate& b) {
      return std::tie(a.confidence, a.center.x, a.center.y, a.label) <
             std::tie(b.confidence, b.center.x, b.center.y, b.label);
    }
  };
  void settle(InputSlot pole, Label label) {
    label_[pole] = label;
    const Label other = label == Label::inside ? Label::outside : Label::inside;
    for (const Link& link : links_[pole])
      if (label_[link.pole] == Label::unknown)
        queue_.push({link.confidence, balls_[link.pole].disk.center, link.is_opposite ? other : label, link.pole});
  }

  const Table<InputSlot, PipelineBall>& balls_;
  Table<InputSlot, std::vector<Link>> links_;
  Table<InputSlot, Label> label_;
  std::priority_queue<Candidate> queue_;
};

}  // namespace

PoleLabels::PoleLabels(SettingsSource& settings, Delaunay& delaunay, VoronoiVertices& vertices, Labels& labels,
                       Poles& poles)
    : Structure("pole-labels", {&settings, &delaunay, &vertices, &labels, &poles}),
      settings_(settings),
      delaunay_(delaunay),
      vertices_(vertices),
      labels_(labels),
      poles_(poles) {}

void PoleLabels::spread(JobControl& job) {
  PolarBalls family(delaunay_, vertices_, poles_);
  family.measure();
  const LocalBalls local = local_balls(family, job);
  const bool is_exact = made_with_ == Precision::exact || made_with_ == Precision::exact_roots;
  const Table<PowerEdgeSlot, PowerEdge> edges =
      is_exact ? run_power_diagram_exact(local.input(), job) : run_power_diagram_doubles(local.input(), job);

  Table<FamilySlot, InputSlot> ball_of_row(local.rows);
  for (const InputSlot i : local.balls.rows()) ball_of_row[local.balls[i].row] = i;
  PoleGraph graph(local.balls);
  const auto link_if_deep = [&](InputSlot a, InputSlot b) {
    if (overlap_deeply(local.balls[a], local.balls[b]))
      graph.link(a, b, false, cosine_at_crossing(local.balls[a].disk, local.balls[b].disk));
  };
  Table<InputSlot, bool> is_visible(local.balls.size(), false);
  for (const PowerEdge& edge : edges) {
    const InputSlot a = ball_of_row[edge.ball[0]];
    const InputSlot b = ball_of_row[edge.ball[1]];
    is_visible[a] = is_visible[b] = true;
    link_if_deep(a, b);
  }
  // A hidden ball has no neighbours in the regular triangulation, so use those in the Voronoi diagram.
  for (const EdgeRow& edge : delaunay_.edges()) {
    if (!edge.is_alive() || delaunay_.face(edge.f[0]).is_infinite() || delaunay_.face(edge.f[1]).is_infinite())
      continue;
    const InputSlot a = ball_of_row[same_row<FamilySlot>(vertices_.vertex(edge.f[0]))];
    const InputSlot b = ball_of_row[same_row<FamilySlot>(vertices_.vertex(edge.f[1]))];
    if (a != kNoSlot && b != kNoSlot && a != b && !(is_visible[a] && is_visible[b])) link_if_deep(a, b);
  }
  for (const SiteSlot site : delaunay_.site_slots()) {
    if (!delaunay_.is_site(site) || poles_.minus(site) == kNoSlot) continue;
    const InputSlot a = ball_of_row[family.ball_of_plus(site)];
    const InputSlot b = ball_of_row[family.ball_of_minus(site)];
    if (a == kNoSlot || b == kNoSlot) continue;
    graph.link(a, b, true,
               -dot(family.direction_to(poles_.plus(site), site), family.direction_to(poles_.minus(site), site)));
  }
  // Balls that represent one far pole have its label.
  Table<FaceSlot, InputSlot> ball_of_pole(delaunay_.face_rows());
  for (const InputSlot i : local.balls.rows()) {
    const FamilySlot row = local.balls[i].row;
    const FaceSlot pole = family.pole_of(row);
    if (pole == kInfinitePole) {
      graph.start_outside(i);
    } else if (const InputSlot other = std::exchange(ball_of_pole[pole], i); other != kNoSlot) {
      graph.link(i, other, false, 1.0);
    }
  }
  graph.spread(job);

  inside_.assign(delaunay_.face_rows(), 0);
  unreached_ = 0;
  for (const FaceSlot face : delaunay_.face_slots()) {
    if (!poles_.is_pole(face)) continue;
    const InputSlot ball = ball_of_pole[face];
    const bool is_reached = ball != kNoSlot && graph.is_reached(ball);
    inside_[face] = (is_reached ? graph.is_inside(ball) : labels_.is_inside(face)) ? 1 : 0;
    unreached_ += is_reached ? 0 : 1;
  }
}

void PoleLabels::rebuild(JobControl& job) {
  clear_changes();
  is_spread_ = wants_spreading() && delaunay_.dimension() == 2;
  made_with_ = settings_.precision();
  if (is_spread_) spread(job);
}

bool PoleLabels::update(JobControl&) {
  const ChangeSet<FaceSlot>& poles = poles_.face_changes();
  const ChangeSet<FaceSlot>& labels = labels_.face_changes();
  if (poles.is_empty() && labels.is_empty())
    return is_spread_ == (wants_spreading() && delaunay_.dimension() == 2) &&
           (!is_spread_ || made_with_ == settings_.precision());
  if (is_spread_ || wants_spreading()) return false;
  recorder_.begin(delaunay_.face_rows());
  for (const ChangeSet<FaceSlot>* changes : {&poles, &labels}) {
    for (const FaceSlot face : changes->removed) recorder_.note(face, true);
    for (const FaceSlot face : changes->touched) recorder_.note(face, true);
  }
  recorder_.finish(changes_, [this](FaceSlot face) { return delaunay_.face(face).is_alive(); });
  return true;
}

StatList PoleLabels::statistics() const {
  std::int64_t inside = 0;
  std::int64_t outside = 0;
  std::int64_t differ = 0;
  for (const FaceSlot face : delaunay_.face_slots()) {
    if (!poles_.is_pole(face)) continue;
    (is_inside(face) ? inside : outside) += 1;
    differ += is_inside(face) != labels_.is_inside(face) ? 1 : 0;
  }
  return {{"inside", inside},
          {"outside", outside},
          {"against_triangle", differ},
          {"unreached", is_spread_ ? unreached_ : 0}};
}

std::string_view PoleLabels::kernel() const {
  if (!is_spread_) return "none needed";
  const bool is_exact = made_with_ == Precision::exact || made_with_ == Precision::exact_roots;
  return is_exact ? "EPECK" : "EPICK on rounded points";
}

}  // namespace mes
