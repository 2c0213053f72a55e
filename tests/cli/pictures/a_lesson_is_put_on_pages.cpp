// SPDX-License-Identifier: GPL-3.0-or-later
// `mesecina lesson`: the lessons that come with the program, and files that hold none.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/cli/output_of.h"
#include "tests/cli/run_binary.h"
#include "tests/io/temporary_folder.h"

using mes::test::contents_of;
using mes::test::output_of;
using mes::test::run;
using mes::test::RunOptions;
using mes::test::RunResult;
using mes::test::TemporaryFolder;

namespace {

constexpr const char* kCrust = "assets/lessons/crust.json";

void require_refused(const std::vector<std::string>& arguments, int code, const std::string& says,
                     const RunOptions& options = {}) {
  const RunResult result = run(arguments, options);
  INFO(Catch::StringMaker<std::vector<std::string>>::convert(arguments));
  INFO(result.err);
  CHECK(result.exit_code == code);
  CHECK(result.out.empty());
  CHECK(std::ranges::count(result.err, '\n') == 1);
  CHECK_THAT(result.err, Catch::StartsWith("mesecina: ") && Catch::Contains(says));
}

std::string with_steps(const std::string& steps) {
  return R"({"mesecina":"session","schema":1,"data":{"samples":[0,0,4,0,4,3]},"lesson":{"steps":)" + steps + "}}";
}

std::size_t pages_of(const std::string& file) {
  const std::string said = output_of({file}, {.program = "pdfinfo"});
  return std::stoul(said.substr(said.find("Pages:") + 6));
}

}  // namespace

TEST_CASE("every lesson that comes with the program is listed, found by its name, and drawn without a remark") {
  const TemporaryFolder folder;
  const auto lessons = nlohmann::json::parse(output_of({"list", "lessons", "--json"}));
  REQUIRE(lessons.size() == 6);
  const std::string table = output_of({"list", "lessons"});
  RunOptions headless;
  headless.environment = {"DISPLAY=", "WAYLAND_DISPLAY="};
  for (const auto& lesson : lessons) {
    const std::string name = lesson["id"];
    INFO(name);
    CHECK_THAT(table, Catch::Contains(name) && Catch::Contains(std::string(lesson["title"])));
    const std::string steps = output_of({"lesson", name});
    CHECK(std::ranges::count(steps, '\n') == lesson["steps"]);
    const std::string pdf = folder / (name + ".pdf");
    CHECK(output_of({"lesson", name, "--pdf", pdf}, headless).empty());
    CHECK(pages_of(pdf) == lesson["steps"]);
    const std::string words = output_of({pdf, "-"}, {.program = "pdftotext"});
    CHECK_THAT(words, Catch::Contains(std::string(lesson["title"])));
    // The PDF is the lesson: given as one it says the same.
    CHECK(output_of({"lesson", pdf}) == steps);
  }
}

TEST_CASE("steps are chosen, in their order") {
  const std::string all = output_of({"lesson", kCrust});
  const auto lines_of = [](const std::string& text) { return std::ranges::count(text, '\n'); };
  REQUIRE(lines_of(all) == 8);
  CHECK(output_of({"lesson", kCrust, "--steps", "1-8"}) == all);
  CHECK(output_of({"lesson", kCrust, "--steps", "3,1-2,3"}) == output_of({"lesson", kCrust, "--steps", "1-3"}));
  CHECK_THAT(output_of({"lesson", kCrust, "--steps", "2"}),
             Catch::Contains("2 ") && Catch::Contains("Who is nearest"));
  const TemporaryFolder folder;
  const std::string pdf = folder / "some.pdf";
  output_of({"lesson", kCrust, "--steps", "2,7-8", "--pdf", pdf});
  CHECK(pages_of(pdf) == 3);
  for (const char* steps : {"0", "a", "3-2", "1,,2", ",", "1-", "-1", "1,", "1-2-3", "99999999999999999999"})
    require_refused({"lesson", kCrust, "--steps", steps}, 2, "--steps");
  require_refused({"lesson", kCrust, "--steps", "9"}, 2, "the lesson has 8 steps, and no step 9");
  require_refused({"lesson", kCrust, "--steps", "7-9", "--pdf", pdf}, 2, "no step 9");
  CHECK(pages_of(pdf) == 3);
}

TEST_CASE("pages have the size, the background and the explanations that are asked for") {
  const TemporaryFolder folder;
  const std::string pdf = folder / "a4.pdf";
  output_of({"lesson", "crust", "--steps", "5", "--figure-size", "210mmx297mm", "--background", "102030", "--scale",
             "2", "--key", "--scale-bar", "--axes", "--grid", "--no-annotations", "--no-source", "--pdf", pdf});
  CHECK_THAT(output_of({pdf}, {.program = "pdfinfo"}), Catch::Contains("A4"));
  CHECK_THAT(output_of({pdf, "-"}, {.program = "pdftotext"}), Catch::Contains("Delaunay"));
  require_refused({"lesson", pdf}, 3, "a4.pdf");
  for (const char* size : {"0x1", "10", "1000mmx100mm", "big"})
    require_refused({"lesson", "crust", "--pdf", pdf, "--figure-size", size}, 2, "--figure-size");
  for (const char* scale : {"0", "nan", "x"})
    require_refused({"lesson", "crust", "--pdf", pdf, "--scale", scale}, 2, "--scale");
  require_refused({"lesson", "crust", "--pdf", pdf, "--background", "red"}, 2, "--background");
}

