// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>

#include "core/base/rng.h"
#include "core/io/format.h"
#include "core/io/session/session.h"

using namespace mes;

namespace {

std::shared_ptr<const CurveSet> some_curves() {
  PlaneCurve curve({0.1, -0.0});
  curve.line_to({1.0 / 3.0, 2});
  curve.quadratic_to({1e-300, 5}, {3, 4});
  curve.cubic_to({1, 2}, {3, 4}, {5, 6});
  curve.arc_to({{1, 2}, {3, 0.1}, {0, 4}, 0.5, -6.25}, {7, 8});
  curve.close();
  curve.name = "a \"name\"";
  PlaneCurve open({1e200, 1});
  open.line_to({2, 3});
  return std::make_shared<const CurveSet>(CurveSet{{curve, open}, {{5, 6}}});
}

Session sample_session() {
  Session session;
  session.title = "Elephant \"1\"";
  session.data = std::make_shared<const SampleData>(
      SampleData{{{0.1, 1e-15}, {1.0 / 3.0, -2}, {3, 1e15}},
                 {{true, {0, 1, 2}}, {false, {2}}},
                 {{{1, 2}, 0.3}},
                 {{.text = "$r_1$ \"is\"\nlong", .anchors = {{{0.1, -1e-100}, {}}}, .letters = 20.5}},
                 std::make_shared<const CurveSource>(
                     CurveSource{some_curves(), {.rule = SamplingRule::spacing, .spacing = 0.1}, 1, 2}),
                 MapPlane{MapProjection::equirectangular, 24.9, -1.0 / 3.0}});
  LayerStyle style;
  style.color = {1, 2, 3};
  style.color_map = "viridis";
  style.range_locked = true;
  style.range_low = -0.1;
  style.thin_when_dense = false;
  session.layers = {{{"points", true, style}, {"curve", false, {}}}, {"traced.png", {0.5, 0.25}, 3}};
  session.settings.precision = Precision::exact;
  session.settings[Parameter::medial_sampling_angle] = 171.7;
  session.evolution = {"noise", 18446744073709551615U, 3, {{"noise-factor", 0.1}, {"noise-isotropic", 1}}};
  session.view.add(Vec2{-0.1, 0.2});
  session.view.add(Vec2{5, 6});
  session.entries = {
      GestureBegun{"Move\nsamples"},
      TimelineEdit{.moved = {{0, {0.7, 0.1}}, {2, {5, 1e-17}}}},
      TimelineEdit{.moved = {{0, {0.8, 0.1}}, {2, {6, 1e-17}}}},
      GestureEnded{},
      TimelineEdit{
          .name = "Smooth, 3 steps", .moved = {{1, {2, 2}}}, .inserted = {{9, 9}}, .curve = {{{true, {0, 1, 2, 3}}}}},
      Undone{},
      Redone{},
      TimelineEdit{.name = "Delete", .removed = {1}, .removed_balls = {0}},
      TimelineEdit{.name = "Annotate",
                   .annotations = Annotations{{.kind = AnnotationKind::angle,
                                               .anchors = {{{1.0 / 3.0, 2}, {0}}, {{3, 4}, {0, 1, 2}}, {{5, 6}, {}}},
                                               .shift = {0.1, -30},
                                               .color = Rgb{1, 2, 254}},
                                              {.kind = AnnotationKind::leader, .anchors = {{}}},
                                              {.kind = AnnotationKind::highlight,
                                               .text = "a ball",
                                               .anchors = {{{0, 0}, {0, 1, 2}}, {{1, 2}}, {{3, 4}}, {{5, 1}}},
                                               .elements = {{PrimitiveKind::disk, ProvenanceRole::product, 1.1},
                                                            {PrimitiveKind::ray, ProvenanceRole::origin}}},
                                              {.kind = AnnotationKind::highlight,
                                               .anchors = {{.at = {0, 0}, .balls = {0, 0}, .scale = 1.1},
                                                           {.at = {1, 2}, .balls = {0, 0, 0, 0}, .along = 1.0 / 3.0},
                                                           {.at = {5, 6}}},
                                               .elements = {{PrimitiveKind::segment, ProvenanceRole::itself},
                                                            {PrimitiveKind::point, ProvenanceRole::origin}}}}},
      TimelineEdit{.name = "Annotate", .annotations = Annotations{}},
      TimelineEdit{.name = "Sample",
                   .inserted = {{4, 4}},
                   .source = SourceEdit{.sampling = {.rule = SamplingRule::feature_size,
                                                     .count = 77,
                                                     .least_each = 0,
                                                     .share = 0.3,
                                                     .turn = 0.7,
                                                     .epsilon = 0.123,
                                                     .corner_angle = 0.25,
                                                     .corner_radius = 1.5,
                                                     .jitter = 0.5,
                                                     .seed = 18446744073709551615U},
                                        .first = 3,
                                        .count = 1}},
      TimelineEdit{.name = "Shape", .source = SourceEdit{.curves = some_curves(), .sampling = {.count = 3}}},
      TimelineEdit{.name = "No curves", .source = SourceEdit{.has_curves = false}},
      TimelineEdit{.name = "Ball", .inserted_balls = {{{1, 1}, 0}}},
      TimelineEdit{.name = "Radius", .continues = true, .changed_balls = {{1, {{1, 1}, 0.1}}}},
      LayersChanged{{{"curve", true, style}}, {"curve", "points"}, BackgroundImage{"a.png", {1, 2}, 3}},
      LayersChanged{{{"curve", true, {}}}, {}, BackgroundImage{}},
      SettingsChanged{session.settings},
      ViewChanged{session.view},
      Captioned{"Now \xc3\xa4 the axis"},
      Captioned{"", 2.5}};
  session.lesson = {"What \xc3\xa4 crust is",
                    {{.caption = "# One\n\n**Bold** and $x_1$", .position = 0},
                     {.caption = "",
                      .position = session.entries.size(),
                      .layers = {{{"points", true, style}}, {"a.png", {1, 2}, 3}},
                      .settings = session.settings,
                      .view = session.view,
                      .seconds = 0.1},
                     {.caption = "Back", .position = 4, .settings = ComputationSettings{}}}};
  session.panes = {ParameterChoice{Parameter::a_scale, 1.1}, Bundle{"Two \"lines\"", session.layers},
                   EvolvedChoice{kMostPaneStep}};
  session.pane_views = {session.view, {}, session.view};
  return session;
}

bool equal(const Session& a, const Session& b) {
  return a.title == b.title && a.data->positions == b.data->positions && a.data->contours == b.data->contours &&
         a.data->balls == b.data->balls && a.data->annotations == b.data->annotations && a.data->map == b.data->map &&
         (a.data->source == b.data->source || *a.data->source == *b.data->source) && a.entries == b.entries &&
         a.layers == b.layers && a.settings == b.settings && a.evolution == b.evolution && a.view == b.view &&
         a.lesson == b.lesson && a.panes == b.panes && a.pane_views == b.pane_views;
}

}  // namespace

