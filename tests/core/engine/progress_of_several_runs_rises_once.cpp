// SPDX-License-Identifier: GPL-3.0-or-later
// The progress of a computation that consists of several: from 0 to 1 once, without going back.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "core/base/jobs/job_control.h"
#include "core/structures/balls/axis_ball_union.h"
#include "tests/support/shapes/shapes.h"
#include "tests/support/workbench.h"

using namespace mes;
using namespace mes::test;

namespace {

void count_to(std::uint64_t total, JobControl& job) {
  for (std::uint64_t i = 0; i <= total; ++i) job.checkpoint(i, total);
}

/// Progress at each look of `work(job)`, which is begun anew for each.
template <class Work>
std::vector<double> progress_at_looks(const Work& work) {
  std::vector<double> out;
  for (std::int64_t look = 1;; ++look) {
    JobControl job;
    job.stop_at_look(look);
    bool is_done = true;
    try {
      work(job);
    } catch (const Cancelled&) {
      is_done = false;
    }
    out.push_back(job.progress());
    if (is_done) return out;
  }
}

double largest_step(const std::vector<double>& progress) {
  double out = progress.front();
  for (std::size_t i = 1; i < progress.size(); ++i) out = std::max(out, progress[i] - progress[i - 1]);
  return out;
}

}  // namespace

TEST_CASE("shares of a job fill it one after the other, and lie in each other") {
  JobControl job;
  in_share(job, 0.25, [&] { count_to(10, job); });
  CHECK(job.progress() == 0.25);
  {
    const JobShare middle(job, 0.75);
    CHECK(job.progress() == 0.25);
    job.checkpoint(1, 2);
    CHECK(job.progress() == 0.5);
    in_share(job, 0.75, [&] {
      CHECK(job.progress() == 0.5);
      job.checkpoint(1, 2);
    });
    CHECK(job.progress() == 0.625);
  }
  CHECK(job.progress() == 0.75);
  CHECK(in_share(job, 1.0, [&] {
          count_to(4, job);
          return 7;
        }) == 7);
  CHECK(job.progress() == 1.0);
  // The next job counts in the whole again.
  job.reset_progress();
  job.checkpoint(3, 8);
  CHECK(job.progress() == 0.375);
}

TEST_CASE("progress does not go back, whatever a computation says, and a share that was stopped is closed") {
  JobControl job;
  job.checkpoint(1, 2);
  job.checkpoint(1, 8);
  CHECK(job.progress() == 0.5);
  {
    // It ends where the job is already.
    const JobShare share(job, 0.25);
    count_to(3, job);
  }
  CHECK(job.progress() == 0.5);
  job.reset_progress();
  job.stop_at_look(2);
  CHECK_THROWS_AS(in_share(job, 0.5, [&] { count_to(3, job); }), Cancelled);
  CHECK(job.progress() == 0.0);
  job.reset_progress();
  job.stop_at_look(100);
  job.checkpoint(3, 4);
  CHECK(job.progress() == 0.75);
}

TEST_CASE("a scale skeleton of many unions goes through its progress once, in small steps") {
  TestBench bench;
  bench.show({"a-ball-medial-axis"});
  bench.replace(ellipse(2.0, 1.0, 200, {0.3, 0.1, 3}).data.positions);
  const StructureSet& set = bench.graph().structures();
  SettingsSource settings;
  ComputationSettings chosen;
  chosen[Parameter::scale_axis_factor] = 1.5;
  chosen[Parameter::scale_skeleton_step] = 10.0;
  settings.post(chosen);
  JobControl never;
  settings.rebuild(never);
  std::vector<double> progress = progress_at_looks([&](JobControl& job) {
    ASkeletonUnion skeleton(settings, set.get<AUnion>());
    skeleton.rebuild(job);
    CHECK(std::get<std::int64_t>(skeleton.statistics().back().value) == 4);
  });
  REQUIRE(progress.size() > 20);
  CHECK(progress.front() == 0.0);
  CHECK(progress.back() == 1.0);
  CHECK(std::ranges::is_sorted(progress));
  // Five unions: one makes no more than a fifth of it.
  CHECK(largest_step(progress) < 0.2);
}
