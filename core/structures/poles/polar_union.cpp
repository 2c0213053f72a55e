// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/poles/polar_union.h"

#include "core/structures/balls/voronoi_balls.h"

namespace mes {
namespace {

class InteriorPolarBalls final : public VoronoiBalls {
 public:
  InteriorPolarBalls(const Delaunay& delaunay, const VoronoiVertices& vertices, const PoleLabels& labels)
      : VoronoiBalls(delaunay, vertices), labels_(labels) {}
  bool is_ball(FamilySlot row) const override {
    return delaunay_.is_finite_face(face_of(row)) && labels_.is_inside_pole(face_of(row));
  }
  bool has_changed() const override { return !labels_.changes().is_empty(); }

 private:
  const PoleLabels& labels_;
};

}  // namespace

PUnion::PUnion(SettingsSource& settings, Delaunay& delaunay, VoronoiVertices& vertices, Poles& poles,
               PoleLabels& labels)
    : BallUnion("p-union", {&settings, &delaunay, &vertices, &poles, &labels}, settings, Parameter::p_scale,
                std::make_unique<InteriorPolarBalls>(delaunay, vertices, labels)) {}

PPowerDiagram::PPowerDiagram(SettingsSource& settings, Delaunay& delaunay, VoronoiVertices& vertices, Poles& poles,
                             PoleLabels& labels)
    : PowerDiagram("p-power-diagram", {&settings, &delaunay, &vertices, &poles, &labels}, settings,
                   std::make_unique<InteriorPolarBalls>(delaunay, vertices, labels), Parameter::p_scale) {}

PBallFiltration::PBallFiltration(SettingsSource& settings, Delaunay& delaunay, VoronoiVertices& vertices,
                                 Poles& poles, PoleLabels& labels)
    : BallFiltration("p-ball-filtration", {&settings, &delaunay, &vertices, &poles, &labels}, settings,
                     std::make_unique<InteriorPolarBalls>(delaunay, vertices, labels), Parameter::p_scale) {}

}  // namespace mes
