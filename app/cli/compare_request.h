// SPDX-License-Identifier: GPL-3.0-or-later
// `--compare` of `mesecina render`: what is shown side by side.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/cli/picture_request.h"
#include "app/cli/requests.h"
#include "app/export/comparison.h"
#include "app/layers/ball_families.h"
#include "core/base/error.h"
#include "core/document/pane_choice.h"
#include "core/evolutions/evolution.h"
#include "core/io/session.h"

namespace mes {
class Registry;
}

namespace mes::cli {

/// What is compared, understood as far as it can be without the samples.
struct CompareRequest {
  enum class Subject : std::uint8_t { nothing, precision, parameter, family, bundle, step };
  Subject subject = Subject::nothing;
  std::vector<std::string> words;     ///< of each pane, as "precision exact"
  std::vector<Precision> precisions;  ///< one a pane, where these are compared
  Parameter parameter{};              ///< the one that is compared
  std::vector<double> values;         ///< of it
  std::vector<FamilyKind> families;
  std::vector<PictureRequest> bundles;  ///< with their layers
  std::vector<std::uint64_t> steps;     ///< of `evolution`
  EvolutionChoice evolution{};
};

/// What `--compare` can compare.
std::vector<std::string_view> compared_subjects(const Registry& registry);

/// An evolution that is not named is not yet known. Error: `usage`, naming what there is; `bad_input` for a bundle that
/// cannot be read.
Expected<CompareRequest> understand_comparison(const Registry& registry, const RenderRequest& request,
                                               std::span<const render::ColorMap> maps);

/// Takes what the command does not say of the evolution whose steps are compared from the session (nothing: it has none):
/// which it is, its parameters and its seed. Error: `usage` where neither names one.
Expected<void> take_evolution(const Registry& registry, CompareRequest& compared, const RenderRequest& request,
                              const std::optional<EvolutionChoice>& of_session);

/// The panes, where `picture`, `settings` and `data` say what all have in common. Steps of an evolution are computed
/// here. Error: `usage` for layers without the families that are compared; that of the evolution.
Expected<std::vector<PaneRequest>> panes_of(const CompareRequest& compared, const PictureRequest& picture,
                                            const ComputationSettings& settings,
                                            const std::shared_ptr<const SampleData>& data);

/// What a session says of the comparison: panes beside the main one, which is the first one, or the document itself
/// where that is not among the steps; as many as a session can have.
std::vector<PaneChoice> panes_beside(const CompareRequest& compared);
/// The evolution whose states they show; none for other comparisons.
SessionEvolution evolution_beside(const Registry& registry, const CompareRequest& compared);

}  // namespace mes::cli
