// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/picture/annotations/annotation_drawing.h"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "app/editing/places/measurement.h"
#include "app/picture/annotations/plane_drawing.h"
#include "app/picture/paper/rich_text.h"

namespace mes {
namespace {

constexpr double kLineSpacing = 1.35;
constexpr double kHead = 9.0;
constexpr double kHeadHalf = 3.2;
// Gap between a line and its element, which stays visible.
constexpr double kLineGap = 6.0;
constexpr double kWordsGap = 4.0;
constexpr double kEndRing = 7.0;
constexpr double kPi = std::numbers::pi;

Vec2 unit(Vec2 v) {
  const double size = length(v);
  return size > 0.0 ? (1.0 / size) * v : Vec2{};
}

class AnnotationLayout {
 public:
  AnnotationLayout(const SeenPlane& plane, const MeasureText& measure, const std::optional<Rgb>& background)
      : measure_(measure),
        ink_(paper_colors(background).ink),
        plane_(out_.drawing, plane),
        highlights_(out_.highlights, plane) {
    out_.drawing.width = plane.width;
    out_.drawing.height = plane.height;
    out_.highlights.width = plane.width;
    out_.highlights.height = plane.height;
  }

  void add(const Annotation& annotation, const std::vector<Vec2>& places,
           const std::vector<HighlightedShape>& highlighted) {
    annotation_ = &annotation;
    color_ = annotation.color.value_or(ink_);
    words_box_ = {};
    text_ = rich_text(annotation.text, measured_value(annotation.kind, places), annotation.letters, measure_);
    if (!text_.complaint.empty()) out_.complaints.push_back("an annotation: " + text_.complaint);
    std::vector<Vec2> at;
    for (const Vec2 p : places) at.push_back(plane_.on_paper(p));
    // Draws the sources of an element below the element itself.
    for (std::size_t i = highlighted.size(); i-- > 0;) highlights_.draw(highlighted[i]);
    if (std::ranges::all_of(at, [](Vec2 p) { return is_finite(p); })) draw(at, places);
    out_.words.push_back(words_box_);
    out_.places.push_back(std::move(at));
    out_.kinds.push_back(annotation.kind);
  }

  AnnotationDrawing take() { return std::move(out_); }

 private:
  void draw(const std::vector<Vec2>& at, const std::vector<Vec2>& places) {
    switch (annotation_->kind) {
      case AnnotationKind::text: words_from(at[0] + annotation_->shift); break;
      case AnnotationKind::leader: leader(at[0]); break;
      case AnnotationKind::arrow: arrow(at[0], at[1]); break;
      case AnnotationKind::distance: distance(at[0], at[1], measured(places)); break;
      case AnnotationKind::angle: angle(at, measured(places)); break;
      case AnnotationKind::radius: radius(at, places, measured(places)); break;
      case AnnotationKind::highlight: words_from(at[0] + annotation_->shift); break;
      case AnnotationKind::center_line: ends(at[0], at[1]); break;
    }
  }
  std::string measured(const std::vector<Vec2>& places) const { return measured_value(annotation_->kind, places); }

  // Lines

  void line(Vec2 from, Vec2 to) { plane_.segment(from, to, kAnnotationLine, color_); }
  void head(Vec2 tip, Vec2 direction) {
    const Vec2 back = tip - kHead * direction;
    const Vec2 aside = kHeadHalf * Vec2{-direction.y, direction.x};
    if (plane_.reaches(tip)) out_.drawing.triangles.push_back({{tip, back + aside, back - aside}, color_});
  }
  /// Ends the line below its head, so that the tip is sharp.
  void line_with_head(Vec2 from, Vec2 tip) {
    const Vec2 direction = unit(tip - from);
    if (direction == Vec2{}) return;
    const double room = length(tip - from);
    line(from, tip - std::min(0.8 * kHead, room) * direction);
    head(tip, direction);
  }

  // Words

  double words_width() const {
    double out = 0.0;
    for (const RichLine& line : text_.lines) out = std::max(out, line.width);
    return out;
  }
  double words_height() const {
    return text_.lines.empty()
               ? 0.0
               : annotation_->letters * (1.0 + kLineSpacing * static_cast<double>(text_.lines.size() - 1));
  }
  /// Sets the text with the beginning of the first baseline at `start`.
  void words_from(Vec2 start) {
    const double letters = annotation_->letters;
    if (text_.lines.empty()) return;
    const Vec2 corner = start - Vec2{0.0, kPaperAscent * letters};
    words_box_.add(corner);
    words_box_.add(corner + Vec2{words_width(), words_height()});
    if (!plane_.reaches(corner)) return;
    for (const RichLine& line : text_.lines) {
      add_pieces(line, start, color_, out_.drawing.lines);
      start.y += kLineSpacing * letters;
    }
  }
  /// Sets the text with its middle at `center`.
  void words_around(Vec2 center) {
    words_from(center + Vec2{-0.5 * words_width(), kPaperAscent * annotation_->letters - 0.5 * words_height()});
  }
  /// Sets the text so that it touches `at` and extends from there towards `direction`.
  void words_towards(Vec2 at, Vec2 direction) {
    const double half_width = 0.5 * words_width();
    const double half_height = 0.5 * words_height();
    const double reach = std::abs(direction.x) * half_width + std::abs(direction.y) * half_height;
    words_around(at + (reach + kWordsGap) * direction);
  }
  void measured_words(const std::string& value) {
    if (text_.lines.empty() && annotation_->text.empty() && !value.empty())
      text_ = rich_text("\\value", value, annotation_->letters, measure_);
  }

