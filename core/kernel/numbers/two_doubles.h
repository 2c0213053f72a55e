// SPDX-License-Identifier: GPL-3.0-or-later
// A number as the unevaluated sum of two doubles, with an error bound: about 100 bits of a polynomial whose value is
// small against its terms, at a tenth of the cost of integers of any length.
//
//  1. The true value of an expression differs from `high + low` by less than `bound` up to the rounding of the bound
//     itself, which `sign` allows for. Differences of doubles are exact.
//  2. Where a part leaves the range of doubles, the bound is NaN or infinite, and `sign` returns not known; losses of
//     products below that range are part of the bound.
//  3. The rounding mode must be to nearest.
//
// Let u = 2^-53. A sum of two such numbers rounds twice, when the low parts are added. A product leaves out low * low,
// at most u^2 of it, and rounds four times: two mixed products, u^2 each, their sum, 2 u^2, and the whole, 3 u^2. A
// quotient and a root are bounded by their residuals: |a / b - q| = |a - q b| / |b|, and |sqrt(a) - s| is at most |a -
// s^2| / s. Source: Dekker 1971, Knuth TAOCP 2, 4.2.2; the bound is the usual running error analysis.
#pragma once

#include <cmath>
#include <limits>
#include <optional>

namespace mes {

class TwoDoubles {
 public:
  constexpr TwoDoubles() = default;
  constexpr TwoDoubles(double x) : high_(x) {}
  /// Difference of two doubles, exactly.
  static TwoDoubles difference(double a, double b) { return sum_of(a, -b); }

  /// -1 or 1; 0 means not known.
  int sign() const {
    // The bound results from fewer than 2^10 additions and products of non-negative numbers.
    const double enough = bound_ * (1.0 + 0x1p-40);
    return high_ > enough ? 1 : (-high_ > enough ? -1 : 0);
  }

  /// Rounded to a double.
  double value() const { return high_ + low_; }
  /// Bounds the distance from `value` to the true value, but for a unit in the last place of `value`.
  double error() const { return bound_ * (1.0 + 0x1p-40); }
  /// The double nearest to the true value, if that is known.
  std::optional<double> nearest() const {
    const double off = error() + 0x1p-52 * std::abs(low_);
    const double least = high_ + (low_ - off);
    const double most = high_ + (low_ + off);
    return least == most ? std::optional(least + 0.0) : std::nullopt;
  }
  /// Doubles between which the true value lies; NaN or infinite where nothing is known.
  double low_end() const {
    const double least = low_ - error();
    return least == 0.0 ? high_ : std::nextafter(high_ + least, -std::numeric_limits<double>::infinity());
  }
  double high_end() const {
    const double most = low_ + error();
    return most == 0.0 ? high_ : std::nextafter(high_ + most, std::numeric_limits<double>::infinity());
  }

  // Forced inline: a factor that occurs several times in a polynomial is then split into halves once.
  TwoDoubles operator-() const { return {-high_, -low_, bound_}; }
  [[gnu::always_inline]] friend TwoDoubles operator+(const TwoDoubles& a, const TwoDoubles& b) {
    const TwoDoubles s = sum_of(a.high_, b.high_);
    const double low = a.low_ + b.low_;
    const double rest = s.low_ + low;
    TwoDoubles out = sum_of(s.high_, rest);
    out.bound_ = a.bound_ + b.bound_ + 0x1p-53 * (std::abs(low) + std::abs(rest));
    return out;
  }
  [[gnu::always_inline]] friend TwoDoubles operator-(const TwoDoubles& a, const TwoDoubles& b) { return a + -b; }
  [[gnu::always_inline]] friend TwoDoubles operator*(const TwoDoubles& a, const TwoDoubles& b) {
    const double p = a.high_ * b.high_;
    const Halves x(a.high_), y(b.high_);
    const double missing = x.low * y.low - (((p - x.high * y.high) - x.low * y.high) - x.high * y.low);
    const double rest = missing + (a.high_ * b.low_ + a.low_ * b.high_);
    TwoDoubles out(p + rest);
    out.low_ = rest - (out.high_ - p);
    out.bound_ = (std::abs(a.high_) + a.bound_) * b.bound_ + std::abs(b.high_) * a.bound_ + 0x1p-102 * std::abs(p) +
                 kBelowRange;
    return out;
  }
  /// Unknown where the divisor may be 0.
  friend TwoDoubles operator/(const TwoDoubles& a, const TwoDoubles& b) {
    const double first = a.high_ / b.high_;
    const TwoDoubles rest = a - b * TwoDoubles(first);
    const double second = rest.high_ / b.high_;
    TwoDoubles out = sum_of(first, second);
    const double size = std::abs(b.high_) * (1.0 - 0x1p-50) - b.error();
    out.bound_ = size > 0.0 ? (rest - b * TwoDoubles(second)).size() / size : kUnknown;
    return out;
  }
  /// Square root of a number that is certainly positive; unknown otherwise.
  friend TwoDoubles root_of(const TwoDoubles& a) {
    if (a.sign() <= 0) return {0.0, 0.0, kUnknown};
    const double first = std::sqrt(a.high_);
    const double second = (a - TwoDoubles(first) * TwoDoubles(first)).high_ / (2.0 * first);
    TwoDoubles out = sum_of(first, second);
    out.bound_ = (a - out * out).size() / (first * (1.0 - 0x1p-50));
    return out;
  }

 private:
  static constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  /// Not smaller than the absolute value of the true value, but for the rounding of bounds.
  double size() const { return std::abs(high_) + std::abs(low_) + bound_; }
  // Allowance for products that underflow below 2^-1022.
  static constexpr double kBelowRange = 0x1p-1000;

  /// The two halves of a double, 26 bits each.
  struct Halves {
    explicit Halves(double x) {
      const double shifted = 134217729.0 * x;  // 2^27 + 1
      high = shifted - (shifted - x);
      low = x - high;
    }
    double high, low;
  };
  constexpr TwoDoubles(double high, double low, double bound) : high_(high), low_(low), bound_(bound) {}
  static TwoDoubles sum_of(double a, double b) {
    const double s = a + b;
    const double part = s - a;
    return {s, (a - (s - part)) + (b - part), 0.0};
  }

  double high_ = 0.0;
  double low_ = 0.0;
  double bound_ = 0.0;
};

/// A double of the input. The difference of two is exact; all other arithmetic is done in `TwoDoubles`.
struct GivenDouble {
  explicit constexpr GivenDouble(double number) : value(number) {}
  constexpr operator TwoDoubles() const { return value; }
  friend TwoDoubles operator-(GivenDouble a, GivenDouble b) { return TwoDoubles::difference(a.value, b.value); }
  double value;
};

}  // namespace mes
