// SPDX-License-Identifier: GPL-3.0-or-later
// Measures and reduces the noise of a picture. Private to core/raster.
#pragma once

#include "core/base/jobs/job_control.h"
#include "core/raster/gray_image.h"

namespace mes {

/// The standard deviation of the noise, in grey values. Compression removes the finest noise, so the picture is also
/// measured halved and halved twice, where noise of single pixels has half and a quarter of its deviation. The result
/// is the largest of the three deviations, multiplied by 1, 2 and 4. Each is estimated from the median of the
/// magnitudes of second differences of second differences (the mask of Immerkaer 1996), to which edges and gradients
/// add little. Zero if half of the picture has no noise, as in silhouettes. Cost: reads about 10^5 pixels; with noise,
/// O(pixels).
double noise_of(const GrayImage& image);

/// Replaces each pixel by a Gaussian mean of this deviation in pixels; beyond the edge of the picture its last pixels
/// repeat. Cost: O(pixels * (1 + sigma)). Throws `Cancelled` if there is a job.
GrayImage blurred(const GrayImage& image, double sigma, const JobControl* job = nullptr);

}  // namespace mes