  // Kinds

  void leader(Vec2 at) {
    words_from(at + annotation_->shift);
    if (words_box_.is_empty()) return;
    // Starts in the middle of the side of the text nearest to the element.
    const Vec2 middle = 0.5 * (words_box_.low + words_box_.high);
    Vec2 from = middle;
    if (at.x < words_box_.low.x)
      from.x = words_box_.low.x - kWordsGap;
    else if (at.x > words_box_.high.x)
      from.x = words_box_.high.x + kWordsGap;
    else if (at.y < words_box_.low.y)
      from.y = words_box_.low.y - kWordsGap;
    else if (at.y > words_box_.high.y)
      from.y = words_box_.high.y + kWordsGap;
    else
      return;  // the text covers the element
    const double room = length(at - from);
    if (room > kLineGap) line_with_head(from, at - kLineGap * unit(at - from));
  }

  void arrow(Vec2 from, Vec2 to) {
    line_with_head(from, to);
    const Vec2 direction = unit(from - to);
    words_towards(from + annotation_->shift, direction == Vec2{} ? Vec2{0.0, -1.0} : direction);
  }

  /// Draws a dimension line, beside the two points and with lines out to it if the text was dragged aside.
  void distance(Vec2 a, Vec2 b, const std::string& value) {
    measured_words(value);
    const Vec2 along = unit(b - a);
    if (along == Vec2{}) return words_around(a + Vec2{0.0, -annotation_->letters});
    // Points upwards, so that the text is above the line.
    Vec2 normal{along.y, -along.x};
    if (normal.y > 0.0 || (normal.y == 0.0 && normal.x > 0.0)) normal = -1.0 * normal;
    const double aside = dot(annotation_->shift, normal);
    const Vec2 shift = aside * normal;
    const Vec2 out = aside >= 0.0 ? normal : -1.0 * normal;
    if (std::abs(aside) > kLineGap + kWordsGap) {
      line(a + kLineGap * out, a + shift + kWordsGap * out);
      line(b + kLineGap * out, b + shift + kWordsGap * out);
    }
    const Vec2 from = a + shift;
    const Vec2 to = b + shift;
    const Vec2 middle = 0.5 * (from + to);
    const bool has_room = length(to - from) > 3.0 * kHead;
    if (has_room) {
      line_with_head(middle, from);
      line_with_head(middle, to);
    } else {
      // Draws the arrows from outside if the heads do not fit between.
      line(from, to);
      line_with_head(from - 2.0 * kHead * along, from);
      line_with_head(to + 2.0 * kHead * along, to);
    }
    words_towards(middle + dot(annotation_->shift, along) * along, out);
  }

  void angle(const std::vector<Vec2>& at, const std::string& value) {
    measured_words(value);
    const Vec2 first = at[0] - at[1];
    const Vec2 second = at[2] - at[1];
    if (first == Vec2{} || second == Vec2{}) return words_around(at[1] + annotation_->shift);
    const double arm = std::min(length(first), length(second));
    const double radius = std::clamp(0.5 * arm, std::min(arm, 16.0), 48.0);
    line(at[1], at[0]);
    line(at[1], at[2]);
    const double turn = std::atan2(cross(first, second), dot(first, second));
    const double begin = turn >= 0.0 ? std::atan2(first.y, first.x) : std::atan2(second.y, second.x);
    const double sweep = std::abs(turn);
    if (sweep > 0.0 && plane_.reaches(at[1]))
      out_.drawing.arcs.push_back({at[1], radius, begin, sweep, kAnnotationLine, color_});
    const double middle = begin + 0.5 * sweep;
    const Vec2 direction{std::cos(middle), std::sin(middle)};
    words_towards(at[1] + radius * direction + annotation_->shift, direction);
  }

  void radius(const std::vector<Vec2>& at, const std::vector<Vec2>& places, const std::string& value) {
    measured_words(value);
    const auto circle = measured_circle(places);
    if (!circle) return words_around(at[2] + annotation_->shift);
    const Vec2 center = plane_.on_paper(circle->center);
    const double size = plane_.on_paper(circle->radius);
    if (!is_finite(center) || !std::isfinite(size)) return;
    plane_.circle(center, size, kAnnotationLine, color_);
    if (plane_.reaches(center)) out_.drawing.dots.push_back({center.x, center.y, 2.0, color_});
    const Vec2 direction = unit(at[2] - center);
    line_with_head(center, center + size * direction);
    Vec2 normal{direction.y, -direction.x};
    if (normal.y > 0.0) normal = -1.0 * normal;
    words_towards(center + 0.5 * size * direction + annotation_->shift, normal);
  }

