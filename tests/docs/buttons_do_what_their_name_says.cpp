// SPDX-License-Identifier: GPL-3.0-or-later
// What a panel offers under the name of an action is that action, with its explanation and where it is possible.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <string>

#include "app/actions/actions.h"

namespace fs = std::filesystem;
using namespace mes;

TEST_CASE("a button with the name of an action runs it") {
  // Words of several meanings: of a text, of an annotation, of a bundle, of the picture underneath.
  const std::set<std::string> common{"Copy", "Save", "Save as...", "Delete", "Undo", "Fit to view"};
  std::set<std::string> names;
  for (const ActionDescriptor& action : action_descriptors()) names.insert(std::string(action.name));
  for (const std::string& word : common) REQUIRE(names.contains(word));
  static const std::regex button("Button\\(\"([^\"#]+)[\"#].*");
  int found = 0;
  std::string wrong;
  for (const auto& entry : fs::recursive_directory_iterator("app/panels")) {
    if (entry.path().extension() != ".cpp") continue;
    std::ifstream in(entry.path());
    std::smatch match;
    for (std::string line; std::getline(in, line);) {
      if (!std::regex_search(line, match, button)) continue;
      const std::string name = match[1].str();
      if (!names.contains(name) || common.contains(name)) continue;
      ++found;
      if (line.find("run(ActionId::") == std::string::npos)
        wrong += entry.path().generic_string() + ": " + line + '\n';
    }
  }
  CHECK(wrong == "");
  CHECK(found > 0);
}
