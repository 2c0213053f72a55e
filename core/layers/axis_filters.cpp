// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of the one-step axis that lambda, object angle and cover date keep, with disks, circles and their union,
// and the parts that they remove.
#include <string_view>
#include <vector>

#include "core/layers/parts/family.h"
#include "core/layers/parts/helpers.h"
#include "core/structures/balls/kept_union.h"
#include "core/structures/filters/angle_axis.h"
#include "core/structures/filters/cover_axis.h"
#include "core/structures/filters/lambda_axis.h"

namespace mes {
namespace {

struct FilterLayer {
  const char* id;
  const char* name;
  const char* tooltip;
};
struct FilterLayers {
  const char* scalar;
  FilterLayer axis, disks, circles, removed, boundary;
};

constexpr FilterLayers kLambda{
    "lambda",
    {"lambda-medial-axis", "Lambda medial axis",
     "Axis edges whose two samples are at least twice lambda-limit apart; with keep-topology also those that connect "
     "them"},
    {"lambda-medial-disks", "Lambda medial disks",
     "Inner disks whose samples need an enclosing circle of radius lambda-limit or more"},
    {"lambda-medial-circles", "Lambda medial circles",
     "Inner circles whose samples need an enclosing circle of radius lambda-limit or more"},
    {"removed-by-lambda", "Removed by lambda", "The part of the medial axis that the lambda medial axis lacks"},
    {"lambda-kept-boundary", "Lambda kept boundary",
     "Boundary of the union of the balls along the lambda medial axis: the part of the shape that is kept"}};
constexpr FilterLayers kAngle{
    "angle (degrees)",
    {"angle-medial-axis", "Angle medial axis",
     "Points of the axis that see their two nearest samples at twice angle-limit or more; with keep-topology also "
     "those that connect them"},
    {"angle-medial-disks", "Angle medial disks",
     "Inner disks with two samples that the centre sees at twice angle-limit or more"},
    {"angle-medial-circles", "Angle medial circles",
     "Inner circles with two samples that the centre sees at twice angle-limit or more"},
    {"removed-by-angle", "Removed by angle", "The part of the medial axis that the angle medial axis lacks"},
    {"angle-kept-boundary", "Angle kept boundary",
     "Boundary of the union of the balls along the angle medial axis: the part of the shape that is kept"}};
constexpr FilterLayers kCover{
    "1 - 1/s",
    {"cover-medial-axis", "Cover medial axis",
     "Axis edges whose balls no other swallows while all grow by scale-axis-factor; with keep-topology also those "
     "that "
     "connect them"},
    {"cover-medial-disks", "Cover medial disks",
     "Inner disks that no other swallows while all grow by scale-axis-factor"},
    {"cover-medial-circles", "Cover medial circles",
     "Inner circles that no other swallows while all grow by scale-axis-factor"},
    {"removed-by-cover", "Removed by cover date", "The part of the medial axis that the cover medial axis lacks"},
    {"cover-kept-boundary", "Cover kept boundary",
     "Boundary of the union of the balls along the cover medial axis: the part of the shape that is kept"}};

LayerDescriptor descriptor_of(const FilterLayer& layer, const std::string& scalar, PrimitiveKind kind,
                              LayerStyle style) {
  return {.id = layer.id,
          .name = layer.name,
          .tooltip = layer.tooltip,
          .group = LayerGroup::crust_axis,
          .scalar = scalar,
          .style = std::move(style),
          .kinds = {kind}};
}

Layer kept_axis(const AxisFilter& filter, const FilterLayers& layers) {
  const Delaunay& delaunay = filter.delaunay();
  return make_layer(
      descriptor_of(layers.axis, layers.scalar, PrimitiveKind::segment,
                    {.color = palette::vermilion, .line_width_px = 2.5, .color_map = "cividis"}),
      {&delaunay, &filter},
      edges_part({PrimitiveKind::segment}, delaunay, filter.edge_changes(), [&](EdgeSlot edge, Instance& out) {
        if (filter.is_kept(edge)) out.segment(filter.kept_end(edge, 0), filter.kept_end(edge, 1), filter.value(edge));
      }));
}

Layer removed(const AxisFilter& filter, const FilterLayers& layers) {
  const Delaunay& delaunay = filter.delaunay();
  return make_layer(descriptor_of(layers.removed, layers.scalar, PrimitiveKind::segment,
                                  {.color = palette::vermilion, .opacity = 0.35, .line_width_px = 1.0}),
                    {&delaunay, &filter},
                    table_part(
                        {PrimitiveKind::segment}, [&] { return 2 * delaunay.edge_rows(); }, filter.removed_changes(),
                        [&](AxisEndSlot row, Instance& out) {
                          Vec2 a, b;
                          if (filter.removed_piece(row, a, b))
                            out.segment(a, b, filter.value(EdgeSlot(row.index() / 2)));
                        },
                        ElementType{ElementKind::axis_piece, &filter}));
}

template <class Draw>
Layer kept_balls(const AxisFilter& filter, const FilterLayer& layer, const std::string& scalar, PrimitiveKind kind,
                 LayerStyle style, Draw draw) {
  const Delaunay& delaunay = filter.delaunay();
  style.color = palette::orange;
  style.color_map = "cividis";
  return make_layer(
      descriptor_of(layer, scalar, kind, std::move(style)), {&delaunay, &filter},
      faces_part({kind}, delaunay, filter.node_changes(), [&filter, &delaunay, draw](FaceSlot face, Instance& out) {
        if (filter.is_kept(face))
          draw(out, delaunay.circumcenter(face), delaunay.circumradius(face), filter.value(face));
      }));
}

Layer kept_disks(const AxisFilter& filter, const FilterLayers& layers) {
  return kept_balls(filter, layers.disks, layers.scalar, PrimitiveKind::disk, {.opacity = 0.3},
                    [](Instance& out, Vec2 c, double r, double value) { out.disk(c, r, value); });
}
Layer kept_circles(const AxisFilter& filter, const FilterLayers& layers) {
  return kept_balls(filter, layers.circles, layers.scalar, PrimitiveKind::circle, {.opacity = 0.8},
                    [](Instance& out, Vec2 c, double r, double value) { out.circle(c, r, value); });
}

Layer kept_boundary(const KeptUnion& balls, const FilterLayers& layers) {
  return make_layer(
      descriptor_of(layers.boundary, {}, PrimitiveKind::arc, {.color = palette::orange, .line_width_px = 1.5}),
      {&balls},
      union_part({PrimitiveKind::arc}, balls, &UnionTables::arcs, balls.changes().arcs,
                 [&balls](const BoundaryArc& arc, Instance& out) {
                   if (!arc.is_alive()) return;
                   if (const auto drawn = drawn_arc(arc, balls.family().disk(arc.ball))) out.arc(*drawn);
                 }));
}

/// Calls `make(filter, layers)` for each filter.
template <class Make>
std::vector<Layer> for_each_filter(const StructureSet& set, Make make) {
  std::vector<Layer> out;
  out.push_back(make(set.get<LambdaAxis>(), kLambda));
  out.push_back(make(set.get<AngleAxis>(), kAngle));
  out.push_back(make(set.get<CoverAxis>(), kCover));
  return out;
}

}  // namespace

std::vector<Layer> make_filtered_disk_layers(const StructureSet& set) {
  return for_each_filter(set, kept_disks);
}
std::vector<Layer> make_filtered_circle_layers(const StructureSet& set) {
  return for_each_filter(set, kept_circles);
}
std::vector<Layer> make_kept_boundary_layers(const StructureSet& set) {
  std::vector<Layer> out;
  out.push_back(kept_boundary(set.get<LambdaUnion>(), kLambda));
  out.push_back(kept_boundary(set.get<AngleUnion>(), kAngle));
  out.push_back(kept_boundary(set.get<CoverUnion>(), kCover));
  return out;
}
std::vector<Layer> make_removed_axis_layers(const StructureSet& set) {
  return for_each_filter(set, removed);
}
std::vector<Layer> make_filtered_axis_layers(const StructureSet& set) {
  return for_each_filter(set, kept_axis);
}

}  // namespace mes
