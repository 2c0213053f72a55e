// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/pages/curves_panel.h"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "app/ui/widgets/paragraph.h"
#include "app/ui/widgets/slider.h"
#include "app/ui/widgets/widgets.h"
#include "core/base/counted.h"
#include "core/base/geometry/box2.h"

namespace mes {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr double kMostNumber = 100'000.0;

}  // namespace

void CurvesPanel::number(const char* label, double& value, double low, double high, const char* format,
                         bool is_logarithmic, const char* explanation) {
  ImGui::TextUnformatted(label);
  tooltip(gui_, explanation);
  double shown = value;
  if (slider(gui_, (std::string("##") + label).c_str(), shown, low, high,
             {.format = format, .is_logarithmic = is_logarithmic, .width = ImGui::GetContentRegionAvail().x}))
    value = shown;
  tooltip(gui_, explanation);
}

void CurvesPanel::count(SamplingRequest& request, const char* explanation) {
  auto value = static_cast<double>(request.count);
  ImGui::TextUnformatted("Number");
  if (slider(gui_, "##number", value, 3.0, kMostNumber,
             {.format = "%.0f", .is_logarithmic = true, .is_whole = true, .width = ImGui::GetContentRegionAvail().x}))
    request.count = static_cast<std::size_t>(value);
  tooltip(gui_, explanation);
}

void CurvesPanel::measure() {
  const std::shared_ptr<const CurveSet>& curves = sampler_.source()->curves;
  if (measured_ == curves) return;
  measured_ = curves;
  Box2 box;
  pieces_ = 0;
  for (const PlaneCurve& curve : curves->curves) {
    pieces_ += curve.piece_count();
    for (const Vec2 p : curve.points()) box.add(p);
  }
  extent_ = std::max({box.width(), box.height(), 1e-300});
}

void CurvesPanel::draw() {
  if (!sampler_.source()) return draw_none();
  measure();
  // At a large scale the content is longer than the panel and scrolls below its header.
  if (ImGui::BeginChild("##curves")) {
    const std::size_t curves = sampler_.source()->curves->curves.size();
    const std::size_t corners = sampler_.corners().size();
    ImGui::TextUnformatted(
        fmt::format("{} of {}", counted(curves, "curve", "curves"), counted(pieces_, "piece", "pieces")).c_str());
    tooltip(gui_, "As the file, the picture or the shape defined them; sessions store them");
    SamplingRequest request = sampler_.request();
    draw_rule(request);
    draw_density(request);
    if (corners != 0) draw_corners(request);
    draw_jitter(request);
    sampler_.want(request);
    draw_facts();
  }
  ImGui::EndChild();
}

void CurvesPanel::draw_none() {
  quiet_paragraph(
      "These samples were not taken from curves. Drawings, maps, traced pictures and shapes have curves, which can "
      "be sampled again here. A curve can also be laid through the existing samples.");
  ImGui::BeginDisabled(!actions_.is_enabled(ActionId::curves_of_samples));
  if (ImGui::Button("Curves through samples")) actions_.run(ActionId::curves_of_samples);
  ImGui::EndDisabled();
  tooltip(gui_, actions_.tooltip_of(ActionId::curves_of_samples));
}

void CurvesPanel::draw_rule(SamplingRequest& request) {
  const auto rules = sampling_rules();
  const SamplingRuleDescriptor& now = rules[static_cast<std::size_t>(request.rule)];
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
  if (ImGui::BeginCombo("##rule", std::string(now.name).c_str())) {
    for (const SamplingRuleDescriptor& rule : rules) {
      if (ImGui::Selectable(std::string(rule.name).c_str(), rule.rule == request.rule)) {
        request.rule = rule.rule;
        if (request.count == 0) request.count = kUsualSamples;
        if (request.rule == SamplingRule::spacing && !(request.spacing > 0.0)) request.spacing = 0.02 * extent_;
      }
      tooltip(gui_, std::string(rule.explanation));
    }
    ImGui::EndCombo();
  }
  tooltip(gui_, std::string(now.explanation));
}

