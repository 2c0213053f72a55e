// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/layers/layer_topics.h"

#include <algorithm>
#include <array>

#include "app/layers/ball_families.h"

namespace mes {
namespace {

constexpr auto kTopics = std::to_array<LayerTopic>({
    {"Experiments", "", false, LayerGroup::experiments},
    {"Delaunay & Voronoi", "delaunay voronoi voronoi-circles voronoi-disks a-regular-triangulation a-power-diagram",
     false, LayerGroup::delaunay_voronoi},
    {"Curve", "curve voronoi-crust curve-normals feature-size sampling-epsilon"},
    {"Medial axis",
     "medial-axis center-lines transects outline-axis interior-voronoi-disks interior-voronoi-circles "
     "interior-voronoi-vertices "
     "all-medial-axis "
     "exterior-voronoi-disks exterior-voronoi-circles exterior-voronoi-vertices",
     false, LayerGroup::crust_axis},
    {"Filtered axes",
     "lambda-medial-axis removed-by-lambda lambda-kept-boundary lambda-medial-disks lambda-medial-circles "
     "angle-medial-axis removed-by-angle angle-kept-boundary angle-medial-disks angle-medial-circles "
     "cover-medial-axis removed-by-cover cover-kept-boundary cover-medial-disks cover-medial-circles"},
    {"Scale axis",
     "scale-axis scale-axis-boundary scale-axis-disks scale-axis-circles scale-axis-grown-disks cover-dates", false,
     LayerGroup::scale_axis},
    {"Poles & power crust",
     "power-crust interior-polar-disks interior-polar-circles interior-polar-vertices exterior-polar-disks "
     "exterior-polar-circles exterior-polar-vertices polar-disks polar-circles polar-triangulation "
     "polar-power-diagram anti-crust-edges",
     false, LayerGroup::poles},
    {"Alpha complex", "alpha-disks alpha-edges alpha-triangles alpha-boundary alpha-components alpha-holes"},
    {"Union: balls & boundary",
     "inner-disks inner-circles inner-centers union-boundary isolated ball-triangulation ball-power-diagram", true,
     LayerGroup::union_a},
    {"Union: dual complex",
     "dual-faces dual-interior-edges dual-regular-edges dual-singular-edges degenerate-dual-faces ball-convex-disks "
     "ball-convex-circles ball-convex-centers",
     true},
    {"Union: v-points",
     "v-points v-delaunay v-voronoi v-interior-vertices v-exterior-vertices v-crossing-edges v-alpha-edges "
     "v-origin-edge v-origin-triangle",
     true},
    {"Union: medial axis", "ball-medial-axis ball-medial-disks ball-medial-circles ball-medial-centers", true},
    {"Union: scale axis",
     "scale-axis scale-skeleton scale-axis-boundary scale-axis-disks scale-axis-circles scale-axis-grown-disks",
     true},
    {"Union: alpha complex", "alpha-disks alpha-edges alpha-triangles alpha-boundary alpha-components alpha-holes",
     true},
    {"Samples & picture", "points indices contours image", false, LayerGroup::samples},
    {"Diagnostics",
     "theorem-check curve-defects label-conflicts axis-difference axis-deviation precision-difference axis-nodes "
     "last-change",
     false, LayerGroup::diagnostics},
});

/// The number of names before this one.
std::optional<std::size_t> row_of(std::string_view names, std::string_view name) {
  for (std::size_t row = 0; !names.empty(); ++row) {
    const std::size_t end = std::min(names.find(' '), names.size());
    if (names.substr(0, end) == name) return row;
    names.remove_prefix(std::min(end + 1, names.size()));
  }
  return std::nullopt;
}

}  // namespace

std::span<const LayerTopic> layer_topics() {
  return kTopics;
}

TopicPlace topic_place_of(const LayerDescriptor& descriptor) {
  const bool is_of_union = family_of(descriptor).has_value();
  const std::string_view name = is_of_union ? descriptor.of_any_family : descriptor.id;
  const LayerGroup group = is_of_union ? LayerGroup::union_a : descriptor.group;
  std::optional<TopicPlace> otherwise;
  for (std::size_t topic = 0; topic < kTopics.size(); ++topic) {
    if (kTopics[topic].is_of_union != is_of_union) continue;
    if (const auto row = row_of(kTopics[topic].names, name)) return {topic, *row};
    // More than the number of names.
    if (kTopics[topic].rest == group) otherwise = {topic, kTopics[topic].names.size() + 1};
  }
  return otherwise.value_or(TopicPlace{kTopics.size() - 1, 0});
}

}  // namespace mes
