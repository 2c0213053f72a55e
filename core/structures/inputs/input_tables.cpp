// SPDX-License-Identifier: GPL-3.0-or-later
// Samples, balls and contours of the document as columns.
#include <array>

#include "core/graph/table_maker.h"
#include "core/structures/inputs/contours.h"
#include "core/structures/inputs/samples.h"
#include "core/structures/inputs/scaled_user_balls.h"
#include "core/structures/inputs/shared_borders.h"
#include "core/structures/inputs/user_balls.h"

namespace mes {

std::vector<TableColumns> Samples::table_columns() const {
  TableMaker<SampleSlot> samples(
      "samples", "Samples of the document", [this] { return row_count(); },
      [this](SampleSlot slot) { return is_alive(slot); });
  samples.set_kind(ElementKind::sample);
  samples.set_changes(changes_);
  samples.column("position", "Coordinates of the document", position_);
  samples.column("id", "Number that the document never uses again", id_);
  return taken(samples);
}

std::vector<TableColumns> UserBalls::table_columns() const {
  TableMaker<BallSlot> balls("balls", "Balls of the document", row_count(),
                             [this](BallSlot slot) { return is_alive(slot); });
  balls.set_kind(ElementKind::own_ball);
  balls.set_changes(changes_);
  balls.column("center", "Coordinates of the document", disk_, &Disk::center);
  balls.column("radius", "Radius before scaling", disk_, &Disk::radius);
  balls.column("id", "Number that the document never uses again", id_);
  return taken(balls);
}

std::vector<TableColumns> ScaledUserBalls::table_columns() const {
  TableMaker<BallSlot> balls("balls", "Balls of the document as they are drawn", row_count(),
                             [this](BallSlot slot) { return is_alive(slot); });
  balls.set_kind(ElementKind::own_ball);
  balls.set_rows_of(table_name(balls_.Structure::id(), "balls"));
  balls.set_changes(changes());
  balls.computed("scaled_radius", "Radius times the parameter b-scale",
                 [this](BallSlot slot) { return disk(slot).radius; });
  return taken(balls);
}

std::vector<TableColumns> Contours::table_columns() const {
  TableMaker<ContourSlot> links("links", "Links between samples that follow each other on a contour", row_count(),
                                [this](ContourSlot row) { return has_link(row); });
  links.set_kind(ElementKind::contour_link);
  links.set_changes(changes_);
  links.computed_reference(
      "samples", "From one sample to the next, in the sense of the contour",
      [this](ContourSlot row) {
        const auto [from, to] = link(row);
        return std::array{from, to};
      },
      table_name(samples_.Structure::id(), "samples"));
  links.column("contour", "Number of the contour, from 0", places_, &Place::contour);
  links.computed("is_closed", "The contour is closed", [this](ContourSlot row) { return is_closed(contour(row)); });
  return taken(links);
}

std::vector<TableColumns> SharedBorders::table_columns() const {
  using LinkSlot = Slot<struct BorderLinkTag>;
  const auto table_of = [this](std::string name, std::string description, const std::vector<Link>& links) {
    TableMaker<LinkSlot> out(std::move(name), std::move(description), links.size(), [](LinkSlot) { return true; });
    out.computed_reference(
        "samples", "Both ends, the lower row first",
        [&links](LinkSlot row) {
          return std::array{links[row.index()].first, links[row.index()].second};
        },
        table_name(samples_.Structure::id(), "samples"));
    return out;
  };
  TableMaker<LinkSlot> borders =
      table_of("borders", "Pairs of samples that closed contours link an even number of times", borders_);
  TableMaker<LinkSlot> seams = table_of("seams", "Other links at a sample of several closed contours", seams_);
  return taken(borders, seams);
}

}  // namespace mes
