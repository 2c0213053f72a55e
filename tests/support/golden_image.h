// SPDX-License-Identifier: GPL-3.0-or-later
// Compares a picture with its reference in tests/golden.
//
// A test fails if its picture has no reference or differs from it. The picture, and that of any difference, are written
// to the build folder. If the picture is right, copy it to tests/golden.
#pragma once

#include <string>

#include "render/image/image.h"

namespace mes::test {

struct GoldenTolerance {
  int channel = 6;         ///< invisible difference of a channel, by which drivers disagree
  double outliers = 2e-4;  ///< fraction of pixels that may differ by more
};

/// The same with premultiplied colours. In nearly transparent pixels the straight colour is the quotient of two small
/// numbers, which drivers round differently, and which is invisible.
render::Image premultiplied(render::Image image);

/// Empty if the pictures agree visibly; otherwise describes the difference and the files to look at.
std::string compare_with_golden(const render::Image& image, const std::string& name, const GoldenTolerance& = {});

/// Throws std::runtime_error if the file is not a readable PNG.
render::Image read_png(const std::string& path);
render::Image decode_png(const void* bytes, std::size_t size);
void write_png(const render::Image& image, const std::string& path);

}  // namespace mes::test
