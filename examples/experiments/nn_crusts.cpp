// SPDX-License-Identifier: GPL-3.0-or-later
// The NN-crust and the HNN-crust, and the edges in which they differ from the one-step crust of the program.
//
// Sources: T. K. Dey, P. Kumar, A simple provable algorithm for curve reconstruction, SODA 1999; S. Ohrhallinger, S. A.
// Mitchell, M. Wimmer, Curve reconstruction with many fewer samples, Computer Graphics Forum 35 (2016). In both, each
// sample p chooses the edge to its nearest sample q, and the edge to its half neighbour s, which is the nearest sample
// on the other side. The NN-crust takes the side where the angle qps is at least 90 degrees. The HNN-crust takes the
// side where s is nearer to p than to q, which allows angles down to 60 degrees, so it needs fewer samples at sharp
// bends.
//
// Both look for s among the Delaunay edges at p. Of samples at equal distance p takes the smaller one, first by x and
// then by y. All decisions are exact. The crust has the edges that one end or both chose; `votes` tells them apart.
//
//   mesecina shape.poff --with nn_crusts.cpp
#include <mesecina/experiment.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

using namespace mesecina;

namespace {

using Pair = std::array<Row, 2>;
using Triple = std::array<Row, 3>;

/// `kNearerThanNearest` tells the HNN-crust from the NN-crust.
template <bool kNearerThanNearest>
class Choices final : public Structure {
 public:
  void rebuild(const Inputs& inputs) override {
    const View view{inputs};
    const std::vector<Row> edges = inputs.live_rows("delaunay/edges");
    choice_.assign(inputs.rows("delaunay/sites"), kNone);
    ends_.assign(inputs.rows("delaunay/edges"), kNone);
    votes_.assign(ends_.size(), 0);
    for (const Row edge : edges)
      for (const Row site : ends_[edge] = view.ends[edge]) view.offer_nearest(choice_[site], site, edge);
    for (const Row edge : edges)
      for (const Row site : ends_[edge]) view.offer_half(choice_[site], site, edge);
    for (const Pair& choice : choice_) vote(choice, 1);
    touched_.clear(), removed_.clear();
  }

  // A site chooses again if an edge there is new, gone or moved.
  bool update(const Inputs& inputs) override {
    const View view{inputs};
    const Table edges = inputs.table("delaunay/edges"), sites = inputs.table("delaunay/sites");
    const RowChanges changes = inputs.changes("delaunay/edges");
    removed_.assign(changes.removed.begin(), changes.removed.end());
    touched_.assign(changes.touched.begin(), changes.touched.end());
    choice_.resize(sites.rows(), kNone);
    ends_.resize(edges.rows(), kNone);
    votes_.resize(edges.rows(), 0);
    std::vector<Row> dirty;
    for (const auto* rows : {&touched_, &removed_})
      for (const Row edge : *rows)
        for (const Pair& ends : {ends_[edge], edges.is_alive(edge) ? view.ends[edge] : kNone}) {
          dirty.insert(dirty.end(), ends.begin(), ends.end());
          ends_[edge] = ends;
        }
    std::erase(dirty, kNoRow);
    std::ranges::sort(dirty);
    dirty.erase(std::ranges::unique(dirty).begin(), dirty.end());
    for (const Row site : dirty) {
      vote(choice_[site], -1);
      choice_[site] = kNone;
    }
    for (const Row site : dirty) {
      if (!sites.is_alive(site)) continue;
      if (view.face_at[site] == kNoRow) return false;  // All sites lie on a line, so no face leads around this one.
      view.for_each_edge(site, [&](Row edge) { view.offer_nearest(choice_[site], site, edge); });
      view.for_each_edge(site, [&](Row edge) { view.offer_half(choice_[site], site, edge); });
      vote(choice_[site], 1);
    }
    return true;
  }

  std::vector<OwnTable> tables() const override {
    std::vector<OwnTable> out;
    out.emplace_back("edges", "Which edges are in the crust")
        .rows_of("delaunay/edges")
        .changes(touched_, removed_)
        .column("votes", "How many ends chose the edge; 0: it is not in the crust", votes_);
    return out;
  }
  std::vector<Statistic> statistics() const override {
    const std::int64_t twice = std::ranges::count(votes_, 2), once = std::ranges::count(votes_, 1);
    return {{"edges", once + twice}, {"mutual_edges", twice}};
  }

 private:
  static constexpr Pair kNone{kNoRow, kNoRow};

