// SPDX-License-Identifier: GPL-3.0-or-later
// The steps of a lesson on pages: each computed afresh and drawn as `mesecina render` draws it, with its caption.
//
// All pages of a lesson have one layout, so that nothing jumps from one to the next but what the step changes.
//
// Smallest use:
//     auto printer = LessonPrinter::make(registry, session, {});
//     figure::PdfBook book(printer->info());
//     for (std::size_t i = 0; i < session.lesson.steps.size(); ++i) {
//       const auto page = printer->page(i);
//       book.add(sheet_of(*page));
//     }
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/export/figure.h"
#include "app/layers/legend_scope.h"
#include "app/model/scale_marks.h"
#include "app/picture/caption_text.h"
#include "app/picture/paper_drawing.h"
#include "app/playing/lesson_walk.h"
#include "core/base/color.h"
#include "core/base/error.h"
#include "core/io/session/session.h"
#include "render/colormap.h"
#include "render/figure/figure.h"
#include "render/figure/pdf_book.h"
#include "render/image.h"

namespace mes {

/// Lengths are in points.
struct LessonLook {
  double width = 960.0;  ///< a slide of 16:9
  double height = 540.0;
  std::optional<Rgb> background = Rgb{255, 255, 255};  ///< none: the paper's own
  double scale = 1.25;                                 ///< factor for line widths and point sizes of the drawing
  LegendScope legend = LegendScope::color_maps;
  ScaleMarks marks{};
  bool with_annotations = true;
};

/// Where things are on a page: beside each other where it is wider than high, else one below the other.
struct LessonLayout {
  Box2 drawing;    ///< up to the edges of the page
  Box2 caption;    ///< room for it
  Vec2 number;     ///< the upper left corner of the line with title and number
  double letters;  ///< size of those of the caption, where it fits
};
LessonLayout lesson_layout(double width, double height);

struct LessonPage {
  std::string name;  ///< of the step, on one line; never empty
  CaptionText caption;
  std::uint64_t document = 0;  ///< digest of what is shown
  figure::Figure drawing;
  Vec2 corner;                       ///< of the drawing
  figure::Figure paper;              ///< the whole page: background, caption, title and number, below the drawing
  std::vector<std::string> remarks;  ///< what was left out or not understood, one sentence each
};

/// The page with its bookmark; it has to outlive the sheet.
figure::Sheet sheet_of(const LessonPage& page);

/// The page in pixels. Errors as of `figure::picture_of`.
Expected<render::Image> picture_of(const LessonPage& page, double pixels_per_point);

/// What it guarantees: a page depends on session, look and step alone. Cost: a fresh computation a page. Threads: none.
class LessonPrinter {
 public:
  /// Registry and session have to outlive it, and the session has a step at least. Error: the fonts of the program
  /// cannot be read.
  static Expected<LessonPrinter> make(const Registry& registry, const Session& session, const LessonLook& look);

  /// Title and fonts of a book of the pages.
  figure::BookInfo info() const;
  /// The title of the lesson, or else of the session; may be empty.
  const std::string& title() const;
  /// Error: an entry of the timeline makes no sense, something cannot be computed, memory.
  Expected<LessonPage> page(std::size_t step);

 private:
  LessonPrinter(const Registry& registry, const Session& session, const LessonLook& look,
                std::shared_ptr<const PaperFonts> fonts);
  Expected<void> draw(const LessonScene& scene, const Box2& place, LessonPage& page);
  const render::Image* traced(const BackgroundImage& image, std::vector<std::string>& remarks);
  figure::Figure paper(const CaptionText& caption, std::size_t step, std::vector<std::string>& remarks) const;

  const Registry* registry_;
  const Session* session_;
  LessonLook look_;
  std::shared_ptr<const PaperFonts> fonts_;
  std::vector<render::ColorMap> maps_;
  std::unique_ptr<LessonWalk> walk_;
  /// Traced pictures, by file and whether they stand upright; nothing if the file cannot be read.
  std::map<std::pair<std::string, bool>, std::optional<render::Image>> traced_;
};

}  // namespace mes
