// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/cli/inputs.h"
#include "tests/cli/run_binary.h"
#include "tests/io/temporary_folder.h"

using mes::test::contents_of;
using mes::test::kDude;
using mes::test::run;
using mes::test::RunOptions;
using mes::test::RunResult;
using mes::test::TemporaryFolder;

namespace {

std::uint32_t big_endian(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8U | static_cast<unsigned char>(bytes.at(at + i));
  return value;
}

// No display of either kind, as on a server.
RunOptions headless() {
  RunOptions options;
  options.environment = {"DISPLAY=", "WAYLAND_DISPLAY="};
  return options;
}

std::string picture(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "render");
  for (const char* word : {"-o", "-"}) arguments.emplace_back(word);
  const RunResult result = run(arguments, headless());
  INFO(result.err);
  REQUIRE(result.exit_code == 0);
  CHECK(result.err.empty());
  return result.out;
}

}  // namespace

TEST_CASE("a picture has the size that was asked for and is a PNG") {
  const TemporaryFolder folder;
  const std::string file = (folder / "a.png").string();
  const RunResult result = run({"render", kDude, "--size", "321x123", "-o", file}, headless());
  INFO(result.err);
  REQUIRE(result.exit_code == 0);
  CHECK(result.out.empty());
  const std::string png = contents_of(file);
  CHECK(png.starts_with("\x89PNG\r\n\x1a\n"));
  CHECK(big_endian(png, 16) == 321);
  CHECK(big_endian(png, 20) == 123);
  CHECK(folder.file_count() == 1);
}

TEST_CASE("the same command draws the same bytes, and every option changes them") {
  const std::vector<std::string> plain{kDude, "--size", "200x150"};
  const std::string first = picture(plain);
  CHECK(first == picture(plain));
  std::vector<std::string> pictures{first};
  for (const std::vector<std::string>& option : std::vector<std::vector<std::string>>{{"--scale", "2"},
                                                                                      {"--background", "102030"},
                                                                                      {"--background", "transparent"},
                                                                                      {"--view", "-10,-20,700,800"},
                                                                                      {"--view=300,300,400,500"},
                                                                                      {"--layers", "points"}}) {
    std::vector<std::string> arguments = plain;
    arguments.insert(arguments.end(), option.begin(), option.end());
    const std::string other = picture(arguments);
    CHECK(std::ranges::find(pictures, other) == pictures.end());
    pictures.push_back(other);
  }
}

TEST_CASE("the order of the listed layers does not matter: stacking is the registry's") {
  CHECK(picture({kDude, "--size", "200x150", "--layers", "points,curve,medial-axis"}) ==
        picture({kDude, "--size", "200x150", "--layers", "medial-axis,points,curve"}));
}

TEST_CASE("a layer that is named twice is drawn once") {
  const std::vector<std::string> plain{kDude, "--size", "200x150", "--layers"};
  const auto with = [&](const char* layers) {
    std::vector<std::string> all = plain;
    all.emplace_back(layers);
    return picture(all);
  };
  CHECK(with("interior-voronoi-disks,points,interior-voronoi-disks") == with("interior-voronoi-disks,points"));
}

TEST_CASE("samples that stand close get smaller dots and finer lines, unless their size was asked for") {
  // What a picture carries says how it was asked for.
  const auto with = [](const char* layers, const char* size, const char* style) {
    return picture({kDude, "--no-source", "--size", size, "--layers", layers, "--set-style", style});
  };
  const auto is_same = [&](const char* layers, const char* size, const char* a, const char* b) {
    return with(layers, size, a) == with(layers, size, b);
  };
  // Where there is room the size of the dots counts; where there is none, one that was asked for.
  CHECK(is_same("points", "1600x1200", "points:opacity=1", "points:thin-when-dense=off"));
  CHECK_FALSE(is_same("points", "80x60", "points:opacity=1", "points:thin-when-dense=off"));
  CHECK(is_same("points", "80x60", "points:opacity=1", "points:thin-when-dense=on"));
  CHECK(is_same("points", "80x60", "points:point-size=9", "points:thin-when-dense=off,point-size=9"));
  CHECK_FALSE(is_same("points", "80x60", "points:point-size=9", "points:point-size=9,thin-when-dense=on"));
  CHECK(is_same("curve", "1600x1200", "curve:opacity=1", "curve:thin-when-dense=off"));
  CHECK_FALSE(is_same("curve", "40x30", "curve:opacity=1", "curve:thin-when-dense=off"));
  CHECK(is_same("curve", "40x30", "curve:opacity=1", "curve:thin-when-dense=on"));
  CHECK(is_same("curve", "40x30", "curve:line-width=3", "curve:line-width=3,thin-when-dense=off"));
  CHECK_FALSE(is_same("curve", "40x30", "curve:line-width=3", "curve:thin-when-dense=on,line-width=3"));
}

TEST_CASE("two corners of a view may be given in any order") {
  CHECK(picture({kDude, "--size", "100x100", "--view", "300,300,400,500"}) ==
        picture({kDude, "--size", "100x100", "--view", "400,500,300,300"}));
}

