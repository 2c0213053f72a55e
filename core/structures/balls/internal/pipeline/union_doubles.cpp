// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/balls/internal/complex/power_diagram.h"
#include "core/structures/balls/internal/pipeline/union_pipeline.h"

namespace mes {

UnionTables run_union_doubles(const PipelineInput& input, JobControl& job) {
  return union_pipeline::run<FastKernel, FastKernel>(input, job);
}

Table<PowerEdgeSlot, PowerEdge> run_power_diagram_doubles(const PipelineInput& input, JobControl& job) {
  return power_diagram<FastKernel>(input, job);
}

UnionTables run_v_diagram(const PipelineInput& input, const KnownVPoints& known, JobControl& job) {
  return union_pipeline::run_v_diagram<FastKernel, FastKernel>(input, known, job);
}

}  // namespace mes