TEST_CASE("panes at the ends of their bounds do not cost the session") {
  Session session = sample_session();
  session.panes = {Bundle{std::string(1000, '"'), session.layers}, EvolvedChoice{kMostPaneStep + 1}};
  const auto read = read_session(write_session(session), "a.json");
  REQUIRE(read);
  REQUIRE(read->panes.size() == 2);
  CHECK(read->panes[0] == session.panes[0]);
  CHECK(read->panes[1] == PaneChoice(EvolvedChoice{kMostPaneStep}));
}

TEST_CASE("a session reads back equal, and equal sessions are equal bytes") {
  const Session session = sample_session();
  const std::string text = write_session(session);
  CHECK(looks_like_session(text));
  const auto read = read_session(text, "a.json");
  REQUIRE(read);
  CHECK(equal(*read, session));
  CHECK(write_session(*read) == text);
  const auto empty = read_session(write_session({}), "empty.json");
  REQUIRE(empty);
  CHECK(equal(*empty, {}));
}

TEST_CASE("curves that make no sense are refused with line and column") {
  const auto with = [](const std::string& source) {
    return read_session(
        R"({"mesecina":"session","schema":1,"data":{"samples":[1,2],)" + ("\n\"source\":" + source) + "}}",
        "bad.json");
  };
  const std::string sampling = R"("sampling":{"rule":"number","number":5},"first":0,"count":1)";
  CHECK(with(R"({"drawing":{"curves":[{"closed":false,"points":[0,0,1,1]}]},)" + sampling + "}"));
  for (const auto& [source, says] : std::vector<std::pair<std::string, std::string>>{
           {"{" + sampling + "}", "a source without curves"},
           {R"({"drawing":{"curves":[{"points":[0,0,1,1]}]},)" + sampling + "}", "whether it is closed"},
           {R"({"drawing":{"curves":[{"closed":true,"points":[0,0,1,1]}]},)" + sampling + "}",
            "do not fit its pieces"},
           {R"({"drawing":{"curves":[{"closed":false,"points":[0,0,1]}]},)" + sampling + "}", "\"points\""},
           {R"({"drawing":{"curves":[{"closed":false,"points":[0,"x"]}]},)" + sampling + "}", "not a number"},
           {R"({"drawing":{"curves":[{"closed":false,"points":[]}]},)" + sampling + "}", "has no points"},
           {R"({"drawing":{"curves":[{"closed":false,"points":[0,0,1,1],"kinds":"Z"}]},)" + sampling + "}", "letter"},
           {R"({"drawing":{"curves":[{"closed":false,"points":[0,0,1,1],"kinds":"A"}]},)" + sampling + "}",
            "do not fit"},
           {R"({"drawing":{"curves":7},)" + sampling + "}", "not a list"},
           {R"({"drawing":{},"sampling":3,"first":0,"count":0})", "\"sampling\" is not an object"},
           {R"({"drawing":{},"sampling":{"rule":"spacing"},"first":0,"count":0})", "the spacing of samples is zero"},
           {R"({"drawing":{},"sampling":{"rule":"number","number":0},"first":0,"count":0})",
            "number of samples is zero"},
           {R"({"drawing":{},"sampling":{},"first":-1,"count":0})", "not a whole number"}}) {
    const auto read = with(source);
    INFO(source);
    REQUIRE_FALSE(read);
    CHECK_THAT(read.error().message(), Catch::Contains(says));
  }
  // Samples that do not exist are found when the document is made.
  const auto far = with(R"({"drawing":{},"sampling":{},"first":0,"count":2})");
  REQUIRE(far);
  DocumentReplay replay;
  CHECK_FALSE(replay_session(*far, replay, "bad.json"));
}

