// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/console/progress.h"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace mes::cli {
namespace {

double seconds_between(std::chrono::steady_clock::time_point from, std::chrono::steady_clock::time_point to) {
  return std::chrono::duration<double>(to - from).count();
}

}  // namespace

std::string duration_text(double seconds) {
  const long long whole = std::llround(std::clamp(seconds, 0.0, 1e9));
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole % 3600 / 60);
}

Progress::Progress() : is_terminal_(::isatty(STDERR_FILENO) != 0), last_(started_) {}

Progress::~Progress() {
  if (is_shown_) std::fputs("\r\x1b[K", stderr);
}

void Progress::show(std::string_view task, double fraction) {
  constexpr double kGlance = 0.4;
  constexpr double kBetween = 0.1;
  if (!is_terminal_) return;
  const Clock::time_point now = Clock::now();
  const double elapsed = seconds_between(started_, now);
  if (elapsed < kGlance || (is_shown_ && seconds_between(last_, now) < kBetween)) return;
  // Never shows less than before: not all parts of the work are known when it begins.
  shown_fraction_ = std::max(shown_fraction_, std::clamp(fraction, 0.0, 1.0));
  std::string line = fmt::format("\rmesecina: {} {:.0f} %", task, std::floor(100.0 * shown_fraction_));
  if (shown_fraction_ > 0.01)
    line += fmt::format(", {} left", duration_text(elapsed * (1.0 - shown_fraction_) / shown_fraction_));
  line += "\x1b[K";
  std::fputs(line.c_str(), stderr);
  std::fflush(stderr);
  is_shown_ = true;
  last_ = now;
}

Expected<ComputationResult> compute_with_progress(const Registry& registry, const SampleData& data,
                                                  ComputationRequest request) {
  Progress progress;
  request.on_progress = [&progress](std::string_view task, double fraction) { progress.show(task, fraction); };
  return run_computation(registry, data, request);
}

Expected<ComputationReport> measure_with_progress(const Registry& registry, SampleData data,
                                                  ComputationRequest request,
                                                  std::function<void(const InstancePiece&)> take) {
  Progress progress;
  request.on_progress = [&progress](std::string_view task, double fraction) { progress.show(task, fraction); };
  return run_one_shot(registry, std::move(data), request, std::move(take));
}

}  // namespace mes::cli
