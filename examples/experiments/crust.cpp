// SPDX-License-Identifier: GPL-3.0-or-later
// The Crust, and the edges in which it differs from the one-step crust of the program.
//
// Source: N. Amenta, M. Bern, D. Eppstein, The crust and the beta-skeleton: combinatorial curve reconstruction,
// Graphical Models and Image Processing 60 (1998). The Voronoi vertices of the samples are added to the samples, and
// all are triangulated. The Crust has the Delaunay edges between two samples that are edges there, too: some circle
// through the ends has neither a sample nor a Voronoi vertex inside. Where more than three points lie on one circle,
// all edges between them count, as in the one-step crust. That tests only the two Voronoi vertices at an edge, so it
// has all edges of the Crust.
//
// The second triangulation is exact for the Voronoi vertices as rounded to doubles, which can break a tie. Vertices
// that lie too far away for a document, whose numbers are at most 2^100 apart, are left out.
//
//   mesecina shape.poff --with crust.cpp
#include <mesecina/experiment.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

using namespace mesecina;

namespace {

using Pair = std::array<Row, 2>;
using Triple = std::array<Row, 3>;

/// The tables of the program's triangulation.
struct First {
  const Inputs& inputs;
  Table sites = inputs.table("delaunay/sites"), faces = inputs.table("delaunay/faces");
  Table edges = inputs.table("delaunay/edges");
  InputColumn<Pair> ends = inputs.column<Pair>("delaunay/edges/sites");
  InputColumn<Point> place = inputs.column<Point>("delaunay/sites/position");
  InputColumn<Row> face_at = inputs.column<Row>("delaunay/sites/face");
  InputColumn<Triple> corners = inputs.column<Triple>("delaunay/faces/sites");
  InputColumn<Triple> neighbours = inputs.column<Triple>("delaunay/faces/faces");
  InputColumn<Triple> sides = inputs.column<Triple>("delaunay/faces/edges");
  InputColumn<bool> is_finite = inputs.column<bool>("delaunay/faces/is_finite");
  InputColumn<Point> center = inputs.column<Point>("delaunay/faces/circumcenter");

  /// Exponents of the numbers in the second triangulation. Smaller numbers become 0 there; larger ones do not occur.
  std::pair<int, int> window() const {
    double smallest = 0x1p499, largest = 0.0;
    for (const Row site : sites.live_rows())
      for (const double x : {std::abs(place[site].x), std::abs(place[site].y)}) {
        if (x != 0.0) smallest = std::min(smallest, x);
        largest = std::max(largest, x);
      }
    int low = std::ilogb(smallest), high = std::ilogb(std::max(largest, smallest)) + 1;
    if (high - low < 64) low &= ~15, high = (high + 15) & ~15;  // Steps of 16: it rarely changes.
    const int slack = std::max(0, 100 - (high - low)) / 2;
    return {std::max(low - slack, -500), std::min(high + slack, 500)};
  }
  void add_edges_at(Row site, std::vector<Row>& out) const {
    Row face = face_at[site];
    do {
      const std::size_t next = corners[face][0] == site ? 1 : corners[face][1] == site ? 2 : 0;
      if (sides[face][next] != kNoRow) out.push_back(sides[face][next]);
      face = neighbours[face][next];
    } while (face != face_at[site]);
  }
};

/// The triangulation of samples and Voronoi vertices.
struct Second {
  const Workbench& bench;
  Table samples = bench.table("samples/samples"), faces = bench.table("delaunay/faces");
  Column id = samples.column("id");
  Column site = bench.table("delaunay/samples").column("site");
  Column next_duplicate = bench.table("delaunay/samples").column("next_duplicate");
  Column sample = bench.table("delaunay/sites").column("sample");
  Column place = bench.table("delaunay/sites").column("position");
  Column face_at = bench.table("delaunay/sites").column("face");
  Column corners = faces.column("sites");
  Column neighbours = faces.column("faces");
  Column is_finite = faces.column("is_finite");

