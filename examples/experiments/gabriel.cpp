// SPDX-License-Identifier: GPL-3.0-or-later
// The Gabriel graph: Delaunay edges whose diametral circle has no sample inside.
//
// Source: K. R. Gabriel, R. R. Sokal, A new statistical approach to geographic variation analysis, Systematic Zoology
// 18 (1969). An edge is in the graph exactly if neither of the two corners opposite to it lies inside the circle (D. W.
// Matula, R. R. Sokal, 1980), so each edge looks at its own two triangles.
//
//   mesecina shape.poff --with gabriel.cpp
#include <mesecina/experiment.h>

#include <array>
#include <vector>

using namespace mesecina;

namespace {

class Gabriel final : public Structure {
 public:
  void rebuild(const Inputs& inputs) override {
    const View view(inputs);
    is_gabriel_.assign(inputs.rows("delaunay/edges"), 0);
    count_ = 0;
    for (const Row edge : inputs.live_rows("delaunay/edges")) set(edge, view.is_gabriel(edge));
    touched_.clear();
    removed_.clear();
  }

  // An edge that is not named has the same corners as before, so the answer is the same, too.
  bool update(const Inputs& inputs) override {
    const View view(inputs);
    is_gabriel_.resize(inputs.rows("delaunay/edges"), 0);
    const RowChanges changes = inputs.changes("delaunay/edges");
    touched_.assign(changes.touched.begin(), changes.touched.end());
    removed_.assign(changes.removed.begin(), changes.removed.end());
    for (const Row edge : removed_) set(edge, false);
    for (const Row edge : touched_) set(edge, view.is_gabriel(edge));
    return true;
  }

  std::vector<OwnTable> tables() const override {
    std::vector<OwnTable> out;
    out.emplace_back("edges", "Which edges are in the Gabriel graph")
        .rows_of("delaunay/edges")
        .changes(touched_, removed_)
        .flag("is_gabriel", "No sample lies inside the diametral circle", is_gabriel_);
    return out;
  }

  std::vector<Statistic> statistics() const override { return {{"gabriel_edges", count_}}; }

 private:
  struct View {
    explicit View(const Inputs& inputs)
        : ends(inputs.column<std::array<Row, 2>>("delaunay/edges/sites")),
          beside(inputs.column<std::array<Row, 2>>("delaunay/edges/faces")),
          corners(inputs.column<std::array<Row, 3>>("delaunay/faces/sites")),
          is_finite(inputs.column<bool>("delaunay/faces/is_finite")),
          place(inputs.column<Point>("delaunay/sites/position")) {}

    bool is_gabriel(Row edge) const {
      const auto [a, b] = ends[edge];
      for (const Row face : beside[edge]) {
        if (face == kNoRow || !is_finite[face]) continue;
        for (const Row corner : corners[face])
          if (corner != a && corner != b && side_of_diametral_circle(place[a], place[b], place[corner]) > 0)
            return false;
      }
      return true;
    }

    InputColumn<std::array<Row, 2>> ends, beside;
    InputColumn<std::array<Row, 3>> corners;
    InputColumn<bool> is_finite;
    InputColumn<Point> place;
  };

  void set(Row edge, bool is_gabriel) {
    count_ += static_cast<int>(is_gabriel) - is_gabriel_[edge];
    is_gabriel_[edge] = is_gabriel ? 1 : 0;
  }

  std::vector<std::uint8_t> is_gabriel_;
  std::vector<Row> touched_, removed_;
  std::int64_t count_ = 0;
};

}  // namespace

MESECINA_EXPERIMENT(experiment) {
  experiment.add_structure<Gabriel>({.id = "gabriel", .inputs = {"delaunay"}});
  experiment.add_layer({.id = "gabriel",
                        .name = "Gabriel graph",
                        .description = "Delaunay edges whose diametral circle has no sample inside",
                        .rows = "gabriel/edges",
                        .follows = {"delaunay/edges"},
                        .kinds = {PrimitiveKind::segment}},
                       [](const Inputs& inputs) {
                         const auto is_gabriel = inputs.column<bool>("gabriel/edges/is_gabriel");
                         const auto ends = inputs.column<std::array<Row, 2>>("delaunay/edges/sites");
                         const auto place = inputs.column<Point>("delaunay/sites/position");
                         return [=](Row edge, Drawn& out) {
                           if (is_gabriel[edge]) out.segment(place[ends[edge][0]], place[ends[edge][1]]);
                         };
                       });
}
