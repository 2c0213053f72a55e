// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/session/json_curves.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace mes {
namespace {

using nlohmann::json;

constexpr std::string_view kLetters = "LQCA";  // by kind
constexpr std::size_t kNumbersOfAnArc = 8;

std::unexpected<Error> bad_curves(std::string text) {
  return std::unexpected(Error{ErrorCode::bad_input, "curves: " + std::move(text)});
}

void put_point(json& out, Vec2 p) {
  out.push_back(p.x);
  out.push_back(p.y);
}

json flat_points(const std::vector<Vec2>& points) {
  json out = json::array();
  for (const Vec2 p : points) put_point(out, p);
  return out;
}

json curve_to_json(const PlaneCurve& curve) {
  json out = {{"closed", curve.is_closed()}, {"points", flat_points(curve.points())}};
  if (!curve.name.empty()) out["name"] = curve.name;
  if (curve.is_polyline()) return out;
  std::string kinds;
  for (const PieceKind kind : curve.kinds()) kinds += kLetters[static_cast<std::size_t>(kind)];
  out["kinds"] = std::move(kinds);
  json arcs = json::array();
  for (const EllipticArc& arc : curve.arcs()) {
    for (const Vec2 p : {arc.center, arc.u, arc.v}) put_point(arcs, p);
    arcs.push_back(arc.start);
    arcs.push_back(arc.sweep);
  }
  if (!arcs.empty()) out["arcs"] = std::move(arcs);
  return out;
}

/// Splits a list of numbers into groups of `each`; `take(next)` makes a thing of each group.
template <class Thing, class Take>
Expected<std::vector<Thing>> things_of(JsonView list, std::size_t each, std::string_view key, Take take) {
  std::vector<Thing> out;
  if (!list) return out;
  if (!list.is_list() || list.size() % each != 0)
    return bad_curves("\"" + std::string(key) + "\" is not a list of as many numbers as there must be");
  bool are_numbers = true;
  auto at = list.elements().begin();
  const auto next = [&]() -> double {
    const JsonView value = *at;
    ++at;
    const double number = value.is_number() ? value.number() : 0.0;
    are_numbers = are_numbers && value.is_number() && std::isfinite(number);
    return number;
  };
  out.reserve(list.size() / each);
  for (std::size_t i = list.size() / each; i > 0; --i) out.push_back(take(next));
  if (!are_numbers) return bad_curves("\"" + std::string(key) + "\" holds something that is not a number");
  return out;
}

Expected<std::vector<Vec2>> points_of(JsonView list) {
  return things_of<Vec2>(list, 2, "points", [](const auto& next) {
    const double x = next();
    return Vec2{x, next()};
  });
}

Expected<PlaneCurve> curve_from(JsonView object) {
  if (!object.is_object()) return bad_curves("one is not an object");
  const auto [closed, points, name, letters, arcs] = object.pick<5>({"closed", "points", "name", "kinds", "arcs"});
  if (!closed.is_flag()) return bad_curves("one does not say whether it is closed");
  auto places = points_of(points);
  if (!places) return std::unexpected(places.error());
  if (places->empty()) return bad_curves("one has no points");
  std::vector<PieceKind> kinds;
  if (letters) {
    if (!letters.is_text()) return bad_curves("\"kinds\" is not a text");
    for (const char letter : letters.text()) {
      const std::size_t kind = kLetters.find(letter);
      if (kind == std::string_view::npos) return bad_curves("\"kinds\" has a letter other than L, Q, C and A");
      kinds.push_back(static_cast<PieceKind>(kind));
    }
  } else {
    kinds.assign(places->size() - 1, PieceKind::line);
  }
  auto ellipses = things_of<EllipticArc>(arcs, kNumbersOfAnArc, "arcs", [](const auto& next) {
    EllipticArc arc;
    for (double* const to :
         {&arc.center.x, &arc.center.y, &arc.u.x, &arc.u.y, &arc.v.x, &arc.v.y, &arc.start, &arc.sweep})
      *to = next();
    return arc;
  });
  if (!ellipses) return std::unexpected(ellipses.error());
  constexpr double kTurn = 2.0 * std::numbers::pi * (1.0 + 1e-9);
  if (std::ranges::any_of(*ellipses, [](const EllipticArc& arc) { return std::abs(arc.sweep) > kTurn; }))
    return bad_curves("an arc goes around more than once");
  auto out = PlaneCurve::of_parts(*std::move(places), std::move(kinds), *std::move(ellipses), closed.flag());
  if (!out) return bad_curves("the points of one do not fit its pieces");
  if (name) {
    if (!name.is_text()) return bad_curves("\"name\" is not a text");
    out->name = name.text();
  }
  return *std::move(out);
}

}  // namespace

