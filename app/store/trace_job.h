// SPDX-License-Identifier: GPL-3.0-or-later
// Turns a picture into samples: reads it, previews its outlines, traces it.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "app/system/background_job.h"
#include "core/base/error.h"
#include "core/document/sample_data.h"
#include "core/graph/live_registry.h"
#include "core/raster/trace.h"

namespace mes {

/// The data shown of a picture while the user chooses its threshold.
struct TracePreview {
  GrayImage image{};                         ///< reduced to about a thousand pixels per side
  double reduction = 1.0;                    ///< pixels of the file per pixel of `image`, along a side
  Histogram histogram{};                     ///< histogram of the file
  std::optional<Level> level{};              ///< the best level; nothing if all pixels are alike
  double specks = 0.0;                       ///< default in square pixels of the file, by its size
  std::shared_ptr<const GrayImage> whole{};  ///< the picture of the file, if `image` is reduced
};

/// Guarantees: it never waits for a file; outlines of the preview are computed at once, in milliseconds. Whether and
/// how much to blur depends on the whole picture and is found out on another thread; until then the answer of the
/// previous request is used. That thread also counts outlines and specks as the tracing will, because a reduced
/// picture has fewer specks.
///
/// Smallest use:
///     job.begin("leaf.png");
///     ... each frame: if (auto read = job.poll_picture()) ...;
///                     if (job.preview()) job.follow(), show(job.outlines(request));
///     job.trace(request);
///     ... each frame: if (auto traced = job.poll_samples()) ...
///
/// Threads: the window's; `wake` is called from the reading ones.
class TraceJob {
 public:
  TraceJob(LiveRegistry registry, Waker wake)
      : registry_(std::move(registry)), reading_(wake), deciding_(wake), tracing_(std::move(wake)) {}

  void begin(const std::filesystem::path& file);
  /// Forgets the picture, and gives up all work under way.
  void end();
  bool is_busy() const { return reading_.is_under_way() || deciding_.is_under_way() || tracing_.is_under_way(); }
  bool is_tracing() const { return tracing_.is_under_way(); }
  const std::filesystem::path& file() const { return file_; }

  /// Whether the picture could be read, given once; if so, `preview` is set.
  std::optional<Expected<void>> poll_picture();
  const TracePreview* preview() const { return preview_ ? &*preview_ : nullptr; }
  /// A number unique to this picture.
  std::uint64_t preview_number() const { return number_; }
  /// Called once per frame: takes the results for the whole picture.
  void follow();
  /// Outlines in pixels of the preview. `request` refers to the file, and has threshold and specks. Computed when the
  /// request differs from the last one.
  const Expected<Tracing>& outlines(const TraceRequest& request);

  /// The counts of outlines to trace and to leave out in the whole picture; nothing while they are being counted, or
  /// if there are no outlines. After `outlines` the call is free.
  std::optional<TraceCounts> counts(const TraceRequest& request);

  void trace(const TraceRequest& request);
  struct Samples {
    SampleData data{};
    std::string remark{};  ///< a remark on the traced and omitted outlines
  };
  /// The samples, given once when tracing has ended.
  std::optional<Expected<Samples>> poll_samples();

 private:
  LiveRegistry registry_;
  std::filesystem::path file_;
  std::optional<TracePreview> preview_;
  std::uint64_t number_ = 0;
  /// The parameters that the whole picture needs.
  struct Decision {
    TraceRequest request{};
    TraceCounts counts{};  // counts of the file, in its pixels
  };
  void decide(const TraceRequest& request);
  std::optional<Decision> decision_;
  /// The last request for the preview and its outlines.
  struct Traced {
    TraceRequest request{};
    std::optional<double> blur{};
    friend bool operator==(const Traced&, const Traced&) = default;
  };
  std::optional<Traced> traced_;
  Expected<Tracing> outlines_;
  BackgroundJob<Expected<TracePreview>> reading_;
  BackgroundJob<Decision> deciding_;
  BackgroundJob<Expected<Samples>> tracing_;
};

}  // namespace mes
