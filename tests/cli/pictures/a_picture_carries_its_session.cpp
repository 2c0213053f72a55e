// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures and figures hold what they are of: given as FILE they are that document, as it was seen.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstddef>
#include <nlohmann/json.hpp>

#include "core/base/carried_session.h"
#include "core/base/zlib.h"
#include "core/io/session/session.h"
#include "tests/cli/inputs.h"
#include "tests/cli/output_of.h"
#include "tests/cli/run_binary.h"
#include "tests/io/temporary_folder.h"

using mes::test::contents_of;
using mes::test::kBean;
using mes::test::output_of;
using mes::test::run;
using mes::test::RunResult;
using mes::test::TemporaryFolder;

namespace {

constexpr const char* kCarriers[] = {"png", "svg", "pdf", "ipe"};

/// In a file, or to standard output.
std::string render_picture(const std::string& file, const std::string& format,
                           const std::vector<std::string>& more = {}, const std::string& output = "-") {
  std::vector<std::string> arguments{"render", file, "--size", "300x200", "--to", format, "-o", output};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return output_of(arguments);
}

/// Of what `compute` says of a file, all but its name and format.
nlohmann::json all_computed(const std::string& file) {
  nlohmann::json out =
      nlohmann::json::parse(output_of({"compute", file, "--layers", "all", "--no-timing", "--digest"}));
  out.erase("input");
  return out;
}

const std::vector<std::string> kLook{"--layers", "interior-voronoi-disks,medial-axis,points", "--set-style",
                                     "medial-axis:color=ff0000,line-width=3", "--view=-1,-0.5,1,1.5"};

/// Whatever is given as FILE ends with one line and exit code 3.
void check_refused(const std::string& file, const std::string& reason) {
  for (const char* command : {"compute", "export"}) {
    std::vector<std::string> arguments{command, file};
    if (command == std::string("export")) arguments.insert(arguments.end(), {"--layer", "points", "--format", "csv"});
    const RunResult result = run(arguments);
    INFO(result.err);
    CHECK(result.exit_code == 3);
    CHECK(result.out.empty());
    CHECK(std::ranges::count(result.err, '\n') == 1);
    CHECK_THAT(result.err, Catch::Contains(reason));
  }
}

/// An SVG with this in the place of the session.
std::string svg_with(const std::string& payload) {
  const std::string name(mes::kCarriedSession);
  return "<svg><metadata><" + name + " xmlns=\"urn:mesecina:session\">" + payload + "</" + name +
         "></metadata></svg>";
}

std::string in_base64(const std::string& bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t bit = 0; bit < 8 * bytes.size(); bit += 6) {
    unsigned digit = 0;
    for (std::size_t k = bit; k < bit + 6; ++k)
      digit =
          digit << 1U | (k / 8 < bytes.size() ? static_cast<unsigned char>(bytes[k / 8]) >> (7 - k % 8) & 1U : 0U);
    out += kDigits[digit];
  }
  while (out.size() % 4 != 0) out += '=';
  return out;
}

}  // namespace

TEST_CASE("a picture of a document is that document, to every command") {
  const TemporaryFolder folder;
  const nlohmann::json expected = all_computed(kBean);
  for (const std::string format : kCarriers) {
    INFO(format);
    const std::string file = (folder / ("a." + format)).string();
    render_picture(kBean, format, {}, file);
    CHECK(all_computed(file) == expected);
    CHECK(output_of({"export", file, "--layer", "points", "--format", "poff"}) ==
          output_of({"export", kBean, "--layer", "points", "--format", "poff"}));
    // Under a name that says nothing, too.
    const std::string other = (folder / "unnamed").string();
    std::filesystem::copy_file(file, other, std::filesystem::copy_options::overwrite_existing);
    CHECK(all_computed(other) == expected);
  }
}

TEST_CASE("a picture of a picture is the same picture, whatever kind of file that is") {
  const TemporaryFolder folder;
  const std::string picture = render_picture(kBean, "png", kLook);
  CHECK(picture != render_picture(kBean, "png"));
  for (const std::string format : kCarriers) {
    INFO(format);
    const std::string file = (folder / ("a." + format)).string();
    render_picture(kBean, format, kLook, file);
    CHECK(render_picture(file, "png") == picture);
    CHECK(render_picture(file, format) == contents_of(file));
    // What is asked for goes before what the session has.
    CHECK(render_picture(file, "png", {"--view", "0,0,1,1"}) != picture);
  }
}

