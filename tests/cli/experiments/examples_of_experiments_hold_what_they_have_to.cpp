// SPDX-License-Identifier: GPL-3.0-or-later
// The experiments that come with the program, and those in its documents.
#include <algorithm>
#include <catch2/catch.hpp>

#include "workshop.h"

using namespace mes::test;

TEST_CASE("the examples hold what structures have to hold") {
  const Workshop workshop;
  std::vector<std::string> words{"check"};
  // Those that use CGAL take long to compile, and have a test of their own.
  for (const auto& entry : fs::directory_iterator("examples/experiments")) {
    const std::string name = entry.path().filename().string();
    if (name.ends_with(".cpp") && !name.starts_with("moebius")) words.push_back(entry.path().string());
  }
  std::ranges::sort(words.begin() + 1, words.end());  // each after those that it reads
  CHECK(words.size() > 8);
  const std::string table = workshop.output_of(words);
  INFO(table);
  CHECK_THAT(table, Catch::Contains("gabriel") && Catch::Contains("beta-skeleton-growing"));
}

TEST_CASE("the sources in the documentation hold what they have to hold") {
  const Workshop workshop;
  const std::string text = content_of("docs/experiments.md");
  const std::string begin = "```cpp\n";
  int count = 0;
  for (std::size_t at = text.find(begin); at != std::string::npos; at = text.find(begin, at + 1)) {
    const std::size_t from = at + begin.size();
    const std::string file =
        workshop.write("block" + std::to_string(++count) + ".cpp", text.substr(from, text.find("```", from) - from));
    CHECK_THAT(workshop.output_of({"check", file}), Catch::Contains(" ok, "));
  }
  CHECK(count == 3);
}
