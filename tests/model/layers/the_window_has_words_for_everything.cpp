// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <set>
#include <vector>

#include "app/editing/editor.h"
#include "app/editing/places/neighborhood.h"
#include "app/layers/words/parameter_words.h"
#include "app/layers/words/verdict_word.h"
#include "core/builtins/builtins.h"
#include "core/evolutions/evolution.h"
#include "core/graph/structure.h"

using namespace mes;

TEST_CASE("the light says one thing for each state, and nothing while it is not known") {
  CHECK(verdict_word({TheoremLight::green}, false, Checking::done).word == "Proved");
  CHECK(verdict_word({TheoremLight::yellow}, false, Checking::done).word == "Not proved");
  CHECK(verdict_word({TheoremLight::red}, true, Checking::done).word == "Wrong");
  CHECK(verdict_word({TheoremLight::none}, false, Checking::done).word == "Nothing to prove");
  CHECK(verdict_word({TheoremLight::none}, true, Checking::done).word == "No memory");
  for (const TheoremLight light :
       {TheoremLight::none, TheoremLight::green, TheoremLight::yellow, TheoremLight::red}) {
    CHECK(verdict_word({light}, false, Checking::under_way).word == "Checking");
    CHECK(verdict_word({light}, false, Checking::under_way).mood == VerdictWord::Mood::quiet);
    CHECK(verdict_word({light}, false, Checking::cancelled).word == "Not checked");
  }
}

TEST_CASE("a note about sampling or drawing is listed and leaves the light as it is") {
  NodeReport judge;
  judge.structure = "axis-certificate";
  judge.state = NodeState::up_to_date;
  judge.is_judging = true;
  NodeReport sampled = judge;
  sampled.structure = "axis-sampling";
  sampled.is_judging = false;
  sampled.findings.push_back({FindingLevel::note, "axis-sampling: sampled balls are farther apart", 7, {}, {}});
  CHECK(light_of(std::vector{judge, sampled}) == TheoremLight::green);
  CHECK(light_of(std::vector{sampled}) == TheoremLight::none);
  CHECK(text_of(sampled.findings.front(), "axis-sampling") == "7 sampled balls are farther apart");
  CHECK(mood_of(FindingLevel::note) == VerdictWord::Mood::quiet);
  CHECK(mood_of(FindingLevel::doubt) == VerdictWord::Mood::doubtful);
  CHECK(mood_of(FindingLevel::wrong) == VerdictWord::Mood::wrong);
  judge.findings.push_back({FindingLevel::doubt, "samples with an odd number of curve edges", 1, {}, {}});
  CHECK(light_of(std::vector{judge, sampled}) == TheoremLight::yellow);
  // Without inner balls nothing is judged, and there is nothing to doubt.
  judge.is_judging = false;
  CHECK(light_of(std::vector{judge, sampled}) == TheoremLight::none);
  judge.findings.front().level = FindingLevel::wrong;
  CHECK(light_of(std::vector{sampled, judge}) == TheoremLight::red);
}

TEST_CASE("a finding is said with its count, one as one, and whose balls it is about") {
  Finding finding{.text = "samples with an odd number of curve edges instead of two: corners, noise, ends of strokes",
                  .count = 1,
                  .places = {},
                  .epsilon = {}};
  CHECK(text_of(finding, "one-step-crust") ==
        "1 sample with an odd number of curve edges instead of two: a corner, noise, the end of a stroke");
  finding.count = 12;
  CHECK(text_of(finding, "one-step-crust").starts_with("12 samples with"));
  finding.text =
      "a-union: triangles misjudged by rounding: their balls have a common sample, so their orthogonal radius is "
      "zero";
  finding.count = 207;
  const std::string text = text_of(finding, "a-union");
  CHECK(text.starts_with("207 triangles misjudged by rounding"));
  CHECK(text.find("a-union") == std::string::npos);
  CHECK(text.ends_with("(union of the inner balls)"));
  finding.text = "words of a later version";
  CHECK(text_of(finding, "curve") == "207 words of a later version");
}

