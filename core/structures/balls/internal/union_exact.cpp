// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/balls/internal/power_diagram.h"
#include "core/structures/balls/internal/union_pipeline.h"

namespace mes {

UnionTables run_union_rational(const PipelineInput& input, JobControl& job) {
  return UnionPipeline<ExactKernel, ExactKernel>(input, true, job).run();
}

UnionTables run_union_mixed(const PipelineInput& input, JobControl& job) {
  return UnionPipeline<ExactKernel, RootsKernel>(input, true, job).run();
}

UnionTables run_union_roots(const PipelineInput& input, JobControl& job) {
  return UnionPipeline<RootsKernel, RootsKernel>(input, false, job).run();
}

UnionTables run_dual_complex_exact(const PipelineInput& input, JobControl& job) {
  return UnionPipeline<ExactKernel, ExactKernel>(input, true, job).run_dual_complex();
}

std::vector<PowerEdge> run_power_diagram_exact(const PipelineInput& input, JobControl& job) {
  return power_diagram<ExactKernel>(input, job);
}

}  // namespace mes
