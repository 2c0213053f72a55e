// SPDX-License-Identifier: GPL-3.0-or-later
// Spreads labels from infinity to all faces.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/base/jobs/job_control.h"
#include "core/base/jobs/parallel.h"
#include "core/base/jobs/prefetch.h"
#include "core/structures/delaunay/delaunay.h"

namespace mes {

/// Labels every live face: 0 at infinity; from a face to its neighbour `i`, wherever `is_passage(face, i)`, the label
/// changes exactly if `is_border(face, i)`. Both must be the same seen from the neighbour. Passages must join all faces
/// to infinity, and no closed path through them may cross an odd number of borders. Dead rows get 0.
///
/// Cost: O(faces). How: the rows are cut into `parts`, in each of which connected faces are labelled up to their sign;
/// the signs follow from the passages between parts. Threads: borrows other cores.
template <class IsPassage, class IsBorder>
class LabelSpread {
 public:
  LabelSpread(const Delaunay& delaunay, IsPassage is_passage, IsBorder is_border)
      : delaunay_(delaunay), is_passage_(is_passage), is_border_(is_border) {}

  static std::size_t usual_parts(std::size_t rows) {
    return std::min(2 * worker_count(), chunk_count(std::max<std::size_t>(rows, 1)));
  }

  void run(Table<FaceSlot, std::uint8_t>& inside, std::size_t parts, JobControl& job) {
    const std::size_t rows = delaunay_.face_rows();
    inside.assign(rows, kUnknown);
    if (parts > 1) piece_of_.assign(rows, 0);
    parts_.assign(parts, {});
    run_tasks(parts, [&](std::size_t i) {
      parts_[i].begin = FaceSlot(rows * i / parts);
      parts_[i].end = FaceSlot(rows * (i + 1) / parts);
      label_part(inside, parts_[i], job);
    });

    if (parts == 1) return;
    job.checkpoint();
    find_signs(inside);
    run_tasks(parts, [&](std::size_t i) {
      const Part& part = parts_[i];
      for (const FaceSlot face : slots_between<FaceSlot>(part.begin.index(), part.end.index()))
        if (delaunay_.face(face).is_alive()) inside[face] ^= sign_[part.first_piece + piece_of_[face]];
    });
  }

 private:
  static constexpr std::uint8_t kUnknown = 2;
  struct Link {
    FaceSlot from, to;
    std::uint8_t is_border;
  };
  struct Part {
    FaceSlot begin, end;
    std::uint32_t pieces = 0;
    std::size_t first_piece = 0;            // index among the pieces of all parts
    std::vector<std::uint8_t> at_infinity;  // by piece: its label for faces at infinity, if it has any
    std::vector<Link> links;                // to later parts
    bool holds(FaceSlot face) const { return begin <= face && face < end; }
  };

  // A piece's sign is that of the piece above it, flipped where `turns_` says so.
  std::size_t top_of(std::size_t piece) {
    std::size_t top = piece;
    std::uint8_t sign = 0;
    for (; above_[top] != top; top = above_[top]) sign ^= turns_[top];
    while (above_[piece] != top) {
      const std::size_t next = std::exchange(above_[piece], static_cast<std::uint32_t>(top));
      sign ^= std::exchange(turns_[piece], sign);
      piece = next;
    }
    return top;
  }

