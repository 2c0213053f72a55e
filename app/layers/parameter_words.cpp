// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/layers/parameter_words.h"

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "core/draw/layer_descriptor.h"

namespace mes {
namespace {

using Words = std::string_view;

constexpr std::array<Words, 4> kSchemes{"Cubic B-spline", "Corner cutting (Chaikin)",
                                        "Four-point, through every sample", "Midpoints"};
constexpr std::array<Words, 2> kNoise{"Along the normal", "In every direction"};

constexpr std::array<Words, 3> kAngleModes{"Each point by its own angle", "Edges by their largest angle",
                                           "Edges by the mean of their ends"};

struct Title {
  Words id;
  Words title;
};
constexpr auto kTitles = std::to_array<Title>({{"medial-sampling-angle", "Angle of sampled balls"},
                                               {"union-shortcut", "Certified shortcut for unions"},
                                               {"pole-propagation", "Pole labels by propagation"},
                                               {"lambda-limit", "Lambda: limit"},
                                               {"angle-limit", "Object angle: limit"},
                                               {"angle-mode", "Object angle of an edge"},
                                               {"keep-topology", "Filters keep the topology"},
                                               {"scale-axis-factor", "Scale axis: factor"},
                                               {"scale-skeleton-step", "Scale skeleton: step"},
                                               {"alpha-radius", "Alpha complex: radius"},
                                               {"smooth-mu", "Way to the middle"},
                                               {"smooth-back", "Way back"},
                                               {"smooth-keep-area", "Keep the area of loops"},
                                               {"subdivide-scheme", "Scheme"},
                                               {"noise-factor", "Strength"},
                                               {"noise-isotropic", "Direction"},
                                               {"growing-step", "Step"},
                                               {"alpha-step", "Step"},
                                               {"freeze-chains", "Keep the order of the beginning"}});
constexpr auto kSpokenExplanations = std::to_array<Title>(
    {{"angle-mode", "What stands for an axis edge, along which the angle varies"},
     {"subdivide-scheme", "What the curve through the samples becomes"},
     {"noise-isotropic", "Where a sample may move"},
     {"smooth-back",
      "How far it then goes back, which keeps the curve from shrinking (Taubin); usually a little more than the way "
      "to "
      "the middle. 0: it does not go back"},
     {"noise-factor", "Largest distance a sample moves, as a multiple of the distance between its two neighbours"},
     {"alpha-radius",
      "Radius of the disks about the samples. Balls grow with it: one of radius r has the radius sqrt(r^2 + "
      "alpha-radius^2)"},
     {"growing-step", "How much is added in each step to the factor by which radii are multiplied or divided"},
     {"freeze-chains",
      "Where the document has no contours. On: the crust of the beginning says who follows whom; off: the crust of "
      "each step does"}});
constexpr std::array<std::pair<Words, LayerGroup>, 3> kFamilyGroups{
    {{"a-", LayerGroup::union_a}, {"p-", LayerGroup::union_p}, {"b-", LayerGroup::union_b}}};

std::string words_of(Words id) {
  std::string out(id);
  std::ranges::replace(out, '-', ' ');
  return out;
}

void replace(std::string& text, Words what, Words by) {
  if (const std::size_t at = text.find(what); at != std::string::npos) text.replace(at, what.size(), by);
}

}  // namespace

std::string title_of(const ParameterDescriptor& descriptor) {
  if (const auto found = std::ranges::find(kTitles, descriptor.id, &Title::id); found != kTitles.end())
    return std::string(found->title);
  for (const auto& [prefix, group] : kFamilyGroups)
    if (descriptor.id.starts_with(prefix))
      return std::string(title_of(group)) + ": " + words_of(descriptor.id.substr(prefix.size()));
  std::string out = words_of(descriptor.id);
  if (!out.empty()) out[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(out[0])));
  return out;
}

std::span<const std::string_view> choices_of(const ParameterDescriptor& descriptor) {
  if (descriptor.id == "subdivide-scheme") return kSchemes;
  if (descriptor.id == "noise-isotropic") return kNoise;
  if (descriptor.id == "angle-mode") return kAngleModes;
  return {};
}

std::string beyond_words(const std::string& title, double number, double low, double high) {
  return number < low ? fmt::format("{}: {} is below {}, which is taken instead", title, number, low)
                      : fmt::format("{}: {} is above {}, which is taken instead", title, number, high);
}

std::string spoken_explanation(const ParameterDescriptor& descriptor) {
  if (const auto found = std::ranges::find(kSpokenExplanations, descriptor.id, &Title::id);
      found != kSpokenExplanations.end())
    return std::string(found->title);
  std::string out(descriptor.explanation);
  if (!is_switch(descriptor)) return out;
  const bool begins_with_off = out.starts_with("0: ");
  replace(out, begins_with_off ? "0: " : "1: ", begins_with_off ? "Off: " : "On: ");
  replace(out, begins_with_off ? "; 1: " : "; 0: ", begins_with_off ? "; on: " : "; off: ");
  return out;
}

}  // namespace mes
