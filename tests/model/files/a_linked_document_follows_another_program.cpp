// SPDX-License-Identifier: GPL-3.0-or-later
// Two programs edit one document over a link whose lines take their time, and end with the same samples, balls, contours and settings.
#include <array>
#include <catch2/catch.hpp>
#include <deque>
#include <nlohmann/json.hpp>

#include "app/store/document_link.h"
#include "core/base/rng.h"

using namespace mes;
using Json = nlohmann::json;

namespace {

/// What the other program does: it keeps the lists, and decides which change is the next one.
class OtherSide {
 public:
  std::vector<std::array<double, 2>> samples;
  std::vector<std::array<double, 3>> balls;
  std::vector<std::pair<bool, std::vector<std::size_t>>> contours;
  DocumentLink::Settings settings;
  int refused = 0;

  /// The answer to a proposal; empty: it comes too late.
  std::string take(const std::string& line) {
    const Json change = Json::parse(line);
    if (change["number"] != number_ + 1) {
      ++refused;
      return {};
    }
    make(change);
    return Json{{"accepted", number_}}.dump();
  }
  std::string edit(Rng& rng) {
    Json change{{"number", number_ + 1}, {"name", "There"}};
    if (!samples.empty() && rng.below(2) == 0) change["removed"] = {rng.below(samples.size())};
    if (!samples.empty() && rng.below(2) == 0)
      change["moved"] = {{rng.below(samples.size()), rng.uniform(), rng.uniform()}};
    if (rng.below(2) == 0) change["inserted"] = {{rng.uniform(), rng.uniform()}, {rng.uniform(), rng.uniform()}};
    if (!balls.empty() && rng.below(3) == 0)
      change["moved_balls"] = {{rng.below(balls.size()), rng.uniform(), rng.uniform(), rng.uniform()}};
    if (rng.below(3) == 0) change["inserted_balls"] = {{rng.uniform(), rng.uniform(), 1.0}};
    if (balls.size() > 4) change["removed_balls"] = {0, 2};
    if (rng.below(4) == 0) change["settings"] = {{rng.below(2) == 0 ? "lambda" : "theirs", rng.uniform()}};
    if (rng.below(8) == 0) change["settings"]["precision"] = rng.below(2) == 0 ? "exact" : "naive";
    if (rng.below(4) == 0) {
      const std::size_t count = samples.size() - (change.contains("removed") ? 1U : 0U) +
                                (change.contains("inserted") ? change["inserted"].size() : 0U);
      Json places = Json::array();
      for (std::size_t i = 0; i < count; ++i)
        if (rng.below(2) == 0) places.push_back(i);
      change["contours"] = Json::array();
      if (!places.empty()) change["contours"].push_back({rng.below(2) == 0, places});
    }
    make(change);
    return change.dump();
  }