TEST_CASE("a caption shown for no time is equal to one shown for less than that") {
  const std::string zero = R"({"mesecina":"session","schema":1,"timeline":[{"caption":"Now","seconds":0}]})";
  const auto expected = read_session(zero, "zero.json");
  REQUIRE(expected);
  for (const std::string seconds : {"-0.0", "-1"}) {
    std::string text = zero;
    text.replace(text.rfind('0'), 1, seconds);
    const auto session = read_session(text, "negative.json");
    REQUIRE(session);
    CHECK(session->entries == expected->entries);
    CHECK(write_session(*session) == write_session(*expected));
  }
}

TEST_CASE("steps of a lesson stand where they stood when entries of a later version are left out") {
  const auto session = read_session(R"({"mesecina":"session","schema":1,
    "lesson":{"steps":[{"caption":"end","position":5},{"position":0},{"position":3,"seconds":-1},{"position":2},
      {"position":1,"seconds":1e9,"scent":"rose"}]},
    "timeline":[{"teleport":3},{"edit":{"insert":[3,4]}},{"teleport":4},{"edit":{"insert":[5,6]}},{"teleport":5}]})",
                                    "later.json");
  REQUIRE(session);
  CHECK(session->entries.size() == 2);
  std::vector<std::size_t> positions;
  std::vector<double> seconds;
  for (const LessonStep& step : session->lesson.steps) {
    positions.push_back(step.position);
    seconds.push_back(step.seconds);
  }
  CHECK(positions == std::vector<std::size_t>{2, 0, 1, 1, 0});
  CHECK(seconds == std::vector<double>{0, 0, 0, 0, kLongestLessonStep});
}

TEST_CASE("a lesson that makes no sense is refused with line and column") {
  const auto with = [](const std::string& lesson) {
    return "{\"mesecina\":\"session\",\"schema\":1,\n\"lesson\":" + lesson + ",\"timeline\":[{\"undo\":1}]}";
  };
  std::string many = "{\"steps\":[{}";
  for (std::size_t i = 0; i < kMostLessonSteps; ++i) many += ",{}";
  struct Case {
    std::string lesson;
    const char* says;
    std::uint64_t column;
  };
  for (const Case& each : std::initializer_list<Case>{
           {"7", "lesson: not an object", 10},
           {R"({"title":7})", "\"title\" is not a text", 19},
           {R"({"steps":{}})", "\"steps\" is not a list", 19},
           {R"({"steps":[{},4]})", "step 2 of the lesson: not an object", 23},
           {R"({"steps":[{"caption":4}]})", "step 1 of the lesson: \"caption\" is not a text", 31},
           {R"({"steps":[{"caption":")" + std::string(kLongestLessonCaption + 1, 'a') + R"("}]})",
            "longer than 10000 bytes", 31},
           {R"({"title":")" + std::string(kLongestLessonTitle + 1, 'a') + R"("})", "longer than 1000 bytes", 19},
           {R"({"steps":[{"position":-1}]})", "counts entries", 32},
           {R"({"steps":[{"position":0.5}]})", "counts entries", 32},
           {R"({"steps":[{"position":"1"}]})", "counts entries", 32},
           {R"({"steps":[{"position":1},{"position":2}]})", "position 2 on a timeline of 1 entry", 47},
           {R"({"steps":[{"position":18446744073709551615}]})", "position 18446744073709551615", 32},
           {R"({"steps":[{"layers":[]}]})", "step 1 of the lesson: layers", 30},
           {R"({"steps":[{"settings":7}]})", "\"settings\" is not an object", 32},
           {R"({"steps":[{"view":[1,2,3]}]})", "step 1 of the lesson: view", 28},
           {R"({"steps":[{"seconds":"1"}]})", "\"seconds\" is not a number", 31},
           {many + "]}", "1001 steps, more than 1000", 19}}) {
    const auto refused = read_session(with(each.lesson), "a.json");
    INFO(each.lesson.substr(0, 100));
    REQUIRE_FALSE(refused);
    CHECK(refused.error().code == ErrorCode::bad_input);
    CHECK_THAT(refused.error().text, Catch::Contains(each.says));
    CHECK(refused.error().line == 2);
    CHECK(refused.error().column == each.column);
  }
}

