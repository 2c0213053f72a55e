// SPDX-License-Identifier: GPL-3.0-or-later
// The density of the samples as columns; rows are those of `Delaunay` and of `Samples`.
#include "core/graph/table_maker.h"
#include "core/structures/density/curve_sampling.h"
#include "core/structures/density/feature_size.h"

namespace mes {

std::vector<TableColumns> FeatureSize::table_columns() const {
  const std::string of_edges = table_name(delaunay_.id(), "edges");
  TableMaker<SiteSlot> sites("sites", "Local feature sizes, estimated from the samples", delaunay_.site_rows(),
                             [this](SiteSlot site) { return delaunay_.is_site(site); });
  sites.set_kind(ElementKind::site);
  sites.set_rows_of(table_name(delaunay_.id(), "sites"));
  sites.set_changes(site_changes_);
  sites.computed("feature_size", "Distance to the nearest Voronoi edge of the axis on either side",
                 [this](SiteSlot site) { return has_size(site) ? size(site) : kNoValue; });
  sites.reference("nearest", "Edge whose Voronoi edge is nearest", nearest_, of_edges).is_followed = false;
  sites
      .computed("is_exempt", "A corner, end or junction of the curve, where the estimate says nothing",
                [this](SiteSlot site) { return is_exempt(site); })
      .is_followed = false;

  TableMaker<EdgeSlot> edges("edges", "How densely samples lie along the crust", delaunay_.edge_rows(),
                             [this](EdgeSlot e) { return delaunay_.edge(e).is_alive() && crust_.is_crust(e); });
  edges.set_kind(ElementKind::delaunay_edge);
  edges.set_rows_of(of_edges);
  edges.set_changes(edge_changes_);
  edges.computed("epsilon", "Half the length of the crust edge over the smaller feature size of its ends",
                 [this](EdgeSlot edge) { return has_epsilon(edge) ? epsilon(edge) : kNoValue; });
  return taken(sites, edges);
}

std::vector<TableColumns> CurveSampling::table_columns() const {
  TableMaker<SampleSlot> samples("samples", "Which samples lie off the curves that they were taken from",
                                 samples_.row_count(), [this](SampleSlot slot) { return samples_.is_alive(slot); });
  samples.set_kind(ElementKind::sample);
  samples.set_rows_of(table_name(samples_.Structure::id(), "samples"));
  samples.flag("is_off_curves", "The sample lies off the curves", is_off_);
  return taken(samples);
}

}  // namespace mes