 private:
  template <class List>
  static void change_list(const Json& change, const std::string& suffix, List& list) {
    for (const Json& one : change.value("moved" + suffix, Json::array()))
      for (std::size_t i = 0; i < list.front().size(); ++i) list[one[0].get<std::size_t>()][i] = one[i + 1];
    const Json removed = change.value("removed" + suffix, Json::array());
    for (auto at = removed.rbegin(); at != removed.rend(); ++at)
      list.erase(list.begin() + at->template get<std::ptrdiff_t>());
    for (const Json& one : change.value("inserted" + suffix, Json::array()))
      list.push_back(one.get<typename List::value_type>());
  }
  void make(const Json& change) {
    const Json removed = change.value("removed", Json::array());
    for (auto& [is_closed, places] : contours)
      for (auto at = removed.rbegin(); at != removed.rend(); ++at) {
        std::erase(places, at->get<std::size_t>());
        for (std::size_t& place : places) place -= place > at->get<std::size_t>() ? 1U : 0U;
      }
    std::erase_if(contours, [](const auto& contour) { return contour.second.empty(); });
    if (change.contains("contours")) {
      contours.clear();
      for (const Json& one : change["contours"])
        contours.emplace_back(one[0].get<bool>(), one[1].get<std::vector<std::size_t>>());
    }
    const Json changed = change.value("settings", Json::object());
    for (const auto& [id, value] : changed.items())
      if (id == "precision")
        settings.precision = value;
      else
        settings.parameters[id] = value;
    change_list(change, "", samples);
    change_list(change, "_balls", balls);
    ++number_;
  }
  std::uint64_t number_ = 0;
};

SampleId random_sample(const Editor& editor, Rng& rng) {
  const auto slots = editor.document().slots_in_input_order();
  return editor.document().id(slots[rng.below(slots.size())]);
}

void edit(Editor& editor, Rng& rng, DocumentLink::Settings& settings) {
  const Document& document = editor.document();
  switch (rng.below(8)) {
    case 5: settings.parameters[rng.below(2) == 0 ? "lambda" : "ours"] = rng.uniform(); break;
    case 6: settings.precision = rng.below(2) == 0 ? "exact" : "fast"; break;
    case 7: {
      CurveOrder contours;
      for (const SampleSlot slot : document.slots_in_input_order())
        if (rng.below(3) != 0) {
          if (contours.contours.empty() || rng.below(4) == 0) contours.contours.push_back({rng.below(2) == 0, {}});
          contours.contours.back().samples.push_back(document.id(slot));
        }
      REQUIRE(editor.set_contours(std::move(contours), "Contours"));
      break;
    }
    case 0: static_cast<void>(editor.insert(std::vector<Vec2>{{rng.uniform(), rng.uniform()}}, "Insert")); break;
    case 1:
      if (document.sample_count() > 0)
        static_cast<void>(editor.remove(std::vector{random_sample(editor, rng)}, "Remove"));
      break;
    case 2:
      if (document.sample_count() > 0)
        static_cast<void>(editor.move(
            std::vector{std::pair{random_sample(editor, rng), Vec2{rng.uniform(), rng.uniform()}}}, "Move"));
      break;
    case 3: static_cast<void>(editor.insert_balls(std::vector<Disk>{{{rng.uniform(), 0.0}, 0.5}}, "Ball")); break;
    default: editor.undo();
  }
}

}  // namespace

TEST_CASE("both sides end with the same, in whatever order their lines arrive") {
  int refused = 0;
  std::size_t contours = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Rng rng(seed);
    Editor editor([](const auto& /*delta*/) {});
    SampleData data;
    OtherSide other;
    for (int i = 0; i < 10; ++i) {
      data.positions.push_back({rng.uniform(), rng.uniform()});
      other.samples.push_back({data.positions.back().x, data.positions.back().y});
    }
    REQUIRE(editor.load(data));
    DocumentLink link;
    DocumentLink::Settings settings{.precision = "fast", .parameters = {{"lambda", 1.0}, {"ours", 0.0}}};
    other.settings = settings;
    link.begin(editor.document(), settings);
    std::deque<std::string> here, there;  // on their way
    const auto deliver_here = [&] {
      if (here.empty()) return;
      const bool is_change = here.front().find("accepted") == std::string::npos;
      const auto answer = link.take(here.front(), editor, settings);
      REQUIRE(answer);
      CHECK(answer->empty() != is_change);
      here.pop_front();
    };
    const auto deliver_there = [&] {
      if (there.empty()) return;
      if (std::string answer = other.take(there.front()); !answer.empty()) here.push_back(std::move(answer));
      there.pop_front();
    };
    for (int step = 0; step < 200; ++step) {
      switch (rng.below(5)) {
        case 0: edit(editor, rng, settings); break;
        case 1: here.push_back(other.edit(rng)); break;
        case 2: deliver_here(); break;
        case 3: deliver_there(); break;
        default:
          if (auto line = link.propose(editor, settings)) there.push_back(*std::move(line));
      }
    }
    for (int round = 0; round < 1000; ++round) {
      while (!here.empty()) deliver_here();
      while (!there.empty()) deliver_there();
      if (auto line = link.propose(editor, settings)) there.push_back(*std::move(line));
      if (here.empty() && there.empty()) break;
    }
    // Contours by places of samples in the plane, which all differ.
    using Loops = std::vector<std::pair<bool, std::vector<std::array<double, 2>>>>;
    Loops our_contours, their_contours;
    const SampleData data_here = data_of(editor.document());
    for (const SampleData::Contour& contour : data_here.contours) {
      auto& loop = our_contours.emplace_back(contour.closed, std::vector<std::array<double, 2>>()).second;
      for (const std::uint32_t place : contour.points)
        loop.push_back({data_here.positions[place].x, data_here.positions[place].y});
    }
    for (const auto& [is_closed, places] : other.contours) {
      auto& loop = their_contours.emplace_back(is_closed, std::vector<std::array<double, 2>>()).second;
      for (const std::size_t place : places) loop.push_back(other.samples[place]);
    }
    CHECK(our_contours == their_contours);
    contours += our_contours.size();
    CHECK(settings == other.settings);
    std::vector<std::array<double, 2>> samples;
    for (const SampleSlot slot : editor.document().slots_in_input_order()) {
      const Vec2 p = editor.document().position(slot);
      samples.push_back({p.x, p.y});
    }
    std::ranges::sort(samples);
    std::ranges::sort(other.samples);
    CHECK(samples == other.samples);
    std::vector<std::array<double, 3>> balls;
    for (const BallSlot slot : editor.document().ball_slots_in_input_order()) {
      const Disk& d = editor.document().disk(slot);
      balls.push_back({d.center.x, d.center.y, d.radius});
    }
    std::ranges::sort(balls);
    std::ranges::sort(other.balls);
    CHECK(balls == other.balls);
    refused += other.refused;
  }
  CHECK(contours > 20);
  CHECK(refused > 20);  // some proposals did cross a change
}

