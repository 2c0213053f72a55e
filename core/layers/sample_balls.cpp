// SPDX-License-Identifier: GPL-3.0-or-later
// Voronoi balls and polar balls of the samples, as disks, circles and centres; each row of a table makes one layer.
#include <span>
#include <string_view>
#include <vector>

#include "core/base/assert.h"
#include "core/layers/parts/helpers.h"
#include "core/structures/axis/inner_balls.h"
#include "core/structures/crust/labels.h"
#include "core/structures/poles/pole_labels.h"

namespace mes {
namespace {

enum class BallSet : std::uint8_t {
  voronoi,
  exterior_voronoi,
  interior_voronoi,
  exterior_polar,
  polar,
  interior_polar
};

struct BallSetLook {
  LayerGroup group;
  Rgb color;
  bool is_interior;  ///< belongs to the paper, and is not arbitrarily large
};
constexpr BallSetLook kLooks[] = {
    {LayerGroup::delaunay_voronoi, palette::grey, false},  // voronoi
    {LayerGroup::crust_axis, palette::sky, false},         // exterior_voronoi
    {LayerGroup::crust_axis, palette::orange, true},       // interior_voronoi
    {LayerGroup::poles, palette::sky, false},              // exterior_polar
    {LayerGroup::poles, palette::purple, false},           // polar
    {LayerGroup::poles, palette::orange, true},            // interior_polar
};

struct BallLayer {
  BallSet set;
  const char* id;
  const char* name;
  const char* tooltip;
  double opacity = 1.0;
  bool dashed = false;
  bool flat = false;
  bool visible_at_start = false;
};

// Bottom layer first.
constexpr BallLayer kDisks[] = {
    {BallSet::voronoi, "voronoi-disks", "Voronoi disks", "Circumdisks of all Delaunay triangles", 0.1},
    {BallSet::exterior_voronoi, "exterior-voronoi-disks", "Exterior Voronoi disks",
     "Disks of triangles not labelled inside", 0.1},
    {.set = BallSet::interior_voronoi,
     .id = "interior-voronoi-disks",
     .name = "Interior Voronoi disks",
     .tooltip = "Disks of inside triangles; their union approximates the shape",
     .opacity = 0.2,
     .flat = true,
     .visible_at_start = true},
    {BallSet::exterior_polar, "exterior-polar-disks", "Exterior polar disks", "Disks of poles not labelled inside",
     0.1},
    {BallSet::polar, "polar-disks", "Polar disks", "Disks of all poles", 0.1},
    {BallSet::interior_polar, "interior-polar-disks", "Interior polar disks", "Disks of poles labelled inside", 0.2},
};
constexpr BallLayer kCircles[] = {
    {BallSet::voronoi, "voronoi-circles", "Voronoi circles", "Circumcircles of all Delaunay triangles", 0.4},
    {.set = BallSet::exterior_voronoi,
     .id = "exterior-voronoi-circles",
     .name = "Exterior Voronoi circles",
     .tooltip = "Circumcircles of triangles not labelled inside",
     .opacity = 0.4,
     .dashed = true},
    {BallSet::interior_voronoi, "interior-voronoi-circles", "Interior Voronoi circles",
     "Circumcircles whose triangle is labelled inside", 0.6},
    {BallSet::exterior_polar, "exterior-polar-circles", "Exterior polar circles",
     "Circles of poles not labelled inside", 0.4},
    {BallSet::polar, "polar-circles", "Polar circles", "Circles of all poles", 0.4},
    {BallSet::interior_polar, "interior-polar-circles", "Interior polar circles", "Circles of poles labelled inside",
     0.6},
};
constexpr BallLayer kCenters[] = {
    {BallSet::exterior_voronoi, "exterior-voronoi-vertices", "Exterior Voronoi vertices",
     "Centres of the outside circumcircles"},
    {BallSet::interior_voronoi, "interior-voronoi-vertices", "Interior Voronoi vertices",
     "Centres of the inside circumcircles"},
    {BallSet::exterior_polar, "exterior-polar-vertices", "Exterior polar vertices", "Poles not labelled inside"},
    {BallSet::interior_polar, "interior-polar-vertices", "Interior polar vertices", "Poles labelled inside"},
};

LayerDescriptor descriptor_of(const BallLayer& layer, PrimitiveKind kind) {
  const BallSetLook& look = kLooks[static_cast<std::size_t>(layer.set)];
  return {.id = layer.id,
          .name = layer.name,
          .tooltip = layer.tooltip,
          .group = look.group,
          .in_paper = look.is_interior,
          .in_fit_box = look.is_interior,
          .visible_at_start = layer.visible_at_start,
          .scalar = "radius",
          .style = {.color = look.color,
                    .opacity = layer.opacity,
                    .point_size_px = kind == PrimitiveKind::point ? 4.0 : LayerStyle{}.point_size_px,
                    .dashed = layer.dashed,
                    .flat = layer.flat},
          .kinds = {kind}};
}

/// Calls `use(input structures, changes, holds)`, where `holds(face)` tells whether a finite face is a ball of the set.
template <class Use>
Layer with_balls(BallSet balls, const StructureSet& set, const Use& use) {
  const auto& delaunay = set.get<Delaunay>();
  const auto& labels = set.get<Labels>();
  const auto& inner = set.get<InnerBalls>();
  const auto& poles = set.get<Poles>();
  const auto& pole_labels = set.get<PoleLabels>();
  switch (balls) {
    case BallSet::voronoi: return use({&delaunay}, delaunay.face_changes(), [](FaceSlot) { return true; });
    case BallSet::exterior_voronoi:
      return use({&delaunay, &labels}, labels.face_changes(), [&](FaceSlot face) { return !labels.is_inside(face); });
    case BallSet::interior_voronoi:
      return use({&delaunay, &inner}, inner.changes(), [&](FaceSlot face) { return inner.is_ball(face); });
    case BallSet::exterior_polar:
      return use({&delaunay, &poles, &pole_labels}, pole_labels.changes(),
                 [&](FaceSlot face) { return poles.is_pole(face) && !pole_labels.is_inside(face); });
    case BallSet::polar:
      return use({&delaunay, &poles}, poles.face_changes(), [&](FaceSlot face) { return poles.is_pole(face); });
    case BallSet::interior_polar:
      return use({&delaunay, &pole_labels}, pole_labels.changes(),
                 [&](FaceSlot face) { return pole_labels.is_inside_pole(face); });
  }
  assertion_failed("every set of balls has its layers", __FILE_NAME__, __LINE__);
}

/// Draws each ball with `draw(instance, centre, radius)`.
template <class Draw>
std::vector<Layer> ball_layers(std::span<const BallLayer> layers, PrimitiveKind kind, const StructureSet& set,
                               Draw draw) {
  const auto& delaunay = set.get<Delaunay>();
  std::vector<Layer> out;
  for (const BallLayer& layer : layers) {
    const auto make = [&](std::vector<const Structure*> structures, const ChangeSet<FaceSlot>& changes, auto holds) {
      return make_layer(
          descriptor_of(layer, kind), std::move(structures),
          faces_part({kind}, delaunay, changes, [&delaunay, holds, draw](FaceSlot face, Instance& instance) {
            if (holds(face)) draw(instance, delaunay.circumcenter(face), delaunay.circumradius(face));
          }));
    };
    out.push_back(with_balls(layer.set, set, make));
  }
  return out;
}

}  // namespace

std::vector<Layer> make_sample_ball_disk_layers(const StructureSet& set) {
  return ball_layers(kDisks, PrimitiveKind::disk, set, [](Instance& out, Vec2 c, double r) { out.disk(c, r, r); });
}
std::vector<Layer> make_sample_ball_circle_layers(const StructureSet& set) {
  return ball_layers(kCircles, PrimitiveKind::circle, set,
                     [](Instance& out, Vec2 c, double r) { out.circle(c, r, r); });
}
std::vector<Layer> make_sample_ball_center_layers(const StructureSet& set) {
  return ball_layers(kCenters, PrimitiveKind::point, set, [](Instance& out, Vec2 c, double r) { out.point(c, r); });
}

}  // namespace mes
