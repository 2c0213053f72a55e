// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/store/trace_job.h"

#include <algorithm>
#include <new>
#include <span>
#include <utility>

#include "core/io/files/read_file.h"
#include "core/io/format.h"
#include "core/raster/picture_decoder.h"

namespace mes {
namespace {

constexpr int kLongestSide = 1024;
constexpr std::uint64_t kMostPictureBytes = std::uint64_t{1} << 28U;

Expected<TracePreview> read_preview(const std::filesystem::path& file, const std::stop_token& stop) try {
  JobControl job(stop);
  const auto bytes = read_regular_file(file, {.job = &job, .most_bytes = kMostPictureBytes});
  if (!bytes) return std::unexpected(bytes.error());
  auto pixels = decode_pixels(std::as_bytes(std::span(*bytes)), file.string(), 0, kMostPicturePixels,
                              PictureTurn::upright, &job);
  if (!pixels) return std::unexpected(std::move(pixels.error()));
  TracePreview out{.image = gray_of(*std::move(pixels))};
  out.histogram = histogram_of(out.image);
  out.level = otsu_level(out.histogram);
  out.specks = default_specks(out.image);
  while (std::max(out.image.width, out.image.height) > kLongestSide) {
    GrayImage half = halved(out.image);
    if (!out.whole) out.whole = std::make_shared<const GrayImage>(std::move(out.image));
    out.image = std::move(half);
    out.reduction *= 2.0;
  }
  return out;
} catch (const std::bad_alloc&) {
  return std::unexpected(Error{ErrorCode::out_of_memory, "there is not enough memory for it", file.string()});
}

Expected<TraceJob::Samples> read_samples(const Registry& registry, const std::filesystem::path& file,
                                         const TraceRequest& request, const std::stop_token& stop) {
  JobControl job(stop);
  auto loaded = read_sample_file(file, "picture", &job, {.trace = request, .formats = &registry.formats()});
  if (!loaded) return std::unexpected(std::move(loaded.error()));
  TraceJob::Samples out{.data = std::move(loaded->data)};
  for (const std::string& warning : loaded->warnings) out.remark += (out.remark.empty() ? "" : "; ") + warning;
  return out;
}

}  // namespace

void TraceJob::begin(const std::filesystem::path& file) {
  end();
  file_ = file;
  reading_.begin([file](const std::stop_token& stop) { return read_preview(file, stop); });
}

void TraceJob::end() {
  reading_.give_up();
  deciding_.give_up();
  tracing_.give_up();
  preview_.reset();
  decision_.reset();
  traced_.reset();
  outlines_ = {};
}

std::optional<Expected<void>> TraceJob::poll_picture() {
  auto read = reading_.poll();
  if (!read) return std::nullopt;
  if (!*read) return std::unexpected(read->error());
  preview_ = std::move(**read);
  traced_.reset();
  ++number_;
  return Expected<void>();
}

void TraceJob::follow() {
  if (auto decision = deciding_.poll()) decision_ = *std::move(decision);
}

// One at a time, so that dragging a slider does not restart the job at every step.
void TraceJob::decide(const TraceRequest& request) {
  if (!preview_->whole || deciding_.is_under_way() || (decision_ && decision_->request == request)) return;
  deciding_.begin([whole = preview_->whole, request](const std::stop_token& stop) {
    const JobControl job(stop);
    Decision out{request};
    try {
      if (const auto counts = counts_of_tracing(*whole, request, &job)) out.counts = *counts;
    } catch (const std::bad_alloc&) {
      // Without memory for the count, the preview stays as it is.
    }
    return out;
  });
}

const Expected<Tracing>& TraceJob::outlines(const TraceRequest& request) {
  if (!preview_) return outlines_;
  decide(request);
  TraceRequest reduced = request;
  reduced.pixel_area = preview_->reduction * preview_->reduction;
  if (reduced.specks) *reduced.specks /= reduced.pixel_area;
  const Traced wanted{reduced,
                      decision_ ? std::optional(decision_->counts.blur / preview_->reduction) : std::nullopt};
  if (traced_ == wanted) return outlines_;
  outlines_ =
      wanted.blur ? trace_blurred(preview_->image, reduced, *wanted.blur) : mes::trace(preview_->image, reduced);
  traced_ = wanted;
  return outlines_;
}

std::optional<TraceCounts> TraceJob::counts(const TraceRequest& request) {
  const Expected<Tracing>& shown = outlines(request);
  if (!preview_ || !shown) return std::nullopt;
  if (!preview_->whole) return shown->counts;
  return decision_ && decision_->request == request ? std::optional(decision_->counts) : std::nullopt;
}

void TraceJob::trace(const TraceRequest& request) {
  tracing_.begin([registry = registry_.share(), file = file_, request](const std::stop_token& stop) {
    return read_samples(*registry, file, request, stop);
  });
}

std::optional<Expected<TraceJob::Samples>> TraceJob::poll_samples() {
  return tracing_.poll();
}

}  // namespace mes
