// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <catch2/catch.hpp>
#include <span>
#include <string>
#include <vector>

#include "app/actions/messages.h"
#include "app/actions/refusal.h"

using namespace mes;

TEST_CASE("problems that come together are all in the log, and the first ones above the canvas") {
  Messages messages;
  messages.problem("Old");
  messages.problems({});
  CHECK(messages.problem() == "Old");
  std::vector<std::string> texts;
  for (int i = 0; i < 8; ++i) texts.push_back("Kind " + std::to_string(i));
  messages.problems(std::span(texts).first(2));
  CHECK(messages.problem() == "Kind 0\nKind 1");
  messages.problems(texts);
  CHECK(messages.problem() == "Kind 0\nKind 1\nKind 2\nKind 3\nKind 4\nKind 5\nand 2 more, in View > Log");
  REQUIRE(messages.entries().size() == 11);
  for (int i = 0; i < 8; ++i) {
    CHECK(messages.entries()[3 + static_cast<std::size_t>(i)].text == texts[static_cast<std::size_t>(i)]);
    CHECK(messages.entries()[3 + static_cast<std::size_t>(i)].is_problem);
  }
}

TEST_CASE("notices are not problems, and a repeated notice counts as a new one") {
  Messages messages;
  messages.notice("Two lines were left out");
  CHECK(messages.problem().empty());
  CHECK(messages.notice() == "Two lines were left out");
  REQUIRE(messages.entries().size() == 1);
  CHECK_FALSE(messages.entries().front().is_problem);
  const auto number = messages.notice_number();
  messages.notices({});
  CHECK(messages.notice_number() == number);
  messages.notice("Two lines were left out");
  CHECK(messages.notice_number() != number);
  messages.problem("Not written");
  CHECK_FALSE(messages.notice().empty());
  messages.clear_notice();
  CHECK(messages.problem() == "Not written");
}

TEST_CASE("each remark and problem counts as said, also one that is said again") {
  Messages messages;
  CHECK(messages.said() == 0);
  messages.remark("done");
  messages.remark("done");
  messages.problem("not done");
  CHECK(messages.said() == 3);
  CHECK(messages.entries().size() == 2);
  messages.clear();
  CHECK(messages.said() == 3);
}

TEST_CASE("a refusal goes when the same part does something, and problems of others stay") {
  Messages messages;
  Refusal fields(messages);
  Refusal clipboard(messages);
  fields.forget();
  messages.problem("Of another");
  fields.forget();
  CHECK(messages.problem() == "Of another");
  fields.say({ErrorCode::bad_input, "no number"});
  CHECK(messages.problem() == "No number");
  clipboard.forget();
  CHECK(messages.problem() == "No number");
  fields.forget();
  CHECK(messages.problem().empty());
  fields.say({ErrorCode::bad_input, "no number"});
  clipboard.say({ErrorCode::bad_input, "No text"});
  fields.forget();
  CHECK(messages.problem() == "No text");
  CHECK(messages.entries().size() == 3);  // each stays in the log, and what is repeated is counted
}

TEST_CASE("messages begin with a large letter, unless they begin with a name") {
  Messages messages;
  const auto remarked = [&](const char* text) {
    messages.remark(text);
    return messages.remark();
  };
  CHECK(remarked("the settings could not be read") == "The settings could not be read");
  CHECK(remarked("epsilon 3 is too large: at most 1") == "Epsilon 3 is too large: at most 1");
  CHECK(remarked("cannot write /tmp/a.poff: no room") == "Cannot write /tmp/a.poff: no room");
  CHECK(remarked("\u00e4 is no number") == "\u00e4 is no number");
  CHECK(remarked("") == "");
  for (const char* name : {"house.poff: no sample", "my house.poff:3:4: no number", "house: no sample",
                           "/tmp/a.poff: no sample", "alpha-radius is too large", "ffmpeg cannot be run", "Saved"})
    CHECK(remarked(name) == name);
  messages.problem("there is no room");
  CHECK(messages.problem() == "There is no room");
  messages.notices(std::array<std::string, 2>{"one is left", "two are gone"});
  CHECK(messages.notice() == "One is left\nTwo are gone");
  CHECK(messages.entries().back().text == "Two are gone");
}
