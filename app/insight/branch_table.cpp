// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/insight/branch_table.h"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "app/insight/center_line_run.h"
#include "core/base/counted.h"
#include "core/io/systems/map_conversion.h"
#include "core/io/text/text_numbers.h"
#include "core/structures/balls/kept_union.h"
#include "core/workbench/workbench.h"

namespace mes {
namespace {

// Each edge continues where the previous one ended. Ends of edges at one node may differ in their last bits.
std::vector<Vec2> line_of(const AxisFilter& filter, const AxisBranch& branch) {
  std::vector<Vec2> out{branch.from.place};
  for (const EdgeSlot edge : branch.edges) {
    const Vec2 a = filter.kept_end(edge, 0);
    const Vec2 b = filter.kept_end(edge, 1);
    out.push_back(distance(a, out.back()) <= distance(b, out.back()) ? b : a);
  }
  return out;
}

void add_shares(const Workbench& bench, BranchTable& out) {
  const auto& axis = bench.get<MedialAxis>();
  const auto& delaunay = bench.get<Delaunay>();
  const auto& lambda = bench.get<LambdaAxis>();
  for (const EdgeSlot edge : delaunay.edge_slots()) {
    if (!delaunay.edge(edge).is_alive() || !axis.is_axis_edge(edge) || axis.is_zero_length(edge)) continue;
    const double length = delaunay.dual_length(edge);
    const FaceSlot* const face = delaunay.edge(edge).f;
    const double radius = 0.5 * delaunay.circumradius(face[0]) + 0.5 * delaunay.circumradius(face[1]);
    if (!std::isfinite(length) || !std::isfinite(radius)) continue;
    out.radii.push_back({radius, length});
    out.lambdas.push_back({lambda.value(edge), length});
  }
}

void add_stations(const AxisFilter& filter, const OneStepCrust& crust, const CenterLineWish& wish, JobControl& job,
                  BranchTable& out) {
  constexpr double kOfLongest = 400.0;
  constexpr double kMost = 100'000.0;  // of all lines
  CenterLines set = center_lines_of(filter, crust, out.branches, wish.request, job);
  smooth(set, kUsualSmoothing);
  double longest = 0.0;
  double all = 0.0;
  for (const CenterLine& line : set.lines) {
    longest = std::max(longest, length_of(line));
    all += length_of(line);
  }
  const double spacing = std::max(longest / kOfLongest, all / kMost);
  if (!(spacing > 0.0)) return;
  for (const CenterLine& line : set.lines) {
    job.checkpoint();
    out.stations.push_back(stations_of(line, spacing));
  }
}

constexpr std::array<std::pair<std::string_view, BranchColumn>, 6> kNumbers{
    {{"length", BranchColumn::length},
     {"radius", BranchColumn::radius_mean},
     {"least", BranchColumn::radius_least},
     {"largest", BranchColumn::radius_largest},
     {"lambda", BranchColumn::lambda},
     {"angle", BranchColumn::angle}}};
constexpr std::array kKinds{BranchEndKind::leaf, BranchEndKind::junction, BranchEndKind::cut, BranchEndKind::none};

double distance_to(const std::vector<Vec2>& line, Vec2 p) {
  double out = std::numeric_limits<double>::infinity();
  if (line.size() == 1) return distance(line.front(), p);
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Vec2 a = line[i - 1];
    const Vec2 along = line[i] - a;
    const double size = dot(along, along);
    const double t = size > 0.0 ? std::clamp(dot(p - a, along) / size, 0.0, 1.0) : 0.0;
    out = std::min(out, distance(p, a + t * along));
  }
  return out;
}

/// Structures that only measure the area; the rest of the table does not need them.
bool is_measured_only(std::string_view structure) {
  return structure == "lambda-union" || structure == "angle-union" || structure == "cover-union";
}

}  // namespace

std::string_view layer_of(BranchAxis axis) {
  switch (axis) {
    case BranchAxis::whole: return "medial-axis";
    case BranchAxis::lambda: return "lambda-medial-axis";
    case BranchAxis::cover: return "cover-medial-axis";
    case BranchAxis::angle: break;
  }
  return "angle-medial-axis";
}

std::string_view name_of(BranchEndKind kind) {
  switch (kind) {
    case BranchEndKind::leaf: return "leaf";
    case BranchEndKind::junction: return "junction";
    case BranchEndKind::cut: return "cut";
    case BranchEndKind::none: break;
  }
  return "none";
}

