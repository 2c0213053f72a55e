// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/raster/internal/fitting/ellipse_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "core/raster/internal/fitting/residual_windows.h"

namespace mes {
namespace {

constexpr std::size_t kParameters = 5;
// In pixels. On a nearly exact circle any sample could become an end of the axis.
constexpr double kLeastDifference = 1e-3;
using MatrixRow = std::array<double, kParameters>;
using Matrix = std::array<MatrixRow, kParameters>;

/// The points where a quadratic form of the offset from the centre is one.
struct Conic {
  Vec2 center{};
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;

  double determinant() const { return xx * yy - xy * xy; }
  bool is_ellipse() const { return xx > 0.0 && determinant() > 1e-12 * xx * yy; }
  Vec2 half_gradient(Vec2 d) const { return {xx * d.x + xy * d.y, xy * d.x + yy * d.y}; }
};

/// The conic with the moments of the polygon, which is the ellipse if the points lie on one.
std::optional<Conic> by_moments(std::span<const Edge> edges) {
  const Vec2 origin = edges.front().at;
  double area = 0.0;
  Vec2 first{};
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const Vec2 a = edges[i].at - origin;
    const Vec2 b = edges[i + 1 < edges.size() ? i + 1 : 0].at - origin;
    const double twice = cross(a, b);
    area += twice / 2.0;
    first = first + (twice / 6.0) * (a + b);
    xx += twice / 12.0 * (a.x * a.x + a.x * b.x + b.x * b.x);
    yy += twice / 12.0 * (a.y * a.y + a.y * b.y + b.y * b.y);
    xy += twice / 24.0 * (2.0 * a.x * a.y + a.x * b.y + b.x * a.y + 2.0 * b.x * b.y);
  }
  if (area == 0.0) return std::nullopt;
  const Vec2 mean = (1.0 / area) * first;
  // Variances are a quarter of the squares of the half axes.
  const double var_x = 4.0 * (xx / area - mean.x * mean.x);
  const double var_y = 4.0 * (yy / area - mean.y * mean.y);
  const double both = 4.0 * (xy / area - mean.x * mean.y);
  const double determinant = var_x * var_y - both * both;
  if (!(var_x > 0.0 && determinant > 0.0)) return std::nullopt;
  return Conic{origin + mean, var_y / determinant, -both / determinant, var_x / determinant};
}

/// The distance of an edge from the conic, to first order, and its derivatives by the parameters.
struct Beside {
  Residual residual{};
  MatrixRow derivative{};
  double curvature = 0.0;
  double across = 0.0;  // share of the normal along the line of pixels
};

Beside beside(const Conic& conic, const Edge& edge) {
  const Vec2 d = edge.at - conic.center;
  const Vec2 half = conic.half_gradient(d);
  const double size = 2.0 * std::max(length(half), 1e-12);
  const Vec2 normal = (2.0 / size) * half;
  Beside out;
  // Positive outside.
  out.residual.left = (dot(d, half) - 1.0) / size;
  out.derivative = {-2.0 * half.x / size, -2.0 * half.y / size, d.x * d.x / size, 2.0 * d.x * d.y / size,
                    d.y * d.y / size};
  const double most = std::max(std::abs(normal.x), std::abs(normal.y));
  const double least = std::min(std::abs(normal.x), std::abs(normal.y));
  out.across = std::abs(edge.is_along_y ? normal.y : normal.x);
  out.residual.weight = out.across >= kLeastShare ? out.across : 0.0;
  out.residual.jumps = std::min(least, most - least);
  // det M / |M d|^3, on the conic.
  const double gradient = 0.5 * size;
  out.curvature = conic.determinant() / (gradient * gradient * gradient);
  return out;
}

std::optional<MatrixRow> solved(Matrix a, MatrixRow b) {
  for (std::size_t i = 0; i < kParameters; ++i) {
    if (!(a[i][i] > 0.0)) return std::nullopt;
    for (std::size_t k = i + 1; k < kParameters; ++k) {
      const double factor = a[k][i] / a[i][i];
      for (std::size_t j = i; j < kParameters; ++j) a[k][j] -= factor * a[i][j];
      b[k] -= factor * b[i];
    }
  }
  for (std::size_t i = kParameters; i-- > 0;) {
    for (std::size_t k = i + 1; k < kParameters; ++k) b[i] -= a[i][k] * b[k];
    b[i] /= a[i][i];
  }
  return b;
}

class EllipseFit {
 public:
  EllipseFit(std::span<const Edge> edges, const EdgeNoise& noise) : edges_(edges), noise_(noise) {}

