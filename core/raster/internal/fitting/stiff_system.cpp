// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/raster/internal/fitting/stiff_system.h"

#include <utility>

namespace mes {
namespace {

constexpr std::size_t kReach = 3;

/// Elimination without pivots, which a positive definite matrix does not need.
std::array<double, kReach> solved_small(std::array<std::array<double, kReach>, kReach> a,
                                        std::array<double, kReach> b) {
  for (std::size_t i = 0; i < kReach; ++i)
    for (std::size_t k = i + 1; k < kReach; ++k) {
      const double factor = a[k][i] / a[i][i];
      for (std::size_t j = i; j < kReach; ++j) a[k][j] -= factor * a[i][j];
      b[k] -= factor * b[i];
    }
  for (std::size_t i = kReach; i-- > 0;) {
    for (std::size_t k = i + 1; k < kReach; ++k) b[i] -= a[i][k] * b[k];
    b[i] /= a[i][i];
  }
  return b;
}

/// Both substitutions for the first `count` unknowns, each a number or a row of numbers. Diagonals are inverted.
template <class Value, class Subtract, class Scale>
void substitute(const std::vector<std::array<double, 4>>& rows, std::vector<Value>& x, std::size_t count,
                Subtract subtract, Scale scale) {
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = 1; j <= kReach && i + j < count; ++j) subtract(x[i + j], rows[i][j], x[i]);
  for (std::size_t i = count; i-- > 0;) {
    scale(x[i], rows[i][0]);
    for (std::size_t j = 1; j <= kReach && i + j < count; ++j) subtract(x[i], rows[i][j], x[i + j]);
  }
}

}  // namespace

void StiffSystem::factor_first(std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    std::array<double, 4>& row = rows_[i];
    row[0] = 1.0 / row[0];
    for (std::size_t j = 1; j <= kReach && i + j < count; ++j) {
      const double factor = row[j] * row[0];
      for (std::size_t k = j; k <= kReach; ++k) rows_[i + j][k - j] -= factor * row[k];
    }
    for (std::size_t j = 1; j <= kReach; ++j) row[j] *= row[0];
  }
}

void StiffSystem::factor() {
  const std::size_t count = rows_.size();
  if (!is_closed_) return factor_first(count);
  const std::size_t inner = count - kReach;
  border_.assign(inner, Row{});
  for (std::size_t i = inner - kReach; i < count; ++i)
    for (std::size_t j = 0; j <= kReach; ++j) {
      const std::size_t other = i + j;
      if (i < inner) {
        if (other >= inner) border_[i][other - inner] += std::exchange(rows_[i][j], 0.0);
      } else if (other < count) {
        corner_[i - inner][other - inner] += rows_[i][j];
        if (other != i) corner_[other - inner][i - inner] += rows_[i][j];
      } else {
        border_[other - count][i - inner] += rows_[i][j];
      }
    }
  factor_first(inner);
  reduced_ = border_;
  substitute(
      rows_, reduced_, inner,
      [](Row& x, double factor, const Row& y) {
        for (std::size_t j = 0; j < kReach; ++j) x[j] -= factor * y[j];
      },
      [](Row& x, double factor) {
        for (double& value : x) value *= factor;
      });
  // Only the first and the last rows touch the border.
  for (std::size_t k = 0; k < inner; ++k) {
    if (k == kReach && inner > 2 * kReach) k = inner - kReach;
    for (std::size_t i = 0; i < kReach; ++i)
      for (std::size_t j = 0; j < kReach; ++j) corner_[i][j] -= border_[k][i] * reduced_[k][j];
  }
}

void StiffSystem::solve() {
  std::vector<double>& right = right_;
  const std::size_t inner = is_closed_ ? rows_.size() - kReach : rows_.size();
  substitute(
      rows_, right, inner, [](double& x, double factor, double y) { x -= factor * y; },
      [](double& x, double factor) { x *= factor; });
  if (!is_closed_) return;
  Row last{right[inner], right[inner + 1], right[inner + 2]};
  for (std::size_t k = 0; k < inner; ++k) {
    if (k == kReach && inner > 2 * kReach) k = inner - kReach;
    for (std::size_t i = 0; i < kReach; ++i) last[i] -= border_[k][i] * right[k];
  }
  last = solved_small(corner_, last);
  for (std::size_t k = 0; k < inner; ++k)
    for (std::size_t j = 0; j < kReach; ++j) right[k] -= reduced_[k][j] * last[j];
  for (std::size_t j = 0; j < kReach; ++j) right[inner + j] = last[j];
}

}  // namespace mes