// The whole axis is the lambda axis with limit 0.
Expected<BranchTable> branch_table_of(const Registry& registry, const SampleData& data,
                                      const ComputationSettings& settings, BranchAxis axis, JobControl& job,
                                      bool measures_area) {
  ComputationSettings chosen = settings;
  if (axis == BranchAxis::whole) chosen[Parameter::lambda_limit] = 0.0;
  chosen[Parameter::a_scale] = 1.0;  // shares refer to the unscaled balls
  Workbench bench(registry, {.keeps_document = false});
  const auto& lambda = bench.get<LambdaAxis>();
  const auto& angle = bench.get<AngleAxis>();
  const AxisFilter& filter = axis == BranchAxis::angle   ? static_cast<const AxisFilter&>(angle)
                             : axis == BranchAxis::cover ? bench.get<CoverAxis>()
                                                         : static_cast<const AxisFilter&>(lambda);
  const KeptUnion& kept = axis == BranchAxis::angle   ? static_cast<const KeptUnion&>(bench.get<AngleUnion>())
                          : axis == BranchAxis::cover ? bench.get<CoverUnion>()
                                                      : static_cast<const KeptUnion&>(bench.get<LambdaUnion>());
  std::vector<std::string_view> needed{lambda.id(), angle.id(), filter.id()};
  if (measures_area) needed.push_back(kept.id());
  if (auto good = bench.need(needed); !good) return std::unexpected(good.error());
  bench.choose(chosen);
  if (auto good = bench.load(data); !good) return std::unexpected(good.error());
  // The table can do without the union, so a failure of the union alone is not an error.
  if (auto good = bench.run_or_throw(job); !good && good.error().code != ErrorCode::cannot_compute)
    return std::unexpected(good.error());
  BranchTable out;
  out.map = data.map;
  out.measures_area = measures_area;
  for (const NodeReport& node : bench.nodes()) {
    if (node.state != NodeState::failed) continue;
    std::string problem = "structure " + node.structure + " failed: " + node.reason;
    if (!is_measured_only(node.structure))
      return std::unexpected(Error{ErrorCode::cannot_compute, std::move(problem), {}, 0, 0});
    out.area_problem = std::move(problem);
  }
  out.branches = branches_of(filter, bench.get<InnerBalls>(), lambda, angle, kLeastBranch);
  out.lines.reserve(out.branches.size());
  for (const AxisBranch& branch : out.branches) {
    out.lines.push_back(line_of(filter, branch));
    out.length += branch.length;
  }
  out.reason = filter.reason();
  for (const Stat& stat : filter.statistics()) {
    if (stat.key == "components") out.components = std::get<std::int64_t>(stat.value);
    if (stat.key == "cycles") out.cycles = std::get<std::int64_t>(stat.value);
  }
  const bool has_area = measures_area && out.area_problem.empty();
  for (const Stat& stat : has_area ? kept.statistics() : StatList{}) {
    if (stat.key == "area") out.area = std::get<double>(stat.value);
    if (stat.key == "share_of_shape") out.share_of_shape = std::get<double>(stat.value);
  }
  add_shares(bench, out);
  add_stations(filter, bench.get<OneStepCrust>(), wish_of(settings, data.annotations), job, out);
  return out;
}

std::string kept_in_words(const BranchTable& table) {
  std::string out = fmt::format("{}, length {:.6g}, {}, {}", counted(table.branches.size(), "branch", "branches"),
                                table.length, counted(static_cast<std::size_t>(table.components), "component"),
                                counted(static_cast<std::size_t>(table.cycles), "cycle"));
  if (table.share_of_shape > 0.0) out += fmt::format(", {:.4g} % of the shape", 100.0 * table.share_of_shape);
  if (!table.area_problem.empty()) out += ", share of the shape unknown: " + table.area_problem;
  return out;
}

Expected<std::string> branches_as_csv(const BranchTable& table) {
  const auto written = WrittenPlane::of(table.map);
  if (!written) return std::unexpected(written.error());
  std::string out =
      "branch,from,from_x,from_y,to,to_x,to_y,edges,length,radius_least,radius_mean,radius_largest,lambda,angle\n";
  std::size_t number = 0;
  for (const AxisBranch& branch : table.branches) {
    out += std::to_string(++number);
    for (const AxisBranch::End& end : {branch.from, branch.to}) {
      out += ',' + std::string(name_of(end.kind));
      const Vec2 place = written->position(end.place);
      for (const double x : {place.x, place.y}) append_number(out += ',', x);
    }
    out += ',' + std::to_string(branch.edges.size());
    for (const double x :
         {branch.length, branch.radius_least, branch.radius_mean, branch.radius_largest, branch.lambda})
      append_number(out += ',', written->length(x));
    append_number(out += ',', branch.angle);
    out += '\n';
  }
  return out;
}

