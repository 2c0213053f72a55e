// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/layer_digest.h"

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <bit>

#include "core/base/geometry/vec2.h"

namespace mes {
namespace {

/// The finaliser of SplitMix64 over a chain of words.
class Hash {
 public:
  explicit constexpr Hash(std::uint64_t seed) : state_(seed) {}
  constexpr void add(std::uint64_t word) {
    std::uint64_t z = (state_ ^ word) + 0x9e3779b97f4a7c15U;
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    state_ = z ^ (z >> 31U);
  }
  constexpr std::uint64_t value() const { return state_; }

 private:
  std::uint64_t state_;
};

/// Two independent hashes.
class DoubleHash {
 public:
  void add(std::uint64_t word) {
    high_.add(word);
    low_.add(std::rotl(word, 32));
  }
  LayerDigest value() const { return {high_.value(), low_.value()}; }

 private:
  Hash high_{0x6d65736563696e61U};
  Hash low_{0x243f6a8885a308d3U};
};

using Values = std::array<double, 8>;

void sort_places(Values& v, std::size_t count) {
  const auto place = [&v](std::size_t i) { return Vec2{v[2 * i], v[2 * i + 1]}; };
  for (std::size_t i = 1; i < count; ++i) {
    for (std::size_t k = i; k != 0 && lexicographically_less(place(k), place(k - 1)); --k) {
      std::swap(v[2 * k], v[2 * k - 2]);
      std::swap(v[2 * k + 1], v[2 * k - 1]);
    }
  }
}

// Rewrites equivalent values to one canonical form.
void make_canonical(PrimitiveKind kind, Values& v) {
  for (double& value : v) value += 0.0;  // no -0
  switch (kind) {
    case PrimitiveKind::segment: sort_places(v, 2); break;
    case PrimitiveKind::triangle: sort_places(v, 3); break;
    case PrimitiveKind::parabola:
      if (lexicographically_less({v[4], v[5]}, {v[0], v[1]})) {
        std::swap(v[0], v[4]);
        std::swap(v[1], v[5]);
      }
      break;
    case PrimitiveKind::line:
      if (lexicographically_less({v[2], v[3]}, Vec2{})) {
        v[2] = 0.0 - v[2];
        v[3] = 0.0 - v[3];
      }
      break;
    case PrimitiveKind::point:
    case PrimitiveKind::disk:
    case PrimitiveKind::circle:
    case PrimitiveKind::ray:
    case PrimitiveKind::arc: break;
  }
}

}  // namespace

std::string LayerDigest::text() const {
  return fmt::format("{:016x}{:016x}", high, low);
}

LayerDigest digest_of(PrimitiveKind kind, std::span<const double> instances, bool with_scalars) {
  LayerDigest out;
  const std::size_t stride = stride_of(kind);
  Values values{};
  for (std::size_t at = 0; at < instances.size(); at += stride) {
    std::ranges::copy(instances.subspan(at, stride), values.begin());
    if (!with_scalars) values[stride - 1] = 0.0;
    make_canonical(kind, values);
    DoubleHash hash;
    hash.add(static_cast<std::uint64_t>(kind) + 1);
    for (std::size_t i = 0; i < stride; ++i) hash.add(std::bit_cast<std::uint64_t>(values[i]));
    out += hash.value();
  }
  return out;
}

LayerDigest named(std::string_view name, const LayerDigest& digest) {
  DoubleHash hash;
  for (const char letter : name) hash.add(static_cast<unsigned char>(letter));
  hash.add(digest.high);
  hash.add(digest.low);
  return hash.value();
}

}  // namespace mes
