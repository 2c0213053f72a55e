// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/balls/internal/numbers/root_numbers.h"
#include "core/structures/balls/internal/pipeline/union_pipeline.h"

namespace mes {

UnionTables run_union_roots(const PipelineInput& input, JobControl& job) {
  return union_pipeline::run<RootsKernel, RootsKernel>(input, job);
}

}  // namespace mes
