// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/cli/run_binary.h"
#include "tests/io/temporary_folder.h"
#include "tests/support/golden_image.h"

using namespace mes::test;
using mes::render::Image;
using nlohmann::json;

namespace {

std::set<std::string> names_in(const std::filesystem::path& folder) {
  std::set<std::string> out;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) out.insert(entry.path().filename().string());
  return out;
}

}  // namespace

TEST_CASE("each step of a session is a picture, the same in every run, and shards are those of the whole") {
  const TemporaryFolder folder;
  const auto film = [&](const std::string& name, const std::vector<std::string>& extra = {}) {
    std::vector<std::string> arguments{"play",   kEditedBean, "--frames", (folder / name).string(),
                                       "--size", "320x200"};
    arguments.insert(arguments.end(), extra.begin(), extra.end());
    return run(arguments);
  };
  REQUIRE(film("whole").exit_code == 0);
  REQUIRE(film("again").exit_code == 0);
  REQUIRE(film("parts", {"--shard", "1/3"}).exit_code == 0);
  REQUIRE(film("parts", {"--shard", "3/3"}).exit_code == 0);
  REQUIRE(film("parts", {"--shard", "2/3"}).exit_code == 0);

  const json manifest = json::parse(contents_of(folder / "whole" / "manifest.json"));
  CHECK(manifest["complete"] == true);
  REQUIRE(manifest["frames"].size() == 12);
  CHECK(manifest["width"] == 320);
  std::set<std::string> pictures;
  for (int i = 1; i <= 12; ++i) {
    const std::string name = (i < 10 ? "0000" : "000") + std::to_string(i) + ".png";
    const std::string picture = contents_of(folder / "whole" / name);
    REQUIRE_FALSE(picture.empty());
    CHECK(contents_of(folder / "again" / name) == picture);
    CHECK(contents_of(folder / "parts" / name) == picture);
    pictures.insert(picture);
  }
  // Undoing the drag leads back to a picture that was there, up to the last bit of a few pixels.
  CHECK(pictures.size() >= 11);
  CHECK(names_in(folder / "parts").contains("manifest-2-of-3.json"));

  // The manifest is the session, with its history; that of a part too.
  const auto digests = [](const std::string& file) {
    const RunResult played = run({"play", file});
    INFO(played.err);
    REQUIRE(played.exit_code == 0);
    return played.out;
  };
  CHECK(digests((folder / "whole" / "manifest.json").string()) == digests(kEditedBean));
  CHECK(digests((folder / "parts" / "manifest-2-of-3.json").string()) == digests(kEditedBean));
  REQUIRE(film("bare", {"--no-source"}).exit_code == 0);
  const std::string bare = (folder / "bare" / "manifest.json").string();
  CHECK(contents_of(bare).find("mesecina-session") == std::string::npos);
  const RunResult none = run({"compute", bare});
  CHECK(none.exit_code == 3);
  CHECK(none.err == "mesecina: " + bare +
                        ":1:1: this is a manifest of frames that carries no session, not a text of "
                        "samples\n");

  const RunResult refused = film("whole");
  CHECK(refused.exit_code == 4);
  CHECK(refused.err.find("frames already") != std::string::npos);
}

TEST_CASE("a film shows annotations at each step, and what else explains it where that is asked for") {
  const TemporaryFolder folder;
  const std::string session = (folder / "a.json").string();
  std::ofstream(session)
      << R"({"mesecina":"session","schema":1,"data":{"samples":[0,0,4,0,4,3,0,3]},"view":[-1,-1,5,4],
    "timeline":[{"edit":{"annotations":[{"kind":"leader","at":[4,3],"follows":[[2]],"text":"here","shift":[-60,40]}]}},
    {"edit":{"move":[2,3,2]}},{"undo":true},{"undo":true}]})";
  const auto film = [&](const std::string& name, const std::vector<std::string>& extra = {}) {
    std::vector<std::string> arguments{"play", session, "--frames", (folder / name).string(), "--size", "320x200"};
    arguments.insert(arguments.end(), extra.begin(), extra.end());
    REQUIRE(run(arguments).exit_code == 0);
    std::vector<Image> out;
    for (int i = 1; i <= 5; ++i) out.push_back(read_png(folder / name / ("0000" + std::to_string(i) + ".png")));
    return out;
  };
  const std::vector<Image> shown = film("shown");
  const std::vector<Image> bare = film("bare", {"--no-annotations"});
  // Opened, annotated, its sample moved, moved back, without.
  CHECK(shown[0] == bare[0]);
  CHECK(shown[1] != bare[1]);
  CHECK(bare[1] == bare[0]);
  CHECK(shown[2] != bare[2]);
  CHECK(shown[3] == shown[1]);
  CHECK(shown[4] == shown[0]);
  const std::vector<Image> explained = film("explained", {"--axes", "--grid", "--scale-bar", "--key"});
  for (std::size_t i = 0; i < shown.size(); ++i) CHECK(explained[i] != shown[i]);
  const std::vector<Image> titled = film("titled", {"--title", "Four samples"});
  for (std::size_t i = 0; i < shown.size(); ++i) CHECK(titled[i] != shown[i]);
}

