// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/curves/internal/repeated_positions.h"

#include <bit>
#include <cstddef>

namespace mes {
namespace {

std::size_t hash_of(Vec2 p) {
  constexpr std::uint64_t kOdd = 0x9e3779b97f4a7c15;
  // Adding 0.0 makes both zeros equal.
  std::uint64_t bits = std::bit_cast<std::uint64_t>(p.x + 0.0) * kOdd;
  bits = (bits ^ (bits >> 32U)) + std::bit_cast<std::uint64_t>(p.y + 0.0);
  bits = (bits ^ (bits >> 29U)) * kOdd;
  bits = (bits ^ (bits >> 32U)) * kOdd;
  return static_cast<std::size_t>(bits ^ (bits >> 29U));
}

/// Hash for small tables of 2^bits slots: different coordinates mostly give different sums of products.
std::size_t short_hash_of(Vec2 p, int bits) {
  constexpr std::uint64_t kOdd = 0x9e3779b97f4a7c15;
  constexpr std::uint64_t kOther = 0xd6e8feb86659fd93;
  const std::uint64_t sum =
      std::bit_cast<std::uint64_t>(p.x + 0.0) * kOdd + std::bit_cast<std::uint64_t>(p.y + 0.0) * kOther;
  return static_cast<std::size_t>(sum >> static_cast<unsigned>(64 - bits));
}

}  // namespace

std::span<const std::uint32_t> RepeatedPositions::find(std::span<const Vec2> positions) {
  // A small table fits in the nearest cache. In long lists, most positions prove unique without a table.
  constexpr std::size_t kFew = 1U << 13U;
  if (positions.size() > kFew) {
    note_shared_hashes(positions);
    find_among(positions, shared_);
  } else {
    find_among_few(positions);
  }
  return repeated_;
}

// Like `find_among`, with 16-bit indices.
void RepeatedPositions::find_among_few(std::span<const Vec2> positions) {
  constexpr std::uint16_t kFree = 0xffffU;
  const auto bits = static_cast<int>(std::bit_width(4 * positions.size() + 1));
  const std::size_t mask = (std::size_t{1} << static_cast<unsigned>(bits)) - 1;
  few_places_.assign(mask + 1, kFree);
  repeated_.clear();
  std::uint16_t* const places = few_places_.data();
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const Vec2 here = positions[i];
    if (!is_finite(here)) {
      were_finite_ = false;
      continue;
    }
    std::size_t at = short_hash_of(here, bits);
    while (places[at] != kFree && positions[places[at]] != here) at = (at + 1) & mask;
    if (places[at] == kFree)
      places[at] = static_cast<std::uint16_t>(i);
    else
      repeated_.push_back(static_cast<std::uint32_t>(i));
  }
}

// Uses a hash table of indices, at most a quarter full.
void RepeatedPositions::find_among(std::span<const Vec2> positions, std::span<const std::uint32_t> numbers) {
  constexpr std::uint32_t kFree = 0xffffffffU;
  const std::size_t mask = std::bit_ceil(4 * numbers.size() + 1) - 1;
  places_.assign(mask + 1, kFree);
  repeated_.clear();
  for (const std::uint32_t i : numbers) {
    if (!is_finite(positions[i])) {
      were_finite_ = false;
      continue;
    }
    std::size_t at = hash_of(positions[i]) & mask;
    while (places_[at] != kFree && positions[places_[at]] != positions[i]) at = (at + 1) & mask;
    if (places_[at] == kFree)
      places_[at] = i;
    else
      repeated_.push_back(i);
  }
}

// Collects positions whose hash occurs twice, and those that are not finite. Uses two bit sets with many more bits than
// there are positions.
void RepeatedPositions::note_shared_hashes(std::span<const Vec2> positions) {
  constexpr std::size_t kPlacesEach = 16;
  constexpr std::size_t kWord = 64;
  const std::size_t places = std::bit_ceil(kPlacesEach * positions.size() + kWord);
  once_.assign(places / kWord, 0);
  twice_.assign(places / kWord, 0);
  const std::size_t mask = places - 1;
  for (const Vec2 here : positions) {
    const std::size_t place = hash_of(here) & mask;
    const std::uint64_t bit = std::uint64_t{1} << (place % kWord);
    std::uint64_t& word = once_[place / kWord];
    twice_[place / kWord] |= word & bit;
    word |= bit;
  }
  shared_.clear();
  for (std::uint32_t i = 0; i < positions.size(); ++i) {
    const std::size_t place = hash_of(positions[i]) & mask;
    if (!is_finite(positions[i]) || ((twice_[place / kWord] >> (place % kWord)) & 1U) != 0) shared_.push_back(i);
  }
}

}  // namespace mes