  std::optional<Ellipse> found() {
    const auto begin = by_moments(edges_);
    if (!begin) return std::nullopt;
    conic_ = *begin;
    constexpr double kFarOff = 3.0;  // pixels: no step would bring a farther edge into the noise
    constexpr int kSteps = 5;
    for (int step = 0; step < kSteps; ++step) {
      if (!conic_.is_ellipse()) return std::nullopt;
      measure();
      if (farthest_ > kFarOff || !move()) return std::nullopt;
    }
    if (!conic_.is_ellipse()) return std::nullopt;
    measure();
    bool is_noise = true;
    std::vector<ResidualSum> sums;
    for_each_misfit(residuals_, true, noise_.one, sums, [&](std::size_t, std::size_t) { is_noise = false; });
    return is_noise ? std::optional(axes()) : std::nullopt;
  }

 private:
  void measure() {
    double blurs = 0.0;
    double weights = 0.0;
    rows_.clear();
    for (const Edge& edge : edges_) {
      rows_.push_back(beside(conic_, edge));
      const Beside& row = rows_.back();
      if (edge.variance < 0.0F || row.across < kLeastAcross) continue;
      blurs += row.across * (edge.variance - kVarianceOfPixel) * row.across * row.across;
      weights += row.across;
    }
    const double blur = std::max(kVarianceOfPixel, weights > 0.0 ? blurs / weights : 0.0);
    residuals_.clear();
    farthest_ = 0.0;
    for (Beside& row : rows_) {
      const double across = std::max(row.across, kLeastAcross);
      // Blur moves the measured edge towards the centre of curvature.
      if (noise_.is_blurred) row.residual.left += 0.5 * row.curvature * blur / (across * across);
      farthest_ = std::max(farthest_, row.residual.weight * std::abs(row.residual.left));
      residuals_.push_back(row.residual);
    }
    for_each_stray(residuals_, noise_.one, [this](std::size_t first, std::size_t end, bool are_alone) {
      for (std::size_t i = first; are_alone && i < end; ++i) rows_[i].residual.weight = residuals_[i].weight = 0.0;
    });
  }

  bool move() {
    Matrix squares{};
    MatrixRow right{};
    // The parameters of the form are far smaller than pixels, so they are scaled.
    MatrixRow scale{1.0, 1.0, conic_.xx, std::sqrt(conic_.xx * conic_.yy), conic_.yy};
    for (const Beside& row : rows_)
      for (std::size_t i = 0; i < kParameters; ++i) {
        const double here = row.residual.weight * row.derivative[i] * scale[i];
        right[i] -= here * row.residual.left;
        for (std::size_t k = 0; k < kParameters; ++k) squares[i][k] += here * row.derivative[k] * scale[k];
      }
    const auto step = solved(squares, right);
    if (!step) return false;
    conic_.center = conic_.center + Vec2{(*step)[0], (*step)[1]};
    conic_.xx += (*step)[2] * scale[2];
    conic_.xy += (*step)[3] * scale[3];
    conic_.yy += (*step)[4] * scale[4];
    return true;
  }

  Ellipse axes() const {
    const double mean = 0.5 * (conic_.xx + conic_.yy);
    const double half = 0.5 * (conic_.xx - conic_.yy);
    const double away = std::hypot(half, conic_.xy);
    // The smaller eigenvalue belongs to the longer axis.
    const double angle = 0.5 * std::atan2(-conic_.xy, -half);
    const Vec2 along{std::cos(angle), std::sin(angle)};
    double longer = 1.0 / std::sqrt(mean - away);
    double shorter = 1.0 / std::sqrt(mean + away);
    if (longer - shorter < kLeastDifference) {
      const double radius = 0.5 * (longer + shorter);
      longer = radius + 0.5 * kLeastDifference;
      shorter = radius - 0.5 * kLeastDifference;
    }
    return {conic_.center, longer * along, shorter * perpendicular(along)};
  }

  std::span<const Edge> edges_;
  EdgeNoise noise_;
  Conic conic_;
  std::vector<Beside> rows_;
  std::vector<Residual> residuals_;
  double farthest_ = 0.0;
};

}  // namespace

std::optional<Ellipse> ellipse_of(std::span<const Edge> edges, const EdgeNoise& noise) {
  if (edges.size() <= kParameters) return std::nullopt;
  return EllipseFit(edges, noise).found();
}

}  // namespace mes
