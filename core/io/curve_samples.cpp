// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/curve_samples.h"

#include <memory>
#include <utility>

#include "core/document/taken_samples.h"
#include "core/io/text_numbers.h"

namespace mes {

Expected<LoadedFile> load_samples(CurveSet curves, const SamplingRequest& request, const std::string& name,
                                  ReadJob& job) {
  auto samples = sample(curves, request, {}, job.control());
  if (!samples) return bad_input(samples.error().text, name, 1, 1);
  if (samples->positions.empty()) return bad_input("there is nothing in it to take samples of", name, 1, 1);
  auto data = taken_from(std::make_shared<const CurveSet>(std::move(curves)), *std::move(samples), request);
  if (!data) return bad_input(data.error().text, name, 1, 1);
  LoadedFile file;
  file.data = *std::move(data);
  return file;
}

}  // namespace mes
