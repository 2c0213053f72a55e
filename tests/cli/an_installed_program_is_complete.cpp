// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>

#include "run_binary.h"
#include "tests/io/temporary_folder.h"

using mes::test::contents_of;
using mes::test::run;
using mes::test::RunResult;
using mes::test::TemporaryFolder;
namespace fs = std::filesystem;

namespace {

// Installed into one place and moved to another, as packages do.
fs::path install(const TemporaryFolder& folder) {
  const fs::path first = folder / "first";
  const fs::path second = folder / "second";
  const RunResult installed = run({"--install", std::getenv("MESECINA_BUILD"), "--prefix", first.string()},
                                  {.program = std::getenv("MESECINA_CMAKE")});
  INFO(installed.err);
  REQUIRE(installed.exit_code == 0);
  fs::rename(first, second);
  return second;
}

}  // namespace

TEST_CASE("what is installed is everything a desktop asks for") {
  const TemporaryFolder folder;
  const fs::path prefix = install(folder);
  for (const char* file :
       {"bin/mesecina", "share/applications/mesecina.desktop", "share/mime/packages/mesecina.xml",
        "share/metainfo/org.mesecina.Mesecina.metainfo.xml", "share/icons/hicolor/scalable/apps/mesecina.svg",
        "share/icons/hicolor/16x16/apps/mesecina.png", "share/icons/hicolor/512x512/apps/mesecina.png",
        "share/man/man1/mesecina.1.gz", "share/bash-completion/completions/mesecina",
        "share/fish/vendor_completions.d/mesecina.fish", "share/doc/mesecina/copyright",
        "share/mesecina/shapes/index.json", "share/mesecina/fonts/OFL.txt"}) {
    INFO(file);
    CHECK(fs::is_regular_file(prefix / file));
  }
  // Names that must be the same in two files, or the menu shows neither icon nor program.
  const std::string entry = contents_of(prefix / "share/applications/mesecina.desktop");
  const std::string types = contents_of(prefix / "share/mime/packages/mesecina.xml");
  for (const std::string type :
       {"application/x-poff", "application/x-wpoff", "application/x-mesecina-session+json"}) {
    CHECK_THAT(entry, Catch::Contains(type + ';'));
    CHECK_THAT(types, Catch::Contains("type=\"" + type + '"'));
  }
}

TEST_CASE("an installed program finds its assets from any folder") {
  const TemporaryFolder folder;
  const fs::path prefix = install(folder);
  const mes::test::RunOptions elsewhere{
      .program = (prefix / "bin/mesecina").string(),
      .folder = folder.path().string(),
      .environment = {"MESECINA_ASSETS=", "XDG_DATA_HOME=" + folder.path().string()}};
  const RunResult manual = run({"manual"}, elsewhere);
  CHECK(manual.exit_code == 0);
  const bool is_equal = manual.out == run({"manual"}).out;
  CHECK(is_equal);
  CHECK_THAT(run({"list", "color-maps"}, elsewhere).out, Catch::Contains("viridis"));
  // They are those of the prefix and no others.
  fs::remove_all(prefix / "share/mesecina");
  CHECK_THAT(run({"list", "color-maps"}, elsewhere).out, !Catch::Contains("viridis"));
}
