// SPDX-License-Identifier: GPL-3.0-or-later
// `--compare` of `mesecina render`: the panes side by side.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/cli/requests/picture_request.h"
#include "app/cli/requests/requests.h"
#include "app/export/comparison.h"
#include "app/layers/ball_families.h"
#include "core/base/error.h"
#include "core/document/settings/pane_choice.h"
#include "core/evolutions/evolution.h"
#include "core/io/session/session.h"

namespace mes {
class Registry;
}

namespace mes::cli {

/// A comparison, interpreted as far as possible without the samples.
struct CompareRequest {
  enum class Subject : std::uint8_t { nothing, precision, parameter, family, bundle, step };
  Subject subject = Subject::nothing;
  std::vector<std::string> words;     ///< label of each pane, e.g. "precision exact"
  std::vector<Precision> precisions;  ///< one per pane, if number types are compared
  Parameter parameter{};              ///< the parameter that is compared
  std::vector<double> values;         ///< its values
  std::vector<FamilyKind> families;
  std::vector<PictureRequest> bundles;  ///< including their layers
  std::vector<std::uint64_t> steps;     ///< steps of `evolution`
  EvolutionChoice evolution{};
};

/// The subjects that `--compare` accepts.
std::vector<std::string_view> compared_subjects(const Registry& registry);

/// Interprets the option; an evolution without a name stays unknown. Error: `usage` with the possible words;
/// `bad_input` for a bundle that cannot be read.
Expected<CompareRequest> understand_comparison(const Registry& registry, const RenderRequest& request,
                                               std::span<const render::ColorMap> maps);

/// Completes the evolution whose steps are compared from the session (nothing: it has none): its id, parameters and
/// seed. Error: `usage` if neither names an evolution.
Expected<void> take_evolution(const Registry& registry, CompareRequest& compared, const RenderRequest& request,
                              const std::optional<EvolutionChoice>& of_session);

/// The panes; `picture`, `settings` and `data` are their common part. Computes the steps of an evolution. Error:
/// `usage` for layers without the compared families; errors of the evolution.
Expected<std::vector<PaneRequest>> panes_of(const CompareRequest& compared, const PictureRequest& picture,
                                            const ComputationSettings& settings,
                                            const std::shared_ptr<const SampleData>& data);

/// The comparison in a session: panes beside the main one, which is the first one, or the document itself if it is
/// not among the steps; at most as many as a session can hold.
std::vector<PaneChoice> panes_beside(const CompareRequest& compared);
/// The evolution whose states the panes show; nothing for other comparisons.
SessionEvolution evolution_beside(const Registry& registry, const CompareRequest& compared);

}  // namespace mes::cli
