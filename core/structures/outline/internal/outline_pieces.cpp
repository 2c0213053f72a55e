// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/outline/internal/outline_pieces.h"

#include <bit>

namespace mes {
namespace {

bool is_same(const Piece& a, const Piece& b) {
  return a.kind == b.kind && a.points == b.points && a.arc == b.arc;
}

}  // namespace

std::vector<Piece> outline_pieces_of(const PlaneCurve& curve) {
  std::vector<Piece> out;
  curve.for_each_piece([&](const Piece& piece) {
    if (piece.kind != PieceKind::line || piece.from() != piece.to()) out.push_back(piece);
  });
  if (!curve.is_closed() || out.empty()) return out;
  // The border of a beginning is the longest shorter one with which it ends as well (Knuth, Morris and Pratt, 1977).
  std::vector<std::size_t> border(out.size(), 0);
  for (std::size_t i = 1; i < out.size(); ++i) {
    std::size_t size = border[i - 1];
    while (size != 0 && !is_same(out[size], out[i])) size = border[size - 1];
    border[i] = is_same(out[size], out[i]) ? size + 1 : 0;
  }
  const std::size_t period = out.size() - border.back();
  if (out.size() % period == 0) out.resize(period);
  return out;
}

bool go_around_alike(std::span<const Piece> a, std::span<const Piece> b) {
  if (a.size() != b.size()) return false;
  const auto first = std::ranges::find_if(b, [&](const Piece& piece) { return is_same(piece, a.front()); });
  const auto rest = static_cast<std::size_t>(b.end() - first);
  return std::ranges::equal(a.first(rest), b.last(rest), is_same) &&
         std::ranges::equal(a.last(a.size() - rest), b.first(b.size() - rest), is_same);
}

std::uint64_t fingerprint(std::span<const Piece> pieces) {
  std::uint64_t sum = 0;
  for (const Piece& piece : pieces) {
    std::uint64_t own = 0;
    for (const double x : {piece.from().x, piece.from().y, piece.to().x, piece.to().y}) {
      constexpr std::uint64_t kOdd = 0x9e3779b97f4a7c15U;                         // 2^64 over the golden ratio
      own = std::rotl((own ^ std::bit_cast<std::uint64_t>(x + 0.0)) * kOdd, 29);  // + 0.0: -0 equals 0
    }
    sum += own;
  }
  return sum;
}

}  // namespace mes
