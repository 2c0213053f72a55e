// my-structure: Delaunay edges and their lengths.
//
//   mesecina shape.poff --with my-structure.cpp     shows it; saving this file shows the new version
//   mesecina check my-structure.cpp                 says whether it holds what structures have to hold
//
// `mesecina list structures` names all tables and their columns. Change what is marked with "here".
#include <mesecina/experiment.h>

#include <array>
#include <cmath>
#include <vector>

using namespace mesecina;

namespace {

class MyStructure final : public Structure {
 public:
  void rebuild(const Inputs& inputs) override {
    // Here: what is read, by "structure/table/column".
    const auto ends = inputs.column<std::array<Row, 2>>("delaunay/edges/sites");
    const auto place = inputs.column<Point>("delaunay/sites/position");
    const double factor = inputs.parameter("my-structure-factor");
    length_.assign(inputs.rows("delaunay/edges"), 0.0);
    for (const Row edge : inputs.live_rows("delaunay/edges")) {
      const Point a = place[ends[edge][0]], b = place[ends[edge][1]];
      length_[edge] = factor * std::hypot(b.x - a.x, b.y - a.y);  // Here: what is computed for a row.
    }
  }

  // Here: the columns that others may read.
  std::vector<OwnTable> tables() const override {
    std::vector<OwnTable> out;
    out.emplace_back("edges", "Lengths of Delaunay edges")
        .rows_of("delaunay/edges")
        .column("length", "Length, multiplied by the factor", length_);
    return out;
  }

 private:
  std::vector<double> length_;
};

}  // namespace

MESECINA_EXPERIMENT(experiment) {
  experiment.add_parameter({.id = "my-structure-factor",
                            .description = "Lengths are multiplied by it",
                            .low = 0.0,
                            .high = 10.0,
                            .default_value = 1.0});
  experiment.add_structure<MyStructure>(
      {.id = "my-structure", .inputs = {"delaunay"}, .parameters = {"my-structure-factor"}});
  experiment.add_layer({.id = "my-structure",
                        .name = "My structure",
                        .description = "Delaunay edges, coloured by their length",
                        .rows = "my-structure/edges",
                        .structures = {"delaunay"},
                        .kinds = {PrimitiveKind::segment},
                        .scalar = "length",
                        .color_map = "viridis"},
                       [](const Inputs& inputs) {
                         const auto ends = inputs.column<std::array<Row, 2>>("delaunay/edges/sites");
                         const auto place = inputs.column<Point>("delaunay/sites/position");
                         const auto length = inputs.column<double>("my-structure/edges/length");
                         // Here: what is drawn for a row.
                         return [=](Row edge, Drawn& out) {
                           out.segment(place[ends[edge][0]], place[ends[edge][1]], length[edge]);
                         };
                       });
}