TEST_CASE("every kind of pane reads back, and kinds of a later version are left out") {
  const std::vector<PaneChoice> kinds{Precision::naive,    ParameterChoice{Parameter::p_scale, 0.9},
                                      FamilyKind::polar,   FamilyKind::own,
                                      Bundle{.name = "a"}, EvolvedChoice{0},
                                      BeforeLastEdit{}};
  for (const PaneChoice& kind : kinds) {
    Session session;
    session.panes = {kind};
    const auto read = read_session(write_session(session), "a.json");
    REQUIRE(read);
    CHECK(read->panes == session.panes);
  }
  const auto panes_of = [](const std::string& panes) {
    const auto read = read_session(R"({"mesecina":"session","schema":1,"panes":)" + panes + "}", "a.json");
    REQUIRE(read);
    return read->panes;
  };
  CHECK(panes_of("[]").empty());
  CHECK(panes_of(R"([{"hologram":1},{"precision":"quantum"},{"step":3,"scent":"rose"}])") ==
        std::vector<PaneChoice>{EvolvedChoice{3}});
  CHECK(panes_of(R"([{"parameter":"warp","value":1},{"family":"cubes"}])") ==
        std::vector<PaneChoice>{ParameterChoice{{.id = "warp"}, 1.0}});
  // Its range is that of every number.
  const auto warp = std::get<ParameterChoice>(panes_of(R"([{"parameter":"warp","value":1}])").front());
  CHECK(within(warp.parameter, -1e9) == -1e9);
  const double most = Parameter::a_scale.high;
  CHECK(panes_of(R"([{"parameter":"a-scale","value":1e9}])") ==
        std::vector<PaneChoice>{ParameterChoice{Parameter::a_scale, most}});
  // A pane without a view of its own among others that have one shows everything; one of a later version takes its
  // view along.
  const auto some =
      read_session(R"({"mesecina":"session","schema":1,"panes":[{"step":3},{"hologram":1,"view":[1,1,2,2]},)"
                   R"({"step":4,"view":[8,9,1,2]},{"step":5,"view":[]}]})",
                   "a.json");
  REQUIRE_FALSE(some);  // four panes
  const auto free =
      read_session(R"({"mesecina":"session","schema":1,"panes":[{"step":3},{"hologram":1,"view":[1,1,2,2]},)"
                   R"({"step":4,"view":[8,9,1,2]}]})",
                   "a.json");
  REQUIRE(free);
  CHECK(free->panes.size() == 2);
  REQUIRE(free->pane_views.size() == 2);
  CHECK(free->pane_views[0].is_empty());
  CHECK(free->pane_views[1].low == Vec2{1, 2});
  CHECK(free->pane_views[1].high == Vec2{8, 9});
  // A session without any is the text that it was before there were panes.
  CHECK(write_session({}).find("panes") == std::string::npos);
}

TEST_CASE("panes that make no sense are refused with line and column") {
  struct Case {
    std::string panes;
    const char* says;
    std::uint64_t column;
  };
  for (const Case& each : std::initializer_list<Case>{
           {"7", "panes: not a list", 9},
           {"{}", "panes: not a list", 9},
           {"[{},{},{},{}]", "panes: 4, more than 3", 9},
           {"[{\"step\":1,\"view\":3}]", "pane 1: \"view\" is not two corners", 27},
           {"[{\"step\":1,\"view\":[1,2]}]", "pane 1: \"view\" is not two corners", 27},
           {"[{\"step\":1,\"view\":[1,2,\"a\",3]}]", "pane 1: \"view\" has something that is not a number", 32},
           {"[{},4]", "pane 2: not an object", 13},
           {R"([{"precision":4}])", "pane 1: \"precision\" is not a short text", 23},
           {R"([{"precision":")" + std::string(1001, 'a') + R"("}])", "\"precision\" is not a short text", 23},
           {R"([{"parameter":"a-scale","value":"1"}])", "pane 1: \"value\" is not a number", 41},
           {R"([{"parameter":"a-scale"}])", "pane 1: \"value\" is not a number", 10},
           {R"([{"family":1}])", "pane 1: \"family\" is not a short text", 20},
           {R"([{"bundle":1}])", "pane 1: \"bundle\" is not an object", 20},
           {R"([{"bundle":{"name":"a","layers":7}}])", "pane 1: ", 20},
           {R"([{"step":-1}])", "pane 1: \"step\" is not a whole number of at most 1000000", 18},
           {R"([{"step":1000001}])", "pane 1: \"step\" is not a whole number of at most 1000000", 18}}) {
    const auto refused =
        read_session("{\"mesecina\":\"session\",\"schema\":1,\n\"panes\":" + each.panes + "}", "a.json");
    INFO(each.panes.substr(0, 100));
    REQUIRE_FALSE(refused);
    CHECK(refused.error().code == ErrorCode::bad_input);
    CHECK_THAT(refused.error().text, Catch::Contains(each.says));
    CHECK(refused.error().line == 2);
    CHECK(refused.error().column == each.column);
  }
}

