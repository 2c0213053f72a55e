// SPDX-License-Identifier: GPL-3.0-or-later
// A picture on its way to samples: read, looked at with its outlines, traced.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "app/system/background_job.h"
#include "core/base/error.h"
#include "core/document/commands.h"
#include "core/graph/live_registry.h"
#include "core/raster/trace.h"

namespace mes {

/// What can be shown of a picture while its threshold is chosen.
struct TracePreview {
  GrayImage image{};                         ///< reduced to about a thousand pixels a side
  double reduction = 1.0;                    ///< pixels of the file along a side of one of these
  Histogram histogram{};                     ///< of the file
  std::optional<Level> level{};              ///< the best; nothing: all pixels are alike
  double specks = 0.0;                       ///< square pixels of the file, as usual for its size
  std::shared_ptr<const GrayImage> whole{};  ///< that of the file, if this one is reduced
};

/// What it guarantees: it never waits for a file; outlines of the preview are computed at once, in milliseconds. Whether
/// they are of a blurred picture, and how much, is what the whole picture needs: this is found out on another thread, and
/// until then it is as for the request before. Outlines and specks are counted there, too, as the tracing will count them:
/// a reduced picture has fewer specks.
///
/// Smallest use:
///     desk.begin("leaf.png");
///     ... each frame: if (auto read = desk.poll_picture()) ...; if (desk.preview()) desk.follow(), show(desk.outlines(request));
///     desk.trace(request);
///     ... each frame: if (auto traced = desk.poll_samples()) ...
///
/// Threads: the window's; `wake` is called from the reading ones.
class TraceDesk {
 public:
  TraceDesk(LiveRegistry registry, Waker wake)
      : registry_(std::move(registry)), reading_(wake), deciding_(wake), tracing_(std::move(wake)) {}

  void begin(const std::filesystem::path& file);
  /// Forgets the picture, and gives up what is under way.
  void end();
  bool is_busy() const { return reading_.is_under_way() || deciding_.is_under_way() || tracing_.is_under_way(); }
  bool is_tracing() const { return tracing_.is_under_way(); }
  const std::filesystem::path& file() const { return file_; }

  /// Whether the picture could be read, once; `preview` is there then.
  std::optional<Expected<void>> poll_picture();
  const TracePreview* preview() const { return preview_ ? &*preview_ : nullptr; }
  /// A number that differs from that of every other picture.
  std::uint64_t preview_number() const { return number_; }
  /// Once a turn: takes what was found out about the whole picture.
  void follow();
  /// Outlines in pixels of the preview. `request` is about the file, and says threshold and specks. Computed when it
  /// differs from the last one.
  const Expected<Tracing>& outlines(const TraceRequest& request);

  /// What the picture of the file has to trace and to leave out; nothing while that is being counted, or where there are no
  /// outlines. Asked after `outlines`, it costs nothing.
  std::optional<TraceCounts> counts(const TraceRequest& request);

  void trace(const TraceRequest& request);
  struct Samples {
    SampleData data{};
    std::string remark{};  ///< what was traced and left out
  };
  /// Once, when tracing has ended.
  std::optional<Expected<Samples>> poll_samples();

 private:
  LiveRegistry registry_;
  std::filesystem::path file_;
  std::optional<TracePreview> preview_;
  std::uint64_t number_ = 0;
  /// What the whole picture needs.
  struct Decision {
    TraceRequest request{};
    TraceCounts counts{};  // of the file, in its pixels
  };
  void decide(const TraceRequest& request);
  std::optional<Decision> decision_;
  /// What was asked of the preview.
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
