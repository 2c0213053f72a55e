// SPDX-License-Identifier: GPL-3.0-or-later
// The weak witness complex: the shape of many samples by few of them.
//
// Some samples are landmarks; all samples are witnesses. A witness sees an edge between its two nearest landmarks, and
// a triangle between its three nearest. The complex has the edges that are seen, and the triangles that are seen and
// whose edges are (V. de Silva, G. Carlsson, Topological estimation using witness complexes, Point-Based Graphics
// 2004). All of them are Delaunay edges and triangles of the landmarks, yet nothing but distances is compared, exactly.
// Landmarks are chosen by max-min: each is the sample that is farthest from those before it; the first is the one with
// the smallest coordinates. Of landmarks at the same distance, the one that was chosen first is nearer; of samples
// equally far away, the one with smaller coordinates is chosen. Cost: O(samples * landmarks).
//
//   mesecina shape.poff --with witness_complex.cpp
#include <mesecina/experiment.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <vector>

using namespace mesecina;

namespace {

double square_of_distance(Point a, Point b) {
  return (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y);
}
/// The order of the distances ab and cd. Their rounded squares are off by less than 1e-15 of them, so a clear
/// difference of these spares the exact predicate, which takes some 100 times as long.
int order_of_distances(double square_ab, double square_cd, Point a, Point b, Point c, Point d) {
  if (square_ab > 1e-290 && square_cd < 0.999999 * square_ab) return 1;
  if (square_cd > 1e-290 && square_ab < 0.999999 * square_cd) return -1;
  return compare_distances(a, b, c, d);
}

template <std::size_t N>
struct Simplex {
  std::array<Row, N> sites;
  std::uint32_t witnesses;
};

class WitnessComplex final : public Structure {
 public:
  void rebuild(const Inputs& inputs) override {
    const std::size_t rows = inputs.rows("delaunay/sites");
    is_landmark_.assign(rows, 0);
    distance_.assign(rows, INFINITY);
    edges_.clear();
    triangles_.clear();
    radius_ = INFINITY;
    landmarks_ = components_ = 0;
    choose_landmarks(inputs);
    find_simplices();
  }

  std::vector<OwnTable> tables() const override {
    std::vector<OwnTable> out;
    out.emplace_back("sites", "Which samples are landmarks")
        .rows_of("delaunay/sites")
        .flag("is_landmark", "The sample is a landmark", is_landmark_)
        .column("distance", "Distance from the nearest landmark", distance_);
    out.emplace_back("edges", "Edges of the complex")
        .column("sites", "Both ends", edges_, &Simplex<2>::sites)
        .refers_to("delaunay/sites")
        .column("witnesses", "Number of samples with these nearest landmarks", edges_, &Simplex<2>::witnesses);
    out.emplace_back("triangles", "Triangles of the complex")
        .column("sites", "Corners", triangles_, &Simplex<3>::sites)
        .refers_to("delaunay/sites")
        .column("witnesses", "Number of samples with these nearest landmarks", triangles_, &Simplex<3>::witnesses);
    return out;
  }
  std::vector<Statistic> statistics() const override {
    const auto edges = static_cast<std::int64_t>(edges_.size()),
               triangles = static_cast<std::int64_t>(triangles_.size());
    return {{"landmarks", landmarks_},
            {"witness_edges", edges},
            {"witness_triangles", triangles},
            {"components", components_},
            {"euler_characteristic", landmarks_ - edges + triangles},
            {"covering_radius", radius_}};
  }

 private:
  /// A sample with its nearest landmarks, at most three, the nearest first.
  struct Witness {
    Row site;
    Point at;
    std::array<std::uint32_t, 3> near{};
    std::array<double, 3> squares{};
    std::size_t count = 0;
  };

  void choose_landmarks(const Inputs& inputs) {
    const auto place = inputs.column<Point>("delaunay/sites/position");
    witnesses_.clear();
    for (const Row site : inputs.live_rows("delaunay/sites")) witnesses_.push_back({site, place[site]});
    std::ranges::sort(witnesses_, [](const Witness& a, const Witness& b) {
      return a.at.x < b.at.x || (a.at.x == b.at.x && a.at.y < b.at.y);
    });
    const double part = inputs.parameter("witness-landmarks") / 100.0;
    const auto wanted = static_cast<std::size_t>(std::ceil(part * static_cast<double>(witnesses_.size())));
    chosen_.clear();
    std::size_t farthest = 0;
    while (chosen_.size() < std::min(wanted, witnesses_.size())) {
      inputs.checkpoint(chosen_.size(), wanted);
      const auto rank = static_cast<std::uint32_t>(chosen_.size());
      chosen_.push_back(farthest);
      const Point landmark = witnesses_[farthest].at;
      farthest = 0;
      for (std::size_t i = 0; i < witnesses_.size(); ++i) {
        Witness& witness = witnesses_[i];
        const double square = square_of_distance(witness.at, landmark);
        std::size_t at = witness.count;
        while (at > 0 && order_of_distances(square, witness.squares[at - 1], witness.at, landmark, witness.at,
                                            landmark_of(witness, at - 1)) < 0)
          --at;
        witness.count = std::min<std::size_t>(witness.count + 1, 3);
        for (std::size_t k = witness.count; k-- > at;) {
          witness.near[k] = k == at ? rank : witness.near[k - 1];
          witness.squares[k] = k == at ? square : witness.squares[k - 1];
        }
        const Witness& best = witnesses_[farthest];
        if (i != farthest && order_of_distances(witness.squares[0], best.squares[0], witness.at,
                                                landmark_of(witness, 0), best.at, landmark_of(best, 0)) > 0)
          farthest = i;
      }
    }
    landmarks_ = static_cast<std::int64_t>(chosen_.size());
    for (const std::size_t landmark : chosen_) is_landmark_[witnesses_[landmark].site] = 1;
    if (chosen_.empty()) return;
    for (const Witness& witness : witnesses_) {
      const Point nearest = landmark_of(witness, 0);
      distance_[witness.site] = std::hypot(witness.at.x - nearest.x, witness.at.y - nearest.y);
    }
    radius_ = distance_[witnesses_[farthest].site];
  }

