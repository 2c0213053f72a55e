// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/raster/internal/stiff_system.h"

#include <utility>

namespace mes {
namespace {

constexpr std::size_t kReach = 3;
using Small = std::array<std::array<double, kReach>, kReach>;

/// Elimination without pivots, which a positive definite matrix does not need.
std::array<double, kReach> solved_small(Small a, std::array<double, kReach> b) {
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

}  // namespace

void StiffSystem::factor(std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    std::array<double, 4>& row = rows_[i];
    const double pivot = row[0];
    for (std::size_t j = 1; j <= kReach && i + j < count; ++j) {
      const double factor = row[j] / pivot;
      for (std::size_t k = j; k <= kReach; ++k) rows_[i + j][k - j] -= factor * row[k];
    }
    for (std::size_t j = 1; j <= kReach; ++j) row[j] /= pivot;
  }
}

void StiffSystem::solve(std::vector<double>& x, std::size_t count) const {
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = 1; j <= kReach && i + j < count; ++j) x[i + j] -= rows_[i][j] * x[i];
  for (std::size_t i = count; i-- > 0;) {
    x[i] /= rows_[i][0];
    for (std::size_t j = 1; j <= kReach && i + j < count; ++j) x[i] -= rows_[i][j] * x[i + j];
  }
}

// The last three unknowns of a closed system join its ends: the others are solved for them first.
std::vector<double> StiffSystem::solved() && {
  const std::size_t count = rows_.size();
  if (!is_closed_) {
    factor(count);
    solve(right_, count);
    return std::move(right_);
  }
  const std::size_t inner = count - kReach;
  std::array<std::vector<double>, kReach> border;  // columns of the last unknowns, in the rows of the others
  Small corner{};
  for (std::vector<double>& column : border) column.assign(inner, 0.0);
  for (std::size_t i = inner - kReach; i < count; ++i)
    for (std::size_t j = 0; j <= kReach; ++j) {
      const std::size_t other = i + j;
      if (i < inner) {
        if (other >= inner) border[other - inner][i] += std::exchange(rows_[i][j], 0.0);
      } else if (other < count) {
        corner[i - inner][other - inner] += rows_[i][j];
        if (other != i) corner[other - inner][i - inner] += rows_[i][j];
      } else {
        border[i - inner][other - count] += rows_[i][j];
      }
    }
  factor(inner);
  std::array<std::vector<double>, kReach> reduced = border;
  for (std::vector<double>& column : reduced) solve(column, inner);
  std::array<double, kReach> last{right_[inner], right_[inner + 1], right_[inner + 2]};
  std::vector<double> out(right_.begin(), right_.begin() + static_cast<std::ptrdiff_t>(inner));
  solve(out, inner);
  for (std::size_t i = 0; i < kReach; ++i)
    for (std::size_t k = 0; k < inner; ++k) {
      if (border[i][k] == 0.0) continue;
      last[i] -= border[i][k] * out[k];
      for (std::size_t j = 0; j < kReach; ++j) corner[i][j] -= border[i][k] * reduced[j][k];
    }
  last = solved_small(corner, last);
  for (std::size_t k = 0; k < inner; ++k)
    for (std::size_t j = 0; j < kReach; ++j) out[k] -= reduced[j][k] * last[j];
  out.insert(out.end(), last.begin(), last.end());
  return out;
}

}  // namespace mes
