// SPDX-License-Identifier: GPL-3.0-or-later
// The certificate of the axis as columns: where it holds and where it does not.
#include "core/graph/table_maker.h"
#include "core/structures/certificate/axis_certificate.h"

namespace mes {

std::vector<TableColumns> AxisCertificate::table_columns() const {
  TableMaker<EdgeSlot> edges("edges", "Border edges, between an inside and an outside face", delaunay_.edge_rows(),
                             [this](EdgeSlot e) { return delaunay_.edge(e).is_alive() && is_border(e); });
  edges.limit_rows(edge_);
  edges.set_kind(ElementKind::delaunay_edge);
  edges.set_rows_of(table_name(delaunay_.id(), "edges"));
  edges.set_changes(edge_changes_);
  edges.computed("is_bad", "Another inner ball meets the arc beyond the edge",
                 [this](EdgeSlot edge) { return is_bad_edge(edge); });

  TableMaker<SiteSlot> sites("sites", "Sites between faces", delaunay_.site_rows(),
                             [this](SiteSlot site) { return delaunay_.dimension() == 2 && delaunay_.is_site(site); });
  sites.set_kind(ElementKind::site);
  sites.set_rows_of(table_name(delaunay_.id(), "sites"));
  sites.set_changes(site_changes_);
  sites.flag("is_bad", "The site touches inner balls and does not have two border edges", bad_site_);
  return taken(edges, sites);
}

}  // namespace mes
