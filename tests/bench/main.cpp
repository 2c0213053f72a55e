// SPDX-License-Identifier: GPL-3.0-or-later
// Our pipeline against the raw CGAL operation, side by side in one process, with a table of ratios at the end.
// `--benchmark_filter=REGEX` chooses, e.g. `--benchmark_filter=/10000/`.
#include <benchmark/benchmark.h>

#include <cstdio>

#include "core/base/jobs/keep_memory.h"
#include "tests/bench/ratios.h"

int main(int argc, char** argv) {
  mes::keep_freed_memory();  // as the program does
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
#ifndef NDEBUG
  std::fprintf(stderr, "mesecina_bench: this is not a release build; its figures mean nothing\n");
  return 1;
#endif
  mes::bench::RatioTable table;
  mes::bench::register_scratch(table);
  mes::bench::register_edits(table);
  mes::bench::register_drawing(table);
  mes::bench::register_dragging(table);
  mes::bench::register_recording(table);
  mes::bench::register_figures(table);
  mes::bench::register_tracing(table);
  mes::bench::register_cities(table);
  mes::bench::register_outlines(table);
  mes::bench::register_importing(table);
  mes::bench::register_sampling(table);
  mes::bench::register_unions(table);
  mes::bench::register_evolving(table);
  mes::bench::register_panes(table);
  mes::bench::register_insight(table);
  mes::bench::register_experiments(table);
  mes::bench::register_reloading(table);
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();

  std::printf("\n%-34s %9s %13s %13s %8s %7s   %s\n", "median", "samples", "ours [us]", "raw [us]", "ratio", "goal",
              "raw is");
  for (const auto& r : table.ratios()) {
    std::printf("%-34s %9zu %13.2f %13.2f %8.2f ", r.what.c_str(), r.samples, r.ours_us, r.raw_us,
                r.ours_us / r.raw_us);
    if (r.goal > 0.0) {
      std::printf("%6.2f%s", r.goal, r.ours_us / r.raw_us <= r.goal ? " " : "!");
    } else {
      std::printf("%6s ", "-");
    }
    std::printf("  %s\n", r.against.c_str());
  }
  for (const auto& kind : {"move, curve", "remove, curve", "insert, curve"}) {
    const auto* small = table.find(kind, 1000);
    const auto* large = table.find(kind, 1000000);
    if (!small || !large) continue;
    std::printf("%-34s edit at 10^6 over 10^3 is %.2f times that of the raw call (goal 2.00)\n", kind,
                (large->ours_us / small->ours_us) / (large->raw_us / small->raw_us));
  }
  for (const auto& note : table.notes()) std::printf("%s\n", note.c_str());
  return 0;
}
