// my-shape: a square with a notch.
//
//   mesecina shape my-shape --with my-shape.cpp -o my-shape.poff
//   mesecina check my-shape.cpp                     says whether it holds what shapes have to hold
//
// Change what is marked with "here".
#include <mesecina/experiment.h>

#include <vector>

using namespace mesecina;

MESECINA_EXPERIMENT(experiment) {
  experiment.add_shape(
      {.id = "my-shape",
       .name = "My shape",
       .description = "A square with a notch",
       .parameters =
           {{.id = "depth", .description = "Depth of the notch", .low = 0.1, .high = 0.9, .default_value = 0.5}}},
      [](std::span<const double> values) {
        const double depth = values[0];
        // Here: closed polygons, by their corners.
        return std::vector<std::vector<Point>>{
            {{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.6, 1.0}, {0.5, 1.0 - depth}, {0.4, 1.0}, {0.0, 1.0}}};
      });
}
