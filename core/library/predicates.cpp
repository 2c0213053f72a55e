// SPDX-License-Identifier: GPL-3.0-or-later
// Exact predicates.
#include <mesecina/geometry.h>

#include "core/kernel/point_predicates.h"
#include "core/library/internal/adapter.h"

namespace mesecina {
inline namespace v1 {

int orientation(Point a, Point b, Point c) {
  return guarded([&] { return mes::orientation(inner(a), inner(b), inner(c)); });
}

int side_of_circle(Point a, Point b, Point c, Point d) {
  return guarded([&] { return mes::side_of_circle(inner(a), inner(b), inner(c), inner(d)); });
}

int side_of_diametral_circle(Point a, Point b, Point c) {
  return guarded([&] { return mes::side_of_diametral_circle(inner(a), inner(b), inner(c)); });
}

int side_of_power_circle(const Ball& a, const Ball& b, const Ball& c, const Ball& d) {
  return guarded([&] { return mes::side_of_power_circle(inner(a), inner(b), inner(c), inner(d)); });
}

int compare_distances(Point a, Point b, Point c, Point d) {
  return guarded([&] { return mes::compare_distances(inner(a), inner(b), inner(c), inner(d)); });
}

int compare_circumradii(Point a, Point b, Point c, Point d, Point e, Point f) {
  return guarded(
      [&] { return mes::compare_circumradii(inner(a), inner(b), inner(c), inner(d), inner(e), inner(f)); });
}

}  // namespace v1
}  // namespace mesecina
