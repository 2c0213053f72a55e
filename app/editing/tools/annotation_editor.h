// SPDX-License-Identifier: GPL-3.0-or-later
// The annotation that the user is working on, and the elements to which its anchors are attached.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "app/editing/editor.h"
#include "core/document/annotation.h"

namespace mes {

/// Guarantees:
///  1. The chosen annotation belongs to the document, or is a draft that enters it with its first letter. Any other
///     change of the annotations, such as undo, ends the choice.
///  2. A new annotation and all changes to it until the choice ends are one step of undo; moving it is another one.
///     All changes of an older annotation are one step, too.
///  3. An annotation that would show nothing leaves the document when the choice ends.
///
/// Smallest use:
///     annotations.begin({.kind = AnnotationKind::text, .anchors = {annotations.anchor_at(p, reach)}});
///     Annotation changed = *annotations.current(); changed.text = "crust"; annotations.change(changed);
///     annotations.close();
///
/// Threads: the window's. Depends on no window and no OpenGL.
class AnnotationEditor {
 public:
  explicit AnnotationEditor(Editor& editor) : editor_(editor) {}

  /// Attaches an anchor to the nearest sample within `reach`, else to the centre of the nearest ball, else to the
  /// Voronoi vertex there (if `with_vertices`, and with at most `kMostSamplesForVertices` samples); else the anchor
  /// is fixed. Finds elements as `PlaceIndex::nearest`. The anchor gets exactly the position of the element.
  static constexpr std::size_t kMostSamplesForVertices = 20'000;
  Anchor anchor_at(Vec2 p, double reach, bool with_vertices) const;

  /// Ends the present choice and begins another. A draft that is visible without words enters the document at once.
  Expected<void> begin(Annotation draft);
  void select(std::size_t i);
  /// The chosen annotation, or null.
  const Annotation* current() const;
  /// Its index among those of the document; nothing for a draft.
  std::optional<std::size_t> selected() const { return selected_; }
  bool is_draft() const { return draft_.has_value(); }
  /// Grows with each new choice.
  std::uint64_t choice_number() const { return choice_number_; }

  Expected<void> change(Annotation changed);
  Expected<void> erase();
  /// Ends the choice; returns false if there was none.
  bool close();

  /// Ends the choice and leaves the document as it is. Call it when another document is about to replace this one.
  void forget();

  /// One step of a drag, which sets the moved annotation. Call it within a gesture.
  Expected<void> move(std::size_t i, Annotation moved);

  /// Call it after anything that may have changed the document.
  void follow();

 private:
  Expected<void> put(Annotations annotations, const std::string& name, bool continues);
  std::optional<Anchor> vertex_at(Vec2 p, double reach) const;

  Editor& editor_;
  std::optional<Annotation> draft_;
  std::optional<std::size_t> selected_;
  std::shared_ptr<const Annotations> seen_;  // the annotations as this editor left them
  bool is_new_ = false;                      // the choice began as a draft
  bool is_changed_ = false;
  std::uint64_t revision_ = 0;  // revision of the document after the last change by this annotations
  std::uint64_t choice_number_ = 0;
};

/// True if the kind shows something without words.
constexpr bool shows_without_words(AnnotationKind kind) {
  return kind != AnnotationKind::text && kind != AnnotationKind::leader;
}

}  // namespace mes
