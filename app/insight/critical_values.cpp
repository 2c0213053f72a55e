// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/insight/critical_values.h"

#include <new>
#include <utility>

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
  is_followed_ = true;
  wanted_ = document;
  if (auto found = job_.poll()) found_ = *std::move(found);
  // One at a time: while samples are dragged, the next begins when this one has ended.
  if (job_.is_under_way() || job_.is_ending() || (found_ && found_->document == wanted_)) return;
  job_.begin([registry = registry_.share(), document, samples = data()](const std::stop_token& stop) -> Found {
    Found out{document, {}, {}};
    JobControl job(stop);
    try {
      if (auto values = critical_values_of(*registry, samples, job))
        out.values = *std::move(values);
      else
        out.problem = values.error().text;
    } catch (const Cancelled&) {
      // The result is dropped.
    } catch (const std::bad_alloc&) {
      out.problem = "there is not enough memory";
    }
    return out;
  });
}

}  // namespace mes
