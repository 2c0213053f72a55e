// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/balls/ball_diagrams.h"

#include "core/base/jobs/isolated.h"
#include "core/structures/balls/local_balls.h"
#include "core/structures/balls/voronoi_balls.h"

namespace mes {

PowerDiagram::PowerDiagram(std::string_view id, std::vector<Structure*> inputs, const SettingsSource& settings,
                           std::unique_ptr<BallFamily> family, std::optional<Parameter> scale)
    : Structure(id, std::move(inputs)), settings_(settings), family_(std::move(family)), scale_(scale) {}

void PowerDiagram::rebuild(JobControl& job) {
  made_with_ = settings_.precision();
  family_->set_scale(scale());
  const LocalBalls balls = local_balls(*family_, job);
  const PipelineInput input = balls.input();
  switch (made_with_) {
    case Precision::naive: {
      constexpr IsolationLimits kLimits{10.0, std::uint64_t{1} << 32U, "naive arithmetic"};
      const auto bytes = run_isolated(
          [&] {
            JobControl own;
            TableWriter writer;
            writer(run_power_diagram_naive(input, own));
            return writer.take();
          },
          kLimits, job);
      TableReader reader(bytes);
      reader(edges_);
      break;
    }
    case Precision::fast: edges_ = run_power_diagram_doubles(input, job); break;
    case Precision::exact:
    case Precision::exact_roots: edges_ = run_power_diagram_exact(input, job); break;
  }
}

bool PowerDiagram::update(JobControl&) {
  return made_with_ == settings_.precision() && family_->scale() == scale() && !family_->has_changed();
}

StatList PowerDiagram::statistics() const {
  std::int64_t rays = 0;
  for (const PowerEdge& edge : edges_) rays += edge.kind == PowerEdge::Kind::segment ? 0 : 1;
  return {{"edges", static_cast<std::int64_t>(edges_.size())}, {"unbounded", rays}};
}

std::string_view PowerDiagram::kernel() const {
  switch (made_with_) {
    case Precision::naive: return "double";
    case Precision::fast: return "EPICK on rounded points";
    case Precision::exact:
    case Precision::exact_roots: return "EPECK";
  }
  return {};
}

VDiagram::VDiagram(std::string_view id, std::vector<Structure*> inputs, const BallUnion& balls)
    : Structure(id, std::move(inputs)), union_(balls) {}

KnownVPoints VDiagram::known_v_points(const Table<InputSlot, PipelineBall>&) const {
  return {};
}

void VDiagram::rebuild(JobControl& job) {
  own_ = UnionTables{};
  if (union_.rung() != UnionRung::shortcut) return;
  const LocalBalls balls = local_balls(union_.family(), job);
  own_ = run_v_diagram(balls.input(), known_v_points(balls.balls), job);
}

bool VDiagram::update(JobControl&) {
  return union_.changes().size() == 0;
}

StatList VDiagram::statistics() const {
  std::vector<std::int64_t> kinds(3, 0);
  for (const VEdge& edge : tables().v_edges) ++kinds[static_cast<std::size_t>(edge.kind)];
  std::int64_t inside = 0;
  for (const VFace& face : tables().v_faces) inside += face.is_inside;
  return {{"v_edges", kinds[0] + kinds[1] + kinds[2]},
          {"crossing_edges", kinds[1]},
          {"alpha_edges", kinds[2]},
          {"v_faces", static_cast<std::int64_t>(tables().v_faces.size())},
          {"inside", inside}};
}

APowerDiagram::APowerDiagram(SettingsSource& settings, Delaunay& delaunay, Labels& labels, InnerBalls& balls)
    : PowerDiagram("a-power-diagram", {&settings, &delaunay, &labels, &balls}, settings,
                   inner_voronoi_balls(delaunay, balls), Parameter::a_scale) {}

VoronoiBallDiagram::VoronoiBallDiagram(SettingsSource& settings, Delaunay& delaunay, VoronoiVertices& vertices)
    : PowerDiagram("voronoi-ball-diagram", {&settings, &delaunay, &vertices}, settings,
                   std::make_unique<VoronoiBalls>(delaunay, vertices)) {}

BPowerDiagram::BPowerDiagram(SettingsSource& settings, UserBalls& balls)
    : PowerDiagram("b-power-diagram", {&settings, &balls}, settings, user_ball_family(balls), Parameter::b_scale) {}

BVDiagram::BVDiagram(BUnion& b_union) : VDiagram("b-v-diagram", {&b_union}, b_union) {}

AVDiagram::AVDiagram(Delaunay& delaunay, OneStepCrust& crust, Labels& labels, InnerBalls& balls, AUnion& a_union)
    : VDiagram("a-v-diagram", {&delaunay, &crust, &labels, &balls, &a_union}, a_union),
      delaunay_(delaunay),
      crust_(crust),
      labels_(labels),
      balls_(balls),
      union_(a_union) {}

// The samples on the circle of a ball are the corners of its faces. Along the outer edges of these faces, the arc
// beyond a border edge is free and that beyond any other is covered. A sample that only this ball touches is no
// v-point, and then lies between two border edges.
KnownVPoints AVDiagram::known_v_points(const Table<InputSlot, PipelineBall>& balls) const {
  KnownVPoints out;
  const UnionTables& t = union_.tables();
  Table<SiteSlot, VPointSlot> v_of_site(delaunay_.site_rows());
  for (const SiteSlot site : delaunay_.site_slots()) {
    if (!t.v_points[same_row<VPointSlot>(site)].is_alive()) continue;
    v_of_site[site] = out.points.next();
    out.points.push_back(delaunay_.site_position(site));
    out.sites.push_back(site);
  }
  const auto arc_beyond = [&](EdgeSlot edge) {
    const EdgeRow& row = delaunay_.edge(edge);
    if (labels_.is_inside(row.f[0]) != labels_.is_inside(row.f[1])) return CircleArc::free;
    const auto touched_by_two = [&](SiteSlot site) {
      return t.v_points[same_row<VPointSlot>(site)].multiplicity == 2;
    };
    const bool is_singular = touched_by_two(row.v[0]) && touched_by_two(row.v[1]);
    return is_singular ? CircleArc::singular : CircleArc::covered;
  };
  out.places.resize(balls.size());
  for (const InputSlot k : balls.rows()) {
    // Walk from corner to corner; across a diagonal of cocircular samples the walk goes on in the next face.
    FaceSlot face = same_row<FaceSlot>(balls[k].row);
    int i = 0;
    while (is_diagonal(face, i)) {
      const FaceSlot next = delaunay_.face(face).n[i];
      i = next3(delaunay_.face(next).index_of_neighbour(face));
      face = next;
    }
    const FaceSlot first_face = face;
    const int first_i = i;
    std::vector<CirclePlace>& places = out.places[k];
    do {
      const FaceRow& row = delaunay_.face(face);
      // Edge i runs from corner next3(i) to corner prev3(i).
      const VPointSlot v = v_of_site[row.v[prev3(i)]];
      const CircleArc arc = arc_beyond(row.e[i]);
      if (v != kNoSlot) places.push_back({v, arc});
      int j = next3(i);
      while (is_diagonal(face, j)) {
        const FaceSlot next = delaunay_.face(face).n[j];
        j = next3(delaunay_.face(next).index_of_neighbour(face));
        face = next;
      }
      i = j;
    } while (face != first_face || i != first_i);
  }
  return out;
}

bool AVDiagram::is_diagonal(FaceSlot face, int i) const {
  const EdgeSlot edge = delaunay_.face(face).e[i];
  return edge != kNoSlot && crust_.is_cocircular(edge);
}

}  // namespace mes
