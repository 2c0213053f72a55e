// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cstdlib>

#include "run_binary.h"
#include "tests/cli/inputs.h"
#include "tests/io/temporary_folder.h"

using mes::test::contents_of;
using mes::test::kDude;
using mes::test::run;
using mes::test::RunOptions;
using mes::test::RunResult;
using mes::test::TemporaryFolder;

TEST_CASE("an output that cannot be written is exit code 4 and leaves nothing") {
  const TemporaryFolder folder;
  for (const std::string& output : {(folder / "no" / "folder.json").string(), folder.path().string()}) {
    const RunResult result = run({"compute", kDude, "-o", output});
    INFO(result.err);
    CHECK(result.exit_code == 4);
    CHECK_THAT(result.err, Catch::StartsWith("mesecina: " + output + ": cannot be written: "));
    CHECK(result.out.empty());
  }
  const RunResult picture = run({"render", kDude, "-o", (folder / "no" / "a.png").string()});
  CHECK(picture.exit_code == 4);
  CHECK(folder.file_count() == 0);
}

TEST_CASE("a standard output that takes nothing is exit code 4") {
  RunOptions options;
  options.out_path = "/dev/full";
  for (const std::vector<std::string>& command : std::vector<std::vector<std::string>>{
           {"compute", kDude}, {"list", "layers"}, {"export", kDude, "--layer", "points", "--format", "csv"}}) {
    const RunResult result = run(command, options);
    CHECK(result.exit_code == 4);
    CHECK_THAT(result.err, Catch::Contains("standard output: cannot be written: No space left"));
  }
}

TEST_CASE("what was found is not said where it cannot be written") {
  for (const char* command : {"branches", "persistence", "repair", "decimate"}) {
    INFO(command);
    const RunResult result = run({command, "assets/shapes/bean.poff", "-o", "/dev/full"});
    CHECK(result.exit_code == 4);
    CHECK_THAT(result.err, Catch::StartsWith("mesecina: /dev/full: cannot be written: No space left"));
    const RunResult good = run({command, "assets/shapes/bean.poff", "-o", "/dev/null"});
    CHECK(good.exit_code == 0);
    CHECK_FALSE(good.err.empty());
  }
}

TEST_CASE("a reader that has had enough is no failure") {
  const TemporaryFolder folder;
  const std::string errors = (folder / "errors").string();
  const std::string command = "(sleep 0.2; exec \"$MESECINA_BINARY\" list layers) 2>" + errors + " | true";
  REQUIRE(std::system(command.c_str()) == 0);
  CHECK(contents_of(errors).empty());
}

TEST_CASE("a failed command leaves an older output as it was") {
  const TemporaryFolder folder;
  const auto output = folder.write("a.json", "old");
  const RunResult result = run({"compute", "-", "-o", output.string()}, {.input = "1 x\n"});
  CHECK(result.exit_code == 3);
  CHECK(contents_of(output) == "old");
  CHECK(folder.file_count() == 1);
}

TEST_CASE("an input that is its own output is overwritten, unless something else has written to it meanwhile") {
  const TemporaryFolder folder;
  // More complaints than a pipe holds: while they are not read, the command has read its input and written nothing.
  std::string samples = "POFF 3 0 0\n0 0\n1 0\n0 1\n";
  for (int i = 0; i < 5000; ++i) samples += "# loop closed 0 1 7\n";
  const auto file = folder.write("a.poff", samples);
  std::filesystem::create_symlink("a.poff", folder / "link.poff");
  const auto command = [&](const std::string& output, const std::vector<std::string>& extra = {}) {
    std::vector<std::string> out{"export", file.string(), "--layer", "points", "--format", "poff", "-o", output};
    out.insert(out.end(), extra.begin(), extra.end());
    return out;
  };
  const RunOptions meanwhile{.at_first_error = [&] { folder.write("a.poff", "theirs"); }};
  for (const std::string& output : {file.string(), (folder / "link.poff").string()}) {
    folder.write("a.poff", samples);
    const RunResult result = run(command(output), meanwhile);
    CHECK(result.exit_code == 4);
    CHECK_THAT(result.err, Catch::EndsWith(output + ": cannot be written: it has changed since it was read; --force "
                                                    "overwrites it\n"));
    CHECK(contents_of(file) == "theirs");
  }
  folder.write("a.poff", samples);
  CHECK(run(command(file.string(), {"--force"}), meanwhile).exit_code == 0);
  CHECK(contents_of(file).starts_with("POFF 3"));
  CHECK(contents_of(file).size() < 100);
  // No other program has written to it, and another file is none of its business.
  folder.write("a.poff", samples);
  CHECK(run(command(file.string())).exit_code == 0);
  CHECK(contents_of(file).size() < 100);
  // Something else than samples would destroy them.
  folder.write("a.poff", samples);
  for (const std::vector<std::string>& other :
       {std::vector<std::string>{"compute", file, "-o", file},
        {"render", file, "--to", "png", "-o", file},
        {"persistence", file, "-o", file},
        {"export", file, "--layer", "points", "--format", "csv", "-o", file}}) {
    const RunResult result = run(other);
    CHECK(result.exit_code == 4);
    CHECK_THAT(result.err, Catch::EndsWith(": cannot be written: it is an input; --force overwrites it\n"));
    CHECK(contents_of(file) == samples);
  }
  CHECK(run({"compute", file, "-o", file, "--force"}).exit_code == 0);
  CHECK(contents_of(file).starts_with("{"));
  folder.write("a.poff", samples);
  CHECK(run(command((folder / "b.poff").string()), meanwhile).exit_code == 0);
  CHECK(folder.file_count() == 3);
}

TEST_CASE("every command that reads and writes files heeds what was written to its input meanwhile") {
  const TemporaryFolder folder;
  std::string samples = "POFF 3 0 0\n0 0\n1 0\n0 1\n";
  for (int i = 0; i < 5000; ++i) samples += "# loop closed 0 1 7\n";
  const auto file = folder.write("a.poff", samples);
  // Bundles may have any name, also that of the picture to be drawn with them.
  const auto bundles = folder / "a.png";
  std::filesystem::copy_file("assets/bundles/starting.json", bundles);
  struct Case {
    std::filesystem::path both;
    std::vector<std::string> command;
  };
  for (const auto& [both, command] :
       std::vector<Case>{{file, {"compute", file, "-o", file}},
                         {file, {"evolve", file, "--evolution", "smooth", "--steps", "1", "-o", file}},
                         {bundles, {"render", file, "--bundle", bundles, "--size", "16x16", "-o", bundles}}}) {
    folder.write("a.poff", samples);
    const RunResult result =
        run(command, {.at_first_error = [&, name = both.filename().string()] { folder.write(name, "theirs"); }});
    CHECK(result.exit_code == 4);
    CHECK_THAT(result.err,
               Catch::Contains(command.front() == "evolve" ? "it has changed since it was read" : "it is an input"));
    CHECK(contents_of(both) == "theirs");
  }
  CHECK(folder.file_count() == 2);
}
