// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/layers/words/verdict_word.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/base/counted.h"

namespace mes {
namespace {

using Mood = VerdictWord::Mood;

constexpr std::string_view kCertificate = "axis-certificate";

struct Name {
  std::string_view id;
  std::string_view name;
};
constexpr auto kNames = std::to_array<Name>({
    {"samples", "the samples"},
    {"contours", "the contours"},
    {"curve-source", "the curves of the samples"},
    {"center-line-ends", "the ends of centre lines"},
    {"curve-sampling", "how well samples represent their curves"},
    {"balls", "your own balls"},
    {"scaled-balls", "your own balls"},
    {"settings", "the parameters"},
    {"delaunay", "the Delaunay triangulation"},
    {"last-change", "the last change"},
    {"one-step-crust", "the crust"},
    {"curve", "the curve"},
    {"voronoi-vertices", "the Voronoi vertices"},
    {"labels", "inside and outside"},
    {"inner-balls", "the inner balls"},
    {"medial-axis", "the medial axis"},
    {"center-lines", "the centre lines"},
    {"axis-nodes", "the nodes of the axis"},
    {"outline-axis", "the axis of the outline"},
    {"axis-deviation", "the deviation of the axis"},
    {kCertificate, "the theorem"},
    {"axis-difference", "the difference of the two axes"},
    {"poles", "the poles"},
    {"pole-labels", "inside and outside of the poles"},
    {"polar-diagram", "the power diagram of the poles"},
    {"power-crust", "the power crust"},
    {"voronoi-ball-diagram", "the power diagram of the Voronoi balls"},
    {"axis-sampling", "the balls along the medial axis"},
    {"scale-union", "the union of the grown balls"},
    {"scale-ball-sampling", "the balls along the scale axis"},
    {"cover-dates", "the cover dates"},
    {"layers", "the drawing"},
});

// The families of balls and the structures made from each, for ids like "a-power-diagram".
constexpr std::array<Name, 3> kFamilies{
    {{"a-", "the inner balls"}, {"p-", "the polar balls"}, {"b-", "your own balls"}}};
constexpr std::array<Name, 8> kOfBalls{{{"union", "the union of "},
                                        {"power-diagram", "the power diagram of "},
                                        {"v-diagram", "the Voronoi diagram of the v-points of "},
                                        {"ball-sampling", "the sampled balls of "},
                                        {"scale-union", "the union of the grown balls along the axis of "},
                                        {"scale-sampling", "the balls along the scale axis of "},
                                        {"skeleton-union", "the scale skeleton of "},
                                        {"precision-difference", "the difference of the number types for "}}};

// The names of findings, in the plural and the singular.
struct Spoken {
  std::string_view several;  // the text of the finding
  std::string_view one;
};
constexpr auto kSpokenFindings = std::to_array<Spoken>({
    {"curve edges that another inner ball protrudes beyond: too few samples there",
     "curve edge that another inner ball protrudes beyond: too few samples there"},
    {"intervals of the curves with too few samples to stand for them, epsilon above 1",
     "interval of the curves with too few samples to stand for it, epsilon above 1"},
    {"pairs of neighbours along the curves that the crust does not join",
     "pair of neighbours along the curves that the crust does not join"},
    {"samples inside the shape, on shared borders, or where its border meets itself",
     "sample inside the shape, on a shared border, or where its border meets itself"},
    {"edges at which inside and outside contradict the crust",
     "edge at which inside and outside contradict the crust"},
    {"samples with an odd number of curve edges instead of two: corners, noise, ends of strokes",
     "sample with an odd number of curve edges instead of two: a corner, noise, the end of a stroke"},
    {"samples on no curve", "sample on no curve"},
    {"triangles misjudged by rounding: their balls have a common sample, so their orthogonal radius is zero",
     "triangle misjudged by rounding: its balls have a common sample, so its orthogonal radius is zero"},
    {"v-points that are not samples, by rounding or in truth",
     "v-point that is not a sample, by rounding or in truth"},
    {"v-points that are not samples", "v-point that is not a sample"},
    {"contradictions between dual complex and Voronoi diagram of the v-points",
     "contradiction between dual complex and Voronoi diagram of the v-points"},
    {"points that are not finite, left out of sums and drawing",
     "point that is not finite, left out of sums and drawing"},
    {"differences of the axis from the dual complex in Euler characteristic",
     "difference of the axis from the dual complex in Euler characteristic"},
});

const Name* named_family(std::string_view structure) {
  const auto found =
      std::ranges::find_if(kFamilies, [&](const Name& family) { return structure.starts_with(family.id); });
  return found == kFamilies.end() ? nullptr : found;
}

}  // namespace

Mood mood_of(FindingLevel level) {
  switch (level) {
    case FindingLevel::doubt: return Mood::doubtful;
    case FindingLevel::wrong: return Mood::wrong;
    case FindingLevel::note: break;
  }
  return Mood::quiet;
}

Checking checking_of(const EngineStatus& status, bool is_outdated) {
  if (status.cancelled) return Checking::cancelled;
  if (is_outdated || (status.busy && status.busy_ms >= kShownAfterMs)) return Checking::under_way;
  return Checking::done;
}

VerdictWord verdict_word(const SamplingVerdict& verdict, bool lacks_memory, Checking checking) {
  const auto without_verdict = [](Mood mood, std::string_view word, std::string_view meaning) {
    return VerdictWord{mood, word, meaning, std::string(meaning)};
  };
  if (checking == Checking::under_way)
    return without_verdict(Mood::quiet, "Checking", "The verdict on these samples is being computed");
  if (checking == Checking::cancelled)
    return without_verdict(Mood::warning, "Not checked", "The computation was cancelled; resume it for an answer");
  switch (verdict.light) {
    case TheoremLight::green:
      return {
          Mood::good, "Proved",
          "The one-step axis is the medial axis of the union of the inner balls: proved exactly for these samples",
          verdict.text()};
    case TheoremLight::yellow:
      return {Mood::doubtful, "Not proved",
              "Computed exactly, but the samples are not dense enough everywhere. Click for the positions",
              verdict.text()};
    case TheoremLight::red:
      return {Mood::wrong, "Wrong", "The chosen number type gave a wrong or inconsistent result. Click to see what",
              verdict.text()};
    case TheoremLight::none: break;
  }
  if (lacks_memory)
    return without_verdict(Mood::warning, "No memory",
                           "Not enough memory for an answer. Undo, hide layers or open a smaller file");
  return {Mood::quiet, "Nothing to prove", "The theorem is about inner balls of samples, and these have none",
          verdict.text()};
}

std::string text_of(const Finding& finding, std::string_view structure) {
  std::string_view text = finding.text;
  const std::string prefix = std::string(structure) + ": ";
  const Name* const family = named_family(structure);
  if (text.starts_with(prefix)) text.remove_prefix(prefix.size());
  if (finding.count == 1)
    if (const auto found = std::ranges::find(kSpokenFindings, text, &Spoken::several); found != kSpokenFindings.end())
      text = found->one;
  const std::string out = grouped(static_cast<std::size_t>(finding.count)) + ' ' + std::string(text);
  return family == nullptr ? out : out + " (union of " + std::string(family->name) + ')';
}

std::string structure_name(std::string_view id) {
  if (const auto found = std::ranges::find(kNames, id, &Name::id); found != kNames.end())
    return std::string(found->name);
  if (const Name* const family = named_family(id)) {
    const auto made = std::ranges::find(kOfBalls, id.substr(family->id.size()), &Name::id);
    if (made != kOfBalls.end()) return std::string(made->name) + std::string(family->name);
  }
  std::string out(id);
  std::ranges::replace(out, '-', ' ');
  return out;
}

std::string task_text(std::string_view task) {
  if (task.empty()) return "Computing";
  return (task == kCertificate ? "Checking " : "Computing ") + structure_name(task);
}

}  // namespace mes