TEST_CASE("a film of a session with panes shows all of them, each as it is at that step") {
  const TemporaryFolder folder;
  const auto film = [&](const std::string& name, const std::string& panes) {
    const std::string session = (folder / (name + ".json")).string();
    std::ofstream(session)
        << R"({"mesecina":"session","schema":1,"data":{"samples":[0,0,4,0,4,3,0,3]},"view":[-1,-1,5,4],
    )" << panes
        << R"("timeline":[{"edit":{"name":"Move","move":[2,3,2]}},{"edit":{"name":"Insert","insert":[2,1]}},{"undo":true}]})";
    const RunResult result = run({"play", session, "--frames", (folder / name).string(), "--size", "616x330"});
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    std::vector<Image> out;
    for (int i = 1; i <= 4; ++i) out.push_back(read_png(folder / name / ("0000" + std::to_string(i) + ".png")));
    return out;
  };
  const auto part = [](const Image& image, int left) {
    std::vector<std::uint8_t> out;
    // Without the frame around the pane.
    for (int y = 2; y < 298; ++y)
      out.insert(out.end(), image.rgba.begin() + static_cast<std::ptrdiff_t>(image.offset(left + 2, y)),
                 image.rgba.begin() + static_cast<std::ptrdiff_t>(image.offset(left + 298, y)));
    return out;
  };
  const std::vector<Image> shown = film("before", R"("panes":[{"before_last_edit":true}],)");
  // Moved, inserted, taken back: each pane beside has what the main one had before.
  CHECK(part(shown[0], 316) == part(shown[0], 0));
  CHECK(part(shown[1], 316) == part(shown[0], 0));
  CHECK(part(shown[1], 0) != part(shown[0], 0));
  CHECK(part(shown[2], 316) == part(shown[1], 0));
  CHECK(part(shown[3], 316) == part(shown[0], 0));
  CHECK(part(shown[3], 0) == part(shown[1], 0));
  CHECK(film("alone", "")[0] != shown[0]);
  const json manifest = json::parse(contents_of(folder / "before" / "manifest.json"));
  CHECK(manifest["width"] == 616);
  // With free cameras a pane has the view that the session gives it.
  const std::vector<Image> same = film("same", R"("panes":[{"precision":"exact","view":[-1,-1,5,4]}],)");
  const std::vector<Image> free = film("free", R"("panes":[{"precision":"exact","view":[-1,-1,11,4]}],)");
  CHECK(part(free[0], 0) == part(same[0], 0));
  CHECK(part(free[0], 316) != part(same[0], 316));
}

TEST_CASE("panes of a film count the steps of an evolution from its beginning, and say what cannot be made") {
  const TemporaryFolder folder;
  const auto film = [&](const std::string& name, const std::string& evolution, const std::string& panes,
                        const std::string& timeline) {
    const std::string session = (folder / (name + ".json")).string();
    std::ofstream(session) << R"({"mesecina":"session","schema":1,"view":[-1,-1,5,4],
      "data":{"samples":[0,0,4,0,4,3,0,3],"contours":[{"closed":true,"points":[0,1,2,3]}]},"evolution":{"id":")"
                           << evolution << R"("},"panes":[)" << panes << R"(],"timeline":[)" << timeline << "]}";
    const RunResult result = run({"play", session, "--frames", (folder / name).string(), "--size", "616x330"});
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    const auto frames = json::parse(contents_of(folder / name / "manifest.json"))["frames"].size();
    std::vector<Image> out;
    for (std::size_t i = 1; i <= frames; ++i)
      out.push_back(read_png(folder / name / ("0000" + std::to_string(i) + ".png")));
    return out;
  };
  // Without the frame around the pane.
  const auto part = [](const Image& image, int left) {
    std::vector<std::uint8_t> out;
    for (int y = 2; y < 298; ++y)
      out.insert(out.end(), image.rgba.begin() + static_cast<std::ptrdiff_t>(image.offset(left + 2, y)),
                 image.rgba.begin() + static_cast<std::ptrdiff_t>(image.offset(left + 298, y)));
    return out;
  };
  // Each sample half-way to the middle of its neighbours, twice; then one is moved by hand.
  const std::string evolved =
      R"({"edit":{"name":"once","state":true,"move":[0,1,0.75,1,3,0.75,2,3,2.25,3,1,2.25]}},
         {"edit":{"name":"twice","replaces":true,"state":true,"move":[0,1.5,1.125,1,2.5,1.125,2,2.5,1.875,3,1.5,1.875]}},
         {"edit":{"name":"Smooth, 1 step","move":[2,4,3]}})";
  const std::vector<Image> first = film("first", "smooth", R"({"step":0})", evolved);
  REQUIRE(first.size() == 4);
  CHECK(part(first[0], 316) == part(first[0], 0));
  CHECK(part(first[1], 0) != part(first[0], 0));
  CHECK(part(first[1], 316) == part(first[0], 0));
  CHECK(part(first[2], 316) == part(first[0], 0));
  // An edit of a state is state 0 of what follows.
  CHECK(part(first[3], 316) == part(first[3], 0));
  CHECK(part(first[3], 0) != part(first[2], 0));

  const std::vector<Image> impossible =
      film("impossible", "subdivide", R"({"step":60})", R"({"edit":{"name":"Move","move":[2,3,2]}})");
  REQUIRE(impossible.size() == 2);
  CHECK(part(impossible[1], 0) != part(impossible[0], 0));
  const std::vector<std::uint8_t> nothing = part(impossible[0], 316);
  CHECK(std::ranges::all_of(nothing, [](std::uint8_t byte) { return byte == 255; }));
  CHECK(part(impossible[1], 316) == nothing);
}