double number_in(const AxisBranch& branch, std::size_t row, BranchColumn column) {
  switch (column) {
    case BranchColumn::number: return static_cast<double>(row + 1);
    case BranchColumn::from: return static_cast<double>(branch.from.kind);
    case BranchColumn::to: return static_cast<double>(branch.to.kind);
    case BranchColumn::length: return branch.length;
    case BranchColumn::radius_least: return branch.radius_least;
    case BranchColumn::radius_mean: return branch.radius_mean;
    case BranchColumn::radius_largest: return branch.radius_largest;
    case BranchColumn::lambda: return branch.lambda;
    case BranchColumn::angle: break;
  }
  return branch.angle;
}

Expected<BranchFilter> BranchFilter::parse(std::string_view text) {
  BranchFilter out;
  const auto wrong = [](std::string_view word) {
    return std::unexpected(Error{ErrorCode::usage,
                                 fmt::format("'{}' is neither a kind of end (leaf, junction, cut, none) nor a "
                                             "condition such as length>2.5; numbers are length, radius, least, "
                                             "largest, lambda, angle",
                                             word),
                                 {},
                                 0,
                                 0});
  };
  while (true) {
    const std::size_t begin = text.find_first_not_of(" \t,");
    if (begin == std::string_view::npos) return out;
    text.remove_prefix(begin);
    const std::string_view word = text.substr(0, text.find_first_of(" \t,"));
    text.remove_prefix(word.size());
    Condition condition;
    const std::size_t sign = word.find_first_of("<>");
    if (sign == std::string_view::npos) {
      const auto kind = std::ranges::find(kKinds, word, [](BranchEndKind k) { return name_of(k); });
      if (kind == kKinds.end()) return wrong(word);
      condition.is_kind = true;
      condition.kind = *kind;
    } else {
      const auto number =
          std::ranges::find(kNumbers, word.substr(0, sign), &std::pair<std::string_view, BranchColumn>::first);
      if (number == kNumbers.end()) return wrong(word);
      condition.column = number->second;
      condition.is_above = word[sign] == '>';
      std::string_view rest = word.substr(sign + 1);
      condition.is_equal_enough = rest.starts_with('=');
      if (condition.is_equal_enough) rest.remove_prefix(1);
      const auto limit = parse_number(rest);
      if (!limit) return wrong(word);
      condition.limit = *limit;
    }
    out.conditions_.push_back(condition);
  }
}

bool BranchFilter::holds(const AxisBranch& branch) const {
  return std::ranges::all_of(conditions_, [&](const Condition& condition) {
    if (condition.is_kind) return branch.from.kind == condition.kind || branch.to.kind == condition.kind;
    const double value = number_in(branch, 0, condition.column);
    if (value == condition.limit) return condition.is_equal_enough;
    return (value > condition.limit) == condition.is_above;
  });
}

std::vector<std::size_t> rows_of(const BranchTable& table, const BranchFilter& filter, BranchColumn by,
                                 bool is_descending) {
  std::vector<std::size_t> out;
  for (std::size_t row = 0; row < table.branches.size(); ++row)
    if (filter.holds(table.branches[row])) out.push_back(row);
  std::ranges::stable_sort(out, [&](std::size_t a, std::size_t b) {
    const double x = number_in(table.branches[a], a, by);
    const double y = number_in(table.branches[b], b, by);
    return is_descending ? y < x : x < y;
  });
  return out;
}

std::size_t branch_near(const BranchTable& table, Vec2 place, double reach) {
  std::size_t out = table.lines.size();
  double least = reach;
  for (std::size_t i = 0; i < table.lines.size(); ++i) {
    const double here = distance_to(table.lines[i], place);
    if (here > least || (here == least && out != table.lines.size())) continue;
    least = here;
    out = i;
  }
  return out;
}

ShareHistogram histogram_of(std::span<const AxisShare> shares, std::size_t bins) {
  ShareHistogram out;
  for (const AxisShare& share : shares) out.high = std::max(out.high, share.value);
  if (!(out.high > 0.0) || bins == 0) return {};
  out.lengths.assign(bins, 0.0);
  for (const AxisShare& share : shares) {
    const double place = share.value / out.high * static_cast<double>(bins);
    out.lengths[std::min(bins - 1, static_cast<std::size_t>(std::max(0.0, place)))] += share.length;
  }
  return out;
}

}  // namespace mes
