// my-evolution: each sample goes towards the middle of its neighbours on the curve.
//
//   mesecina shape.poff --with my-evolution.cpp     shows it; saving this file shows the new version
//   mesecina check my-evolution.cpp                 says whether it holds what evolutions have to hold
//
// Change what is marked with "here".
#include <mesecina/experiment.h>

#include <vector>

using namespace mesecina;

MESECINA_EXPERIMENT(experiment) {
  experiment.add_evolution({.id = "my-evolution",
                            .name = "My evolution",
                            .description = "Moves samples towards the middle of their neighbours",
                            .parameters = {{.id = "my-evolution-way",
                                            .description = "How far a sample goes towards the middle",
                                            .low = 0.0,
                                            .high = 1.0,
                                            .default_value = 0.5}}},
                           [](const MovingSamples& samples, std::span<const double> values) {
                             const double way = values[0];
                             std::vector<Point> next(samples.positions.begin(), samples.positions.end());
                             for (const Contour& curve : samples.curves) {
                               const std::size_t count = curve.points.size();
                               for (std::size_t i = 0; i < count; ++i) {
                                 if (!samples.may_move[curve.points[i]])
                                   continue;  // ends of open curves and crossings stay
                                 const Point before = samples.positions[curve.points[(i + count - 1) % count]];
                                 const Point at = samples.positions[curve.points[i]];
                                 const Point after = samples.positions[curve.points[(i + 1) % count]];
                                 // Here: where a sample goes.
                                 next[curve.points[i]] = {(1.0 - way) * at.x + way * 0.5 * (before.x + after.x),
                                                          (1.0 - way) * at.y + way * 0.5 * (before.y + after.y)};
                               }
                             }
                             return next;
                           });
}
