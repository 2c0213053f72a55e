// SPDX-License-Identifier: GPL-3.0-or-later
// How noisy a picture is, and the picture with less of it. Private to core/raster.
#pragma once

#include "core/base/job_control.h"
#include "core/raster/gray_image.h"

namespace mes {

/// The standard deviation of the noise, in grey values. Compression takes the finest noise away, so the picture is also
/// measured halved and halved twice; there noise of single pixels has half and a quarter of its deviation. What counts is
/// the largest of the three, multiplied by 1, 2 and 4. From the median of the magnitudes of second differences of
/// second differences (the mask of Immerkaer 1996), to which edges and gradients add little. Zero where half of the
/// picture has no noise, as silhouettes. Cost: some 10^5 pixels are looked at; with noise, O(pixels).
double noise_of(const GrayImage& image);

/// Each pixel the mean of those around it, with the weights of a Gauss curve of this width in pixels; beyond the edge of
/// the picture its last pixels go on. Cost: O(pixels * (1 + sigma)). Throws `Cancelled` if there
/// is a job.
GrayImage blurred(const GrayImage& image, double sigma, const JobControl* job = nullptr);

}  // namespace mes