TEST_CASE("what has no lesson is refused in one line") {
  const TemporaryFolder folder;
  const std::string pdf = folder / "out.pdf";
  require_refused({"lesson", "assets/shapes/bean.poff", "--pdf", pdf}, 3, "this is not a session but poff");
  require_refused({"lesson", "tests/data/edited_bean.json", "--pdf", pdf}, 3, "this session has no lesson");
  require_refused({"lesson", "nothing.json", "--pdf", pdf}, 3, "nothing.json");
  require_refused({"lesson", "crsut"}, 2, "did you mean crust");
  require_refused({"lesson", "-", "--pdf", pdf}, 3, "the file is empty", {.input = ""});
  require_refused({"lesson", "-"}, 3, "position 1 on a timeline of 0 entries",
                  {.input = with_steps(R"([{"position":1}])")});
  require_refused({"lesson", "-"}, 3, "this session has no lesson", {.input = with_steps("[]")});
  require_refused({"lesson"}, 2, "LESSON");
  require_refused({"lesson", "crust", "--pdf", "/nowhere/out.pdf"}, 4, "/nowhere");
  require_refused({"lesson", "crust", "--pdf", folder.path().string()}, 4, folder.path().string());
  CHECK_FALSE(std::filesystem::exists(pdf));
  CHECK(folder.file_count() == 0);
}

TEST_CASE("lessons without samples, without words or with an odd caption are drawn") {
  const TemporaryFolder folder;
  const std::string pdf = folder / "out.pdf";
  for (const char* samples : {"[]", "[1,2]", "[1,2,3,4]"}) {
    const std::string session = std::string(R"({"mesecina":"session","schema":1,"data":{"samples":)") + samples +
                                R"(},"lesson":{"steps":[{},{"caption":"# <b> ( \\ ) \u0000\u0007"}]}})";
    output_of({"lesson", "-", "--pdf", pdf}, {.input = session});
    CHECK(pages_of(pdf) == 2);
    CHECK(output_of({"lesson", "-"}, {.input = session}).starts_with("  1    4 s\n  2    4 s  <b> ( \\ )"));
  }
  const RunResult odd = run({"lesson", "-", "--pdf", pdf}, {.input = with_steps(R"([{"caption":"$\\nonsense$"}])")});
  CHECK(odd.exit_code == 0);
  CHECK_THAT(odd.err, Catch::Contains("step 1: caption: ") && Catch::Contains("nonsense"));
}

TEST_CASE("a PDF is not written over the lesson it is made of without being asked") {
  const TemporaryFolder folder;
  const std::string file = folder.write("lesson.json", contents_of(kCrust));
  CHECK(run({"lesson", file, "--pdf", file}).exit_code == 4);
  CHECK(contents_of(file) == contents_of(kCrust));
  // Nothing is lost: the PDF carries the lesson.
  output_of({"lesson", file, "--pdf", file, "--force"});
  CHECK(contents_of(file).starts_with("%PDF"));
  CHECK(std::ranges::count(output_of({"lesson", file}), '\n') == 8);
}

TEST_CASE("a lesson is one file for a browser, with nothing from elsewhere and nothing that is not escaped") {
  const std::string html = output_of({"lesson", "crust", "--html", "-"});
  const auto count = [&](std::string_view part) {
    std::size_t out = 0;
    for (std::size_t at = html.find(part); at != std::string::npos; at = html.find(part, at + 1)) ++out;
    return out;
  };
  CHECK(html.starts_with("<!DOCTYPE html>"));
  CHECK(count("<svg ") == 8);
  CHECK(count("<section ") == 8);
  CHECK(count("<script>") == 1);
  CHECK(count(" src=") == 0);
  CHECK(count("default-src 'none'") == 1);
  CHECK(count("<h2>Who is nearest</h2>") == 1);
  std::vector<std::string> ids;
  constexpr std::string_view kId = " id=\"";
  for (std::size_t at = html.find(kId); at != std::string::npos; at = html.find(kId, at + 1))
    ids.push_back(html.substr(at + kId.size(), html.find('"', at + kId.size()) - at - kId.size()));
  const std::size_t all = ids.size();
  std::ranges::sort(ids);
  ids.erase(std::ranges::unique(ids).begin(), ids.end());
  CHECK(ids.size() == all);
  const std::string evil = R"([{"caption":"# </section><script>alert(1)</script>\n\n\"'&"}])";
  const std::string escaped = output_of({"lesson", "-", "--html", "-"}, {.input = with_steps(evil)});
  CHECK_THAT(escaped, !Catch::Contains("alert(1)</script>") &&
                          Catch::Contains("&lt;/section&gt;&lt;script&gt;alert(1)") &&
                          Catch::Contains("&quot;&#39;&amp;"));
  require_refused({"lesson", "crust", "--html", "-", "--pdf", "-"}, 2, "two outputs are named");
}