TEST_CASE("a journal keeps its lesson, also where entries are torn off") {
  const Session session = sample_session();
  std::string text = write_journal_head(session);
  CHECK(std::ranges::count(text, '\n') == 1);
  for (const TimelineEntry& entry : session.entries) text += write_journal_line(entry);
  const auto whole = read_journal(text, "a.journal");
  REQUIRE(whole);
  CHECK(whole->session.lesson == session.lesson);
  const auto torn = read_journal(text.substr(0, text.find('\n') + 3), "torn.journal");
  REQUIRE(torn);
  REQUIRE(torn->is_torn);
  REQUIRE(torn->session.lesson.steps.size() == 3);
  for (const LessonStep& step : torn->session.lesson.steps) CHECK(step.position == 0);
  CHECK(read_session(write_session(torn->session), "saved.json"));
}

TEST_CASE("a session is a source of samples and balls: those of its last state") {
  const auto file = read_sample_bytes(write_session(sample_session()), "a.json");
  REQUIRE(file);
  CHECK(file->format == "session");
  CHECK(file->data.positions == std::vector<Vec2>{{0.8, 0.1}, {6, 1e-17}, {9, 9}, {4, 4}});
  REQUIRE(file->data.contours.size() == 1);
  CHECK(file->data.contours[0].points == std::vector<std::uint32_t>{0, 1, 2});
  REQUIRE(file->data.balls.size() == 1);
  CHECK(file->data.balls[0].radius == 0.1);
}

TEST_CASE("samples that a contour of a session has more than once are said in one line, as they are now") {
  const auto warnings_of = [](std::vector<std::uint32_t> points, TimelineLog entries = {}) {
    Session session;
    session.data = std::make_shared<const SampleData>(
        SampleData{.positions = {{0, 0}, {4, 0}, {2, 2}, {4, 4}, {0, 4}}, .contours = {{true, std::move(points)}}});
    session.entries = std::move(entries);
    const auto file = read_sample_bytes(write_session(session), "a.json");
    REQUIRE(file);
    return file->warnings;
  };
  const std::vector<std::string> one{"a.json: 1 sample is on its contour more than once; evolutions do not move it"};
  CHECK(warnings_of({0, 1, 2, 3, 4}).empty());
  CHECK(warnings_of({0, 1, 2, 3, 4, 2}) == one);
  CHECK(
      warnings_of({0, 1, 2, 3, 1, 2}) ==
      std::vector<std::string>{"a.json: 2 samples are on their contour more than once; evolutions do not move them"});
  // Named twice in a row, and around the end, it is one corner.
  CHECK(warnings_of({0, 1, 1, 2, 0}).empty());
  TimelineLog without_the_sample;
  TimelineEdit edit{.name = "Delete"};
  edit.removed = {2};
  without_the_sample.push_back(edit);
  CHECK(warnings_of({0, 1, 2, 3, 4, 2}, without_the_sample).empty());
}

TEST_CASE("what can be undone is not skipped: kinds of annotations that are not known are refused in one line") {
  for (const char* annotation :
       {R"({"kind":"fresco","at":"a wall"})", R"({"kind":"highlight","at":[1,2],"elements":[["torus","itself",7]]})",
        R"({"kind":"highlight","at":[1,2],"elements":[["point","cousin"]]})"}) {
    for (const char* place : {R"("data":{"annotations":[@]})", R"("timeline":[{"edit":{"annotations":[@]}}])"}) {
      std::string text = std::string(R"({"mesecina":"session","schema":1,)") + place + "}";
      text.replace(text.find('@'), 1, annotation);
      INFO(text);
      const auto read = read_session(text, "a.json");
      REQUIRE_FALSE(read);
      CHECK(read.error().code == ErrorCode::bad_input);
      const std::string message = read.error().message();
      CHECK(message.starts_with("a.json"));
      CHECK(message.find("misspelled, or of a later one") != std::string::npos);
      CHECK(message.find('\n') == std::string::npos);
    }
  }
}

