// SPDX-License-Identifier: GPL-3.0-or-later
// Components, holes, loops and area: what does not change when a shape is bent.
#include <catch2/catch.hpp>
#include <numbers>

#include "core/structures/crust/curve.h"
#include "tests/support/shapes/shapes.h"
#include "tests/support/workbench.h"

using namespace mes;
using namespace mes::test;

namespace {

using std::numbers::pi;

struct Topology {
  TestShape shape;
  std::int64_t components;
  std::int64_t holes;
  double area;
};

// Areas by elementary geometry.
std::vector<Topology> topologies(double epsilon, const Sampling& sampling) {
  std::vector<Topology> out;
  out.push_back({ellipse_graded(2.0, 1.0, epsilon, sampling), 1, 0, 2.0 * pi});
  out.push_back({ellipse_graded(5.0, 1.0, epsilon, sampling), 1, 0, 5.0 * pi});
  out.push_back({stadium(2.0, 1.0, epsilon, sampling), 1, 0, 8.0 + pi});
  out.push_back({rounded_rectangle(3.0, 2.0, 0.5, epsilon, sampling), 1, 0, 24.0 - (4.0 - pi) * 0.25});
  out.push_back({annulus(1.0, 2.0, epsilon, sampling), 1, 1, 3.0 * pi});
  out.push_back({eccentric_hole(1.0, 3.0, 1.0, epsilon, sampling), 1, 1, 8.0 * pi});
  for (const std::size_t k : {2U, 3U, 5U}) {
    const auto holes = static_cast<std::int64_t>(k);
    out.push_back({disk_with_holes(k, 3.0, 0.5, 1.65, epsilon, sampling), 1, holes,
                   pi * (9.0 - 0.25 * static_cast<double>(k))});
  }
  out.push_back({two_ellipses(2.0, 1.0, 0.5, static_cast<std::size_t>(25.0 / epsilon), sampling), 2, 0, 4.0 * pi});
  out.push_back({island_in_hole(1.0, 0.6, 2.0, 3.0, epsilon, sampling), 2, 1, 5.6 * pi});
  return out;
}

double polygon_area(const SampleData& data) {
  double twice = 0.0;
  for (const SampleData::Contour& contour : data.contours)
    for (std::size_t i = 0; i < contour.points.size(); ++i)
      twice +=
          cross(data.positions[contour.points[i]], data.positions[contour.points[(i + 1) % contour.points.size()]]);
  return 0.5 * twice;
}

double polygon_length(const SampleData& data) {
  double sum = 0.0;
  for (const SampleData::Contour& contour : data.contours)
    for (std::size_t i = 0; i < contour.points.size(); ++i)
      sum += distance(data.positions[contour.points[i]],
                      data.positions[contour.points[(i + 1) % contour.points.size()]]);
  return sum;
}

}  // namespace

TEST_CASE("the axis has as many components and cycles as the shape has parts and holes") {
  for (const double epsilon : {0.4, 0.15}) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
      for (const Topology& topology : topologies(epsilon, {0.2, 0.2, seed})) {
        INFO(topology.shape.name << " seed " << seed);
        const ComparedBench bench(topology.shape.data.positions);
        CHECK(bench.count("medial-axis", "components") == topology.components);
        CHECK(bench.count("medial-axis", "cycles") == topology.holes);
        CHECK(bench.count("medial-axis", "chi") == topology.components - topology.holes);
      }
    }
  }
}

TEST_CASE("the curve has one loop for each boundary, and the area of the shape") {
  for (const double epsilon : {0.4, 0.15, 0.05}) {
    for (const Topology& topology : topologies(epsilon, {0.2, 0.1, 4})) {
      INFO(topology.shape.name);
      const SampleData& data = topology.shape.data;
      const ComparedBench bench(data.positions);
      CHECK(bench.count("curve", "loops") == static_cast<std::int64_t>(data.contours.size()));
      CHECK(bench.count("curve", "open_chains") == 0);
      CHECK(bench.count("curve", "isolated") == 0);
      // The samples' own polygon to rounding; the smooth shape up to the square of the spacing.
      CHECK(bench.measure("curve", "area") == Approx(polygon_area(data)).epsilon(1e-12));
      CHECK(bench.measure("curve", "length") == Approx(polygon_length(data)).epsilon(1e-12));
      CHECK(bench.measure("curve", "area") == Approx(topology.area).epsilon(epsilon * epsilon));
    }
  }
}

TEST_CASE("loops keep the inside on their left, and normals point outside") {
  for (const Topology& topology : topologies(0.3, {0.2, 0.2, 5})) {
    INFO(topology.shape.name);
    const ComparedBench bench(topology.shape.data.positions);
    const auto& delaunay = bench.get<Delaunay>();
    const auto& curve = bench.get<Curve>();
    const auto& labels = bench.get<Labels>();
    std::size_t sites = 0;
    for (const Curve::Chain& chain : curve.chains()) {
      if (chain.sites.empty()) continue;
      CHECK(chain.closed);
      CHECK(chain.has_inside);
      for (std::size_t i = 0; i < chain.sites.size(); ++i) {
        const EdgeRow& row = delaunay.edge(chain.edges[i]);
        const bool forward = row.v[0] == chain.sites[i];
        if (!labels.is_inside(row.f[forward ? 0 : 1])) FAIL("the inside is not on the left");
        if (!curve.has_normal(chain.sites[i])) FAIL("a site of a loop has no normal");
        const Vec2 normal = curve.normal(chain.sites[i]);
        if (!(std::abs(length(normal) - 1.0) < 1e-12)) FAIL("a normal is not of unit length");
        const std::size_t after = i + 1 == chain.sites.size() ? 0 : i + 1;
        const Vec2 along = delaunay.site_position(chain.sites[after]) - delaunay.site_position(chain.sites[i]);
        if (!(cross(along, normal) < 0.0)) FAIL("a normal does not point to the right of its loop");
        ++sites;
      }
    }
    CHECK(sites == topology.shape.data.positions.size());
  }
}
