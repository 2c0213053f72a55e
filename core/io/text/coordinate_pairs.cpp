// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/text/coordinate_pairs.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "core/io/text/ascii_text.h"
#include "core/io/text/short_decimal.h"

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace mes {

#ifdef __SSE2__
namespace {

constexpr unsigned kWindow = 64;
constexpr unsigned kWord = 8;  // bytes that are read at once for a number; may lie beyond the window

/// Bit masks of 64 bytes; the lowest bit is the first byte.
struct Signs {
  std::uint64_t digits = 0;
  std::uint64_t points = 0;
  std::uint64_t minuses = 0;
  std::uint64_t separators = 0;  // the usual separators: a space, a comma, the letter
};

Signs signs_of(const char* at, char letter) {
  Signs out;
  const auto mask = [](__m128i truth) { return std::uint64_t{static_cast<std::uint32_t>(_mm_movemask_epi8(truth))}; };
#pragma GCC unroll 4
  for (unsigned i = 0; i < kWindow; i += 16) {
    const __m128i bytes = _mm_loadu_si128(reinterpret_cast<const __m128i*>(at + i));
    const auto are = [&](char c) { return _mm_cmpeq_epi8(bytes, _mm_set1_epi8(c)); };
    const __m128i value = _mm_sub_epi8(bytes, _mm_set1_epi8('0'));
    out.digits |= mask(_mm_cmpeq_epi8(_mm_min_epu8(value, _mm_set1_epi8(9)), value)) << i;
    out.points |= mask(are('.')) << i;
    out.minuses |= mask(are('-')) << i;
    out.separators |= mask(_mm_or_si128(_mm_or_si128(are(' '), are(',')), are(letter))) << i;
  }
  return out;
}

/// Masks of the first bytes, ends and points of the numbers, and the index of the first unusual byte. Before that byte
/// each number has only digits and at most one point, and two numbers are separated by one separator, a minus sign, or
/// both.
struct Window {
  std::uint64_t begins, ends, points;
  unsigned unusual;
};

/// The bytes must begin with a number, or right after one.
Window window_at(const char* at, char letter) {
  const Signs s = signs_of(at, letter);
  const std::uint64_t numeric = s.digits | s.points;
  // The carry runs past the digits after a point; a point at its end is a second one.
  const std::uint64_t second_points = (s.digits + (s.points << 1U)) & ~s.digits & s.points;
  const std::uint64_t lone_points = s.points & ~(s.digits << 1U) & ~(s.digits >> 1U);
  const std::uint64_t others = ~(numeric | s.minuses | s.separators);
  const std::uint64_t gaps = (s.separators & ~((numeric | s.minuses) >> 1U)) | (s.minuses & ~(numeric >> 1U));
  const std::uint64_t unusual = second_points | lone_points | others | gaps;
  return {numeric & ~(numeric << 1U), ~numeric & (numeric << 1U), s.points,
          static_cast<unsigned>(std::countr_zero(unusual | std::uint64_t{1} << (kWindow - 1)))};
}

bool is_numeric(char c) {
  return c == '.' || (c >= '0' && c <= '9');
}

/// Whether the bytes are blanks with at most one separator among them.
bool is_gap(const char* at, const char* end, char letter) {
  bool is_separated = false;
  for (; at != end; ++at) {
    if (is_blank(*at)) continue;
    if (is_separated || (*at != ',' && (*at != letter || letter == '\0'))) return false;
    is_separated = true;
  }
  return true;
}

/// Converts 0 to 8 digits to their values, one a byte; the first digit is in the lowest of `count` bytes.
std::uint64_t digits_of(const char* at, unsigned count) {
  std::uint64_t bytes = 0;
  std::memcpy(&bytes, at, kWord);
  const unsigned half = 4 * (kWord - count);  // all bits may be shifted out
  return internal::eight_digits(((bytes ^ 0x3030303030303030) << half) << half);
}

constexpr std::array<double, 9> kPowers{1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8};
constexpr std::array<std::uint64_t, 9> kWholePowers{1, 10, 100, 1000, 10000, 100000, 1000000, 10000000, 100000000};
constexpr std::uint64_t kMostExact = std::uint64_t{1} << 53U;

/// Reads an unsigned number of `size` digits and points; `points` is their mask. False if this takes more than that.
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
  // Numerator and denominator are exact doubles, so the quotient is rounded only once.
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

/// Reads any number in the bytes `from` to `to`, without its sign, after the gap since byte `last`. False if this takes
/// more than that.
bool number_at(const char* here, unsigned last, unsigned from, unsigned to, std::uint64_t points, char letter,
               bool is_first, double& value) {
  const bool is_negative = from > last && here[from - 1] == '-';
  const unsigned gap = from - last - (is_negative ? 1U : 0U);
  const bool may_follow = is_first   ? gap == 0
                          : gap == 0 ? is_negative
                                     : is_gap(here + last, here + last + gap, letter);
  const unsigned size = to - from;
  double found = 0.0;
  if (!may_follow || !to_number(here + from, size, (points >> from) & ((std::uint64_t{1} << size) - 1), found))
    return false;
  value = is_negative ? -found : found;
  return true;
}

/// For numbers of up to eight bytes, by the distance 7 - i of the point from the highest byte (the last entry: no
/// point): masks of the bytes before and after the point, and the divisor of the digits.
struct Points {
  std::array<std::uint64_t, kWord + 1> before{};
  std::array<std::uint64_t, kWord + 1> after{};
  std::array<double, kWord + 1> powers{};
};

constexpr Points kPoints = [] {
  Points out;
  for (unsigned i = 0; i < kWord; ++i) {
    out.before[i] = (std::uint64_t{1} << (8 * i)) - 1;
    out.after[i] = ~out.before[i] & ~(std::uint64_t{0xff} << (8 * i));
    out.powers[i] = kPowers[kWord - 1 - i];
  }
  out.after[kWord] = ~std::uint64_t{0};
  out.powers[kWord] = 1.0;
  return out;
}();

/// An unsigned number of one to eight bytes, with digits and at most one point.
struct ShortNumber {
  std::uint64_t bytes = 0;  // last character in the highest byte; digits as values, zeros in front
  unsigned point = 0;       // index into kPoints

  ShortNumber(const char* at, unsigned size) {
    constexpr std::uint64_t kAllPoints = 0x1010101010101010;  // bit that a point has and a digit lacks
    std::memcpy(&bytes, at, kWord);
    bytes = (bytes ^ 0x3030303030303030) << (-(8 * size) & 63U);
    const std::uint64_t points = bytes & kAllPoints;
    point = (static_cast<unsigned>(std::countr_zero(points | std::uint64_t{1} << 63U)) + 1) / 8;
  }
};

__m128d two(const double& low, const double& high) {
  return _mm_loadh_pd(_mm_load_sd(&low), &high);
}

__m128i two(const std::uint64_t& low, const std::uint64_t& high) {
  return _mm_unpacklo_epi64(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(&low)),
                            _mm_loadl_epi64(reinterpret_cast<const __m128i*>(&high)));
}

/// Computes both values at once. Numerators and denominators are exact doubles, so each quotient is rounded only once.
__m128d values_of(const ShortNumber& x, const ShortNumber& y) {
  const auto constant = [](int high, int low) { return _mm_set1_epi32(high | low << 16); };
  const __m128i bytes = two(x.bytes, y.bytes);
  const __m128i before = _mm_and_si128(bytes, two(kPoints.before[x.point], kPoints.before[y.point]));
  const __m128i after = _mm_and_si128(bytes, two(kPoints.after[x.point], kPoints.after[y.point]));
  const __m128i digits = _mm_or_si128(_mm_slli_epi64(before, 8), after);
  // Combines digits into pairs of 16 bits, then fours of 32, then eights.
  const __m128i tens = _mm_and_si128(digits, _mm_set1_epi16(0x00ff));
  const __m128i twos = _mm_add_epi16(_mm_mullo_epi16(tens, _mm_set1_epi16(10)), _mm_srli_epi16(digits, 8));
  const __m128i fours = _mm_madd_epi16(twos, constant(100, 1));
  const __m128i eights = _mm_madd_epi16(_mm_packs_epi32(fours, fours), constant(10000, 1));
  return _mm_div_pd(_mm_cvtepi32_pd(eights), two(kPoints.powers[x.point], kPoints.powers[y.point]));
}

/// Sign mask of a number, indexed by the byte before it.
constexpr std::array<double, 256> kSigns = [] {
  std::array<double, 256> out{};
  out['-'] = -0.0;
  return out;
}();

const double& sign_after(char c) {
  return kSigns[static_cast<unsigned char>(c)];
}

}  // namespace

