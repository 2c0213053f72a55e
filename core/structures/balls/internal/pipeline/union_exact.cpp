// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/balls/internal/complex/power_diagram.h"
#include "core/structures/balls/internal/pipeline/union_pipeline.h"

namespace mes {

UnionTables run_union_exact(const PipelineInput& input, JobControl& job) {
  return union_pipeline::run<ExactKernel, CrossingKernel>(input, job);
}

UnionTables run_dual_complex_exact(const PipelineInput& input, JobControl& job) {
  return union_pipeline::run_dual_complex<ExactKernel, ExactKernel>(input, job);
}

Table<PowerEdgeSlot, PowerEdge> run_power_diagram_exact(const PipelineInput& input, JobControl& job) {
  return power_diagram<ExactKernel>(input, job);
}

}  // namespace mes
