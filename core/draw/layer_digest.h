// SPDX-License-Identifier: GPL-3.0-or-later
// What a layer draws, as one number.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "core/draw/primitives.h"

namespace mes {

/// What it guarantees:
///  1. It is a function of the set of things drawn (with their multiplicity): it does not depend on the order of
///     instances, on which end of a segment comes first, on the corner a triangle begins at or the way around it, on
///     the sign of a line's direction, nor on the sign of a zero. Everything else counts to the last bit, scalars
///     too.
///  2. Digests of disjoint sets add up to that of their union.
///
/// Two sums of 64 bits, each of an independent hash of the instances; by accident different sets agree about once in
/// 2^128 pairs. It does not defend against collisions made on purpose.
///
/// Cost: some ten nanoseconds an instance. Threads: plain data.
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
  /// 32 hexadecimal digits.
  std::string text() const;
};

/// Of instances of one kind, `stride_of(kind)` doubles each. Without scalars these count as zero.
LayerDigest digest_of(PrimitiveKind kind, std::span<const double> instances, bool with_scalars = true);

/// Of a named digest: what a picture of several layers adds up from.
LayerDigest named(std::string_view name, const LayerDigest& digest);

}  // namespace mes
