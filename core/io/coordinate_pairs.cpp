// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/coordinate_pairs.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "core/io/short_decimal.h"

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace mes {

#ifdef __SSE2__
namespace {

constexpr unsigned kWindow = 64;
constexpr unsigned kWord = 8;  // bytes that are read for a number at once, and may lie beyond the window

/// Of 64 bytes, the first one the lowest bit.
struct Signs {
  std::uint64_t numeric = 0;  // digits and points
  std::uint64_t points = 0;
};

Signs signs_of(const char* at) {
  Signs out;
  for (unsigned i = 0; i < kWindow; i += 16) {
    const __m128i bytes = _mm_loadu_si128(reinterpret_cast<const __m128i*>(at + i));
    const __m128i value = _mm_sub_epi8(bytes, _mm_set1_epi8('0'));
    const __m128i digits = _mm_cmpeq_epi8(_mm_min_epu8(value, _mm_set1_epi8(9)), value);
    const __m128i points = _mm_cmpeq_epi8(bytes, _mm_set1_epi8('.'));
    const auto mask = [](__m128i truth) {
      return std::uint64_t{static_cast<std::uint32_t>(_mm_movemask_epi8(truth))};
    };
    out.numeric |= mask(_mm_or_si128(digits, points)) << i;
    out.points |= mask(points) << i;
  }
  return out;
}

/// Where numbers begin and end, and points.
struct Window {
  std::uint64_t begins, ends, points;
};

Window window_at(const char* at) {
  const Signs signs = signs_of(at);
  return {signs.numeric & ~(signs.numeric << 1U), ~signs.numeric & (signs.numeric << 1U), signs.points};
}

bool is_blank(char c) {
  return c == ' ' || (c >= '\t' && c <= '\r');
}

/// Blanks, with at most one separator among them.
bool is_gap(const char* at, const char* end, char letter) {
  bool is_separated = false;
  for (; at != end; ++at) {
    if (is_blank(*at)) continue;
    if (is_separated || (*at != ',' && (*at != letter || letter == '\0'))) return false;
    is_separated = true;
  }
  return true;
}

/// Digits as the numbers that they are, the first in the lowest of `count` bytes, 0 to 8 of them.
std::uint64_t digits_of(const char* at, unsigned count) {
  std::uint64_t bytes = 0;
  std::memcpy(&bytes, at, kWord);
  const unsigned half = 4 * (kWord - count);  // all bits may be shifted out
  return internal::eight_digits(((bytes ^ 0x3030303030303030) << half) << half);
}

constexpr std::array<double, 9> kPowers{1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8};
constexpr std::array<std::uint64_t, 9> kWholePowers{1, 10, 100, 1000, 10000, 100000, 1000000, 10000000, 100000000};
constexpr std::uint64_t kMostExact = std::uint64_t{1} << 53U;

/// A number without a sign of `size` digits and points, with these points; false where it takes more.
bool to_number(const char* at, unsigned size, std::uint64_t points, double& value) {
  if ((points & (points - 1)) != 0) return false;
  if (points == 0) {
    if (size > kWord) return false;
    value = static_cast<double>(digits_of(at, size));
    return true;
  }
  const auto whole = static_cast<unsigned>(std::countr_zero(points));
  const unsigned decimals = size - 1 - whole;
  if (size == 1) return false;
  // Both sides of each quotient are doubles without rounding, so that it is rounded once.
  if (size <= kWord) {
    std::uint64_t bytes = 0;
    std::memcpy(&bytes, at, kWord);
    bytes ^= 0x3030303030303030;
    const std::uint64_t before = bytes & ((std::uint64_t{1} << (8 * whole)) - 1);
    const std::uint64_t digits = (bytes >> 8U & ~std::uint64_t{0} << (8 * whole)) | before;
    value = static_cast<double>(internal::eight_digits(digits << (8 * (kWord + 1 - size)))) / kPowers[decimals];
    return true;
  }
  if (whole > kWord || decimals > kWord) return false;
  const std::uint64_t all = digits_of(at, whole) * kWholePowers[decimals] + digits_of(at + whole + 1, decimals);
  value = static_cast<double>(all) / kPowers[decimals];
  return all <= kMostExact;
}

}  // namespace

PairRun read_coordinate_pairs(std::string_view text, char letter, std::span<Vec2> out, bool follows_a_pair) {
  const char* at = text.data();
  const char* const end = at + text.size();
  std::size_t count = 0;
  bool is_first = !follows_a_pair;
  // Pairs that are taken of a window: as many as the fullest ones have is a number that changes, and each change makes the
  // processor go back.
  std::size_t most = kWindow;
  std::array<char, kWindow + kWord> last_bytes{};
  while (at != end && count < out.size()) {
    const bool is_last = end - at < static_cast<std::ptrdiff_t>(last_bytes.size());
    if (is_last) std::copy(at, end, last_bytes.begin());
    const char* const here = is_last ? last_bytes.data() : at;
    // Locals all: these are what the processor works ahead with.
    auto [begins, ends, points] = window_at(here);
    unsigned last = 0;  // end of the last number
    unsigned done = 0;  // end of the last pair
    bool is_x = true;
    Vec2 pair;
    const std::size_t wanted = std::min(count + most, out.size());
    for (; ends != 0; begins &= begins - 1, ends &= ends - 1, is_x = !is_x) {
      const auto from = static_cast<unsigned>(std::countr_zero(begins));
      const auto to = static_cast<unsigned>(std::countr_zero(ends));
      const bool is_negative = from > last && here[from - 1] == '-';
      const unsigned gap = from - last - (is_negative ? 1U : 0U);
      const bool is_usual = gap == 1 && (here[last] == ' ' || here[last] == ',' || (is_x && here[last] == letter));
      const bool may_follow = is_first               ? gap == 0
                              : is_usual || gap == 0 ? is_usual || is_negative
                                                     : is_gap(here + last, here + last + gap, is_x ? letter : '\0');
      const unsigned size = to - from;
      double value = 0.0;
      if (!may_follow || !to_number(here + from, size, (points >> from) & ((std::uint64_t{1} << size) - 1), value))
        break;
      value = is_negative ? -value : value;
      last = to;
      is_first = false;
      if (is_x) {
        pair.x = value;
        continue;
      }
      if ((here[to] | 0x20) == 'e') break;  // of x it is none of what may follow
      pair.y = value;
      out[count++] = pair;
      done = to;
      if (count == wanted) break;
    }
    if (count < wanted) most -= wanted - count;
    at += done;
    if (done == 0 || is_last) break;
  }
  return {static_cast<std::size_t>(at - text.data()), count};
}
#else
PairRun read_coordinate_pairs(std::string_view, char, std::span<Vec2>, bool) {
  return {};
}
#endif

}  // namespace mes