  struct View {
    const Inputs& inputs;
    InputColumn<Pair> ends = inputs.column<Pair>("delaunay/edges/sites");
    InputColumn<Triple> corners = inputs.column<Triple>("delaunay/faces/sites");
    InputColumn<Triple> neighbours = inputs.column<Triple>("delaunay/faces/faces");
    InputColumn<Triple> sides = inputs.column<Triple>("delaunay/faces/edges");
    InputColumn<Point> place = inputs.column<Point>("delaunay/sites/position");
    InputColumn<Row> face_at = inputs.column<Row>("delaunay/sites/face");

    Point far_end(Row site, Row edge) const { return place[ends[edge][0] == site ? ends[edge][1] : ends[edge][0]]; }
    bool is_shorter(Row site, Row edge, Row than) const {
      if (than == kNoRow) return true;
      const Point p = place[site], a = far_end(site, edge), b = far_end(site, than);
      const int order = compare_distances(p, a, p, b);
      return order != 0 ? order < 0 : a.x != b.x ? a.x < b.x : a.y < b.y;
    }
    void offer_nearest(Pair& choice, Row site, Row edge) const {
      if (is_shorter(site, edge, choice[0])) choice[0] = edge;
    }
    void offer_half(Pair& choice, Row site, Row edge) const {
      const Point p = place[site], q = far_end(site, choice[0]), s = far_end(site, edge);
      if (s == q) return;
      // The angle at p is at least 90 degrees if p lies in or on the circle with the diameter qs.
      const bool is_far_side =
          kNearerThanNearest ? compare_distances(s, p, s, q) < 0 : side_of_diametral_circle(q, s, p) >= 0;
      if (is_far_side && is_shorter(site, edge, choice[1])) choice[1] = edge;
    }
    template <class Visit>
    void for_each_edge(Row site, Visit visit) const {
      Row face = face_at[site];
      do {
        const Triple at = corners[face];
        const std::size_t next = at[0] == site ? 1 : at[1] == site ? 2 : 0;
        if (sides[face][next] != kNoRow) visit(sides[face][next]);
        face = neighbours[face][next];
      } while (face != face_at[site]);
    }
  };

  void vote(const Pair& choice, int change) {
    for (const Row edge : choice) {
      if (edge == kNoRow) continue;
      votes_[edge] = static_cast<std::uint8_t>(votes_[edge] + change);
      touched_.push_back(edge);
    }
  }

  std::vector<Pair> choice_;         // by site: edges
  std::vector<Pair> ends_;           // by edge: sites as of the last computation
  std::vector<std::uint8_t> votes_;  // by edge
  std::vector<Row> touched_, removed_;
};

template <bool kNearerThanNearest>
void add_crust(Experiment& experiment, const std::string& id, const std::string& name, const std::string& side) {
  experiment.add_structure<Choices<kNearerThanNearest>>({.id = id, .inputs = {"delaunay"}});
  LayerSpec spec{.id = id,
                 .name = name,
                 .description = "Edges to the nearest sample, and to the nearest one " + side,
                 .rows = id + "/edges",
                 .follows = {"delaunay/edges"},
                 .kinds = {PrimitiveKind::segment},
                 .color = {0.1, 0.45, 0.75}};
  experiment.add_layer(spec, [id](const Inputs& inputs) {
    const auto votes = inputs.column<std::uint8_t>(id + "/edges/votes");
    const auto ends = inputs.column<Pair>("delaunay/edges/sites");
    const auto place = inputs.column<Point>("delaunay/sites/position");
    return [=](Row edge, Drawn& out) {
      if (votes[edge] != 0) out.segment(place[ends[edge][0]], place[ends[edge][1]]);
    };
  });
  spec.id += "-difference";
  spec.name += ", difference";
  spec.description = "Edges in which the " + name + " and the one-step crust differ";
  spec.follows.push_back("one-step-crust/edges");
  spec.scalar = "1: only in the " + name + ", -1: only in the one-step crust";
  spec.color = {0.85, 0.1, 0.1};
  spec.line_width = 3.0;
  experiment.add_layer(spec, [id](const Inputs& inputs) {
    const auto votes = inputs.column<std::uint8_t>(id + "/edges/votes");
    const auto is_one_step = inputs.column<bool>("one-step-crust/edges/is_crust");
    const auto ends = inputs.column<Pair>("delaunay/edges/sites");
    const auto place = inputs.column<Point>("delaunay/sites/position");
    return [=](Row edge, Drawn& out) {
      const bool is_crust = votes[edge] != 0;
      if (is_crust != is_one_step[edge])
        out.segment(place[ends[edge][0]], place[ends[edge][1]], is_crust ? 1.0 : -1.0);
    };
  });
}

}  // namespace

MESECINA_EXPERIMENT(experiment) {
  add_crust<false>(experiment, "nn-crust", "NN-crust", "at an angle of at least 90 degrees");
  add_crust<true>(experiment, "hnn-crust", "HNN-crust", "that is nearer to the sample than to its nearest one");
}
