// SPDX-License-Identifier: GPL-3.0-or-later
// A digest of the drawing of a layer.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "core/draw/primitives.h"

namespace mes {

/// Guarantees:
///  1. It depends only on the set of drawn things (with multiplicity): not on the order of instances, on which end of a
///     segment is first, on the first corner or the orientation of a triangle, on the sign of a line's direction, nor
///     on the sign of a zero. Everything else counts to the last bit, including scalars.
///  2. The digests of disjoint sets add up to that of their union.
///
/// Consists of two 64-bit sums, each of an independent hash of the instances; different sets agree by accident about
/// once in 2^128 pairs. It does not protect against deliberate collisions.
///
/// Cost: about ten nanoseconds for each instance. Threads: plain data.
struct LayerDigest {
  std::uint64_t high = 0;
  std::uint64_t low = 0;

  LayerDigest& operator+=(const LayerDigest& other) {
    high += other.high;
    low += other.low;
    return *this;
  }
  LayerDigest& operator-=(const LayerDigest& other) {
    high -= other.high;
    low -= other.low;
    return *this;
  }
  friend bool operator==(const LayerDigest&, const LayerDigest&) = default;
  /// The digest as 32 hexadecimal digits.
  std::string text() const;
};

/// Digest of instances of one kind, `stride_of(kind)` doubles each. If `with_scalars` is false, scalars count as zero.
LayerDigest digest_of(PrimitiveKind kind, std::span<const double> instances, bool with_scalars = true);

/// Digest combined with a name; a picture of several layers is the sum of these.
LayerDigest named(std::string_view name, const LayerDigest& digest);

}  // namespace mes
