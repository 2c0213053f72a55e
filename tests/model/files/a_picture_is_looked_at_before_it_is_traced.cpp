// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <semaphore>

#include "app/store/trace_job.h"
#include "core/base/rng.h"
#include "core/builtins/builtins.h"
#include "tests/io/temporary_folder.h"

using namespace mes;

namespace {

/// A dark disk of a quarter of the side, in a PGM of 1100 pixels a side, with a light hole.
std::string disk(int side, bool has_hole) {
  std::string out = "P5 " + std::to_string(side) + ' ' + std::to_string(side) + " 255\n";
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const double away = std::hypot(x - 0.5 * side, y - 0.5 * side);
      out += static_cast<char>(away > 0.25 * side || (has_hole && away < 0.1 * side) ? 200 : 50);
    }
  return out;
}

/// A job, and the way to wait for what it reads.
struct Waited {
  std::counting_semaphore<> woken{0};
  TraceJob job{builtins(), [this] { woken.release(); }};

  template <class Poll>
  auto next(Poll poll) {
    while (true) {
      if (auto outcome = poll()) return std::move(*outcome);
      woken.acquire();
    }
  }
  Expected<void> picture() {
    return next([this] { return job.poll_picture(); });
  }
  Expected<TraceJob::Samples> samples() {
    return next([this] { return job.poll_samples(); });
  }
};

}  // namespace

TEST_CASE("outlines are those of a reduced picture, and samples those of the file") {
  const test::TemporaryFolder folder;
  Waited waited;
  TraceJob& job = waited.job;
  job.begin(folder.write("disk.pgm", disk(1100, true)));
  CHECK(job.is_busy());
  REQUIRE(waited.picture().has_value());
  CHECK_FALSE(job.poll_picture().has_value());
  const TracePreview* const preview = job.preview();
  REQUIRE(preview != nullptr);
  CHECK(preview->image.width == 550);
  CHECK(preview->reduction == 2.0);
  CHECK((preview->level == Level{124}));
  CHECK(preview->specks == Approx(121.0));

  TraceRequest request{.threshold = 124, .specks = preview->specks};
  REQUIRE(job.outlines(request).has_value());
  CHECK(job.outlines(request)->curves.curves.size() == 2);
  // The hole has an area of some 38,000 square pixels of the file.
  request.specks = 45000.0;
  REQUIRE(job.outlines(request).has_value());
  CHECK(job.outlines(request)->curves.curves.size() == 1);
  CHECK(job.outlines(request)->counts.pinholes == 1);
  request.threshold = 220;
  CHECK_FALSE(job.outlines(request).has_value());
  request.threshold = 124;
  CHECK(job.outlines(request).has_value());

  job.trace(request);
  CHECK(job.is_tracing());
  const auto samples = waited.samples();
  REQUIRE(samples.has_value());
  CHECK(samples->data.contours.size() == 1);
  CHECK(samples->data.positions.size() >= 400);
  for (const Vec2 p : samples->data.positions) CHECK(std::abs(distance(p, {550.5, 549.5}) - 275.0) < 0.5);
  CHECK_THAT(samples->remark, Catch::Contains("traced all pixels of grey value 124 or darker; left out: 1 hole"));
  CHECK_FALSE(job.is_tracing());
  // The whole picture is asked for the last request, too.
  for (job.follow(); job.is_busy(); job.follow()) waited.woken.acquire();
  CHECK(job.outlines(request)->counts.blur == 0.0);
}

