// SPDX-License-Identifier: GPL-3.0-or-later
// Compares a picture with the one kept in tests/golden.
//
// A picture that is missing there or differs fails the test; what was drawn, and for a difference also a picture of
// it, is written to the build folder, from where it is looked at and, when right, copied to tests/golden.
#pragma once

#include <string>

#include "render/image.h"

namespace mes::test {

struct GoldenTolerance {
  int channel = 6;         ///< difference of a channel that the eye does not see and drivers disagree by
  double outliers = 2e-4;  ///< fraction of pixels that may differ by more
};

/// The same with colours multiplied by alpha. Of pixels that are nearly transparent the colour without it is the quotient
/// of two small numbers, which drivers round otherwise, and which is not seen.
render::Image premultiplied(render::Image image);

/// Empty when the pictures agree, as far as they are seen; otherwise what is wrong and where to look.
std::string compare_with_golden(const render::Image& image, const std::string& name, const GoldenTolerance& = {});

/// Throws std::runtime_error when the file is not a readable PNG.
render::Image read_png(const std::string& path);
render::Image decode_png(const void* bytes, std::size_t size);
void write_png(const render::Image& image, const std::string& path);

}  // namespace mes::test
