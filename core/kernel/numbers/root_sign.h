// SPDX-License-Identifier: GPL-3.0-or-later
// Signs of polynomials in rational numbers and a few square roots, without a separation bound.
#pragma once

#include <CGAL/Exact_rational.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "core/base/assert.h"

namespace mes {

/// An element of the field of the rationals with up to four square roots adjoined. It is a sum, over sets of roots, of
/// a rational coefficient times the product of the roots in the set. Radicands are not negative; they may depend on
/// each other and contain squares. All elements of one expression refer to one array of radicands.
///
/// Cost: a product takes n m steps for factors with n and m coefficients, each at most 16.
class RootElement {
 public:
  using Rational = CGAL::Exact_rational;
  static constexpr std::size_t kMostRoots = 4;
  using Radicands = std::array<Rational, kMostRoots>;

  RootElement() = default;
  explicit RootElement(const Rational& number) { set(0, number); }
  explicit RootElement(double number) : RootElement(Rational(number)) {}
  /// number + factor * (square root of radicand `root`). `radicands` must outlive every element computed from this one.
  RootElement(const Rational& number, const Rational& factor, const Radicands& radicands, std::size_t root)
      : radicands_(&radicands) {
    MES_ASSERT(root < kMostRoots);
    set(0, number);
    set(std::size_t{1} << root, factor);
  }

  RootElement operator-() const {
    RootElement out = *this;
    for_each([&](std::size_t roots) { out.of_[roots] = -of_[roots]; });
    return out;
  }
  friend RootElement operator+(const RootElement& a, const RootElement& b) {
    RootElement out = a;
    if (out.radicands_ == nullptr) out.radicands_ = b.radicands_;
    b.for_each([&](std::size_t roots) { out.add(roots, b.of_[roots]); });
    return out;
  }
  friend RootElement operator-(const RootElement& a, const RootElement& b) { return a + -b; }
  friend RootElement operator*(const RootElement& a, const RootElement& b) {
    RootElement out;
    out.radicands_ = a.radicands_ != nullptr ? a.radicands_ : b.radicands_;
    a.for_each([&](std::size_t of_a) {
      b.for_each([&](std::size_t of_b) {
        Rational product = a.of_[of_a] * b.of_[of_b];
        for (std::size_t both = of_a & of_b; both != 0; both &= both - 1)
          product *= (*out.radicands_)[static_cast<std::size_t>(std::countr_zero(both))];
        out.add(of_a ^ of_b, product);
      });
    });
    return out;
  }

  /// Returns -1, 0 or 1. The element is A + B r, where r is the last root, and A and B are free of it. If A and B agree
  /// in sign, that is the answer; otherwise the sign of A^2 - B^2 r^2 tells which term is larger.
  int sign() const {
    if (used_ == 0) return 0;
    const auto last = static_cast<std::size_t>(std::bit_width(highest_set()));
    if (last == 0) return of_[0] > 0 ? 1 : -1;
    const std::size_t root = last - 1;
    RootElement without, factor;
    without.radicands_ = factor.radicands_ = radicands_;
    for_each([&](std::size_t roots) {
      const bool has_root = ((roots >> root) & 1U) != 0;
      (has_root ? factor : without).set(roots & ~(std::size_t{1} << root), of_[roots]);
    });
    const int of_factor = (*radicands_)[root] == 0 ? 0 : factor.sign();
    const int of_rest = without.sign();
    if (of_factor == 0 || of_factor == of_rest) return of_rest;
    if (of_rest == 0) return of_factor;
    const RootElement square = factor * factor * RootElement((*radicands_)[root]);
    return of_rest * (without * without - square).sign();
  }

 private:
  template <class Visit>
  void for_each(Visit visit) const {
    for (unsigned left = used_; left != 0; left &= left - 1) visit(static_cast<std::size_t>(std::countr_zero(left)));
  }
  /// The highest-numbered set of roots that has a coefficient.
  std::size_t highest_set() const { return static_cast<std::size_t>(std::bit_width(used_)) - 1; }
  void set(std::size_t roots, const Rational& coefficient) {
    if (coefficient == 0) return;
    of_[roots] = coefficient;
    used_ |= 1U << roots;
  }
  void add(std::size_t roots, const Rational& coefficient) {
    const unsigned bit = 1U << roots;
    if ((used_ & bit) == 0) {
      set(roots, coefficient);
      return;
    }
    of_[roots] += coefficient;
    if (of_[roots] == 0) used_ &= ~bit;
  }

  std::array<Rational, std::size_t{1} << kMostRoots> of_;  // indexed by set of roots
  std::uint32_t used_ = 0;                                 // bit set of the sets whose coefficient is not zero
  const Radicands* radicands_ = nullptr;
};

}  // namespace mes
