// SPDX-License-Identifier: GPL-3.0-or-later
// `FastKernel` with one more step, between doubles and numbers of any length, in the predicates that triangulations
// call most. Neighbours on both sides of a shape lie nearly on one circle, and balls that touch one sample nearly have
// a point of equal power; intervals usually fail there.
#pragma once

#include <type_traits>

#include "core/kernel/ball_signs.h"
#include "core/kernel/circle_side.h"
#include "core/kernel/kernels.h"

namespace mes {

/// The kernel's own predicates, except those declared here; all answers are the same.
struct FilteredKernel : FastKernel {
  struct Side_of_oriented_circle_2 {
    using result_type = CGAL::Oriented_side;
    CGAL::Oriented_side operator()(const FastKernel::Point_2& a, const FastKernel::Point_2& b,
                                   const FastKernel::Point_2& c, const FastKernel::Point_2& d) const {
      const auto place = [](const FastKernel::Point_2& p) { return Vec2{p.x(), p.y()}; };
      return static_cast<CGAL::Oriented_side>(sign_of_in_circle(place(a), place(b), place(c), place(d)));
    }
  };
  Side_of_oriented_circle_2 side_of_oriented_circle_2_object() const { return {}; }

  class Power_side_of_oriented_power_circle_2 : public FastKernel::Power_side_of_oriented_power_circle_2 {
   public:
    using Base = FastKernel::Power_side_of_oriented_power_circle_2;
    using Base::operator();
    CGAL::Oriented_side operator()(const Weighted_point_2& a, const Weighted_point_2& b, const Weighted_point_2& c,
                                   const Weighted_point_2& d) const {
      const auto ball = [](const Weighted_point_2& p) { return BallOf<double>{p.x(), p.y(), p.weight()}; };
      return static_cast<CGAL::Oriented_side>(
          -sign_of_excess_at_center<FastKernel>(ball(a), ball(b), ball(c), ball(d)));
    }
  };
  Power_side_of_oriented_power_circle_2 power_side_of_oriented_power_circle_2_object() const { return {}; }
};

/// The traits of triangulations that belong to a kernel.
template <class Kernel>
using TriangulationTraits = std::conditional_t<std::is_same_v<Kernel, FastKernel>, FilteredKernel, Kernel>;

}  // namespace mes

/// Walks begin in doubles, as they do with the kernel itself.
template <>
struct CGAL::Triangulation_structural_filtering_traits<mes::FilteredKernel> {
  using Use_structural_filtering_tag = Tag_true;
};
