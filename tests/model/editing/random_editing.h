// SPDX-License-Identifier: GPL-3.0-or-later
// Anything a user may do with an editor, at random.
#pragma once

#include <array>

#include "app/editing/editor.h"
#include "core/base/rng.h"
#include "core/document/taken_samples.h"

namespace mes::test {

class RandomEditing {
 public:
  explicit RandomEditing(std::uint64_t seed) : random_(seed) {}

  SampleData data() {
    SampleData out;
    for (int i = 0; i < 12; ++i) out.positions.push_back(place());
    out.contours = {{true, {0, 1, 2, 3, 4}}};
    for (int i = 0; i < 3; ++i) out.balls.push_back({place(), random_.uniform()});
    return out;
  }

  void step(Editor& editor) {
    const Document& document = editor.document();
    switch (random_.below(16)) {
      case 0:
        if (!editor.in_gesture()) editor.begin_gesture("Gesture");
        break;
      case 1:
        if (editor.in_gesture()) editor.end_gesture();
        break;
      case 2: editor.cancel_gesture(); break;
      case 3: editor.undo(); break;
      case 4: editor.redo(); break;
      case 5: static_cast<void>(editor.insert(std::array{place(), place()}, "Insert")); break;
      case 6: static_cast<void>(editor.insert_balls(std::array{Disk{place(), random_.uniform()}}, "Ball")); break;
      case 7:
        choose(editor);
        static_cast<void>(editor.remove_selection());
        break;
      case 8:
        choose(editor);
        static_cast<void>(editor.scale_selected_balls(1.5, 0.1, random_.below(2) == 0));
        break;
      case 9: choose(editor); [[fallthrough]];
      case 10: static_cast<void>(editor.nudge_selection(place())); break;
      case 11:
      case 12:
        if (!editor.in_gesture()) evolve(editor);
        break;
      case 13:
      case 14:
        if (!editor.in_gesture()) resample(editor);
        break;
      default:
        if (document.slot_count() > 0 && document.is_alive(SampleSlot(0)))
          static_cast<void>(editor.move(std::array{std::pair{document.id(SampleSlot(0)), place()}}, "Move"));
    }
  }

 private:
  Vec2 place() { return {random_.uniform(), random_.uniform()}; }
  /// Samples of a polygon, or a few without curves.
  void resample(Editor& editor) {
    PlaneCurve curve(place());
    for (std::uint64_t i = random_.below(4); i > 0; --i) curve.line_to(place());
    const auto curves = std::make_shared<const CurveSet>(CurveSet{.curves = {curve}, .points = {place()}});
    const SamplingRequest request{.rule = SamplingRule::count, .count = 1 + random_.below(9)};
    auto data = taken_from(curves, *sample(*curves, request), request);
    if (random_.below(4) == 0) data->source.reset();
    static_cast<void>(editor.resample(*data, "Resample", random_.below(2) == 0));
  }
  void evolve(Editor& editor) {
    std::vector<Vec2> positions;
    for (const SampleSlot slot : editor.document().slots_in_input_order())
      positions.push_back(editor.document().position(slot) + 0.1 * place());
    std::vector<SampleData::Contour> contours;
    // New samples in a curve.
    if (random_.below(2) == 0 && positions.size() < 40) {
      positions.push_back(place());
      contours = {{random_.below(2) == 0, {0, static_cast<std::uint32_t>(positions.size() - 1)}}};
    }
    // Of a step that is replaced, all samples it made come back as new ones; there are never too few places.
    static_cast<void>(editor.evolve(positions, contours, "Evolve"));
  }
  void choose(Editor& editor) {
    editor.selection().clear();
    const Document& document = editor.document();
    for (int i = 0; i < 2 && document.slot_count() > 0; ++i) {
      const SampleSlot slot(random_.below(document.slot_count()));
      if (document.is_alive(slot)) editor.selection().add(slot);
    }
    if (document.ball_slot_count() == 0) return;
    const BallSlot ball(random_.below(document.ball_slot_count()));
    if (document.is_ball_alive(ball)) editor.selection().add_ball(ball);
  }

  Rng random_;
};

}  // namespace mes::test
