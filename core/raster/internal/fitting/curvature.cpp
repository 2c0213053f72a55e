// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/raster/internal/fitting/curvature.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <queue>
#include <utility>

namespace mes {
namespace {

// A level part gets this relative change of curvature between its ends, unless that moves the curve too far.
constexpr double kTilt = 2e-3;
constexpr double kMoved = 0.02;  // pixels; the curve moves by about a tenth of it

/// Values at positions, from the first extreme to the last.
struct Profile {
  std::vector<double> value;
  std::vector<double> place;
};

/// Returns the first index, the last, and those where the values turn.
std::vector<std::size_t> extremes_of(const std::vector<double>& values) {
  std::vector<std::size_t> out{0};
  double direction = 0.0;
  std::size_t last = 0;  // start of the last different value
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double step = values[i] - values[i - 1];
    if (step == 0.0) continue;
    if (direction * step < 0.0) out.push_back(last);
    direction = step;
    last = i;
  }
  if (values.size() > 1) out.push_back(values.size() - 1);
  return out;
}

/// Removes pairs whose flattening moves the curve by less than the tolerance, and leaves at least `least` extremes.
std::vector<std::size_t> significant(const Profile& row, std::vector<std::size_t> extremes, std::size_t least,
                                     const std::function<double(double)>& tolerance) {
  struct Pair {
    double excess = 0.0;  // over the tolerance
    std::size_t first = 0, second = 0;
    bool operator>(const Pair& other) const { return excess > other.excess; }
  };
  std::vector<std::size_t> before(extremes.size()), after(extremes.size());
  for (std::size_t i = 0; i < extremes.size(); ++i) {
    before[i] = i == 0 ? 0 : i - 1;
    after[i] = i + 1;
  }
  std::priority_queue<Pair, std::vector<Pair>, std::greater<>> queue;
  const std::size_t last = extremes.size() - 1;
  const auto add = [&](std::size_t i) {
    const std::size_t k = after[i];
    if (i == 0 || k >= last) return;
    const double height = std::abs(row.value[extremes[i]] - row.value[extremes[k]]);
    const double length = row.place[extremes[k]] - row.place[extremes[i]];
    // Flattening takes out a wave of curvature with half the height and twice the length.
    constexpr double kSquare = std::numbers::pi * std::numbers::pi;
    queue.push({2.0 * height * length * length / (kSquare * tolerance(2.0 * length)), i, k});
  };
  for (std::size_t i = 1; i < extremes.size(); ++i) add(i);
  std::vector<bool> is_gone(extremes.size(), false);
  std::size_t count = extremes.size();
  while (!queue.empty() && queue.top().excess < 1.0 && count >= least + 2) {
    const Pair pair = queue.top();
    queue.pop();
    if (is_gone[pair.first] || is_gone[pair.second] || after[pair.first] != pair.second) continue;
    is_gone[pair.first] = is_gone[pair.second] = true;
    count -= 2;
    const std::size_t left = before[pair.first], right = after[pair.second];
    after[left] = right;
    before[right] = left;
    add(left);
  }
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < extremes.size(); ++i)
    if (!is_gone[i]) out.push_back(extremes[i]);
  return out;
}

