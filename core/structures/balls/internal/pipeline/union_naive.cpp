// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/balls/internal/complex/power_diagram.h"
#include "core/structures/balls/internal/pipeline/union_pipeline.h"

namespace mes {

UnionTables run_union_naive(const PipelineInput& input, JobControl& job) {
  return union_pipeline::run<NaiveKernel, NaiveKernel>(input, job);
}

Table<PowerEdgeSlot, PowerEdge> run_power_diagram_naive(const PipelineInput& input, JobControl& job) {
  return power_diagram<NaiveKernel>(input, job);
}

}  // namespace mes
