// SPDX-License-Identifier: GPL-3.0-or-later
// Settings, samples and balls made of bytes.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "core/document/commands.h"
#include "core/document/settings/computation_settings.h"
#include "tests/fuzz/byte_source.h"

namespace mes::fuzz {

/// How coordinates are read. Lattices have ties without end, plain ones hardly any.
enum class Places : std::uint8_t { lattice, plain, far_away, any_double };

class PlaceSource {
 public:
  PlaceSource(ByteSource& bytes, Places places) : bytes_(bytes), places_(places) {
    if (places == Places::far_away) {
      origin_ = {std::ldexp(bytes.small_integer(), bytes_.byte() % 64), std::ldexp(bytes.small_integer(), 30)};
      unit_ = std::ldexp(1.0, bytes.small_integer() > 0 ? 10 : -10);
    }
  }

  double number() {
    switch (places_) {
      case Places::lattice: return static_cast<double>(static_cast<int>(bytes_.byte() % 16U) - 8);
      case Places::plain: return bytes_.integer() / 64.0;
      case Places::far_away: return bytes_.integer() * unit_;
      case Places::any_double: return bytes_.any_double();
    }
    return 0.0;
  }
  Vec2 point() {
    const double x = number();
    const double y = number();
    return origin_ + Vec2{x, y};
  }
  Disk disk() {
    const Vec2 center = point();
    return {center, std::abs(number()) * (places_ == Places::plain ? 0.25 : 1.0)};
  }

 private:
  ByteSource& bytes_;
  Places places_;
  Vec2 origin_{};
  double unit_ = 1.0;
};

inline ComputationSettings read_settings(ByteSource& bytes) {
  constexpr std::array<double, 8> kScales{1.0, 1.0, 1.0, 0.5, 2.0, 1.5, 1.1, 0.01};
  ComputationSettings out;
  out.precision = static_cast<Precision>(bytes.below(kPrecisions));
  const std::uint8_t choices = bytes.byte();
  out[Parameter::union_shortcut] = (choices & 1U) != 0 ? 0.0 : 1.0;
  out[Parameter::pole_propagation] = (choices & 2U) != 0 ? 1.0 : 0.0;
  out[Parameter::medial_sampling_angle] = (choices & 4U) != 0 ? 170.0 : 95.0;
  // Roots of that many balls take minutes.
  if (out.precision != Precision::exact_roots)
    out[Parameter::scale_axis_factor] = std::max(Parameter::scale_axis_factor.low, kScales[choices % kScales.size()]);
  out[Parameter::scale_skeleton_step] = (choices & 8U) != 0 ? 40.0 : 60.0;
  out[Parameter::keep_topology] = (choices & 8U) != 0 ? 1.0 : 0.0;
  out[Parameter::lambda_limit] = (choices & 16U) != 0 ? 0.5 : 0.0;
  out[Parameter::alpha_radius] = (choices & 48U) != 0 ? 0.75 : 0.0;
  out[Parameter::angle_limit] = (choices & 32U) != 0 ? 45.0 : 0.0;
  out[Parameter::angle_mode] = static_cast<double>((choices >> 6U) % 3U);
  for (const Parameter& scale : {Parameter::a_scale, Parameter::p_scale, Parameter::b_scale})
    out[scale] = kScales[bytes.below(kScales.size())];
  return out;
}

}  // namespace mes::fuzz
