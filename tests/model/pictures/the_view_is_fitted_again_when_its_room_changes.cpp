// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "app/editing/editor.h"
#include "app/panes/view_fitter.h"

using namespace mes;

namespace {

struct Fitting {
  Editor editor{[](const std::shared_ptr<const DocumentDelta>&) {}};
  ViewMotion view;
  ViewFitter fitter{view};

  Fitting() {
    view.set_viewport(800, 600);
    SampleData data;
    for (const Vec2 p : {Vec2{0, 0}, Vec2{4, 0}, Vec2{4, 3}, Vec2{0, 3}}) data.positions.push_back(p);
    REQUIRE(editor.load(data));
  }
  /// A frame with a panel on the right.
  void draw(double panel, bool is_held = false) {
    view.set_insets({.right = panel});
    fitter.follow(editor.document(), {.is_held = is_held});
  }
  void come_to_rest() {
    for (int i = 0; i < 1000 && view.is_moving(); ++i) view.advance(0.05);
    REQUIRE_FALSE(view.is_moving());
  }
  /// Where the middle of the samples is seen, from the left.
  double middle_px() const { return view.camera().to_screen({2.0, 1.5}).x; }
};

}  // namespace

TEST_CASE("a drawing that was fitted is fitted again when a panel comes") {
  Fitting fitting;
  fitting.fitter.want(ViewFitter::How::at_once);
  REQUIRE(fitting.fitter.is_wanted());
  fitting.draw(0.0);
  CHECK_FALSE(fitting.fitter.is_wanted());
  CHECK(fitting.middle_px() == Approx(400.0));
  fitting.draw(200.0);
  CHECK(fitting.view.is_moving());
  fitting.come_to_rest();
  CHECK(fitting.middle_px() == Approx(300.0));
}

TEST_CASE("a view that was moved by hand, or is held, stays where it is") {
  Fitting fitting;
  fitting.fitter.want(ViewFitter::How::at_once);
  fitting.draw(0.0);
  fitting.draw(200.0, true);
  CHECK_FALSE(fitting.view.is_moving());
  fitting.view.pan({50.0, 0.0});
  const double middle = fitting.middle_px();
  fitting.draw(200.0);
  CHECK_FALSE(fitting.view.is_moving());
  CHECK(fitting.middle_px() == middle);
}

TEST_CASE("a drawing that has become another one is not fitted without being asked") {
  Fitting fitting;
  fitting.fitter.want(ViewFitter::How::at_once);
  fitting.draw(0.0);
  REQUIRE(fitting.editor.insert(std::vector{Vec2{40.0, 30.0}}, "far away"));
  fitting.draw(200.0);
  CHECK_FALSE(fitting.view.is_moving());
}

TEST_CASE("a target is fitted once, instead of the drawing and without a margin") {
  Fitting fitting;
  fitting.fitter.set_target({{0.0, 0.0}, {8.0, 6.0}});
  fitting.draw(0.0);
  CHECK_FALSE(fitting.fitter.is_wanted());
  fitting.fitter.want(ViewFitter::How::at_once);
  fitting.draw(0.0);
  CHECK(fitting.view.camera().units_per_pixel() == Approx(0.01));
  fitting.fitter.want(ViewFitter::How::at_once);
  fitting.draw(0.0);
  CHECK(fitting.middle_px() == Approx(400.0));
}

TEST_CASE("a view that is noted and shown again is the same view, also under a legend") {
  Fitting fitting;
  fitting.fitter.want(ViewFitter::How::at_once);
  fitting.draw(200.0);
  fitting.view.pan({-30.0, 20.0});
  const double scale = fitting.view.camera().units_per_pixel();
  const double middle = fitting.middle_px();
  for (int i = 0; i < 3; ++i) {
    fitting.fitter.set_target(fitting.view.free_box());
    fitting.fitter.want(ViewFitter::How::at_once);
    fitting.view.set_insets({.right = 200.0});
    fitting.fitter.follow(fitting.editor.document(), {.legend = {180.0, 260.0}});
    fitting.view.set_insets({.right = 200.0});
    CHECK(fitting.view.camera().units_per_pixel() == Approx(scale));
    CHECK(fitting.middle_px() == Approx(middle));
  }
}

TEST_CASE("what was shown since, such as a place or the selection, stays when panels come and go") {
  Fitting fitting;
  fitting.fitter.want(ViewFitter::How::at_once);
  fitting.draw(0.0);
  fitting.view.fit({{1.0, 1.0}, {1.5, 1.5}}, 0.0, true);
  const double scale = fitting.view.camera().units_per_pixel();
  fitting.draw(200.0);
  CHECK_FALSE(fitting.view.is_moving());
  CHECK(fitting.view.camera().units_per_pixel() == scale);
}

TEST_CASE("a target is shown again when the window is resized, as at the end of a lesson, and not for a panel") {
  Fitting fitting;
  const Box2 target{{0.0, 0.0}, {8.0, 6.0}};
  fitting.fitter.set_target(target);
  fitting.fitter.want(ViewFitter::How::at_once);
  fitting.view.set_viewport(1600, 1200);
  fitting.draw(0.0);
  fitting.view.set_viewport(800, 600);
  fitting.draw(0.0);
  CHECK(fitting.view.camera().units_per_pixel() == Approx(0.01));
  CHECK(fitting.middle_px() == Approx(200.0));
  fitting.draw(200.0);
  CHECK_FALSE(fitting.view.is_moving());
  fitting.view.pan({50.0, 0.0});
  fitting.view.set_viewport(1600, 1200);
  fitting.draw(200.0);
  CHECK(fitting.view.camera().units_per_pixel() == Approx(0.01));
}
