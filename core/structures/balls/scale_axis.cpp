// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/balls/scale_axis.h"

#include <algorithm>

#include "core/graph/explain.h"
#include "core/structures/balls/voronoi_balls.h"

namespace mes {
namespace {

constexpr std::size_t kEdgesALook = 1024;

OwnerSlot edge_owner(EdgeSlot edge) {
  return same_row<OwnerSlot>(edge);
}

/// Inner Voronoi balls, plus balls between them unless the factor is 1.
class BallsAlongAxis final : public VoronoiBalls {
 public:
  BallsAlongAxis(const Delaunay& delaunay, const InnerBalls& balls, const SampledBalls& between)
      : VoronoiBalls(delaunay, balls.vertices()), balls_(balls), between_(between) {}

  std::size_t rows() const override {
    return is_plain() ? delaunay_.face_rows() : 2 * std::max(delaunay_.face_rows(), between_.rows());
  }
  std::string_view rows_of() const override { return is_plain() ? VoronoiBalls::rows_of() : std::string_view(); }
  bool is_ball(FamilySlot row) const override {
    if (is_between(row)) return between_of(row).index() < between_.rows() && between_.is_alive(between_of(row));
    const FaceSlot face = face_at(row);
    return face.index() < delaunay_.face_rows() && balls_.is_ball(face) && vertices_.is_vertex(face);
  }
  Disk plain_disk(FamilySlot row) const override {
    return is_between(row) ? between_.disk(between_of(row)) : VoronoiBalls::plain_disk(as_face(row));
  }
  bool is_from_samples() const override { return is_plain(); }
  BallOrigin origin(FamilySlot row) const override {
    return is_between(row) ? BallOrigin::disk : BallOrigin::circumdisk;
  }
  std::array<Vec2, 3> corners(FamilySlot row) const override {
    if (!is_between(row)) return VoronoiBalls::corners(as_face(row));
    const Vec2 center = between_.disk(between_of(row)).center;
    return {center, center, center};
  }
  void touched_samples(FamilySlot row, std::vector<TouchedSample>& out) const override {
    VoronoiBalls::touched_samples(as_face(row), out);
  }
  bool has_changed() const override { return !balls_.changes().is_empty() || !between_.changes().is_empty(); }

  bool is_between(FamilySlot row) const { return !is_plain() && row.index() % 2 == 1; }
  FaceSlot face_at(FamilySlot row) const { return FaceSlot(is_plain() ? row.index() : row.index() / 2); }

 private:
  bool is_plain() const { return scale() == 1.0; }
  FamilySlot as_face(FamilySlot row) const { return same_row<FamilySlot>(face_at(row)); }
  static SampledSlot between_of(FamilySlot row) { return SampledSlot(row.index() / 2); }

