// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <span>
#include <string>
#include <vector>

#include "app/actions/messages.h"
#include "app/actions/refusal.h"

using namespace mes;

TEST_CASE("problems that come together are all in the log, and the first ones above the canvas") {
  Messages messages;
  messages.problem("old");
  messages.problems({});
  CHECK(messages.problem() == "old");
  std::vector<std::string> texts;
  for (int i = 0; i < 8; ++i) texts.push_back("kind " + std::to_string(i));
  messages.problems(std::span(texts).first(2));
  CHECK(messages.problem() == "kind 0\nkind 1");
  messages.problems(texts);
  CHECK(messages.problem() == "kind 0\nkind 1\nkind 2\nkind 3\nkind 4\nkind 5\nand 2 more, in View > Log");
  REQUIRE(messages.entries().size() == 11);
  for (int i = 0; i < 8; ++i) {
    CHECK(messages.entries()[3 + static_cast<std::size_t>(i)].text == texts[static_cast<std::size_t>(i)]);
    CHECK(messages.entries()[3 + static_cast<std::size_t>(i)].is_problem);
  }
}

TEST_CASE("notices are not problems, and a repeated notice counts as a new one") {
  Messages messages;
  messages.notice("two lines were left out");
  CHECK(messages.problem().empty());
  CHECK(messages.notice() == "two lines were left out");
  REQUIRE(messages.entries().size() == 1);
  CHECK_FALSE(messages.entries().front().is_problem);
  const auto number = messages.notice_number();
  messages.notices({});
  CHECK(messages.notice_number() == number);
  messages.notice("two lines were left out");
  CHECK(messages.notice_number() != number);
  messages.problem("not written");
  CHECK_FALSE(messages.notice().empty());
  messages.clear_notice();
  CHECK(messages.problem() == "not written");
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
  messages.problem("of another");
  fields.forget();
  CHECK(messages.problem() == "of another");
  fields.say({ErrorCode::bad_input, "no number"});
  CHECK(messages.problem() == "no number");
  clipboard.forget();
  CHECK(messages.problem() == "no number");
  fields.forget();
  CHECK(messages.problem().empty());
  fields.say({ErrorCode::bad_input, "no number"});
  clipboard.say({ErrorCode::bad_input, "no text"});
  fields.forget();
  CHECK(messages.problem() == "no text");
  CHECK(messages.entries().size() == 3);  // each stays in the log, and what is repeated is counted
}
