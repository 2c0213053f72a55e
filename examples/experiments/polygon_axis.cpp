// SPDX-License-Identifier: GPL-3.0-or-later
// The exact medial axis of the polygon through the samples.
//
// The polygon consists of the closed contours of the document, or else of the closed chains of the one-step crust. Its
// medial axis is the inner part of the Voronoi diagram of its corners and open sides, without the edges between a side
// and its own ends (D. T. Lee, Medial axis transformation of a planar shape, IEEE PAMI 4, 1982). Two sides or two
// corners give straight pieces. A corner and a side give an arc of a parabola, drawn as chords that are at most 1/10000
// of the diagonal away. CGAL's segment Delaunay graph decides everything exactly, also where contours touch or cross
// (M. Karavelas, A robust and efficient implementation for the segment Voronoi diagram, ISVD 2004). A region is inside
// if a path from outside crosses an odd number of sides; the path goes through the graph, so no rounded point is
// located. Only coordinates of vertices are rounded. Every convex corner has a branch, so a sampled curve has a branch
// for most samples: polygon-axis-angle hides them.
//
// Cost: 0.8 s for the 10 000 samples of a letter; several times more for smooth curves with as many samples, where
// corners are nearly cocircular and exact numbers decide.
//
//   mesecina shape.poff --with polygon_axis.cpp
// mesecina-flags: -DNDEBUG -lmpfr -lgmp
#include "polygon_axis.h"

namespace {

class PolygonAxis final : public Structure {
 public:
  void rebuild(const Inputs& inputs) override;
  std::vector<OwnTable> tables() const override {
    std::vector<OwnTable> out;
    out.emplace_back("pieces", "Straight pieces of the axis, and chords of its parabolas")
        .column("from", "One end", pieces_, &Piece::from)
        .column("to", "The other end", pieces_, &Piece::to)
        .column("half_angle", "Half the angle between the two nearest points as the middle sees them, in degrees",
                pieces_, &Piece::half_angle)
        .column("is_curved", "The piece is a chord of a parabola", pieces_, &Piece::is_curved);
    return out;
  }
  std::vector<Statistic> statistics() const override {
    return {{"polygon_sides", sides_}, {"straight_pieces", lines_}, {"parabolic_arcs", arcs_}};
  }
  std::vector<Finding> findings() const override {
    if (sides_ == 0) return {{.text = "No contour and no chain of the crust is closed, so there is no polygon"}};
    if (is_unclear_) return {{.text = "Contours share a part of a side, which is not resolved: there is no axis"}};
    return {};
  }

 private:
  std::vector<Piece> pieces_;
  std::int64_t sides_ = 0, lines_ = 0, arcs_ = 0;
  bool is_unclear_ = false;
};

void PolygonAxis::rebuild(const Inputs& inputs) {
  pieces_.clear();
  lines_ = arcs_ = 0;
  is_unclear_ = false;
  // A power of two brings all coordinates to at most 1 without rounding.
  const auto place = inputs.column<Point>("delaunay/sites/position");
  double largest = 0.0;
  for (const Row site : inputs.live_rows("delaunay/sites"))
    largest = std::max({largest, std::abs(place[site].x), std::abs(place[site].y)});
  const double unit = std::ldexp(1.0, std::ilogb(largest) + 1);
  bool may_cross = false;
  const Sides sides = find_sides(inputs, unit, may_cross);
  sides_ = static_cast<std::int64_t>(sides.size());
  if (sides.empty()) return;
  inputs.checkpoint();
  is_unclear_ = may_cross ? !Axis<Crossing>{pieces_, lines_, arcs_}.compute(sides, unit)
                          : !Axis<MeetingAtCorners>{pieces_, lines_, arcs_}.compute(sides, unit);
}

}  // namespace

MESECINA_EXPERIMENT(experiment) {
  experiment.add_parameter(
      {.id = "polygon-axis-angle",
       .description = "Pieces that see their two nearest points under less than twice this are hidden",
       .unit = "degrees",
       .low = 0.0,
       .high = 90.0,
       .default_value = 20.0});
  experiment.add_structure<PolygonAxis>({.id = "polygon-axis", .inputs = {"delaunay", "contours", "curve"}});
  for (const bool is_arc : {false, true})
    experiment.add_layer({.id = is_arc ? "polygon-axis-arcs" : "polygon-axis-lines",
                          .name = is_arc ? "Polygon axis, arcs" : "Polygon axis, lines",
                          .description = std::string(is_arc ? "Parabolic arcs" : "Straight pieces") +
                                         " of the medial axis of the polygon through the samples",
                          .rows = "polygon-axis/pieces",
                          .parameters = {"polygon-axis-angle"},
                          .kinds = {PrimitiveKind::segment},
                          .color = {is_arc ? 0.8 : 0.1, 0.3, is_arc ? 0.1 : 0.8}},
                         [is_arc](const Inputs& inputs) {
                           const auto from = inputs.column<Point>("polygon-axis/pieces/from");
                           const auto to = inputs.column<Point>("polygon-axis/pieces/to");
                           const auto half_angle = inputs.column<double>("polygon-axis/pieces/half_angle");
                           const auto is_curved = inputs.column<bool>("polygon-axis/pieces/is_curved");
                           const double least = inputs.parameter("polygon-axis-angle");
                           return [=](Row row, Drawn& out) {
                             if (is_curved[row] == is_arc && half_angle[row] >= least)
                               out.segment(from[row], to[row]);
                           };
                         });
}
