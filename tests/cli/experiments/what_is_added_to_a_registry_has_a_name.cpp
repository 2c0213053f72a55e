// SPDX-License-Identifier: GPL-3.0-or-later
// The command line, in this process, with a registry that has more than the program: what was added is named, parsed and
// computed like the program's own, and only there.
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "app/cli/command_line.h"
#include "core/builtins/builtins.h"
#include "core/io/session/session.h"
#include "tests/io/temporary_folder.h"
#include "tests/support/added_to_registry.h"

using namespace mes;
using mes::test::registry_with_additions;
using mes::test::TemporaryFolder;

namespace {

constexpr int kDone = 0;
constexpr int kUsage = 2;

/// While it lives, a standard stream goes to a file.
class Redirected {
 public:
  Redirected(int stream, const std::filesystem::path& file) : stream_(stream), kept_(::dup(stream)) {
    std::fflush(nullptr);
    const int to = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    REQUIRE(kept_ >= 0);
    REQUIRE(to >= 0);
    REQUIRE(::dup2(to, stream_) == stream_);
    ::close(to);
  }
  ~Redirected() {
    std::fflush(nullptr);
    static_cast<void>(::dup2(kept_, stream_));
    ::close(kept_);
  }
  Redirected(const Redirected&) = delete;
  Redirected& operator=(const Redirected&) = delete;

 private:
  int stream_;
  int kept_;
};

std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

struct Ran {
  int exit_code = -1;
  std::string out;
  std::string err;
};

Ran run_with(const Registry& registry, const std::vector<std::string>& words) {
  const TemporaryFolder folder;
  std::vector<const char*> argv{"mesecina"};
  for (const std::string& word : words) argv.push_back(word.c_str());
  Ran ran;
  {
    const Redirected out(STDOUT_FILENO, folder / "out");
    const Redirected err(STDERR_FILENO, folder / "err");
    ran.exit_code = cli::run_command_line(registry, static_cast<int>(argv.size()), argv.data(),
                                          [](const cli::WindowRequest& /*request*/) { return -1; });
  }
  ran.out = text_of(folder / "out");
  ran.err = text_of(folder / "err");
  return ran;
}

/// With the registry that has additions, which has to do it without a remark.
std::string done_with_additions(const std::vector<std::string>& words) {
  const Ran ran = run_with(registry_with_additions(), words);
  INFO(ran.err);
  CHECK(ran.exit_code == kDone);
  CHECK(ran.err.empty());
  return ran.out;
}

/// With the program's own registry, which does not know the last word of the message.
void check_refused(const std::vector<std::string>& words, const std::string& refusal, const std::string& name) {
  const Ran ran = run_with(builtins(), words);
  CHECK(ran.exit_code == kUsage);
  CHECK(ran.out.empty());
  CHECK_THAT(ran.err, Catch::StartsWith("mesecina: ") && Catch::Contains(refusal) && Catch::Contains(name));
  CHECK(std::ranges::count(ran.err, '\n') == 1);
}

std::string corner_samples(const TemporaryFolder& folder) {
  return folder.write("corner.poff", "POFF 3 0 0\n0 0\n1 0\n0 1\n").string();
}

}  // namespace

TEST_CASE("lists have what was added, and those of the program have not") {
  for (const auto& [what, id] : std::vector<std::pair<std::string, std::string>>{{"layers", "doubled-points"},
                                                                                 {"structures", "doubled-samples"},
                                                                                 {"parameters", "doubling-factor"},
                                                                                 {"parameters", "doubling-times"},
                                                                                 {"evolutions", "doubling"},
                                                                                 {"shapes", "test-square"}}) {
    INFO(what);
    CHECK_THAT("\n" + done_with_additions({"list", what}), Catch::Contains("\n" + id + ' '));
    CHECK_THAT(done_with_additions({"list", what, "--json"}), Catch::Contains('"' + id + '"'));
    const Ran without = run_with(builtins(), {"list", what});
    CHECK(without.exit_code == kDone);
    CHECK_THAT(without.out, !Catch::Contains(id));
  }
}

TEST_CASE("the manual describes what was added") {
  const std::string with = done_with_additions({"manual"});
  const Ran without = run_with(builtins(), {"manual"});
  CHECK(without.exit_code == kDone);
  for (const char* id : {"`doubled-points`", "`doubled-samples`", "`doubling-factor`", "`doubling-times`",
                         "`doubling`", "`test-square`", "`side=1`"}) {
    INFO(id);
    CHECK_THAT(with, Catch::Contains(id));
    CHECK_THAT(without.out, !Catch::Contains(id));
  }
}

TEST_CASE("shells complete what was added") {
  for (const char* shell : {"bash", "zsh", "fish"}) {
    const std::string with = done_with_additions({"completions", shell});
    const Ran without = run_with(builtins(), {"completions", shell});
    CHECK(without.exit_code == kDone);
    for (const char* id :
         {"doubled-points", "doubled-samples", "doubling-factor=", "doubling-times=", " doubling", "test-square"}) {
      INFO(shell << ": " << id);
      CHECK_THAT(with, Catch::Contains(id));
      CHECK_THAT(without.out, !Catch::Contains(id));
    }
  }
}