TEST_CASE("a session asks for as late a reader as its contents need") {
  const auto schema_of = [](const Annotations& of_data, const Annotations& of_entry) {
    Session session;
    session.data = std::make_shared<const SampleData>(
        SampleData{.positions = {{1, 2}}, .balls = {{{3, 4}, 5}}, .annotations = of_data});
    session.entries = {TimelineEdit{.name = "Annotate", .annotations = of_entry}};
    const std::string text = write_session(session);
    const auto read = read_session(text, "a.json");
    REQUIRE(read);
    CHECK(equal(*read, session));
    const std::string key = "\"schema\":";
    return text.at(text.find(key) + key.size());
  };
  const Annotations words{{.kind = AnnotationKind::leader, .text = "a", .anchors = {{.samples = {0}}}}};
  const Annotations on_ball{{.kind = AnnotationKind::leader, .text = "a", .anchors = {{.balls = {0}}}}};
  const Annotations highlight{
      {.kind = AnnotationKind::highlight, .anchors = {{}}, .elements = {{PrimitiveKind::point, {}}}}};
  CHECK(schema_of({}, {}) == '1');
  CHECK(schema_of(words, words) == '1');
  CHECK(schema_of(on_ball, {}) == '2');
  CHECK(schema_of({}, on_ball) == '2');
  CHECK(schema_of(highlight, words) == '2');
  CHECK(schema_of(words, highlight) == '2');
  const Annotations ends{{.kind = AnnotationKind::center_line, .anchors = {{}, {{}, {0}}}}};
  CHECK(schema_of(ends, {}) == '4');
  CHECK(schema_of(words, ends) == '4');
  // Highlights of files that said 1 are read.
  CHECK(read_session(R"({"mesecina":"session","schema":1,"data":{"annotations":[
    {"kind":"highlight","at":[1,2],"elements":[["point","itself"]]}]}})",
                     "a.json"));
}

TEST_CASE("what is not known is skipped, what makes no sense is refused") {
  const auto read = [](const std::string& text) { return read_session(text, "a.json"); };
  const auto later = read(R"({"mesecina":"session","schema":1,"of the future":[1],
    "data":{"samples":[1,2],"colours":7,"annotations":[
      {"kind":"text","at":[1,2],"letters":1e9,"shift":[-1e9,3],"scent":"rose"}]},
    "settings":{"precision":"quantum","parameters":{"medial-sampling-angle":1e9,"union-shortcut":0.2,"x":1}},
    "timeline":[{"teleport":3},{"edit":{"insert":[3,4],"why":"because"}}]})");
  REQUIRE(later);
  CHECK(later->entries.size() == 1);
  REQUIRE(later->data->annotations.size() == 1);
  CHECK(later->data->annotations[0].letters == kMostLetters);
  CHECK(later->data->annotations[0].shift == Vec2{-kMostShift, 3});
  CHECK(later->settings.precision == Precision::fast);
  CHECK(later->settings[Parameter::medial_sampling_angle] == 179.9);
  CHECK(later->settings[Parameter::union_shortcut] == 0.0);
  // A parameter that is not known is kept, and counts once something asks for it.
  CHECK(later->settings[Parameter{.id = "x", .high = 2.0}] == 1.0);
  CHECK(later->settings[Parameter{.id = "x", .high = 0.5}] == 0.5);
  const auto again = read(write_session(*later));
  REQUIRE(again);
  CHECK(again->settings == later->settings);
  CHECK(again->settings[Parameter{.id = "x", .high = 2.0}] == 1.0);
  CHECK_FALSE(again->settings == ComputationSettings{});
  for (
      const char* text :
      {"",
       "{}",
       "[]",
       "null",
       R"({"mesecina":"session"})",
       R"({"mesecina":"session","schema":5})",
       R"({"mesecina":"session","schema":1,"data":{"samples":[1]}})",
       R"({"mesecina":"session","schema":1,"data":{"samples":[1,"2"]}})",
       R"({"mesecina":"session","schema":1,"data":{"samples":{"0":1}}})",
       R"({"mesecina":"session","schema":1,"data":[]})",
       R"({"mesecina":"session","schema":1,"view":[1,2,3]})",
       R"({"mesecina":"session","schema":1,"timeline":{}})",
       R"({"mesecina":"session","schema":1,"timeline":[4]})",
       R"({"mesecina":"session","schema":1,"timeline":[{"edit":{"remove":[-1]}}]})",
       R"({"mesecina":"session","schema":1,"timeline":[{"edit":{"remove":[4294967296]}}]})",
       R"({"mesecina":"session","schema":1,"timeline":[{"begin":7}]})",
       R"({"mesecina":"session","schema":1,"data":{"annotations":{}}})",
       R"({"mesecina":"session","schema":1,"data":{"annotations":[{"at":[1,2]}]}})",
       R"({"mesecina":"session","schema":1,"data":{"annotations":[{"kind":"text","at":[1]}]}})",
       R"({"mesecina":"session","schema":1,"data":{"annotations":[{"kind":"text","at":[1,1e300]}]}})",
       R"({"mesecina":"session","schema":1,"data":{"annotations":[{"kind":"text","at":[1,2],"text":3}]}})",
       R"({"mesecina":"session","schema":1,"data":{"annotations":[{"kind":"text","at":[1,2],"follows":[1]}]}})",
       R"({"mesecina":"session","schema":1,"data":{"annotations":[{"kind":"text","at":[1,2],"color":"red"}]}})",
       R"({"mesecina":"session","schema":1,"data":{"annotations":[{"kind":"highlight","at":[1,2]}]}})",
       R"({"mesecina":"session","schema":1,"data":{"annotations":[{"kind":"highlight","at":[],"elements":[]}]}})",
       R"({"mesecina":"session","schema":1,"data":{"annotations":[{"kind":"highlight","at":[1,2],"elements":[["ray","itself"]]}]}})",
       R"({"mesecina":"session","schema":1,"data":{"annotations":[{"kind":"highlight","at":[1,2],"elements":[["disk","itself"]]}]}})",
       R"({"mesecina":"session","schema":1,"data":{"annotations":[{"kind":"highlight","at":[1,2],"elements":[["disk","itself","2"]]}]}})",
       R"({"mesecina":"session","schema":1,"data":{"annotations":[{"kind":"highlight","at":[1,2],"elements":["point"]}]}})",
       R"({"mesecina":"session","schema":1,"data":{"annotations":[{"kind":"text","at":[1,2],"balls":[1]}]}})",
       R"({"mesecina":"session","schema":1,"data":{"annotations":[{"kind":"text","at":[1,2],"balls":[[0],[0]]}]}})",
       R"({"mesecina":"session","schema":1,"data":{"annotations":[{"kind":"text","at":[1,2],"balls":[[0,1,2,3,4]]}]}})",
       R"({"mesecina":"session","schema":1,"data":{"annotations":[{"kind":"text","at":[1,2],"balls":[[-1]]}]}})",
       R"({"mesecina":"session","schema":1,"data":{"annotations":[{"kind":"text","at":[1,2],"balls":[[0]],"follows":[[0]]}]}})",
       R"({"mesecina":"session","schema":1,"data":{"annotations":[{"kind":"text","at":[1,2],"balls":[[0]],"scales":[0]}]}})",
       R"({"mesecina":"session","schema":1,"data":{"annotations":[{"kind":"text","at":[1,2],"balls":[[0]],"scales":7}]}})",
       R"({"mesecina":"session","schema":1,"data":{"annotations":[{"kind":"text","at":[1,2],"balls":[[0]],"along":[1]}]}})",
       R"({"mesecina":"session","schema":1,"data":{"annotations":[{"kind":"text","at":[1,2],"scales":[2]}]}})",
       R"({"mesecina":"session","schema":1,"timeline":[{"edit":{"annotations":[7]}}]})",
       R"({"mesecina":"session","schema":1,"evolution":{"seed":-1}})",
       R"({"mesecina":"session","schema":1,"evolution":{"parameters":{"x":"y"}}})"}) {
    INFO(text);
    const auto refused = read(text);
    REQUIRE_FALSE(refused);
    CHECK(refused.error().code == ErrorCode::bad_input);
    CHECK(refused.error().message().find('\n') == std::string::npos);
  }
  // Well formed, but of samples and balls that are not there.
  for (
      const char* text :
      {R"({"mesecina":"session","schema":1,"timeline":[{"edit":{"remove":[0]}}]})",
       R"({"mesecina":"session","schema":1,"timeline":[{"edit":{"annotations":[{"kind":"text","at":[1,2],"balls":[[0]]}]}}]})",
       R"({"mesecina":"session","schema":1,"timeline":[{"edit":{"annotations":[{"kind":"text","at":[1,2],"follows":[[0]]}]}}]})"}) {
    const auto impossible = read_sample_bytes(text, "a.json");
    REQUIRE_FALSE(impossible);
    CHECK(impossible.error().message().find("entry 1") != std::string::npos);
  }
}