  /// Draws a ring about each end, and the text beside the first one, away from the other.
  void ends(Vec2 from, Vec2 to) {
    for (const Vec2 end : {from, to}) {
      plane_.circle(end, kEndRing, 1.5 * kAnnotationLine, color_);
      if (plane_.reaches(end)) out_.drawing.dots.push_back({end.x, end.y, 2.0, color_});
    }
    const Vec2 direction = from == to ? Vec2{0.0, -1.0} : unit(from - to);
    words_towards(from + kEndRing * direction + annotation_->shift, direction);
  }

  const MeasureText& measure_;
  Rgb ink_;
  Rgb color_;
  AnnotationDrawing out_;
  PlaneDrawing plane_;
  HighlightPen highlights_;
  const Annotation* annotation_ = nullptr;
  RichText text_;
  Box2 words_box_;
};

double distance_to(Vec2 p, const Box2& box) {
  const double dx = std::max({box.low.x - p.x, 0.0, p.x - box.high.x});
  const double dy = std::max({box.low.y - p.y, 0.0, p.y - box.high.y});
  return std::hypot(dx, dy);
}

double distance_to(Vec2 p, Vec2 from, Vec2 to) {
  const Vec2 way = to - from;
  const double squared = dot(way, way);
  const double t = squared > 0.0 ? std::clamp(dot(p - from, way) / squared, 0.0, 1.0) : 0.0;
  return length(p - (from + t * way));
}

}  // namespace

PlacedAnnotations place(const Document& document) {
  PlacedAnnotations out{.annotations = document.annotations()};
  out.places.reserve(out.annotations->size());
  out.highlighted.reserve(out.annotations->size());
  for (const Annotation& annotation : *out.annotations) {
    std::vector<Vec2>& places = out.places.emplace_back();
    for (const Anchor& anchor : annotation.anchors) places.push_back(document.place_of(anchor));
    out.highlighted.push_back(highlighted_shapes(annotation, document));
  }
  return out;
}

std::string measured_value(AnnotationKind kind, const std::vector<Vec2>& places) {
  const auto number = [](double x) { return fmt::format("{:.4g}", x); };
  switch (kind) {
    case AnnotationKind::text:
    case AnnotationKind::leader:
    case AnnotationKind::arrow:
    case AnnotationKind::highlight:
    case AnnotationKind::center_line: return {};
    case AnnotationKind::distance: return number(length(places[1] - places[0]));
    case AnnotationKind::angle: {
      const Vec2 first = places[0] - places[1];
      const Vec2 second = places[2] - places[1];
      if (first == Vec2{} || second == Vec2{}) return {};
      return number(180.0 / kPi * std::atan2(std::abs(cross(first, second)), dot(first, second))) + "°";
    }
    case AnnotationKind::radius: {
      const auto circle = measured_circle(places);
      return circle ? number(circle->radius) : std::string();
    }
  }
  return {};
}

AnnotationDrawing layout_annotations(const PlacedAnnotations& placed, const SeenPlane& plane,
                                     const MeasureText& measure, const std::optional<Rgb>& background) {
  AnnotationLayout layout(plane, measure, background);
  for (std::size_t i = 0; i < placed.places.size(); ++i)
    layout.add((*placed.annotations)[i], placed.places[i], placed.highlighted[i]);
  AnnotationDrawing out = layout.take();
  out.plane = plane;
  out.highlighted = placed.highlighted;
  return out;
}

std::optional<std::size_t> annotation_at(const AnnotationDrawing& drawn, Vec2 px, double reach) {
  for (std::size_t i = drawn.words.size(); i-- > 0;) {
    if (!drawn.words[i].is_empty() && distance_to(px, drawn.words[i]) <= 0.5 * reach) return i;
    const std::vector<HighlightedShape>& highlighted = drawn.highlighted[i];
    const auto is_near = [&](const HighlightedShape& shape) {
      return highlight_distance(shape.shape, px, drawn.plane) <= reach;
    };
    if (!highlighted.empty()) {
      if (std::ranges::any_of(highlighted, is_near)) return i;
      continue;
    }
    const std::vector<Vec2>& places = drawn.places[i];
    if (drawn.kinds[i] == AnnotationKind::center_line) {
      if (std::ranges::any_of(places, [&](Vec2 end) { return length(px - end) <= reach; })) return i;
      continue;
    }
    // The anchor of plain text is only its beginning, and the element there stays free for other tools.
    for (std::size_t k = 0; k + 1 < places.size(); ++k)
      if (distance_to(px, places[k], places[k + 1]) <= reach) return i;
  }
  return std::nullopt;
}

}  // namespace mes
