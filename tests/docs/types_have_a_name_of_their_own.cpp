// SPDX-License-Identifier: GPL-3.0-or-later
// Two types of one name in one namespace are one type to the linker: it keeps the functions of one of them for both,
// and the program breaks far from either.
#include <array>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <string>

namespace fs = std::filesystem;

namespace {

/// Types that a header defines in a namespace, "mes::render::Scene". clang-format puts namespaces and what is in them
/// at the beginning of the line.
void collect(const fs::path& header, std::map<std::string, std::string>& headers, std::string& doubles) {
  static const std::regex space("namespace ([a-z_:]+) \\{");
  static const std::regex type("(?:class|struct|enum class|union) ([A-Z]\\w*)(?: final)?(?: : [^;]*)?(?: \\{.*)?");
  std::ifstream in(header);
  std::string inside;
  std::smatch match;
  for (std::string line; std::getline(in, line);) {
    if (std::regex_match(line, match, space)) inside = match[1].str() + "::";
    if (line.ends_with(';') && line.find('{') == std::string::npos) continue;
    if (!std::regex_match(line, match, type)) continue;
    const std::string file = header.generic_string();
    const auto [first, is_new] = headers.emplace(inside + match[1].str(), file);
    if (!is_new && first->second != file) doubles += first->first + " in " + first->second + " and " + file + '\n';
  }
}

}  // namespace

TEST_CASE("no two headers define a type of the same name") {
  std::map<std::string, std::string> headers;
  std::string doubles;
  for (const char* room : {"app", "core", "render"})
    for (const auto& entry : fs::recursive_directory_iterator(room))
      if (entry.path().extension() == ".h") collect(entry.path(), headers, doubles);
  INFO(doubles);
  CHECK(doubles.empty());
  // It has read them.
  CHECK(headers.contains("mes::Document"));
  CHECK(headers.contains("mes::render::Scene"));
  CHECK(headers.size() > 400);
}
