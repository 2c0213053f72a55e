// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editing/curves/sample_making.h"

#include <new>
#include <utility>

namespace mes {

void SampleMaking::want(Call call) {
  wanted_ = std::move(call);
  if (!job_.is_under_way()) begin();
}

void SampleMaking::begin() {
  job_.begin([call = std::exchange(wanted_, nullptr)](const std::stop_token& stop) {
    JobControl job(stop);
    try {
      return call(job);
    } catch (const std::bad_alloc&) {
      return Made{std::unexpected(Error{ErrorCode::out_of_memory, "there is not enough memory for these samples"})};
    }
  });
}

void SampleMaking::stop() {
  job_.give_up();
  wanted_ = nullptr;
  is_accepted_ = false;
}

void SampleMaking::follow() {
  if (auto made = job_.poll()) {
    made_ = std::move(made);
    if (wanted_) begin();
  }
  if (!is_busy() && !is_possible()) is_accepted_ = false;
}

}  // namespace mes
