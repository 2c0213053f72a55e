// SPDX-License-Identifier: GPL-3.0-or-later
// Annotations as they are written: which one is being worked on, and what its places are on.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "app/editing/editor.h"
#include "core/document/annotation.h"

namespace mes {

/// What it guarantees:
///  1. What is chosen is an annotation of the document, or a draft that becomes one with its first letter. Whatever
///     else changes the annotations, such as undo, ends the choice.
///  2. An annotation and all that is done to it until it is left are one step of undo, moving it another one; so are
///     all changes of an older one.
///  3. An annotation that would show nothing leaves the document with the choice.
///
/// Smallest use:
///     desk.begin({.kind = AnnotationKind::text, .anchors = {desk.anchor_at(p, reach)}});
///     Annotation changed = *desk.current(); changed.text = "crust"; desk.change(changed);
///     desk.close();
///
/// Threads: the window's. It knows no window and no OpenGL.
class AnnotationDesk {
 public:
  explicit AnnotationDesk(Editor& editor) : editor_(editor) {}

  /// On the nearest sample within `reach`, or else on the centre of the nearest ball, or else on the vertex of the Voronoi
  /// diagram there, if vertices are wanted and there are at most `kMostSamplesForVertices`, or else fixed. As
  /// `PlaceIndex::nearest`, and what has exactly the place that was found.
  static constexpr std::size_t kMostSamplesForVertices = 20'000;
  Anchor anchor_at(Vec2 p, double reach, bool with_vertices) const;

  /// What shows something without words is put into the document at once. Ends the choice before.
  Expected<void> begin(Annotation draft);
  void select(std::size_t i);
  /// Null when none is chosen.
  const Annotation* current() const;
  /// Its place among those of the document; nothing for a draft.
  std::optional<std::size_t> selected() const { return selected_; }
  bool is_draft() const { return draft_.has_value(); }
  /// Grows with each new choice.
  std::uint64_t choice_number() const { return choice_number_; }

  Expected<void> change(Annotation changed);
  Expected<void> erase();
  /// Ends the choice; false when there was none.
  bool close();

  /// Ends the choice and leaves the document as it is. To be called when another document is about to replace it.
  void forget();

  /// Of a drag: the annotation is as it is moved. Within a gesture.
  Expected<void> move(std::size_t i, Annotation moved);

  /// To be called after whatever may have changed the document.
  void follow();

 private:
  Expected<void> put(Annotations annotations, const std::string& name, bool continues);
  std::optional<Anchor> vertex_at(Vec2 p, double reach) const;

  Editor& editor_;
  std::optional<Annotation> draft_;
  std::optional<std::size_t> selected_;
  std::shared_ptr<const Annotations> seen_;  // as this desk left them
  bool is_new_ = false;                      // the choice began as a draft
  bool is_changed_ = false;
  std::uint64_t revision_ = 0;  // of the document, after the last change by this desk
  std::uint64_t choice_number_ = 0;
};

/// Whether it shows something without words.
constexpr bool shows_without_words(AnnotationKind kind) {
  return kind != AnnotationKind::text && kind != AnnotationKind::leader;
}

}  // namespace mes