TEST_CASE("without its source a figure is as before, and no document") {
  const TemporaryFolder folder;
  for (const std::string format : kCarriers) {
    INFO(format);
    const std::string file = (folder / ("a." + format)).string();
    render_picture(kBean, format, {"--no-source"}, file);
    CHECK(contents_of(file).find(mes::kCarriedSession) == std::string::npos);
    if (format != "pdf") {
      // The drawing itself can be read, as any other, and the picture traced, which is said.
      const RunResult result = run({"compute", file, "--layers", "points"});
      REQUIRE(result.exit_code == 0);
      CHECK(result.err.empty() == (format != "png"));
      CHECK(nlohmann::json::parse(result.out)["input"]["format"] == (format == "png" ? "picture" : format));
    } else {
      check_refused(file, "carries no session");
    }
  }
  for (const std::string format : {"eps", "ps", "tex"}) {
    INFO(format);
    CHECK(render_picture(kBean, format) == render_picture(kBean, format, {"--no-source"}));
  }
}

TEST_CASE("a picture holds neither the history of a session nor the folders of its author") {
  const TemporaryFolder folder;
  const std::string session = "tests/data/edited_bean.json";
  for (const std::string format : kCarriers) {
    const std::string file = (folder / ("a." + format)).string();
    render_picture(session, format, {}, file);
    CHECK(all_computed(file) == all_computed(session));
    CHECK(contents_of(file).find(folder.path().string()) == std::string::npos);
  }
  const std::string svg = render_picture(session, "svg");
  CHECK(svg.size() < contents_of(session).size() + render_picture(session, "svg", {"--no-source"}).size());
}

TEST_CASE("a session that is cut, broken, foreign or too long is refused in one line") {
  const TemporaryFolder folder;
  for (const std::string format : kCarriers) {
    const std::string whole = render_picture(kBean, format);
    // A PDF names the file before it holds it.
    const std::string mark = std::string(mes::kCarriedSession) + (format == "pdf" ? " true" : "");
    const std::size_t begin = whole.find(mark);
    REQUIRE(begin != std::string::npos);
    for (const std::size_t kept : {begin + 40, begin + 200, begin + 1000}) {
      INFO(format << ", " << kept);
      const std::string file = folder.write("cut." + format, whole.substr(0, kept)).string();
      const RunResult result = run({"compute", file});
      INFO(result.err);
      CHECK(result.exit_code == 3);
      CHECK(std::ranges::count(result.err, '\n') == 1);
    }
    std::string broken = whole;
    for (std::size_t i = begin + 120; i < begin + 160; ++i) broken[i] = broken[i] == 'A' ? 'B' : 'A';
    check_refused(folder.write("broken." + format, broken).string(), "cut or broken");
  }
  const std::string manifest = "{\n \"mesecina\": \"take\",\n \"" + std::string(mes::kCarriedSession) + "\"";
  check_refused(folder.write("cut.json", manifest).string(), "the file is cut");
  check_refused(folder.write("cut.json", manifest + ": \"eJw").string(), "the file is cut");
  check_refused(folder.write("broken.json", manifest + ": \"eJwrrgQ\"}").string(), "cut or broken");
  check_refused(folder.write("number.json", manifest + ": 7}").string(), "the file is cut");
  check_refused(folder.write("empty.svg", svg_with("")).string(), "cut or broken");
  check_refused(folder.write("text.svg", svg_with("hello")).string(), "cut or broken");
  const auto packed = [](const std::string& text) { return svg_with(in_base64(mes::zlib_compressed(text))); };
  check_refused(folder.write("nothing.svg", packed("nothing")).string(), "the session that it carries");
  check_refused(folder.write("array.svg", packed("[1, 2]")).string(), "the session that it carries");
  std::string later = mes::write_session({});
  const std::size_t schema = later.find("\"schema\":1");
  REQUIRE(schema != std::string::npos);
  later.replace(schema, 10, "\"schema\":9");
  check_refused(folder.write("later.svg", packed(later)).string(), "later version");
  // A megabyte of the file would be a gigabyte of text.
  check_refused(folder.write("huge.svg", packed(std::string(mes::kMostCarriedBytes + 1, ' '))).string(),
                "more than 128 MiB");
}
