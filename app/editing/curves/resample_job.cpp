// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editing/curves/resample_job.h"

#include <new>
#include <utility>

namespace mes {

void ResampleJob::begin(Wish wish) {
  begun_at_ = editor_.document().revision();
  job_.begin([registry = registry_.share(), wish, wanted = epsilon,
              data = data_of(editor_.document())](const std::stop_token& stop) -> Found {
    Found out{wish, {}, {}, {}};
    JobControl job(stop);
    try {
      if (wish == Wish::repair) {
        auto repaired = repair(*registry, data, wanted, job);
        if (repaired)
          out.repaired = *std::move(repaired);
        else
          out.problem = repaired.error().message();
      } else {
        auto decimated = decimate(*registry, data, wanted, job);
        if (decimated)
          out.decimated = *std::move(decimated);
        else
          out.problem = decimated.error().message();
      }
    } catch (const Cancelled&) {
      out.problem = "the computation was stopped";
    } catch (const GeometryError& error) {
      out.problem = error.what();
    } catch (const std::bad_alloc&) {
      out.problem = "there is not enough memory";
    }
    return out;
  });
}

// The repair numbers samples from the first one of the document, dead ones included.
Expected<void> ResampleJob::apply(const Repair& repaired) {
  const Document& document = editor_.document();
  if (repaired.inserted == 0) return {};
  TimelineEdit edit{.name = "Repair the sampling"};
  const std::size_t old = repaired.data.positions.size() - repaired.inserted;
  edit.inserted.assign(repaired.data.positions.begin() + static_cast<std::ptrdiff_t>(old),
                       repaired.data.positions.end());
  if (!repaired.data.contours.empty()) {
    const std::vector<SampleSlot> slots = document.slots_in_input_order();
    const auto first = document.first_id().value;
    const auto known = document.next_id().value - first;
    edit.curve = repaired.data.contours;
    for (SampleData::Contour& contour : *edit.curve)
      for (std::uint32_t& sample : contour.points)
        sample = static_cast<std::uint32_t>(sample < old ? document.id(slots[sample]).value - first
                                                         : known + (sample - old));
  }
  // Samples on the curves are replaced when others are taken of these curves.
  const std::shared_ptr<const CurveSource>& source = document.source();
  const auto known = document.next_id().value - document.first_id().value;
  if (repaired.is_on_curves && source && source->first + source->count == known)
    edit.source = SourceEdit{.sampling = source->sampling,
                             .first = source->first,
                             .count = source->count + static_cast<std::uint32_t>(repaired.inserted)};
  return editor_.perform(edit);
}

Expected<void> ResampleJob::apply(const Decimation& decimated) {
  if (decimated.removed.empty()) return {};
  const Document& document = editor_.document();
  const std::vector<SampleSlot> slots = document.slots_in_input_order();
  std::vector<SampleId> ids;
  for (const std::uint32_t sample : decimated.removed) ids.push_back(document.id(slots[sample]));
  return editor_.remove(ids, "Decimate the sampling");
}

ResampleJob::Report ResampleJob::report_of(const Found& found) {
  const auto refused = [](std::string text) { return Report{true, {std::move(text)}, {}, {}}; };
  if (!found.problem.empty()) return refused(found.problem);
  if (editor_.document().revision() != begun_at_)
    return refused("The samples were edited meanwhile, so nothing was done to them");
  const auto done = found.repaired ? apply(*found.repaired) : apply(*found.decimated);
  if (!done) return refused(done.error().message());
  if (found.decimated) return {false, {found.decimated->words()}, {}, {}};
  Report out{false, found.repaired->words(), found.repaired->corners, found.repaired->left};
  out.places.insert(out.places.end(), found.repaired->open_ends.begin(), found.repaired->open_ends.end());
  return out;
}

std::optional<ResampleJob::Report> ResampleJob::follow() {
  if (editor_.in_gesture()) return std::nullopt;
  const auto found = job_.poll();
  if (!found) return std::nullopt;
  last_ = report_of(*found);
  reported_at_ = editor_.document().revision();
  return last_;
}

}  // namespace mes