TEST_CASE("a sample without extent is drawn, and so is none") {
  for (const char* input : {"POFF 0 0 0", "1e15 7\n", "3 4\n3 4\n", "1e150 1e150\n-1e150 -1e150\n"}) {
    RunOptions options = headless();
    options.input = input;
    const RunResult result = run({"render", "-", "--layers", "all", "--size", "64x64", "-o", "-"}, options);
    INFO(input << ": " << result.err);
    CHECK(result.exit_code == 0);
    CHECK(result.out.starts_with("\x89PNG"));
  }
}

TEST_CASE("without a display the window says so, and what to do instead") {
  const RunResult result = run({kDude}, headless());
  INFO(result.err);
  CHECK(result.exit_code == 4);
  CHECK(result.out.empty());
  CHECK(std::ranges::count(result.err, '\n') == 1);
  CHECK_THAT(result.err, Catch::StartsWith("mesecina: ") && Catch::Contains("mesecina render"));
}

TEST_CASE("without OpenGL pictures end with code 4, and the other commands work") {
  RunOptions options = headless();
  // A driver that does not exist.
  options.environment.emplace_back("__EGL_VENDOR_LIBRARY_FILENAMES=/nonexistent.json");
  const TemporaryFolder folder;
  const RunResult result = run({"render", kDude, "-o", (folder / "a.png").string()}, options);
  INFO(result.err);
  CHECK(result.exit_code == 4);
  CHECK(std::ranges::count(result.err, '\n') == 1);
  CHECK(folder.file_count() == 0);
  CHECK(run({"compute", kDude}, options).exit_code == 0);
}

TEST_CASE("without the libraries of OpenGL pictures end with code 4") {
  // The loader finds text files in place of the libraries, and refuses them.
  const std::string name = GENERATE("libEGL.so.1", "libOpenGL.so.0 libGL.so.1");
  const TemporaryFolder folder;
  std::istringstream names(name);
  for (std::string library; names >> library;) std::ofstream(folder / library) << "empty";
  RunOptions options = headless();
  options.environment.push_back("LD_LIBRARY_PATH=" + folder.path().string());
  const RunResult result = run({"render", kDude, "-o", (folder / "a.png").string()}, options);
  INFO(result.err);
  CHECK(result.exit_code == 4);
  CHECK(std::ranges::count(result.err, '\n') == 1);
  CHECK_FALSE(std::filesystem::exists(folder / "a.png"));
}

TEST_CASE("styles, colour maps, their range and the legend change a picture") {
  const std::vector<std::string> plain{kDude, "--size", "300x250", "--layers", "interior-voronoi-disks"};
  const auto with = [&](const std::vector<std::string>& more) {
    std::vector<std::string> all = plain;
    all.insert(all.end(), more.begin(), more.end());
    return picture(all);
  };
  const std::string id = "interior-voronoi-disks:";
  std::vector<std::string> seen{with({})};
  // Without a map there is nothing to explain.
  CHECK(with({"--no-legend"}) == seen.front());
  for (const std::vector<std::string>& more : std::vector<std::vector<std::string>>{
           {"--set-style", id + "color=ff0000"},
           {"--set-style", id + "opacity=0.9"},
           {"--set-style", id + "color-map=viridis"},
           {"--set-style", id + "color-map=viridis", "--no-legend"},
           {"--set-style", id + "color-map=inferno", "--no-legend"},
           {"--set-style", id + "color-map=viridis,flat=on,opacity=0.4", "--no-legend"},
           {"--set-style", id + "color-map=viridis,range=0:1000", "--no-legend"}}) {
    seen.push_back(with(more));
    CHECK(std::ranges::count(seen, seen.back()) == 1);
  }
  CHECK(with({"--set-style", id + "color-map=viridis", "--set-style", id + "color-map=none"}) == seen.front());
}

TEST_CASE("a picture to trace lies below the drawing, where it is put") {
  const TemporaryFolder folder;
  const std::string file = (folder / "trace.png").string();
  REQUIRE(run({"render", kDude, "--size", "60x40", "--background", "ff8800", "-o", file}, headless()).exit_code == 0);
  const auto with = [&](const std::vector<std::string>& more) {
    std::vector<std::string> all{kDude, "--size", "150x100", "--layers", "curve"};
    all.insert(all.end(), more.begin(), more.end());
    return picture(all);
  };
  std::vector<std::string> seen{with({})};
  for (const std::vector<std::string>& more :
       std::vector<std::vector<std::string>>{{"--image", file},
                                             {"--image", file + ":320,250,200"},
                                             {"--image", file + ":330,250,200"},
                                             {"--image", file, "--set-style", "image:opacity=0.5"}}) {
    seen.push_back(with(more));
    CHECK(std::ranges::count(seen, seen.back()) == 1);
  }
  for (const std::string& wrong : {(folder / "missing.png").string(), std::string(kDude), file + ":1,2"}) {
    const RunResult result = run({"render", kDude, "--image", wrong, "-o", (folder / "b.png").string()}, headless());
    CHECK(result.exit_code == 3);
    CHECK_THAT(result.err, Catch::StartsWith("mesecina: " + wrong + ": "));
    CHECK(std::ranges::count(result.err, '\n') == 1);
  }
  CHECK(folder.file_count() == 1);
}
