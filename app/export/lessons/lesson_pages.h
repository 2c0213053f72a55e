// SPDX-License-Identifier: GPL-3.0-or-later
// The steps of a lesson on pages: each is computed from scratch, drawn as by `mesecina render`, and has its caption.
//
// All pages of a lesson have one layout, so that from page to page only the changes of the step are visible.
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
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "app/export/figure.h"
#include "app/layers/legend_scope.h"
#include "app/picture/paper/caption_text.h"
#include "app/picture/paper/paper_drawing.h"
#include "app/playing/lesson_walk.h"
#include "app/settings/scale_marks.h"
#include "core/base/color.h"
#include "core/base/error.h"
#include "core/io/session/session.h"
#include "render/figure/figure.h"
#include "render/figure/pdf_book.h"
#include "render/image/image.h"
#include "render/instances/colormap.h"

namespace mes {

/// Lengths are in points.
struct LessonLook {
  double width = 960.0;  ///< a slide of 16:9
  double height = 540.0;
  std::optional<Rgb> background = Rgb{255, 255, 255};  ///< nothing: that of the paper
  double scale = 1.25;                                 ///< factor for line widths and point sizes of the drawing
  LegendScope legend = LegendScope::color_maps;
  ScaleMarks marks{};
  bool with_annotations = true;
};

/// The positions on a page: side by side if it is wider than high, else one below the other.
struct LessonLayout {
  Box2 drawing;    ///< extends to the edges of the page
  Box2 caption;    ///< room for the caption
  Vec2 number;     ///< the upper left corner of the line with title and number
  double letters;  ///< letter size of the caption, if it fits
};
LessonLayout lesson_layout(double width, double height);

struct LessonPage {
  std::string name;  ///< name of the step on one line; never empty
  CaptionText caption;
  std::uint64_t document = 0;  ///< digest of the displayed document
  figure::Figure drawing;
  Vec2 corner;                       ///< upper left corner of the drawing
  figure::Figure paper;              ///< the whole page: background, caption, title and number, below the drawing
  std::vector<std::string> remarks;  ///< parts that were left out or not understood, one sentence each
};

/// The page with its bookmark; the page must outlive the sheet.
figure::Sheet sheet_of(const LessonPage& page);

/// The page in pixels. Errors of `figure::picture_of`.
Expected<render::Image> picture_of(const LessonPage& page, double pixels_per_point);

/// Guarantees: a page depends only on session, look and step. Cost: one computation from scratch per page. Threads:
/// none.
class LessonPrinter {
 public:
  /// Registry and session must outlive it, and the session must have a step. Error: the fonts of the program cannot
  /// be read.
  static Expected<LessonPrinter> make(const Registry& registry, const Session& session, const LessonLook& look);

  /// Title and fonts for a book of the pages.
  figure::BookInfo info() const;
  /// The title of the lesson, or else of the session; may be empty.
  const std::string& title() const;
  /// Error: an entry of the timeline is invalid, a computation fails or is stopped (`cancelled`), or memory runs out.
  Expected<LessonPage> page(std::size_t step, const std::stop_token& stop = {});

 private:
  LessonPrinter(const Registry& registry, const Session& session, const LessonLook& look,
                std::shared_ptr<const PaperFonts> fonts);
  Expected<void> draw(const LessonScene& scene, const Box2& place, LessonPage& page, const std::stop_token& stop);
  const render::Image* traced(const BackgroundImage& image, std::vector<std::string>& remarks);
  figure::Figure paper(const CaptionText& caption, std::size_t step, std::vector<std::string>& remarks) const;

  const Registry* registry_;
  const Session* session_;
  LessonLook look_;
  std::shared_ptr<const PaperFonts> fonts_;
  std::vector<render::ColorMap> maps_;
  std::unique_ptr<LessonWalk> walk_;
  /// Traced pictures, by file and whether they are upright; nothing if the file cannot be read.
  std::map<std::pair<std::string, bool>, std::optional<render::Image>> traced_;
};

}  // namespace mes
