// SPDX-License-Identifier: GPL-3.0-or-later
// The settings of a session as defaults of the command line. A file that is or carries a session means the same to
// every command; each parameter that the command names replaces that of the session.
//
// Smallest use:
//     const auto input = read_source(registry, request.source);
//     compute(input->file.data, input->settings, shown_layers(registry, request.layers, input->session()));
//
// Cost: that of reading the file. Threads: any.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/cli/requests/requests.h"
#include "core/base/error.h"
#include "core/base/ids.h"
#include "core/document/settings/computation_settings.h"
#include "core/evolutions/evolution.h"
#include "core/io/format.h"
#include "core/io/session/session.h"

namespace mes {
class Registry;
}

namespace mes::cli {

struct SourceInput {
  LoadedFile file;
  ComputationSettings settings;
  /// Null if the file is not a session.
  const Session* session() const { return file.session.get(); }
};
/// Reads the file of the command and the settings of the computation. Errors of `read_input` and `settings_of`.
Expected<SourceInput> read_source(const Registry& registry, const Source& source);

/// The layers of `select_layers(ids)` if the command names any; else those that the session (null: no session) shows,
/// bottom first; else those visible at start. Reports how many layers of the session are unknown here.
Expected<std::vector<LayerIndex>> shown_layers(const Registry& registry, const std::string& ids,
                                               const Session* session);

/// The evolution on the slider of the session (null: no session), with seed and parameters; nothing if it has none.
std::optional<EvolutionChoice> evolution_in(const Registry& registry, const Session* session);

/// The same for a session of its document alone: without the edits, the samples are state 0; a moved parameter has
/// already taken its steps.
SessionEvolution evolution_without_history(const Registry& registry, const Session& session);

/// Reports "the session: 2 layers are not available here"; `what` names their source.
void say_unknown_layers(std::size_t count, const std::string& what);

}  // namespace mes::cli