TEST_CASE("what is being computed has a name of its own") {
  std::set<std::string> names;
  for (const std::string_view id : builtins().structures()) {
    const std::string name = structure_name(id);
    INFO(id);
    CHECK(name != id);
    // Ids have hyphens; of words only the v-points do.
    const std::size_t hyphen = name.find('-');
    CHECK((hyphen == std::string::npos || hyphen == name.find("v-points") + 1));
    names.insert(name);
  }
  // Own balls have one name as they are and as they are scaled.
  CHECK(names.size() + 1 >= builtins().structures().size());
  CHECK(task_text("axis-certificate") == "Checking the theorem");
  CHECK(task_text("b-power-diagram") == "Computing the power diagram of your own balls");
  CHECK(task_text("some-new-thing") == "Computing some new thing");
}

TEST_CASE("every parameter has a title, and words for each of its choices") {
  const auto check = [](const Parameter& parameter) {
    INFO(parameter.id);
    const std::string title = title_of(parameter);
    CHECK_FALSE(title.empty());
    CHECK(title.find('-') == std::string::npos);
    const auto choices = parameter.choices;
    if (!choices.empty()) CHECK(static_cast<double>(choices.size()) == parameter.high - parameter.low + 1.0);
    // Numbers of a switch or a choice are not seen in the window.
    if (parameter.is_whole) {
      const std::string text = spoken_explanation(parameter);
      CHECK(text.find("0: ") == std::string::npos);
      CHECK(text.find("1: ") == std::string::npos);
    }
  };
  for (const Parameter& parameter : builtins().parameters()) check(parameter);
  for (const Parameter& parameter : parameters_of(builtins().evolutions().all())) check(parameter);
  CHECK(title_of(Parameter::a_scale) == "Inner balls: scale");
}

TEST_CASE("explanations in the window name parameters by their titles") {
  CHECK(with_titles("twice lambda-limit apart; with keep-topology also those, not my-lambda-limit") ==
        "twice \"Lambda: limit\" apart; with \"Filters keep the topology\" also those, not my-lambda-limit");
  CHECK(with_titles("scale-axis-factor") == "\"Scale axis: factor\"");
  CHECK(with_titles("transects of a shape").find('"') == std::string::npos);
  for (const Parameter& parameter : computation_parameters()) {
    if (!parameter.id.contains('-')) continue;
    for (const LayerDescriptor& layer : builtins().layers())
      CHECK_FALSE(with_titles(layer.tooltip).contains(parameter.id));
    for (const Parameter& other : computation_parameters())
      CHECK_FALSE(spoken_explanation(other).contains(parameter.id));
  }
}

TEST_CASE("a place is shown with its twenty nearest neighbours") {
  Editor editor([](const auto&) {});
  SampleData data;
  for (int i = 0; i <= 100; ++i) data.positions.push_back({static_cast<double>(i), 0.0});
  data.balls.push_back({{50.0, 30.0}, 25.0});
  REQUIRE(editor.load(data));
  const Box2 box = neighborhood_of(editor.document(), {50.0, 0.0});
  CHECK(box.center() == Vec2{50.0, 0.0});
  // The ball's circle is five away, so it is one of the twenty.
  CHECK(box.width() == Approx(2 * 9.0));
  const Box2 end = neighborhood_of(editor.document(), {0.0, 0.0});
  CHECK(end.width() == Approx(2 * 19.0));
  SampleData few;
  few.positions = {{1.0, 1.0}, {4.0, 1.0}};
  REQUIRE(editor.load(few));
  CHECK(neighborhood_of(editor.document(), {1.0, 1.0}).width() == Approx(6.0));
  CHECK(neighborhood_of(Editor([](const auto&) {}).document(), {1.0, 1.0}).width() == 0.0);
}