  // Pieces on either side of a link have matching signs; those with a face at infinity know theirs.
  void find_signs(const Table<FaceSlot, std::uint8_t>& inside) {
    std::size_t pieces = 0;
    for (Part& part : parts_) {
      part.first_piece = pieces;
      pieces += part.pieces;
    }
    above_.resize(pieces);
    for (std::size_t piece = 0; piece < pieces; ++piece) above_[piece] = static_cast<std::uint32_t>(piece);
    turns_.assign(pieces, 0);
    for (const Part& part : parts_) {
      for (const Link& link : part.links) {
        const auto other = std::ranges::find_if(parts_, [&](const Part& one) { return one.holds(link.to); });
        const std::size_t a = part.first_piece + piece_of_[link.from];
        const std::size_t b = other->first_piece + piece_of_[link.to];
        const std::size_t top_a = top_of(a);
        const std::size_t top_b = top_of(b);
        if (top_a == top_b) continue;
        const unsigned sign_a = a == top_a ? 0U : turns_[a];
        const unsigned sign_b = b == top_b ? 0U : turns_[b];
        above_[top_a] = static_cast<std::uint32_t>(top_b);
        turns_[top_a] =
            static_cast<std::uint8_t>(sign_a ^ sign_b ^ inside[link.from] ^ inside[link.to] ^ link.is_border);
      }
    }
    sign_.assign(pieces, 0);
    for (const Part& part : parts_) {
      for (std::size_t i = 0; i < part.pieces; ++i) {
        if (part.at_infinity[i] == kUnknown) continue;
        const std::size_t piece = part.first_piece + i;
        const std::size_t top = top_of(piece);
        sign_[top] = static_cast<std::uint8_t>(part.at_infinity[i] ^ (piece == top ? 0U : turns_[piece]));
      }
    }
    for (std::size_t piece = 0; piece < pieces; ++piece) {
      const std::size_t top = top_of(piece);
      if (piece != top) sign_[piece] = static_cast<std::uint8_t>(sign_[top] ^ turns_[piece]);
    }
  }

  void label_part(Table<FaceSlot, std::uint8_t>& inside, Part& part, JobControl& job) {
    std::vector<FaceSlot> front;
    std::vector<FaceSlot> next_front;
    std::uint64_t done = 0;
    const bool is_whole = parts_.size() == 1;
    // Breadth first, so that a face's row is being fetched while others are looked at.
    const auto spread = [&](FaceSlot seed) {
      inside[seed] = 0;
      front.push_back(seed);
      if (!is_whole) part.at_infinity.push_back(kUnknown);
      while (!front.empty()) {
        for (const FaceSlot face : front) {
          if ((++done & 0xffffU) == 0) job.checkpoint();
          const FaceRow& row = delaunay_.face(face);
          if (!is_whole) {
            piece_of_[face] = part.pieces;
            if (row.is_infinite()) part.at_infinity.back() = inside[face];
          }
          for (int i = 0; i < 3; ++i) {
            const FaceSlot other = row.n[i];
            if (!part.holds(other)) {
              if (part.end <= other && is_passage_(face, i))
                part.links.push_back({face, other, static_cast<std::uint8_t>(is_border_(face, i) ? 1 : 0)});
              continue;
            }
            if (inside[other] != kUnknown || !is_passage_(face, i)) continue;
            inside[other] = static_cast<std::uint8_t>(inside[face] ^ (is_border_(face, i) ? 1U : 0U));
            prefetch(delaunay_.faces().address(other));
            next_front.push_back(other);
          }
        }
        front.swap(next_front);
        next_front.clear();
      }
      ++part.pieces;
    };
    if (is_whole) {
      for (const FaceSlot face : delaunay_.face_slots()) {
        if (!delaunay_.face(face).is_alive() || !delaunay_.face(face).is_infinite()) continue;
        spread(face);
        break;
      }
    }
    for (const FaceSlot face : slots_between<FaceSlot>(part.begin.index(), part.end.index())) {
      if (inside[face] != kUnknown) continue;
      if (is_whole || !delaunay_.face(face).is_alive())
        inside[face] = 0;
      else
        spread(face);
    }
  }

  const Delaunay& delaunay_;
  IsPassage is_passage_;
  IsBorder is_border_;
  std::vector<Part> parts_;
  Table<FaceSlot, std::uint32_t> piece_of_;  // within its part
  // Indexed by piece, over all parts.
  std::vector<std::uint32_t> above_;
  std::vector<std::uint8_t> turns_;
  std::vector<std::uint8_t> sign_;
};

}  // namespace mes
