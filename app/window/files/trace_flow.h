// SPDX-License-Identifier: GPL-3.0-or-later
// Brings a picture into the window: a dialog asks whether it becomes samples or is placed below the drawing.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include "app/panels/dialogs/dialogs.h"
#include "app/store/trace_job.h"
#include "app/system/waker.h"
#include "app/window/work/drawing_board.h"
#include "core/graph/live_registry.h"

namespace mes {

/// Guarantees: it never waits for a picture to be read or traced; a traced picture becomes a document of its own, and
/// the question about unsaved work comes before the tracing. Needs a current OpenGL context for its whole life.
/// Threads: the window's; `wake` is called from others.
class TraceFlow {
 public:
  struct Uses {
    LiveRegistry registry;
    DrawingBoard& board;
    Dialogs& dialogs;
    Messages& messages;
    std::function<void(std::function<void()> then)> leave_work;  ///< continues when the work is saved or given up
    std::function<void(TraceJob::Samples samples, const std::string& title)> open_made;
  };
  TraceFlow(Uses uses, Waker wake);
  ~TraceFlow() { forget_texture(); }
  TraceFlow(const TraceFlow&) = delete;
  TraceFlow& operator=(const TraceFlow&) = delete;

  void open(const std::filesystem::path& file);
  /// Called once per turn before the frame.
  void take_results();

 private:
  void take_samples(Expected<TraceJob::Samples> samples);
  /// Texture of the preview, created on demand.
  ImTextureID texture();
  void forget_texture();

  Uses uses_;
  TraceJob job_;
  std::optional<render::TextureId> texture_;
  std::uint64_t textured_ = 0;  // number of the preview in the texture
};

}  // namespace mes
