// SPDX-License-Identifier: GPL-3.0-or-later
// Experiments of the window are there as long as their sources are good, and as they were while these are not.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "app/experiments/experiment_list.h"
#include "core/builtins/builtins.h"
#include "core/graph/registry.h"
#include "tests/io/temporary_folder.h"
#include "tests/support/bell.h"
#include "tests/support/eventually.h"

using namespace mes;
using namespace mes::test;
namespace fs = std::filesystem;

namespace {

/// Adds a structure over another one, and a layer of its rows.
std::string source_of(const std::string& id, const std::string& input, const std::string& rest = {}) {
  return "#include <mesecina/experiment.h>\n"
         "using namespace mesecina;\n"
         "struct Mine final : Structure {\n"
         "  std::vector<std::uint32_t> values;\n"
         "  void rebuild(const Inputs&) override { values.assign(3, 1); }\n"
         "  std::vector<OwnTable> tables() const override {\n"
         "    std::vector<OwnTable> out;\n"
         "    out.emplace_back(\"rows\", \"Rows\").column(\"value\", \"A value\", values);\n"
         "    return out;\n"
         "  }\n"
         "};\n"
         "MESECINA_EXPERIMENT(experiment) {\n"
         "  experiment.add_structure<Mine>({.id = \"" +
         id + "\", .inputs = {\"" + input +
         "\"}});\n"
         "  experiment.add_layer({.id = \"" +
         id + "-layer\", .rows = \"" + id +
         "/rows\", .kinds = {PrimitiveKind::point}},\n"
         "                       [](const Inputs&) { return [](Row row, Drawn& out) { out.point({1.0 * row, 0.0}); "
         "}; });\n" +
         rest + "}\n";
}

/// The experiments of a window, and the registry that they have led to.
struct Window {
  TemporaryFolder folder;
  Bell bell;
  ExperimentList list{{}, bell.ring()};
  std::shared_ptr<const Registry> registry = std::make_shared<const Registry>(builtins());
  std::vector<std::string> news;

  std::string write(const std::string& name, const std::string& text) const {
    // As editors do it, so that nobody reads half of it.
    std::ofstream(folder / (name + ".new")) << text;
    fs::rename(folder / (name + ".new"), folder / name);
    return (folder / name).string();
  }
  void follow() {
    const auto tell = [this](const ExperimentList::Entry& entry) { news.push_back(entry.file.filename().string()); };
    if (auto changed = list.follow(*registry, tell)) registry = std::move(changed);
  }
  /// Until so many preparations have ended.
  void wait_for_news(std::size_t count) {
    REQUIRE(eventually([&] {
      follow();
      return news.size() >= count;
    }));
    CHECK(news.size() == count);
  }
  bool has(const std::string& layer) const { return registry->find_layer(layer) != kNoLayer; }
  const ExperimentList::Entry& entry(std::size_t index) const { return list.entries()[index]; }
};

using State = ExperimentList::State;

}  // namespace

TEST_CASE("saving a source replaces its version, and a mistake takes nothing away") {
  Window window;
  const std::string file = window.write("mine.cpp", source_of("first", "delaunay"));
  REQUIRE(window.list.add(file));
  window.wait_for_news(1);
  REQUIRE(window.entry(0).state == State::added);
  CHECK(window.has("first-layer"));
  CHECK(window.entry(0).contents.structures == std::vector<std::string>{"first"});
  const LayerIndex place = window.registry->find_layer("first-layer");

  const auto before = window.registry;
  window.write("mine.cpp", source_of("first", "delaunay", "int x = y;\n"));
  window.wait_for_news(2);
  CHECK(window.entry(0).state == State::failed);
  CHECK(window.registry == before);
  REQUIRE_FALSE(window.entry(0).messages.empty());
  CHECK(window.entry(0).messages.front().is_error);
  CHECK(window.entry(0).messages.front().text.find("'y' was not declared") != std::string::npos);

  // It compiles, and cannot be added.
  window.write("mine.cpp", source_of("delaunay", "samples"));
  window.wait_for_news(3);
  CHECK(window.entry(0).state == State::failed);
  CHECK(window.entry(0).problem.find("there is a structure delaunay already") != std::string::npos);
  CHECK(window.registry == before);

  window.write("mine.cpp", source_of("second", "delaunay"));
  window.wait_for_news(4);
  CHECK(window.entry(0).state == State::added);
  CHECK(window.entry(0).problem.empty());
  CHECK_FALSE(window.has("first-layer"));
  CHECK(window.has("second-layer"));

  window.write("mine.cpp", source_of("first", "delaunay"));
  window.wait_for_news(5);
  CHECK(window.registry->find_layer("first-layer") == place);

  window.list.remove(0);
  window.follow();
  CHECK_FALSE(window.has("first-layer"));
  CHECK(window.registry->find_structure("first") == nullptr);
  CHECK(window.registry->structures().size() == builtins().structures().size());
}

TEST_CASE("an experiment that reads another one comes and goes with it") {
  Window window;
  const std::string base = window.write("base.cpp", source_of("base", "delaunay"));
  const std::string above = window.write("over.cpp", source_of("over", "base"));
  // In the order of their names.
  REQUIRE(window.list.add(fs::path(base).parent_path()));
  REQUIRE(window.list.entries().size() == 2);
  window.wait_for_news(2);
  CHECK(window.has("base-layer"));
  CHECK(window.has("over-layer"));

  window.write("base.cpp", source_of("base", "delaunay") + "// another version\n");
  window.wait_for_news(3);
  CHECK(window.entry(1).state == State::added);
  CHECK(window.has("over-layer"));

  window.write("base.cpp", source_of("renamed", "delaunay"));
  window.wait_for_news(4);
  CHECK(window.has("renamed-layer"));
  CHECK_FALSE(window.has("over-layer"));
  CHECK(window.entry(1).state == State::failed);
  CHECK(window.entry(1).problem.find("base") != std::string::npos);

  window.write("base.cpp", source_of("base", "delaunay"));
  window.wait_for_news(5);
  CHECK(window.entry(1).state == State::added);
  CHECK(window.has("over-layer"));
}

TEST_CASE("what is no experiment is refused, and one that is removed while it is compiled does not come") {
  Window window;
  CHECK_FALSE(window.list.add(window.folder / "nowhere.cpp"));
  CHECK_FALSE(window.list.add(window.write("notes.txt", "notes\n")));
  CHECK(window.list.entries().empty());
  REQUIRE(window.list.add(window.write("mine.cpp", source_of("mine", "delaunay"))));
  window.follow();
  CHECK(window.list.is_busy());
  window.list.remove(0);
  REQUIRE(window.list.add(window.write("other.cpp", source_of("other", "delaunay"))));
  window.wait_for_news(1);
  CHECK(window.has("other-layer"));
  CHECK_FALSE(window.has("mine-layer"));
}