TEST_CASE("a journal is read up to where it was torn") {
  const Session session = sample_session();
  std::string text = write_journal_head(session);
  const std::size_t head = text.size();
  std::vector<std::size_t> ends;
  for (const TimelineEntry& entry : session.entries) {
    text += write_journal_line(entry);
    ends.push_back(text.size());
  }
  for (std::size_t cut = 0; cut <= text.size(); ++cut) {
    const auto journal = read_journal(std::string_view(text).substr(0, cut), "x.journal");
    REQUIRE(journal.has_value() == (cut >= head));
    if (!journal) continue;
    const auto whole =
        static_cast<std::size_t>(std::ranges::count_if(ends, [cut](std::size_t end) { return end <= cut; }));
    CHECK(journal->session.entries.size() == whole);
    CHECK(journal->is_torn == (text[cut - 1] != '\n'));
    CHECK(journal->complaint.empty());
  }
  const auto all = read_journal(text, "x.journal");
  CHECK(all->unsaved_edits == 13);
  CHECK(all->session.layers.layers.front().layer == "curve");
  CHECK(all->session.layers.image.file.empty());
  CHECK(read_journal(text + write_journal_saved(), "x.journal")->unsaved_edits == 0);
  CHECK(read_journal(text + write_journal_saved() + write_journal_line(Undone{}), "x.journal")->unsaved_edits == 1);
  CHECK(read_journal(text + write_journal_edits_saved(), "x.journal")->unsaved_edits ==
        (session.lesson.steps.empty() ? 0U : 1U));
  CHECK_FALSE(all->file);
  // A hash has 64 bits, more than a double keeps.
  const SourceFile kept{"/tmp/a \"b\" \xC3\xBC.json", {.size = 12, .hash = 0xffff'ffff'ffff'fff1}};
  const auto saved =
      read_journal(text + write_journal_file({"/x.json", {}}) + write_journal_saved(kept), "x.journal");
  REQUIRE(saved->file);
  CHECK(saved->file->path == kept.path);
  CHECK(saved->file->fingerprint == kept.fingerprint);
  CHECK(saved->unsaved_edits == 0);
  CHECK(saved->session.entries.size() == session.entries.size());
  // Such a name cannot be in a text of JSON.
  CHECK(write_journal_file({"/tmp/\xFF.json", {}}).empty());
  // The head says how things stood when the journal began.
  const auto moved = read_journal(text + write_journal_line(ViewChanged{{{7, 7}, {8, 9}}}), "x.journal");
  CHECK(moved->session.view == Box2{{7, 7}, {8, 9}});
  ComputationSettings settings;
  settings.precision = Precision::naive;
  CHECK(read_journal(text + write_journal_line(SettingsChanged{settings}), "x.journal")->session.settings ==
        settings);
  const auto spoiled =
      read_journal(text + "{\"edit\":{\"remove\":[77]}}\n" + write_journal_line(Undone{}), "x.journal");
  REQUIRE(spoiled);
  CHECK(spoiled->session.entries.size() == session.entries.size());
  CHECK_FALSE(spoiled->complaint.empty());
}

TEST_CASE("no bytes make the reader of sessions crash or hang") {
  const std::string good = write_session(sample_session());
  Rng random(5);
  for (int i = 0; i < 4000; ++i) {
    std::string text = good;
    for (std::uint64_t n = 1 + random.below(6); n > 0; --n) {
      const auto at = static_cast<std::size_t>(random.below(text.size()));
      switch (random.below(4)) {
        case 0: text[at] = static_cast<char>(random.below(256)); break;
        case 1: text.erase(at, static_cast<std::size_t>(random.below(40))); break;
        case 2: text.insert(at, text.substr(static_cast<std::size_t>(random.below(text.size())), 30)); break;
        default: text[at] = "0123456789[]{},:\"-e."[random.below(20)];
      }
      if (text.empty()) text = "{";
    }
    const auto session = read_session(text, "fuzz");
    if (!session) {
      CHECK(session.error().code == ErrorCode::bad_input);
      continue;
    }
    DocumentReplay replay;
    static_cast<void>(replay_session(*session, replay, "fuzz"));
  }
}

TEST_CASE("depth is bounded, brackets in texts do not count, and long lists take no longer than their length") {
  const std::string deep(100'000, '[');
  const auto refused = read_session(deep, "deep.json");
  REQUIRE_FALSE(refused);
  CHECK(refused.error().message() == "deep.json:1:65: this JSON is nested too deeply");
  Session session;
  session.title = std::string(500, '[') + "\\\"{{";
  for (int i = 0; i < 200'000; ++i) session.entries.emplace_back(Captioned{});
  const auto read = read_session(write_session(session), "long.json");
  REQUIRE(read);
  CHECK(read->title == session.title);
  CHECK(read->entries.size() == 200'000);
}

TEST_CASE("where a map lies reads back bit for bit, or is refused") {
  const auto read_with = [](const std::string& map) {
    return read_session(
        R"({"mesecina":"session","schema":1,"data":{"samples":[],"contours":[],"balls":[],"map":)" + map + "}}", "a");
  };
  CHECK(read_with(R"({"degrees":"kept"})")->data->map == MapPlane{});
  const std::string page = R"({"page":[210.0,297.5],"projection":"none","unit":"mm"})";
  CHECK(read_with(page)->data->map == MapPlane{.unit = "mm", .page = {210, 297.5}});
  CHECK(read_session(write_session(*read_with(page)), "a")->data->map == read_with(page)->data->map);
  CHECK(read_with(R"({"degrees":"projected","longitude":181.5,"latitude":-17})")->data->map ==
        MapPlane{MapProjection::equirectangular, 181.5, -17});
  for (const char* map : {"1", "{}", R"({"degrees":"lost"})", R"({"degrees":"projected","longitude":1})",
                          R"({"degrees":"projected","longitude":1,"latitude":90.5})",
                          R"({"degrees":"projected","longitude":1000,"latitude":9})", R"({"projection":"lost"})",
                          R"({"projection":"azimuthal","longitude":1})", R"({"projection":"none","system":"a\nb"})",
                          R"({"projection":"none","page":[1]})", R"({"projection":"none","page":[1,-1]})",
                          R"({"projection":"azimuthal","longitude":1,"latitude":91})"}) {
    INFO(map);
    const auto read = read_with(map);
    REQUIRE_FALSE(read);
    CHECK_THAT(read.error().text, Catch::Contains("map"));
  }
}