void CurvesPanel::draw_density(SamplingRequest& request) {
  switch (request.rule) {
    case SamplingRule::vertices: break;
    case SamplingRule::spacing:
      number("Distance", request.spacing, 1e-4 * extent_, extent_, "%.4g", true,
             "Largest distance between neighbours along the curve, in units of the samples");
      break;
    case SamplingRule::count: count(request, "Largest number of samples, apart from corners and short curves"); break;
    case SamplingRule::adaptive:
    case SamplingRule::refined:
      count(request, "The number for even spacing; where curves are close together, up to eight times as dense");
      number(
          "Share of the distance", request.share, 0.05, 2.0, "%.2f", true,
          "Neighbours are no farther apart than this share of the distance to the nearest other part of the curves");
      break;
    case SamplingRule::curvature: {
      count(request, "The number for even spacing; in bends, up to eight times as dense");
      const double before = kDegrees * request.turn;
      double degrees = before;
      number("Turn", degrees, 1.0, 90.0, "%.3g\u00b0", true, "Largest turn of the direction between neighbours");
      if (degrees != before) request.turn = degrees / kDegrees;
      break;
    }
    case SamplingRule::feature_size:
      number("Epsilon", request.epsilon, 0.05, kMostEpsilon, "%.3g", true,
             "Half the length between neighbours is at most this multiple of the local feature size, the distance of "
             "the curve to its axis on both sides; corners are exempt. The theorem is proved where samples are dense "
             "enough; if it is not for this epsilon, smaller ones are tried");
      break;
  }
}

void CurvesPanel::draw_corners(SamplingRequest& request) {
  const float unit = gui_.unit();
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(counted(sampler_.corners().size(), "corner", "corners").c_str());
  tooltip(gui_, fmt::format("Where the tangent turns by more than {:.0f} degrees. The local feature size is zero "
                            "there: no density satisfies an epsilon",
                            kDegrees * request.corner_angle));
  ImGui::SameLine(0, 10 * unit);
  bool is_rounded = request.corner_radius > 0.0;
  if (checkbox("Rounded", &is_rounded)) request.corner_radius = is_rounded ? 0.02 * extent_ : 0.0;
  tooltip(gui_, "Samples are taken as if corners were arcs of circles");
  ImGui::SameLine(0, 10 * unit);
  if (ImGui::Button("Mark")) actions_.run(ActionId::mark_corners);
  tooltip(gui_, actions_.tooltip_of(ActionId::mark_corners));
  if (is_rounded)
    number("Radius", request.corner_radius, 1e-4 * extent_, 0.5 * extent_, "%.4g", true,
           "Radius of the arcs, in units of the samples; smaller where corners are close together");
}

void CurvesPanel::draw_jitter(SamplingRequest& request) {
  number("Jitter", request.jitter, 0.0, 2.0, "%.2f", false,
         "Each sample is moved by up to this many mean spacings, in any direction");
  if (request.jitter == 0.0) return;
  constexpr double kMostSeed = 9999.0;
  auto seed = static_cast<double>(std::min<std::uint64_t>(request.seed, 9999));
  const double before = seed;
  ImGui::TextUnformatted("Seed");
  slider(gui_, "##seed", seed, 0.0, kMostSeed,
         {.format = "%.0f", .is_whole = true, .width = ImGui::GetContentRegionAvail().x});
  tooltip(gui_, "Seed of the jitter: another number moves samples differently");
  if (seed != before) request.seed = static_cast<std::uint64_t>(seed);
}

void CurvesPanel::draw_facts() {
  ImGui::Dummy({1, 2 * gui_.unit()});
  const std::string remark = sampler_.remark();
  quiet_paragraph(sampler_.samples_text() + (sampler_.is_busy() ? ", being sampled again ..." : ""));
  if (!remark.empty()) quiet_paragraph(remark);
}

}  // namespace mes