  Point landmark_of(const Witness& witness, std::size_t k) const { return witnesses_[chosen_[witness.near[k]]].at; }

  template <std::size_t N>
  std::map<std::array<std::uint32_t, N>, std::uint32_t> seen() const {
    std::map<std::array<std::uint32_t, N>, std::uint32_t> out;
    for (const Witness& witness : witnesses_) {
      if (witness.count < N) continue;
      std::array<std::uint32_t, N> ranks;
      std::copy_n(witness.near.begin(), N, ranks.begin());
      std::ranges::sort(ranks);
      ++out[ranks];
    }
    return out;
  }

  void find_simplices() {
    const auto site = [this](std::uint32_t rank) { return witnesses_[chosen_[rank]].site; };
    std::vector<std::uint32_t> parent(chosen_.size());
    std::iota(parent.begin(), parent.end(), 0U);
    const auto root = [&parent](std::uint32_t rank) {
      while (parent[rank] != rank) rank = parent[rank] = parent[parent[rank]];
      return rank;
    };
    components_ = landmarks_;
    const auto pairs = seen<2>();
    for (const auto& [ends, count] : pairs) {
      edges_.push_back({{site(ends[0]), site(ends[1])}, count});
      const std::uint32_t a = root(ends[0]), b = root(ends[1]);
      if (a != b) --components_;
      parent[a] = b;
    }
    for (const auto& [c, count] : seen<3>())
      if (pairs.contains({c[0], c[1]}) && pairs.contains({c[0], c[2]}) && pairs.contains({c[1], c[2]}))
        triangles_.push_back({{site(c[0]), site(c[1]), site(c[2])}, count});
  }

  std::vector<Witness> witnesses_;
  std::vector<std::size_t> chosen_;  // witnesses that are landmarks, in the order of their choice
  std::vector<std::uint8_t> is_landmark_;
  std::vector<double> distance_;
  std::vector<Simplex<2>> edges_;
  std::vector<Simplex<3>> triangles_;
  std::int64_t landmarks_ = 0, components_ = 0;
  double radius_ = INFINITY;
};

}  // namespace

MESECINA_EXPERIMENT(experiment) {
  experiment.add_parameter({.id = "witness-landmarks",
                            .description = "Part of the samples that are landmarks",
                            .unit = "%",
                            .low = 0.0,
                            .high = 100.0,
                            .default_value = 10.0});
  experiment.add_structure<WitnessComplex>(
      {.id = "witness-complex", .inputs = {"delaunay"}, .parameters = {"witness-landmarks"}});
  experiment.add_layer({.id = "witness-triangles",
                        .name = "Witness triangles",
                        .description = "Triangles of the weak witness complex",
                        .rows = "witness-complex/triangles",
                        .structures = {"delaunay"},
                        .kinds = {PrimitiveKind::triangle},
                        .color = {0.95, 0.75, 0.35},
                        .opacity = 0.6},
                       [](const Inputs& inputs) {
                         const auto sites = inputs.column<std::array<Row, 3>>("witness-complex/triangles/sites");
                         const auto place = inputs.column<Point>("delaunay/sites/position");
                         return [=](Row row, Drawn& out) {
                           const auto [a, b, c] = sites[row];
                           out.triangle(place[a], place[b], place[c]);
                         };
                       });
  experiment.add_layer({.id = "witness-edges",
                        .name = "Witness edges",
                        .description = "Edges of the weak witness complex",
                        .rows = "witness-complex/edges",
                        .structures = {"delaunay"},
                        .kinds = {PrimitiveKind::segment},
                        .color = {0.75, 0.35, 0.05},
                        .line_width = 2.0},
                       [](const Inputs& inputs) {
                         const auto sites = inputs.column<std::array<Row, 2>>("witness-complex/edges/sites");
                         const auto place = inputs.column<Point>("delaunay/sites/position");
                         return [=](Row row, Drawn& out) { out.segment(place[sites[row][0]], place[sites[row][1]]); };
                       });
  experiment.add_layer({.id = "witness-landmarks",
                        .name = "Landmarks",
                        .description = "Samples that are landmarks of the witness complex",
                        .rows = "witness-complex/sites",
                        .follows = {"delaunay/sites"},
                        .kinds = {PrimitiveKind::point},
                        .color = {0.6, 0.1, 0.1},
                        .point_size = 8.0},
                       [](const Inputs& inputs) {
                         const auto is_landmark = inputs.column<bool>("witness-complex/sites/is_landmark");
                         const auto place = inputs.column<Point>("delaunay/sites/position");
                         return [=](Row row, Drawn& out) {
                           if (is_landmark[row]) out.point(place[row]);
                         };
                       });
}