TEST_CASE("films that make no sense are refused before any work") {
  const TemporaryFolder folder;
  const std::string frames = (folder / "f").string();
  for (const std::vector<std::string>& extra : std::vector<std::vector<std::string>>{{"--size", "0x10"},
                                                                                     {"--fps", "0"},
                                                                                     {"--fps", "fast"},
                                                                                     {"--shard", "0/3"},
                                                                                     {"--shard", "4/3"},
                                                                                     {"--shard", "1"},
                                                                                     {"--video", "x.avi"}}) {
    std::vector<std::string> arguments{"play", kEditedBean, "--frames", frames};
    arguments.insert(arguments.end(), extra.begin(), extra.end());
    const RunResult result = run(arguments);
    CHECK(result.exit_code == 2);
    CHECK(std::ranges::count(result.err, '\n') == 1);
  }
  CHECK(folder.file_count() == 0);
  CHECK(run({"play", kEditedBean, "--frames", "/proc/no/such"}).exit_code == 4);
}

TEST_CASE("the demo is computed without a display, with captions and every scene") {
  const TemporaryFolder folder;
  const RunResult result = run({"demo", "--frames", (folder / "demo").string(), "--size", "160x90", "--fps", "1"},
                               {.environment = {"DISPLAY="}});
  REQUIRE(result.err.empty());
  REQUIRE(result.exit_code == 0);
  const json manifest = json::parse(contents_of(folder / "demo" / "manifest.json"));
  CHECK(manifest["complete"] == true);
  const std::size_t frames = manifest["frames"].size();
  CHECK(frames > 150);
  CHECK(names_in(folder / "demo").size() == frames + 1);
  std::set<std::string> documents;
  std::set<std::string> pictures;
  for (const json& frame : manifest["frames"]) {
    documents.insert(frame["document"].get<std::string>());
    pictures.insert(contents_of(folder / "demo" / frame["file"].get<std::string>()));
  }
  // Nothing, 24 strokes, the noise, 40 steps of smoothing.
  CHECK(documents.size() == 66);
  CHECK(pictures.size() > 100);
}

TEST_CASE("a video that cannot be written is refused before the first frame is drawn") {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "bin");
  const auto program = folder.write("bin/ffmpeg", "#!/bin/sh\nexit 1\n");
  std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  const std::vector<std::string> path{"PATH=" + (folder / "bin").string() + ":/usr/bin:/bin"};
  const std::string frames = (folder / "frames").string();
  const RunResult nowhere =
      run({"play", kEditedBean, "--frames", frames, "--video", (folder / "no" / "a.mp4").string()},
          {.environment = path});
  CHECK(nowhere.exit_code == 4);
  CHECK(nowhere.err.find("no/a.mp4: cannot be written: No such file or directory") != std::string::npos);
  const RunResult without = run({"play", kEditedBean, "--frames", frames, "--video", (folder / "a.mp4").string()},
                                {.environment = {"PATH=" + (folder / "frames").string()}});
  CHECK(without.exit_code == 4);
  CHECK(without.err.find("ffmpeg") != std::string::npos);
  CHECK_FALSE(std::filesystem::exists(frames));
  CHECK(folder.file_count() == 1);
}
