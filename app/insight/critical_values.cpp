// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/insight/critical_values.h"

#include "core/structures/filters/lambda_axis.h"
#include "core/workbench/workbench.h"

namespace mes {

Expected<std::vector<double>> critical_values_of(const Registry& registry, const SampleData& data, JobControl& job) {
  Workbench bench(registry, {.keeps_document = false});
  bench.need<LambdaAxis>();
  if (auto good = bench.load({.positions = data.positions}); !good) return std::unexpected(good.error());
  if (auto good = bench.run_or_throw(job); !good) return std::unexpected(good.error());
  return bench.get<LambdaAxis>().critical_values();
}

void CriticalValues::follow(std::uint64_t document, const std::function<SampleData()>& data) {
  latest_.follow(document, [&] {
    return [registry = registry_.share(), samples = data()](JobControl& job) {
      return critical_values_of(*registry, samples, job);
    };
  });
}

}  // namespace mes