TEST_CASE("layers and parameters that were added are computed and exported") {
  const TemporaryFolder folder;
  const std::string file = corner_samples(folder);
  const auto computed = nlohmann::json::parse(
      done_with_additions({"compute", file, "--layers", "doubled-points", "--set", "doubling-factor=3"}));
  CHECK(computed["layers"]["doubled-points"]["points"] == 3);
  CHECK(computed["structures"]["doubled-samples"]["factor"] == 3.0);
  CHECK(done_with_additions({"export", file, "--layer", "doubled-points", "--format", "csv"}) ==
        "x,y\n0,0\n2,0\n0,2\n");
  CHECK(done_with_additions({"export", file, "--layer", "doubled-points", "--format", "csv", "--set",
                             "doubling-factor=0.5"}) == "x,y\n0,0\n0.5,0\n0,0.5\n");
  const std::string swept = done_with_additions(
      {"sweep", file, "--parameter", "doubling-factor=1..2", "--steps", "1", "--layers", "doubled-points"});
  CHECK_THAT(swept, Catch::StartsWith("doubling-factor,layers.doubled-points.points,"));
  check_refused({"compute", file, "--layers", "doubled-points"}, "unknown layer", "doubled-points");
  check_refused({"compute", file, "--set", "doubling-factor=3"}, "unknown parameter", "doubling-factor");
  check_refused({"export", file, "--layer", "doubled-points", "--format", "csv"}, "unknown layer", "doubled-points");
  check_refused({"export", file, "--structure", "doubled-samples", "--format", "csv"}, "unknown structure",
                "doubled-samples");
  check_refused({"sweep", file, "--parameter", "doubling-factor=1..2", "--steps", "1"}, "unknown parameter",
                "doubling-factor");
}

TEST_CASE("figures show layers that were added, also side by side") {
  const TemporaryFolder folder;
  const std::string file = corner_samples(folder);
  const std::string figure = (folder / "alone.svg").string();
  done_with_additions(
      {"render", file, "--layers", "doubled-points", "--set-style", "doubled-points:color=ff0000", "-o", figure});
  CHECK_THAT(text_of(figure), Catch::Contains("doubled-points"));
  const std::string panes = (folder / "panes.svg").string();
  done_with_additions(
      {"render", file, "--layers", "doubled-points", "--compare", "doubling-factor=1,2", "-o", panes});
  CHECK_THAT(text_of(panes), Catch::Contains("pane-a-doubled-points") && Catch::Contains("pane-b-doubled-points"));
  check_refused({"render", file, "--layers", "doubled-points", "-o", figure}, "unknown layer", "doubled-points");
  check_refused({"render", file, "--compare", "doubling-factor=1,2", "-o", panes}, "unknown subject",
                "doubling-factor");
}

TEST_CASE("evolutions that were added have steps, with their parameters") {
  const TemporaryFolder folder;
  const std::string file = corner_samples(folder);
  CHECK_THAT(done_with_additions({"evolve", file, "--evolution", "doubling", "--steps", "3"}),
             Catch::Contains("\n8 0\n") && Catch::Contains("\n0 8\n"));
  CHECK_THAT(
      done_with_additions({"evolve", file, "--evolution", "doubling", "--steps", "1", "--set", "doubling-times=5"}),
      Catch::Contains("\n5 0\n"));
  check_refused({"evolve", file, "--evolution", "doubling", "--steps", "3"}, "unknown evolution", "doubling");
}

TEST_CASE("shapes that were added are made") {
  CHECK_THAT(done_with_additions({"shape", "test-square", "--set", "side=4", "--samples", "8"}),
             Catch::StartsWith("POFF 8 0 0\n") && Catch::Contains("\n4 4\n"));
  check_refused({"shape", "test-square"}, "there is no shape", "test-square");
}

TEST_CASE("a picture that a session names is left out, in one line, where no layer shows pictures") {
  Registry without = builtins();
  REQUIRE(without.remove_layer("image"));
  const TemporaryFolder folder;
  Session session;
  session.data = std::make_shared<const SampleData>(SampleData{.positions = {{0, 0}, {1, 0}, {0, 1}}});
  session.layers.layers = {{"points", true, {}}};
  session.layers.image.file = folder.write("leaf.png", "no picture, which is not looked at").string();
  const std::string file = folder.write("corner.json", write_session(session)).string();
  const std::string figure = (folder / "corner.svg").string();
  const Ran ran = run_with(without, {"render", file, "-o", figure});
  CHECK(ran.exit_code == kDone);
  CHECK(ran.err == "mesecina: the picture underneath is left out: there is no layer for pictures\n");
  CHECK_THAT(text_of(figure), Catch::Contains("<svg"));
}