  const InnerBalls& balls_;
  const SampledBalls& between_;
};

}  // namespace

AxisSampling::AxisSampling(SettingsSource& settings, Delaunay& delaunay, MedialAxis& axis)
    : Structure("axis-sampling", {&settings, &delaunay, &axis}),
      settings_(settings),
      delaunay_(delaunay),
      axis_(axis) {}

// At a factor of 1 balls between would add nothing to the union.
AxisSampling::Density AxisSampling::density() const {
  const ComputationSettings& settings = settings_.current();
  const double factor = settings[Parameter::scale_axis_factor];
  if (factor == 1.0) return {};
  return {settings[Parameter::medial_sampling_angle], std::min(1.0, factor)};
}

bool AxisSampling::is_edge(EdgeSlot edge) const {
  return delaunay_.edge(edge).is_alive() && axis_.is_axis_edge(edge) && !axis_.is_zero_length(edge);
}

// A ball about a point of the edge touches both samples; its radius is the distance to the smaller one.
void AxisSampling::remake(EdgeSlot edge) {
  between_.drop(edge_owner(edge));
  if (made_with_.angle == kNone || !is_edge(edge)) return;
  const EdgeRow& row = delaunay_.edge(edge);
  const Vec2 p = delaunay_.site_position(row.v[0]);
  const Vec2 q = delaunay_.site_position(row.v[1]);
  const Vec2 sample = lexicographically_less(p, q) ? p : q;
  const Vec2 a = delaunay_.circumcenter(row.f[0]);
  const Vec2 b = delaunay_.circumcenter(row.f[1]);
  const auto ball_about = [sample](Vec2 center) { return Disk{center, distance(center, sample)}; };
  const auto shrunk = [&](Vec2 center) { return Disk{center, made_with_.shrinking * distance(center, sample)}; };
  if (!is_finite(ball_about(a)) || !is_finite(ball_about(b))) return;
  halving_.halve([&](double u) { return shrunk(place_between(a, b, u)); }, shrunk(a), shrunk(b),
                 [&](const Disk& disk) { between_.add(edge_owner(edge), ball_about(disk.center)); });
}

double AxisSampling::diameter() const {
  Box2 box;
  for (const EdgeSlot edge : delaunay_.edge_slots()) {
    if (!is_edge(edge)) continue;
    for (const FaceSlot face : delaunay_.edge(edge).f)
      for (const SiteSlot site : delaunay_.face(face).v)
        if (site != kInfiniteSite) box.add(delaunay_.site_position(site));
  }
  return box.is_empty() ? 0.0 : distance(box.low, box.high);
}

double AxisSampling::spacing(double radius) const {
  const double of_angle = made_with_.shrinking * distance_of_sampled(made_with_.angle) * radius;
  if (halving_.tolerance() == 0.0) return of_angle;
  return std::max(of_angle, halving_.widest(made_with_.shrinking * radius));
}

bool AxisSampling::fill(JobControl& job) {
  between_.reset();
  std::size_t looked = 0;
  std::size_t made = 0;
  for (const EdgeSlot edge : delaunay_.edge_slots()) {
    if (looked == 0) job.checkpoint(edge.index(), delaunay_.edge_rows());
    remake(edge);
    if (between_.count() > kMostBallsBetween) return false;
    // One edge may have as many balls as all others together.
    looked = looked == kEdgesALook || between_.count() - made > kEdgesALook ? 0 : looked + 1;
    if (looked == 0) made = between_.count();
  }
  return true;
}

void AxisSampling::rebuild(JobControl& job) {
  made_with_ = density();
  between_.reset();
  if (made_with_.angle == kNone) return;
  halving_ = BallHalving(made_with_.angle);
  while (!fill(job)) halving_ = BallHalving(made_with_.angle, 0.0, false, next_tolerance(halving_, diameter()));
}

bool AxisSampling::update(JobControl&) {
  clear_changes();
  if (density() != made_with_) return false;
  const ChangeSet<EdgeSlot>& edges = axis_.edge_changes();
  if (made_with_.angle == kNone || edges.is_empty()) return true;
  if (halving_.tolerance() != 0.0) return false;
  between_.begin();
  for (const auto* rows : {&edges.removed, &edges.touched}) {
    for (const EdgeSlot edge : *rows) {
      remake(edge);
      if (between_.count() > 2 * kMostBallsBetween) return false;
    }
  }
  between_.finish();
  return between_.count() <= kMostBallsBetween;
}

StatList AxisSampling::statistics() const {
  std::int64_t not_finite = 0;
  if (made_with_.angle != kNone) {
    for (const EdgeSlot edge : delaunay_.edge_slots()) {
      if (!is_edge(edge)) continue;
      const EdgeRow& row = delaunay_.edge(edge);
      const Vec2 sample = delaunay_.site_position(row.v[0]);
      not_finite += std::ranges::all_of(row.f,
                                        [&](FaceSlot face) {
                                          const Vec2 center = delaunay_.circumcenter(face);
                                          return is_finite(Disk{center, distance(center, sample)});
                                        })
                        ? 0
                        : 1;
    }
  }
  return {{"balls_between", static_cast<std::int64_t>(between_.count())},
          {"tolerance", made_with_.angle == kNone ? 0.0 : halving_.tolerance()},
          {"not_finite", not_finite}};
}

void AxisSampling::find(std::vector<Finding>& out) const {
  if (made_with_.angle != kNone) find_tolerance(id(), halving_.tolerance(), between_.count(), out);
}

ScaleUnion::ScaleUnion(SettingsSource& settings, Delaunay& delaunay, OneStepCrust& crust, Labels& labels,
                       InnerBalls& balls, MedialAxis& axis, AxisSampling& sampling, AxisCertificate& certificate)
    : BallUnion("scale-union", {&settings, &delaunay, &crust, &labels, &balls, &axis, &sampling, &certificate},
                settings, Parameter::scale_axis_factor,
                std::make_unique<BallsAlongAxis>(delaunay, balls, sampling.between()), &certificate,
                std::make_unique<SampleUnion>(delaunay, crust, labels, balls, axis, certificate)),
      delaunay_(delaunay),
      labels_(labels),
      balls_(balls),
      sampling_(sampling) {}

void ScaleUnion::rebuild(JobControl& job) {
  hairs_ = {};
  BallUnion::rebuild(job);
}

void ScaleUnion::refine(UnionTables& tables) {
  if (factor() == 1.0) return;
  hairs_ = cut_hairs(tables, spacing());
  tables.measures.axis_length = std::max(0.0, tables.measures.axis_length - hairs_.length);
}

Table<FamilySlot, double> ScaleUnion::spacing() const {
  Table<FamilySlot, double> out(family().rows(), 0.0);
  const auto row_of = [](FaceSlot face) { return FamilySlot(2 * face.index()); };
  for (const FaceSlot face : delaunay_.face_slots()) {
    if (!balls_.is_ball(face)) continue;
    const FamilySlot ball = row_of(balls_.ball(face));
    const FaceRow& row = delaunay_.face(face);
    out[ball] = std::max(out[ball], sampling_.spacing(family().plain_disk(ball).radius));
    for (int i = 0; i < 3; ++i) {
      if (labels_.is_inside(row.n[i])) continue;
      const Vec2 p = delaunay_.site_position(row.v[next3(i)]);
      const Vec2 q = delaunay_.site_position(row.v[prev3(i)]);
      out[ball] = std::max(out[ball], distance(p, q));
    }
  }
  for (const EdgeSlot edge : delaunay_.edge_slots()) {
    sampling_.for_each_on(edge, [&](SampledSlot between) {
      double& there = out[FamilySlot(2 * between.index() + std::size_t{1})];
      there = sampling_.spacing(sampling_.between().disk(between).radius);
      for (const FaceSlot face : delaunay_.edge(edge).f) there = std::max(there, out[row_of(balls_.ball(face))]);
    });
  }
  for (double& spacing : out) spacing *= share_of_spacing(factor());
  return out;
}

StatList ScaleUnion::statistics() const {
  StatList out = BallUnion::statistics();
  out.insert(out.end(), {{"hairs", hairs_.pieces}, {"hair_length", hairs_.length}});
  return out;
}

void GrownBallSampling::explain(ElementKind kind, RowNumber row, Explanation& out) const {
  const SampledSlot ball(row);
  if (kind != ElementKind::sampled_ball || ball.index() >= medial().rows() || !medial().is_alive(ball)) return;
  const Disk& grown = medial().disk(ball);
  const double factor = balls_.family().scale();
  ProvenanceShapes itself, circle;
  itself.circle({grown.center, grown.radius / factor});
  out.say(ProvenanceRole::itself,
          "Ball about a point of the scale axis, radius " + number_text(grown.radius / factor), itself);
  if (factor == 1.0) return;
  circle.circle(grown);
  out.say(ProvenanceRole::origin,
          std::string("the largest ball there in the ") + (factor < 1.0 ? "shrunk" : "grown") + " union, " +
              number_text(factor) + " times as large",
          circle);
}

void explain_divided_radii(const BallUnion& balls, AxisPieceSlot row, Explanation& out) {
  const double factor = balls.family().scale();
  const auto& axis = balls.tables().axis;
  if (factor == 1.0 || !axis.has(row) || !axis[row].is_alive()) return;
  const AxisPiece& piece = axis[row];
  ProvenanceShapes shapes;
  shapes.circle({piece.a, piece.radius_a / factor});
  shapes.circle({piece.b, piece.radius_b / factor});
  out.say(ProvenanceRole::product,
          "radii divided by " + number_text(factor) + " again: " + number_text(piece.radius_a / factor) + " to " +
              number_text(piece.radius_b / factor),
          shapes);
}

void ScaleUnion::explain(ElementKind kind, RowNumber row, Explanation& out) const {
  const FamilySlot ball(row);
  if (kind == ElementKind::axis_piece) {
    BallUnion::explain(kind, row, out);
    return explain_divided_radii(*this, AxisPieceSlot(row), out);
  }
  if (kind != ElementKind::ball) return BallUnion::explain(kind, row, out);
  if (!tables().balls.has(ball) || !family().is_ball(ball)) return;
  const auto& balls = static_cast<const BallsAlongAxis&>(family());
  if (balls.is_between(ball)) {
    ProvenanceShapes itself;
    itself.circle(balls.plain_disk(ball));
    out.say(ProvenanceRole::itself,
            "Ball about a point of an edge of the medial axis, radius " + number_text(balls.plain_disk(ball).radius),
            itself);
  } else {
    out.about(ElementKind::voronoi_vertex, balls.face_at(ball));
  }
  explain_scale(ball, out);
  explain_place(ball, out);
}

}  // namespace mes