json to_json(const CurveSet& curves) {
  json list = json::array();
  for (const PlaneCurve& curve : curves.curves) list.push_back(curve_to_json(curve));
  json out = {{"curves", std::move(list)}};
  if (!curves.points.empty()) out["points"] = flat_points(curves.points);
  if (curves.resolution > 0.0) out["resolution"] = curves.resolution;
  return out;
}

Expected<CurveSet> curves_from(JsonView object) {
  if (!object.is_object()) return bad_curves("not an object");
  const auto [curves, points, resolution] = object.pick<3>({"curves", "points", "resolution"});
  if (curves && !curves.is_list()) return bad_curves("\"curves\" is not a list");
  CurveSet out;
  auto alone = points_of(points);
  if (!alone) return std::unexpected(alone.error());
  out.points = *std::move(alone);
  constexpr double kLargest = 1e300;
  if (resolution.is_number()) out.resolution = std::clamp(resolution.number(), 0.0, kLargest) + 0.0;
  out.curves.reserve(curves.size());
  for (const JsonView element : curves.elements()) {
    auto curve = curve_from(element);
    if (!curve) return std::unexpected(curve.error());
    out.curves.push_back(*std::move(curve));
  }
  return out;
}

json to_json(const SamplingRequest& request) {
  return {{"rule", sampling_rules()[static_cast<std::size_t>(request.rule)].id},
          {"spacing", request.spacing},
          {"number", request.count},
          {"least_each", request.least_each},
          {"share", request.share},
          {"turn", request.turn},
          {"epsilon", request.epsilon},
          {"corner_angle", request.corner_angle},
          {"corner_radius", request.corner_radius},
          {"jitter", request.jitter},
          {"seed", request.seed}};
}

Expected<SamplingRequest> sampling_from(JsonView object) {
  if (!object.is_object()) return bad_curves("\"sampling\" is not an object");
  const auto [rule, spacing, number, least_each, share, turn, epsilon, corner_angle, corner_radius, jitter, seed] =
      object.pick<11>({"rule", "spacing", "number", "least_each", "share", "turn", "epsilon", "corner_angle",
                       "corner_radius", "jitter", "seed"});
  SamplingRequest out{.rule = SamplingRule::adaptive, .count = kUsualSamples};
  if (rule.is_text() && rule.text_length() < 100)
    for (const SamplingRuleDescriptor& known : sampling_rules())
      if (known.id == rule.text()) out.rule = known.rule;
  const auto take = [](JsonView value, double low, double high, double& to) {
    // Avoids a negative zero: timelines are compared by their bytes.
    if (value.is_number()) to = std::clamp(value.number(), low, high) + 0.0;
  };
  take(spacing, 0.0, 1e300, out.spacing);
  if (out.rule == SamplingRule::spacing && out.spacing == 0.0) return bad_curves("the spacing of samples is zero");
  take(share, 1e-3, 10.0, out.share);
  take(turn, kLeastTurn, kMostTurn, out.turn);
  take(epsilon, kLeastEpsilon, kMostEpsilon, out.epsilon);
  take(corner_angle, 0.0, kMostTurn, out.corner_angle);
  take(corner_radius, 0.0, 1e300, out.corner_radius);
  take(jitter, 0.0, kMostJitter, out.jitter);
  const auto count = [](JsonView value, std::uint64_t low, std::uint64_t high, auto& to) {
    const auto found = value.is_number() ? value.count() : std::nullopt;
    if (found) to = std::clamp(*found, low, high);
  };
  count(number, 0, out.most, out.count);
  if (out.count == 0 && (out.rule == SamplingRule::count || out.rule >= SamplingRule::adaptive))
    return bad_curves("the number of samples is zero");
  count(least_each, 0, out.most, out.least_each);
  count(seed, 0, ~std::uint64_t{0}, out.seed);
  return out;
}

}  // namespace mes
