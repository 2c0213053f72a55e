// SPDX-License-Identifier: GPL-3.0-or-later
// The settings of a session, where the command line gives none. A file that is a session, or carries one, means the same
// to every command; each parameter that the command names replaces that of the session.
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

#include "app/cli/requests.h"
#include "core/base/error.h"
#include "core/base/slot.h"
#include "core/document/computation_settings.h"
#include "core/evolutions/evolution.h"
#include "core/io/format.h"
#include "core/io/session.h"

namespace mes {
class Registry;
}

namespace mes::cli {

struct SourceInput {
  LoadedFile file;
  ComputationSettings settings;
  /// Null: the file is none.
  const Session* session() const { return file.session.get(); }
};
/// The file of the command, and what to compute by. Errors of `read_input` and `settings_of`.
Expected<SourceInput> read_source(const Registry& registry, const Source& source);

/// The layers of `select_layers(ids)` where the command names any; or those that the session (null: none) shows, bottom
/// first; or those that are visible at start. How many the session has that are not known here is said.
Expected<std::vector<LayerIndex>> shown_layers(const Registry& registry, const std::string& ids,
                                               const Session* session);

/// The evolution that the session (null: none) has on its slider, with seed and parameters; nothing if it has none.
std::optional<EvolutionChoice> evolution_in(const Registry& registry, const Session* session);

/// The same for a session of its document alone: without the edits, the samples are state 0; a parameter that is moved has
/// taken its steps.
SessionEvolution evolution_without_history(const Registry& registry, const Session& session);

/// "the session: 2 layers are not available here"; `what` has them.
void say_unknown_layers(std::size_t count, const std::string& what);

}  // namespace mes::cli