  /// The circles of the faces around a are empty, so the edge is Delaunay exactly if b lies on one of them. The same
  /// holds for b and a. The walk around both at a time ends after the smaller number of faces.
  bool is_edge(const Pair& ends) const {
    const Pair first{face_at.value<Row>(ends[0]), face_at.value<Row>(ends[1])};
    if (first[0] == kNoRow) return true;  // All sites lie on a line.
    const auto at = [this](Row site) { return place.value<Point>(site); };
    for (Pair face = first;;)
      for (const std::size_t end : {0, 1}) {
        const auto [i, j, k] = corners.value<Triple>(face[end]);
        if (is_finite.value<bool>(face[end]) && side_of_circle(at(i), at(j), at(k), at(ends[1 - end])) == 0)
          return true;
        face[end] = neighbours.value<Triple>(face[end])[i == ends[end] ? 1 : j == ends[end] ? 2 : 0];
        if (face[end] == first[end]) return false;
      }
  }
};

class Crust final : public Structure {
 public:
  void rebuild(const Inputs& inputs) override {
    const First first{inputs};
    bench_.emplace(Catalogue::builtin(), WorkbenchOptions{.keeps_history = false, .keeps_instances = false});
    bench_->need({"delaunay"});
    window_ = first.window();
    sample_of_site_.clear(), sample_of_face_.clear(), is_crust_.clear(), touched_.clear();
    row_of_sample_.clear(), site_of_sample_.clear();
    change_points(first, first.sites.live_rows(), first.faces.live_rows());
    const Second second{*bench_};
    find_rows(second, second.samples.live_rows());
    decide(first, second, first.edges.live_rows());
  }

  // An edge depends on its ends and on the faces around them in the second triangulation.
  bool update(const Inputs& inputs) override {
    const First first{inputs};
    if (first.window() != window_) return false;
    const auto changed = [&inputs](std::string_view table) {
      const RowChanges changes = inputs.changes(table);
      std::vector<Row> rows(changes.touched.begin(), changes.touched.end());
      rows.insert(rows.end(), changes.removed.begin(), changes.removed.end());
      return distinct(std::move(rows));
    };
    change_points(first, changed("delaunay/sites"), changed("delaunay/faces"));
    const Second second{*bench_};
    const auto samples = second.samples.changes(), faces = second.faces.changes();
    if (!samples || !faces) return false;
    find_rows(second, samples->touched);
    touched_ = changed("delaunay/edges");
    std::vector<Row> sites;
    for (const Row face : faces->touched)
      if (second.faces.is_alive(face) && second.is_finite.value<bool>(face))
        for (const Row site : second.corners.value<Triple>(face)) sites.push_back(site);
    for (const Row site : distinct(std::move(sites)))
      for (Row at = second.sample.value<Row>(site); at != kNoRow; at = second.next_duplicate.value<Row>(at))
        if (const auto found = site_of_sample_.find(second.id.value<Row>(at)); found != site_of_sample_.end())
          first.add_edges_at(found->second, touched_);
    decide(first, second, touched_ = distinct(std::move(touched_)));
    return true;
  }

  std::vector<OwnTable> tables() const override {
    std::vector<OwnTable> out;
    out.emplace_back("edges", "Which edges are in the Crust")
        .rows_of("delaunay/edges")
        .changes(touched_, none_)
        .flag("is_crust", "Some circle through the ends has no sample and no Voronoi vertex inside", is_crust_);
    return out;
  }
  std::vector<Statistic> statistics() const override {
    const auto is_added = [](SampleId id) { return id != SampleId{}; };
    return {{"crust_edges", std::int64_t{std::ranges::count(is_crust_, 1)}},
            {"added_vertices", std::int64_t{std::ranges::count_if(sample_of_face_, is_added)}}};
  }

 private:
  static std::vector<Row> distinct(std::vector<Row> rows) {
    std::ranges::sort(rows);
    rows.erase(std::ranges::unique(rows).begin(), rows.end());
    return rows;
  }
  void find_rows(const Second& second, std::span<const Row> rows) {
    for (const Row row : rows)
      if (second.samples.is_alive(row)) row_of_sample_[second.id.value<Row>(row)] = row;
  }

