// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/internal/union_pipeline.h"

namespace mes {

UnionTables run_union_doubles(const PipelineInput& input, JobControl& job) {
  return UnionPipeline<FastKernel, FastKernel>(input, false, job).run();
}

}  // namespace mes