TEST_CASE("a reduced picture is blurred as the whole one, though it has less noise") {
  // Grains of three deviations are specks; of the mean of sixteen pixels none is.
  constexpr int kSide = 2100;
  Rng random(5);
  std::string noisy = "P5 " + std::to_string(kSide) + ' ' + std::to_string(kSide) + " 255\n";
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      double noise = 0.0;
      for (int i = 0; i < 6; ++i) noise += random.uniform(-10.0, 10.0);
      const double mean = std::hypot(x - 0.5 * kSide, y - 0.5 * kSide) > 0.25 * kSide ? 170.0 : 80.0;
      noisy += static_cast<char>(static_cast<unsigned char>(std::lround(std::clamp(mean + noise, 0.0, 255.0))));
    }
  const test::TemporaryFolder folder;
  Waited waited;
  TraceJob& job = waited.job;
  job.begin(folder.write("noisy.pgm", noisy));
  REQUIRE(waited.picture().has_value());
  const TracePreview* const preview = job.preview();
  REQUIRE(preview != nullptr);
  REQUIRE(preview->reduction == 4.0);
  REQUIRE(preview->whole);
  const auto blur_shown = [&](const TraceRequest& request) {
    static_cast<void>(job.outlines(request));
    while (job.is_busy()) {
      waited.woken.acquire();
      job.follow();
      static_cast<void>(job.outlines(request));
    }
    REQUIRE(job.outlines(request).has_value());
    return job.outlines(request)->counts.blur * job.preview()->reduction;
  };
  for (const int threshold : {125, 120, 125}) {
    const TraceRequest request{.threshold = threshold, .specks = preview->specks};
    const auto whole = trace(*preview->whole, request);
    REQUIRE(whole.has_value());
    REQUIRE(whole->counts.blur > 2.0);
    TraceRequest alone = request;
    *alone.specks /= 16.0;
    REQUIRE(trace(preview->image, alone).has_value());
    CHECK(trace(preview->image, alone)->counts.blur == 0.0);
    CHECK(blur_shown(request) == Approx(whole->counts.blur));
    CHECK(counts_of_tracing(*preview->whole, request).value().blur == whole->counts.blur);
  }
  // A decision is not of the picture before.
  job.begin(folder.write("disk.pgm", disk(1100, true)));
  REQUIRE(waited.picture().has_value());
  CHECK(blur_shown({.threshold = 124, .specks = 121.0}) == 0.0);
}

// Specks of four and nine pixels, of which a reduced picture shows some fainter or not at all.
TEST_CASE("specks of a large picture are counted as its tracing counts them") {
  constexpr int kSide = 2100;
  std::string picture = disk(kSide, false);
  const std::size_t start = picture.size() - static_cast<std::size_t>(kSide) * kSide;
  Rng random(9);
  for (int i = 0; i < 40; ++i) {
    const std::size_t size = 2 + random.below(2);
    const std::size_t column = 10 + 50 * static_cast<std::size_t>(i) + random.below(7);
    const std::size_t row = 20 + random.below(100);
    for (std::size_t y = 0; y < size; ++y)
      for (std::size_t x = 0; x < size; ++x) picture[start + (row + y) * kSide + column + x] = 50;
  }
  const test::TemporaryFolder folder;
  Waited waited;
  TraceJob& job = waited.job;
  job.begin(folder.write("specks.pgm", picture));
  REQUIRE(waited.picture().has_value());
  REQUIRE(job.preview()->reduction == 4.0);
  const TraceRequest request{.threshold = 124, .specks = 30.0};
  std::optional<TraceCounts> counts = job.counts(request);
  while (!counts) {
    waited.woken.acquire();
    job.follow();
    counts = job.counts(request);
  }
  CHECK(counts->specks == 40);
  CHECK(counts->outlines == 1);
  REQUIRE(job.outlines(request).has_value());
  CHECK(job.outlines(request)->counts.specks < 40);
  job.trace(request);
  const auto samples = waited.samples();
  REQUIRE(samples.has_value());
  CHECK_THAT(samples->remark, Catch::Contains("left out: 40 specks"));
  CHECK_THAT(samples->remark, Catch::Contains("left out: " + left_out_text(*counts) + " smaller than "));
}

TEST_CASE("a picture that cannot be read is an error, and the next one is read all the same") {
  const test::TemporaryFolder folder;
  Waited waited;
  waited.job.begin(folder / "missing.png");
  const auto missing = waited.picture();
  REQUIRE_FALSE(missing.has_value());
  CHECK_THAT(missing.error().message(), Catch::Contains("missing.png: cannot be read"));
  CHECK(waited.job.preview() == nullptr);
  waited.job.begin(folder.write("text.png", "POFF 0 0 0\n"));
  REQUIRE_FALSE(waited.picture().has_value());
  // Of two in a row only the last comes.
  waited.job.begin(folder.write("first.pgm", disk(100, false)));
  const auto number = waited.job.preview_number();
  waited.job.begin(folder.write("second.pgm", disk(120, false)));
  REQUIRE(waited.picture().has_value());
  CHECK(waited.job.preview()->image.width == 120);
  CHECK(waited.job.preview_number() == number + 1);
  waited.job.end();
  CHECK(waited.job.preview() == nullptr);
}
