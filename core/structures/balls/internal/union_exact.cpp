// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/balls/internal/power_diagram.h"
#include "core/structures/balls/internal/union_pipeline.h"

namespace mes {

UnionTables run_union_rational(const PipelineInput& input, JobControl& job) {
  return union_pipeline::run<ExactKernel, ExactKernel>(input, CrossingRule::sample, job);
}

UnionTables run_union_mixed(const PipelineInput& input, JobControl& job) {
  return union_pipeline::run<ExactKernel, RootsKernel>(input, CrossingRule::sample, job);
}

UnionTables run_union_roots(const PipelineInput& input, JobControl& job) {
  return union_pipeline::run<RootsKernel, RootsKernel>(input, CrossingRule::root, job);
}

UnionTables run_dual_complex_exact(const PipelineInput& input, JobControl& job) {
  return union_pipeline::run_dual_complex<ExactKernel, ExactKernel>(input, job);
}

Table<PowerEdgeSlot, PowerEdge> run_power_diagram_exact(const PipelineInput& input, JobControl& job) {
  return power_diagram<ExactKernel>(input, job);
}

}  // namespace mes
