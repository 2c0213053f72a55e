// SPDX-License-Identifier: GPL-3.0-or-later
// The commands. Each writes its result and nothing else, or reports why it cannot.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/cli/console/interruption.h"
#include "app/cli/requests/requests.h"
#include "core/base/error.h"

namespace mes {
class Registry;
}

namespace mes::cli {

Expected<void> run_compute(const Registry& registry, const ComputeRequest& request, Interruption& interruption);
Expected<void> run_sweep(const Registry& registry, const SweepRequest& request, Interruption& interruption);
Expected<void> run_branches(const Registry& registry, const BranchesRequest& request, Interruption& interruption);
Expected<void> run_centerline(const Registry& registry, const CenterlineRequest& request, Interruption& interruption);
Expected<void> run_persistence(const Registry& registry, const PersistenceRequest& request,
                               Interruption& interruption);
Expected<void> run_repair(const Registry& registry, const ResampleRequest& request, Interruption& interruption);
Expected<void> run_decimate(const Registry& registry, const ResampleRequest& request, Interruption& interruption);
Expected<void> run_export(const Registry& registry, const ExportRequest& request, Interruption& interruption);
/// Writes Voronoi cells.
Expected<void> run_cell_export(const Registry& registry, const ExportRequest& request, Interruption& interruption);
/// Writes a table of a structure.
Expected<void> run_table_export(const Registry& registry, const ExportRequest& request, Interruption& interruption);
Expected<void> run_render(const Registry& registry, const RenderRequest& request, Interruption& interruption);
Expected<void> run_play(const Registry& registry, const PlayRequest& request, Interruption& interruption);
Expected<void> run_demo(const Registry& registry, const DemoRequest& request, Interruption& interruption);
Expected<void> run_lesson(const Registry& registry, const LessonRequest& request, Interruption& interruption);
Expected<void> run_evolve(const Registry& registry, const EvolveRequest& request, Interruption& interruption);
Expected<void> run_shape(const Registry& registry, const ShapeCommand& request, Interruption& interruption);
Expected<void> run_sample(const Registry& registry, const SampleRequest& request, Interruption& interruption);
Expected<void> run_text(const TextCommand& request, Interruption& interruption);
Expected<void> run_list(const Registry& registry, const ListRequest& request, Interruption& interruption);
Expected<void> run_new(const Registry& registry, const NewRequest& request, Interruption& interruption);
Expected<void> run_check(const Registry& registry, const CheckRequest& request, Interruption& interruption);

/// The kinds of experiments that `new` can begin.
std::vector<std::string> things_to_begin();

/// The kinds of things that `list` can list.
std::vector<std::string> listed_things();

/// The formats of `export`, by their ids.
std::span<const std::string_view> export_formats();

/// The formats of `centerline`, by their ids.
std::span<const std::string_view> centerline_formats();

}  // namespace mes::cli