TEST_CASE("lines that make no sense change nothing") {
  Editor editor([](const auto& /*delta*/) {});
  SampleData data;
  data.positions = {{0.0, 0.0}, {1.0, 0.0}};
  REQUIRE(editor.load(data));
  DocumentLink link;
  DocumentLink::Settings settings{.precision = "fast"};
  link.begin(editor.document(), settings);
  const std::uint64_t revision = editor.document().revision();
  for (const std::string line : {"",
                                 "x",
                                 "[]",
                                 "{}",
                                 "3",
                                 R"({"accepted": 1})",
                                 R"({"number": 2})",
                                 R"({"number": 1, "moved": [[2, 0, 0]]})",
                                 R"({"number": 1, "moved": [[0, 0]]})",
                                 R"({"number": 1, "moved": [[-1, 0, 0]]})",
                                 R"({"number": 1, "moved": [[0, 1e999, 0]]})",
                                 R"({"number": 1, "removed": [0, 0]})",
                                 R"({"number": 1, "removed": ["0"]})",
                                 R"({"number": 1, "inserted": [[0]]})",
                                 R"({"number": 1, "inserted": 5})",
                                 R"({"number": 1, "moved": {"a": 1}})",
                                 R"({"number": "1"})",
                                 R"({"number": 1, "contours": [[true, [2]]]})",
                                 R"({"number": 1, "contours": [[1, [0]]]})",
                                 R"({"number": 1, "contours": [[true]]})",
                                 R"({"number": 1, "removed": [0], "contours": [[true, [0, 1]]]})",
                                 R"({"number": 1, "settings": {"lambda": "1"}})",
                                 R"({"number": 1, "settings": {"precision": 1}})",
                                 R"({"number": 1, "settings": [1]})",
                                 R"({"number": 1, "removed_balls": [0]})",
                                 R"({"number": 1, "name": 5, "inserted": [[1, 1]]})"}) {
    INFO(line);
    CHECK_FALSE(link.take(line, editor, settings));
    CHECK(settings == DocumentLink::Settings{.precision = "fast"});
    CHECK(editor.document().revision() == revision);
  }
  CHECK_FALSE(DocumentLink::begun_by("{}"));
  CHECK_FALSE(DocumentLink::begun_by(R"({"session": "x"})"));
  CHECK(link.take(R"({"number": 1, "removed": [0]})", editor, settings));
  CHECK(editor.document().sample_count() == 1);
}