/// Returns monotone values from the first index to the last, and marks those that share the value of the next one.
std::vector<double> monotone(const Profile& row, std::size_t first, std::size_t last, std::vector<char>& is_level) {
  const double sign = row.value[last] >= row.value[first] ? 1.0 : -1.0;
  struct Block {
    double sum = 0.0;
    double weight = 0.0;
    std::size_t count = 0;
    double mean() const { return sum / weight; }
  };
  std::vector<Block> blocks;
  for (std::size_t i = first; i <= last; ++i) {
    constexpr double kLeast = 1e-9;
    const double weight = std::max(kLeast, (i > first ? row.place[i] - row.place[i - 1] : 0.0) +
                                               (i < last ? row.place[i + 1] - row.place[i] : 0.0));
    blocks.push_back({sign * weight * row.value[i], weight, 1});
    while (blocks.size() > 1 && blocks[blocks.size() - 2].mean() >= blocks.back().mean()) {
      const Block end = blocks.back();
      blocks.pop_back();
      blocks.back().sum += end.sum;
      blocks.back().weight += end.weight;
      blocks.back().count += end.count;
    }
  }
  std::vector<double> out;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const Block& block = blocks[b];
    const std::size_t begin = first + out.size();
    const double length = row.place[begin + block.count - 1] - row.place[begin];
    // A level part is tilted so little that the curve hardly moves and the values stay in order.
    double tilt = length > 0.0 ? std::min(kTilt * std::abs(block.mean()), kMoved / (length * length)) : 0.0;
    if (b > 0) tilt = std::min(tilt, block.mean() - blocks[b - 1].mean());
    if (b + 1 < blocks.size()) tilt = std::min(tilt, blocks[b + 1].mean() - block.mean());
    for (std::size_t i = 0; i < block.count; ++i) {
      const double t = length > 0.0 ? (row.place[begin + i] - row.place[begin]) / length - 0.5 : 0.0;
      out.push_back(sign * (block.mean() + tilt * t));
      if (i > 0) is_level[begin + i - 1] = 1;
    }
  }
  return out;
}

}  // namespace

CalmCurvature calmed(std::span<const double> curvature, std::span<const double> lengths, bool is_closed,
                     const std::function<double(double)>& tolerance) {
  const std::size_t count = curvature.size();
  if (count < 3) return {{curvature.begin(), curvature.end()}, std::vector<char>(count, 0)};
  // A closed curve is cut at its largest curvature.
  const std::size_t start =
      is_closed ? static_cast<std::size_t>(std::ranges::max_element(curvature) - curvature.begin()) : 0;
  Profile row;
  double passed = 0.0;
  for (std::size_t i = 0; i < count + (is_closed ? 1U : 0U); ++i) {
    const std::size_t k = (start + i) % count;
    row.value.push_back(curvature[k]);
    row.place.push_back(passed);
    if (k < lengths.size()) passed += lengths[k];
  }
  constexpr std::size_t kOfClosed = 5;  // four, and the first one again at the end
  const auto extremes = significant(row, extremes_of(row.value), is_closed ? kOfClosed : 2, tolerance);
  std::vector<double> out(row.value.size());
  std::vector<char> is_level(row.value.size(), 0);
  std::vector<double> ends(extremes.size());
  for (std::size_t e = 0; e + 1 < extremes.size(); ++e) {
    const std::size_t first = extremes[e], last = extremes[e + 1];
    const std::vector<double> values = monotone(row, first, last, is_level);
    std::ranges::copy(values, out.begin() + static_cast<std::ptrdiff_t>(first));
    // Two rows share an extreme, which takes the farther of their two values.
    const bool rises = row.value[last] >= row.value[first];
    const auto farther = [](bool is_high, double a, double b) { return is_high ? std::max(a, b) : std::min(a, b); };
    ends[e] = e == 0 ? values.front() : farther(!rises, ends[e], values.front());
    ends[e + 1] = values.back();
  }
  if (is_closed) ends.front() = ends.back() = std::max(ends.front(), ends.back());
  for (std::size_t e = 0; e < extremes.size(); ++e) out[extremes[e]] = ends[e];
  CalmCurvature of_nodes{std::vector<double>(count), std::vector<char>(count)};
  for (std::size_t i = 0; i < count; ++i) {
    // Averaging neighbours keeps the values monotone, and removes steps.
    const bool is_end = !is_closed && (i == 0 || i + 1 == count);
    const double before = i > 0 ? out[i - 1] : out[count - 1];
    const double after = i + 1 < out.size() ? out[i + 1] : out[i];
    of_nodes.at[(start + i) % count] = is_end ? out[i] : 0.5 * out[i] + 0.25 * (before + after);
    of_nodes.is_level[(start + i) % count] = is_level[i];
  }
  return of_nodes;
}

}  // namespace mes
