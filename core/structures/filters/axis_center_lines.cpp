// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/filters/axis_center_lines.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "core/kernel/circumcircle.h"

namespace mes {

AxisCenterLines::AxisCenterLines(SettingsSource& settings, Samples& samples, CenterLineEnds& ends,
                                 OneStepCrust& crust, InnerBalls& balls, LambdaAxis& lambda, AngleAxis& angle)
    : Structure("center-lines", {&settings, &samples, &ends, &crust, &balls, &lambda, &angle}),
      settings_(settings),
      samples_(samples),
      ends_(ends),
      crust_(crust),
      balls_(balls),
      lambda_(lambda),
      angle_(angle) {}

std::vector<std::string_view> AxisCenterLines::parameters() const {
  return {Parameter::center_line_pruning.id, Parameter::center_line_branches.id, Parameter::transects.id};
}

AxisCenterLines::Wish AxisCenterLines::wanted() const {
  const ComputationSettings& settings = settings_.current();
  return {settings[Parameter::center_line_pruning], settings[Parameter::center_line_branches],
          settings[Parameter::transects]};
}

std::vector<std::pair<Vec2, Vec2>> AxisCenterLines::ends() const {
  std::vector<std::pair<SampleId, std::optional<Vec2>>> followed;
  for (const auto& line : ends_.current())
    for (const CenterLineEnd& end : line)
      for (const SampleId id : end.follows) followed.emplace_back(id, std::nullopt);
  std::ranges::sort(followed, {}, [](const auto& one) { return one.first; });
  const auto find = [&](SampleId id) {
    return std::ranges::lower_bound(followed, id, {}, [](const auto& one) { return one.first; });
  };
  if (!followed.empty())
    for (const SampleSlot slot : slots_below<SampleSlot>(samples_.row_count()))
      if (samples_.is_alive(slot))
        for (auto at = find(samples_.id(slot)); at != followed.end() && at->first == samples_.id(slot); ++at)
          at->second = samples_.position(slot);
  const auto place_of = [&](const CenterLineEnd& end) {
    std::vector<Vec2> on;
    for (const SampleId id : end.follows)
      if (const auto at = find(id)->second) on.push_back(*at);
    if (on.size() != end.follows.size() || on.empty()) return end.at;
    if (on.size() == 1) return on.front();
    const Vec2 center = circumcircle(on[0], on[1], on[2]).center;
    return is_finite(center) ? center : end.at;
  };
  std::vector<std::pair<Vec2, Vec2>> out;
  for (const auto& [from, to] : ends_.current()) out.emplace_back(place_of(from), place_of(to));
  return out;
}

void AxisCenterLines::rebuild(JobControl& job) {
  wish_ = wanted();
  lines_ = {};
  pieces_ = {};
  transects_ = {};
  const CenterLineRequest request{
      .least_salience = wish_.pruning, .most = static_cast<std::size_t>(wish_.branches), .between = ends()};
  CenterLines set =
      center_lines_of(lambda_, crust_, branches_of(lambda_, balls_, lambda_, angle_, kLeastBranch), request, job);
  unjoined_ = set.unjoined;
  smooth(set, kUsualSmoothing);
  double length = 0.0;
  for (const CenterLine& line : set.lines) length += length_of(line);
  const double spacing = length / wish_.transects;
  for (const CenterLine& line : set.lines) {
    job.checkpoint();
    const LineSlot slot = lines_.next();
    lines_.push_back({length_of(line), widths_of(line), line.is_closed});
    for (std::size_t i = 1; i < line.points.size(); ++i)
      pieces_.push_back({line.points[i - 1].place, line.points[i].place, slot});
    if (!(spacing > 0.0)) continue;
    for (const Station& at : stations_of(line, spacing))
      transects_.push_back({at.left, at.axis, at.right, at.place, at.along, at.width, at.direction, slot});
  }
}

bool AxisCenterLines::update(JobControl&) {
  return wish_ == wanted() && ends_.touched() == 0 && crust_.touched() == 0 && lambda_.touched() == 0;
}

StatList AxisCenterLines::statistics() const {
  StatList out{{"lines", static_cast<std::int64_t>(lines_.size())}};
  if (!ends_.current().empty()) out.push_back({"ends_without_line", static_cast<std::int64_t>(unjoined_)});
  if (lines_.empty()) return out;
  double length = 0.0;
  for (const Line& line : lines_) length += line.length;
  double mean = 0.0;
  double least = std::numeric_limits<double>::infinity();
  double largest = 0.0;
  for (const Line& line : lines_) {
    if (length > 0.0) mean += line.length / length * line.widths.mean;  // products of two lengths may overflow
    least = std::min(least, line.widths.least);
    largest = std::max(largest, line.widths.largest);
  }
  out.push_back({"length", length});
  out.push_back({"width_least", least});
  out.push_back({"width_mean", mean});
  out.push_back({"width_largest", largest});
  return out;
}

}  // namespace mes