PairRun read_coordinate_pairs(std::string_view text, char letter, std::span<Vec2> out, bool follows_a_pair) {
  const char* at = text.data();
  const char* const end = at + text.size();
  std::size_t count = 0;
  bool is_first = !follows_a_pair;
  if (!is_first && !text.empty() && is_numeric(*at)) return {};
  // Number of pairs taken from each window, the least number found so far. Taking all pairs would be a changing number,
  // and each change would cost a branch misprediction.
  std::size_t most = kWindow;
  std::array<char, kWindow + kWord> last_bytes{};
  while (at != end && count < out.size()) {
    const bool is_last = end - at < static_cast<std::ptrdiff_t>(last_bytes.size());
    if (is_last) std::copy(at, end, last_bytes.begin());
    const char* const here = is_last ? last_bytes.data() : at;
    // Only local variables are used, so that the processor can work ahead.
    auto [begins, ends, points, unusual] = window_at(here, letter != '\0' ? letter : ',');
    unsigned done = 0;  // end of the last complete pair
    const auto take = [](std::uint64_t& bits) {
      if (bits == 0) __builtin_unreachable();
      const auto first = static_cast<unsigned>(std::countr_zero(bits));
      bits &= bits - 1;
      return first;
    };
    const std::size_t wanted = std::min(count + most, out.size());
    while (count < wanted && (ends & (ends - 1)) != 0) {
      const unsigned x_from = take(begins), x_to = take(ends), y_from = take(begins), y_to = take(ends);
      const unsigned x_size = x_to - x_from, y_size = y_to - y_from;
      Vec2& pair = out[count];
      if (!is_first && y_to < unusual && std::max(x_size, y_size) <= kWord && here[x_to] != letter) {
        const __m128d values = values_of({here + x_from, x_size}, {here + y_from, y_size});
        _mm_storeu_pd(&pair.x, _mm_xor_pd(values, two(sign_after(here[x_from - 1]), sign_after(here[y_from - 1]))));
        ++count;
        done = y_to;
        continue;
      }
      if ((here[y_to] | 0x20) == 'e') break;  // an exponent; after x the gap check rejects it
      const bool is_good = number_at(here, done, x_from, x_to, points, letter, is_first, pair.x) &&
                           number_at(here, x_to, y_from, y_to, points, '\0', false, pair.y);
      if (!is_good) break;
      is_first = false;
      ++count;
      done = y_to;
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