  /// Replaces the points of sites and faces in the second triangulation, and computes it.
  void change_points(const First& first, const std::vector<Row>& sites, const std::vector<Row>& faces) {
    sample_of_site_.resize(first.sites.rows());
    sample_of_face_.resize(first.faces.rows());
    std::vector<SampleId> gone;
    std::vector<Point> points;
    std::vector<SampleId*> fresh;
    const auto replace = [&](SampleId& id, bool is_alive, Point p) {
      row_of_sample_.erase(id.value), site_of_sample_.erase(id.value);
      if (id != SampleId{}) gone.push_back(std::exchange(id, SampleId{}));
      if (is_alive) points.push_back(p), fresh.push_back(&id);
    };
    for (const Row site : sites) replace(sample_of_site_[site], first.sites.is_alive(site), first.place[site]);
    const double low = std::ldexp(1.0, window_.first), high = std::ldexp(1.0, window_.second);
    for (const Row face : faces) {
      const bool is_finite = first.faces.is_alive(face) && first.is_finite[face];
      const auto [x, y] = is_finite ? first.center[face] : Point{};
      replace(sample_of_face_[face], is_finite && std::abs(x) < high && std::abs(y) < high,
              {std::abs(x) < low ? 0.0 : x, std::abs(y) < low ? 0.0 : y});
    }
    bench_->remove(gone);
    const std::vector<SampleId> ids = bench_->insert(points);
    for (std::size_t i = 0; i < ids.size(); ++i) *fresh[i] = ids[i];
    for (const Row site : sites)
      if (first.sites.is_alive(site)) site_of_sample_[sample_of_site_[site].value] = site;
    bench_->run();
  }

  void decide(const First& first, const Second& second, const std::vector<Row>& edges) {
    is_crust_.resize(first.edges.rows(), 0);
    const auto of = [&](Row site) { return second.site.value<Row>(row_of_sample_.at(sample_of_site_[site].value)); };
    for (const Row edge : edges) {
      if (edge % 1024 == 0) first.inputs.checkpoint();
      const auto [a, b] = first.ends[edge];
      is_crust_[edge] = first.edges.is_alive(edge) && second.is_edge({of(a), of(b)}) ? 1 : 0;
    }
  }

  std::optional<Workbench> bench_;
  std::pair<int, int> window_;
  std::vector<SampleId> sample_of_site_, sample_of_face_;                  // none: not in the bench
  std::unordered_map<std::uint32_t, Row> row_of_sample_, site_of_sample_;  // by the number of the sample's id
  std::vector<std::uint8_t> is_crust_;
  std::vector<Row> touched_, none_;  // removed edges are among the touched ones
};

}  // namespace

MESECINA_EXPERIMENT(experiment) {
  experiment.add_structure<Crust>({.id = "crust", .inputs = {"delaunay"}});
  const auto draw = [](bool is_difference) {
    return [is_difference](const Inputs& inputs) {
      const auto is_crust = inputs.column<bool>("crust/edges/is_crust");
      const auto ends = inputs.column<Pair>("delaunay/edges/sites");
      const auto place = inputs.column<Point>("delaunay/sites/position");
      InputColumn<bool> is_other;
      if (is_difference) is_other = inputs.column<bool>("one-step-crust/edges/is_crust");
      return [=](Row edge, Drawn& out) {
        if (is_crust[edge] == (is_difference && is_other[edge])) return;
        out.segment(place[ends[edge][0]], place[ends[edge][1]], !is_difference ? 0.0 : is_crust[edge] ? 1.0 : -1.0);
      };
    };
  };
  experiment.add_layer({.id = "crust",
                        .name = "Crust",
                        .description = "Delaunay edges with a circle that has no sample and no Voronoi vertex inside",
                        .rows = "crust/edges",
                        .follows = {"delaunay/edges"},
                        .kinds = {PrimitiveKind::segment},
                        .color = {0.1, 0.45, 0.75}},
                       draw(false));
  experiment.add_layer({.id = "crust-difference",
                        .name = "Crust, difference",
                        .description = "Edges in which the Crust and the one-step crust differ",
                        .rows = "crust/edges",
                        .follows = {"delaunay/edges", "one-step-crust/edges"},
                        .kinds = {PrimitiveKind::segment},
                        .scalar = "1: only in the Crust, -1: only in the one-step crust",
                        .color = {0.85, 0.1, 0.1},
                        .line_width = 3.0},
                       draw(true));
}
