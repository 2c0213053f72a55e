// my-layer: the circumcircle of each Delaunay triangle.
//
//   mesecina shape.poff --with my-layer.cpp         shows it; saving this file shows the new version
//   mesecina check my-layer.cpp                     says whether it holds what layers have to hold
//
// `mesecina list structures` names all tables and their columns. Change what is marked with "here".
#include <mesecina/experiment.h>

using namespace mesecina;

MESECINA_EXPERIMENT(experiment) {
  experiment.add_layer({.id = "my-layer",
                        .name = "My layer",
                        .description = "Circumcircles of Delaunay triangles, coloured by their radius",
                        .rows = "delaunay/faces",
                        .kinds = {PrimitiveKind::circle},
                        .scalar = "radius",
                        .color_map = "viridis"},
                       [](const Inputs& inputs) {
                         // Here: what is read, by "structure/table/column".
                         const auto is_finite = inputs.column<bool>("delaunay/faces/is_finite");
                         const auto center = inputs.column<Point>("delaunay/faces/circumcenter");
                         const auto radius = inputs.column<double>("delaunay/faces/circumradius");
                         // Here: what is drawn for a row. One that calls nothing draws nothing.
                         return [=](Row face, Drawn& out) {
                           if (is_finite[face]) out.circle({center[face], radius[face]}, radius[face]);
                         };
                       });
}
