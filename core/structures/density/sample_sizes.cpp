// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/density/sample_sizes.h"

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <utility>

#include "core/document/commands.h"
#include "core/document/taken_samples.h"
#include "core/structures/crust/one_step_crust.h"
#include "core/structures/delaunay/delaunay.h"
#include "core/structures/density/feature_size.h"
#include "core/structures/inputs/samples.h"

namespace mes {

class SampleSizes::Measured {
 public:
  /// `positions` are all samples; those from `first` on are new.
  Expected<void> take(std::span<const Vec2> positions, std::size_t first, JobControl& job) {
    auto delta = first == 0 ? replace_all(document_, {.positions = {positions.begin(), positions.end()}})
                            : insert_samples(document_, positions.subspan(first));
    if (!delta) return std::unexpected(delta.error());
    document_.apply(*delta);
    samples_.post(std::make_shared<const DocumentDelta>(*std::move(delta)));
    // For the first few insertions, the trees that an update of sizes needs cost more than computing all sizes.
    constexpr int kFew = 2;
    const bool is_updated = bring_up_to_date(job, {&samples_, &delaunay_, &crust_}, first != 0);
    bring_up_to_date(job, {&sizes_}, is_updated && ++insertions_ > kFew);
    return {};
  }
  double size(std::uint32_t sample) const {
    const SiteSlot site = delaunay_.site_of_sample(SampleSlot(sample));
    return sizes_.has_size(site) ? sizes_.size(site) : std::numeric_limits<double>::infinity();
  }

 private:
  /// False if one of the structures was rebuilt.
  static bool bring_up_to_date(JobControl& job, std::initializer_list<Structure*> structures, bool may_update) {
    for (Structure* structure : structures) structure->clear_changes();
    for (Structure* structure : structures) {
      job.checkpoint();
      may_update = may_update && structure->update(job);
      if (!may_update) structure->rebuild(job);
    }
    return may_update;
  }

  int insertions_ = 0;
  Document document_;
  Samples samples_;
  Delaunay delaunay_{samples_};
  OneStepCrust crust_{delaunay_};
  FeatureSize sizes_{delaunay_, crust_};
};

SampleSizes::SampleSizes(JobControl& job) : job_(job) {}
SampleSizes::~SampleSizes() = default;

Expected<std::vector<double>> SampleSizes::of(std::span<const Vec2> positions) {
  std::vector<Vec2> wanted(positions.begin(), positions.end());
  if (std::string fault = bring_into_range(wanted); !fault.empty())
    return std::unexpected(Error{ErrorCode::bad_input, "of the samples, " + fault});
  // Beyond this share of new samples a rebuild is quicker.
  constexpr std::size_t kMany = 32;
  const std::size_t before = positions_.size();
  const bool goes_on = measured_ && before != 0 && before <= wanted.size() &&
                       kMany * (wanted.size() - before) < before &&
                       std::equal(positions_.begin(), positions_.end(), wanted.begin());
  positions_.clear();  // invalid until all is done
  if (!goes_on) measured_ = std::make_unique<Measured>();
  if (auto done = measured_->take(wanted, goes_on ? before : 0, job_); !done) return std::unexpected(done.error());
  positions_ = std::move(wanted);
  std::vector<double> out;
  out.reserve(positions_.size());
  for (std::uint32_t i = 0; i < positions_.size(); ++i) out.push_back(measured_->size(i));
  return out;
}

}  // namespace mes
