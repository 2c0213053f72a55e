// SPDX-License-Identifier: GPL-3.0-or-later
// `mesecina branches`: the branches of an axis with their measures, as CSV.
#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "app/cli/input.h"
#include "app/cli/messages.h"
#include "app/cli/names.h"
#include "app/cli/output.h"
#include "app/cli/requests.h"
#include "core/document/commands.h"
#include "core/draw/layer_descriptor.h"
#include "core/engine/graph.h"
#include "core/io/text_numbers.h"
#include "core/structures/filters/axis_branches.h"

namespace mes::cli {
namespace {

constexpr std::array<std::string_view, 3> kAxes{"medial-axis", "lambda-medial-axis", "angle-medial-axis"};

std::string_view name_of(BranchEndKind kind) {
  switch (kind) {
    case BranchEndKind::leaf: return "leaf";
    case BranchEndKind::junction: return "junction";
    case BranchEndKind::cut: return "cut";
    case BranchEndKind::none: break;
  }
  return "none";
}

std::string table_of(const std::vector<AxisBranch>& branches) {
  std::string out =
      "branch,from,from_x,from_y,to,to_x,to_y,edges,length,radius_least,radius_mean,radius_largest,lambda,angle\n";
  std::size_t number = 0;
  for (const AxisBranch& branch : branches) {
    out += std::to_string(++number);
    for (const AxisBranch::End& end : {branch.from, branch.to}) {
      out += ',' + std::string(name_of(end.kind));
      for (const double x : {end.place.x, end.place.y}) append_number(out += ',', x);
    }
    out += ',' + std::to_string(branch.edges.size());
    for (const double x :
         {branch.length, branch.radius_least, branch.radius_mean, branch.radius_largest, branch.lambda, branch.angle})
      append_number(out += ',', x);
    out += '\n';
  }
  return out;
}

}  // namespace

Expected<void> run_branches(const BranchesRequest& request, Interruption& interruption) {
  auto settings = settings_of(request.source);
  if (!settings) return std::unexpected(settings.error());
  if (std::ranges::find(kAxes, request.layer) == kAxes.end())
    return usage_error(
        fmt::format("--layer: {} has no branches; those that have are {}", in_quotes(request.layer), one_of(kAxes)));
  if (auto good = check_output(request.output); !good) return good;
  const auto input = read_input(request.source.file, request.source.from);
  if (!input) return std::unexpected(input.error());
  const Document document;
  const auto delta = replace_all(document, input->data);
  if (!delta) return std::unexpected(delta.error());

  // The whole axis is what a limit of 0 leaves.
  if (request.layer == kAxes[0]) (*settings)[Parameter::lambda_limit] = 0.0;
  Graph graph;
  graph.set_demand(std::array{find_layer("lambda-medial-axis"), find_layer("angle-medial-axis")});
  graph.post_settings(*settings);
  graph.post(std::make_shared<const DocumentDelta>(*delta));
  FramePatch patch;
  JobControl job;
  graph.run(patch, job);
  for (const NodeReport& node : patch.nodes)
    if (node.state == NodeState::failed)
      return std::unexpected(
          Error{ErrorCode::cannot_compute, "structure " + node.structure + " failed: " + node.reason, {}, 0, 0});
  const auto& lambda = graph.structures().get<LambdaAxis>();
  const auto& angle = graph.structures().get<AngleAxis>();
  const AxisFilter& filter = request.layer == kAxes[2] ? static_cast<const AxisFilter&>(angle) : lambda;
  const std::vector<AxisBranch> branches = branches_of(filter, graph.structures().get<InnerBalls>(), lambda, angle);
  if (branches.empty()) say("no branch: " + filter.reason());
  return write_output(request.output, table_of(branches), interruption, {input->sources, request.force});
}

}  // namespace mes::cli
