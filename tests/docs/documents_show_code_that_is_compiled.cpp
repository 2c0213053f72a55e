// SPDX-License-Identifier: GPL-3.0-or-later
// Code in documents and in the comments of headers is part of files that are compiled; lists name all files.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <ranges>
#include <regex>
#include <string>
#include <string_view>
#include <vector>

#include "core/graph/layer.h"
#include "tests/support/workbench.h"

using namespace mes;
using namespace mes::test;
namespace fs = std::filesystem;

namespace mes {
Layer make_crust_confidence_layer(const StructureSet& set);
}

namespace {

std::string text_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  REQUIRE(in);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> out;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    out.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return out;
}

/// Without comments at the end of lines and without white space.
std::string bare(const std::string& code) {
  std::string out;
  for (const std::string& line : lines_of(code))
    for (const char c : line.substr(0, line.find("//")))
      if (c != ' ' && c != '\t') out += c;
  return out;
}

/// The code under each "Smallest use" of a header: lines of the comment that are indented by five spaces.
std::vector<std::string> smallest_uses(const fs::path& header) {
  std::vector<std::string> out;
  bool is_inside = false;
  for (const std::string& line : lines_of(text_of(header))) {
    const std::size_t text = line.starts_with("//") ? line.find_first_not_of('/') : std::string::npos;
    if (line.find("Smallest use") != std::string::npos) {
      out.emplace_back();
      is_inside = true;
    } else if (is_inside && text != std::string::npos && line.substr(text).starts_with("     ")) {
      out.back() += line.substr(text) + '\n';
    } else {
      is_inside = false;
    }
  }
  return out;
}

/// The fenced blocks of a document in one language.
std::vector<std::string> fenced(const fs::path& document, const std::string& language) {
  std::vector<std::string> out;
  bool is_inside = false;
  for (const std::string& line : lines_of(text_of(document))) {
    if (!is_inside && line == "```" + language) {
      out.emplace_back();
      is_inside = true;
    } else if (line == "```") {
      is_inside = false;
    } else if (is_inside) {
      out.back() += line + '\n';
    }
  }
  return out;
}

std::vector<fs::path> files_below(const fs::path& folder, std::string_view extension) {
  std::vector<fs::path> out;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().extension() == extension) out.push_back(entry.path());
  std::ranges::sort(out);
  return out;
}

}  // namespace

TEST_CASE("the smallest uses of core's headers are compiled") {
  const std::string compiled = bare(text_of("tests/docs/examples_of_headers_do_what_they_say.cpp")) +
                               bare(text_of("tests/docs/examples_of_readers_do_what_they_say.cpp")) +
                               bare(text_of("tests/library/examples_of_the_library_do_what_they_say.cpp"));
  std::size_t seen = 0;
  for (const fs::path& header : files_below("core", ".h")) {
    INFO(header);
    for (const std::string& use : smallest_uses(header)) {
      INFO(use);
      CHECK_FALSE(bare(use).empty());
      CHECK(compiled.find(bare(use)) != std::string::npos);
      ++seen;
    }
  }
  CHECK(seen >= 17);
}

TEST_CASE("the document about layers shows a layer that is compiled") {
  const auto blocks = fenced("docs/adding_a_layer.md", "cpp");
  REQUIRE(blocks.size() == 2);
  CHECK(blocks[0] == text_of("tests/docs/crust_confidence.cpp"));
  const std::string list = text_of("core/layers/layers.cpp");
  std::string without_the_new_one;
  for (const std::string& line : lines_of(blocks[1]))
    if (line.find("crust_confidence") == std::string::npos) without_the_new_one += line + '\n';
  CHECK(without_the_new_one.size() < blocks[1].size());
  CHECK(list.find(without_the_new_one) != std::string::npos);
}

TEST_CASE("the documented layer draws the curve") {
  TestBench bench({{0.0, 0.0}, {1.0, 0.0}, {2.0, 0.1}, {2.0, 1.0}, {1.0, 1.2}, {0.0, 1.0}});
  Layer layer = make_crust_confidence_layer(bench.graph().structures());
  LayerPatch patch;
  layer.parts.front()->reset(patch);
  CHECK(patch[PrimitiveKind::segment].count == bench.count("one-step-crust", "crust_edges"));
  CHECK(patch[PrimitiveKind::segment].count > 0);
}

TEST_CASE("paths and links in documents exist") {
  // A folder of the project, then a path; capitals stand for a name that a reader chooses.
  const std::regex path(
      "`((?:app|assets|cmake|core|docs|examples|packaging|python|render|scripts|tests)/[a-z0-9_./-]*)`");
  const std::regex link("\\]\\(([^)#: ]+)");
  std::vector<fs::path> documents = files_below("docs", ".md");
  documents.insert(documents.end(), {"README.md", "CONTRIBUTING.md"});
  std::size_t paths = 0, links = 0;
  const auto found = [](const std::string& text, const std::regex& expression) {
    return std::ranges::subrange(std::sregex_iterator(text.begin(), text.end(), expression), std::sregex_iterator());
  };
  for (const fs::path& document : documents) {
    std::string text;
    bool is_code = false;
    for (const std::string& line : lines_of(text_of(document))) {
      if (line.starts_with("```")) is_code = !is_code;
      if (!is_code) text += line + '\n';
    }
    INFO(document);
    for (const std::smatch& match : found(text, path)) {
      if (match[1] == "core/layers/crust_confidence.cpp") continue;  // the layer that docs/adding_a_layer.md adds
      INFO(match[1]);
      CHECK(fs::exists(match[1].str()));
      ++paths;
    }
    for (const std::smatch& match : found(text, link)) {
      INFO(match[1]);
      CHECK(fs::exists(document.parent_path() / match[1].str()));
      ++links;
    }
  }
  CHECK(paths >= 100);
  CHECK(links >= 100);
}

TEST_CASE("every layer and every format is in its list") {
  std::size_t seen = 0;
  const std::regex maker("\n(?:Layer|std::vector<Layer>) (make_[a-z_]+_layers?)\\(const \\w+& \\w+\\) \\{");
  const std::string lists = text_of("core/layers/layers.cpp") + text_of("core/layers/union/union_layers.cpp");
  for (const fs::path& path : files_below("core/layers", ".cpp")) {
    const std::string source = text_of(path);
    for (const std::smatch& match :
         std::ranges::subrange(std::sregex_iterator(source.begin(), source.end(), maker), std::sregex_iterator())) {
      INFO(match[1]);
      const std::regex added("add(?:_layers?)?\\(" + match[1].str() + "\\);\n");
      CHECK(std::regex_search(lists, added));
      ++seen;
    }
  }
  CHECK(seen >= 90);
  seen = 0;
  const std::string formats = text_of("core/io/format_list.cpp");
  for (const fs::path& path : files_below("core/io", ".cpp")) {
    const std::string name = path.stem();
    if (text_of(path).find("\nFormat " + name + "_format() {") == std::string::npos) continue;
    INFO(path);
    CHECK(formats.find("  add(" + name + "_format());\n") != std::string::npos);
    ++seen;
  }
  CHECK(seen >= 22);
}