TEST_CASE("a lesson is a picture a step, and captions with their times") {
  const TemporaryFolder folder;
  const std::string frames = folder / "frames";
  output_of({"lesson", "crust", "--steps", "6-8", "--frames", frames, "--size", "321x180"});
  const auto manifest = nlohmann::json::parse(contents_of(frames + "/manifest.json"));
  REQUIRE(manifest["frames"].size() == 3);
  CHECK(manifest["complete"] == true);
  CHECK(manifest["frames"][0]["interaction"] == "Crust or skeleton");
  // Samples are deleted, and that is undone.
  CHECK(manifest["frames"][0]["document"] != manifest["frames"][1]["document"]);
  CHECK(manifest["frames"][0]["document"] == manifest["frames"][2]["document"]);
  const std::string png = contents_of(frames + "/00003.png");
  REQUIRE(png.size() > 24);
  CHECK(png.substr(16, 8) == std::string("\0\0\x01\x41\0\0\0\xb4", 8));
  CHECK_FALSE(std::filesystem::exists(frames + "/00004.png"));
  require_refused({"lesson", "crust", "--frames", frames}, 4, "there are frames already");
  require_refused({"lesson", "crust", "--video", folder / "lesson.avi"}, 2, "must end in .mp4 or .webm");
  require_refused({"lesson", "crust", "--video", folder / "nowhere" / "lesson.mp4"}, 4, "lesson.mp4");
  for (const char* size : {"0x1", "x", "1000x100"})
    require_refused({"lesson", "crust", "--frames", frames, "--size", size}, 2, "--size");
  const std::string steps = R"([{"caption":"# A < B\n\n- c --> d","seconds":2.5},{"seconds":3600},{"caption":"e"}])";
  CHECK(output_of({"lesson", "-", "--vtt", "-"}, {.input = with_steps(steps)}) ==
        "WEBVTT\n\n1\n00:00:00.000 --> 00:00:02.500\n<b>A &lt; B</b>\n- c --&gt; d\n"
        "\n3\n00:10:02.500 --> 00:10:06.500\ne\n");
}

TEST_CASE("the lessons are those that the script makes") {
  if (run({"--version"}, {.program = "python3"}).exit_code != 0) {
    WARN("python3 is not installed");
    return;
  }
  const RunResult made = run({"scripts/make_lessons.py", "--check"}, {.program = "python3"});
  INFO(made.err);
  CHECK(made.exit_code == 0);
}

TEST_CASE("a lesson and the page for browsers are written into a folder, which keeps what it holds of others") {
  const TemporaryFolder folder;
  const std::string target = folder / "lecture";
  RunOptions options;
  options.environment = {"MESECINA_WEB=" + (folder / "page").string()};
  require_refused({"lesson", kCrust, "--web", target}, 1, "the page for browsers is not here", options);
  CHECK_FALSE(std::filesystem::exists(target));

  std::filesystem::create_directories(folder / "page" / "inner");
  folder.write("page/index.html", "<head>\n<title>Mesecina</title>\n</head>");
  folder.write("page/mesecina.wasm", "program");
  folder.write("page/page.js", "start();");
  CHECK(output_of({"lesson", kCrust, "--web", target}, options).empty());
  CHECK(contents_of(folder / "lecture/index.html") ==
        "<head>\n<title>What a crust is</title>\n<meta name=\"lesson\" content=\"lesson.json\">\n</head>");
  CHECK(contents_of(folder / "lecture/mesecina.wasm") == "program");
  CHECK(contents_of(folder / "lecture/page.js") == "start();");
  CHECK(output_of({"lesson", folder / "lecture/lesson.json"}) == output_of({"lesson", kCrust}));

  // An earlier page is replaced, and titles are text.
  folder.write("page/mesecina.wasm", "newer program");
  folder.write("own.json", R"({"mesecina":"session","schema":1,"title":"a<b","data":{"samples":[0,0]},"lesson":)"
                           R"({"title":"Is a < b & c?","steps":[{"caption":"One"}]}})");
  CHECK(output_of({"lesson", folder / "own.json", "--web", target}, options).empty());
  CHECK(contents_of(folder / "lecture/mesecina.wasm") == "newer program");
  CHECK_THAT(contents_of(folder / "lecture/index.html"),
             Catch::Contains("<title>Is a &lt; b &amp; c?</title>\n<meta name=\"lesson\""));

  std::filesystem::create_directories(folder / "site");
  folder.write("site/index.html", "mine");
  require_refused({"lesson", kCrust, "--web", folder / "site"}, 4, "holds other files", options);
  CHECK(contents_of(folder / "site/index.html") == "mine");
  CHECK(output_of({"lesson", kCrust, "--web", folder / "site", "--force"}, options).empty());
  CHECK(contents_of(folder / "site/index.html") != "mine");
  require_refused({"lesson", kCrust, "--web", folder / "own.json"}, 4, "own.json", options);
}
