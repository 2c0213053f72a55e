// SPDX-License-Identifier: GPL-3.0-or-later
// `render --compare`: each pane is what a picture of its own would show, at one scale.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "core/io/format.h"
#include "core/io/session/session.h"
#include "tests/cli/inputs.h"
#include "tests/cli/run_binary.h"
#include "tests/io/temporary_folder.h"
#include "tests/support/golden_image.h"

using mes::render::Image;
using mes::test::contents_of;
using mes::test::kBean;
using mes::test::kDude;
using mes::test::read_png;
using mes::test::run;
using mes::test::RunOptions;
using mes::test::RunResult;
using mes::test::TemporaryFolder;

namespace {

RunResult render_panes(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "render");
  RunOptions headless;
  headless.environment = {"DISPLAY=", "WAYLAND_DISPLAY="};
  return run(arguments, headless);
}

void drawn(const std::vector<std::string>& arguments) {
  const RunResult result = render_panes(arguments);
  INFO(result.err);
  REQUIRE(result.exit_code == 0);
  CHECK(result.err.empty());
}

Image part_of(const Image& image, int left, int top, int width, int height) {
  Image out{width, height, {}};
  for (int y = 0; y < height; ++y) {
    const auto row = image.rgba.begin() + static_cast<std::ptrdiff_t>(image.offset(left, top + y));
    out.rgba.insert(out.rgba.end(), row, row + 4 * width);
  }
  return out;
}

/// Without the line around a pane.
Image inside(const Image& image) {
  return part_of(image, 2, 2, image.width - 4, image.height - 4);
}

std::size_t occurrences(const std::string& text, const std::string& what) {
  std::size_t out = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++out;
  return out;
}

/// The lines of a group of an SVG file, by its id.
std::string group_of(const std::string& svg, const std::string& id) {
  const std::size_t begin = svg.find("<g id=\"" + id + "\"");
  if (begin == std::string::npos) return {};
  const std::size_t end = svg.find("inkscape:groupmode", svg.find('>', begin));
  return svg.substr(begin, end == std::string::npos ? end : end - begin);
}

}  // namespace

TEST_CASE("a pane has the pixels of the picture that it would be alone") {
  const TemporaryFolder folder;
  const std::string layers = "points,curve,p-union-boundary,p-ball-medial-axis";
  // Three panes of 300 x 270 with gaps of 16 and bands of 30.
  const std::string all = (folder / "all.png").string();
  const std::vector<std::string> common{kDude, "--layers", layers, "--view", "0,0,800,700", "--no-source"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), common.begin(), common.end());
    return more;
  };
  drawn(with({"--compare", "p-scale=1,1.2,0.9", "--size", "932x300", "-o", all}));
  const Image image = read_png(all);
  const char* const values[] = {"1", "1.2", "0.9"};
  for (int pane = 0; pane < 3; ++pane) {
    const std::string one = (folder / "one.png").string();
    drawn(with({"--set", std::string("p-scale=") + values[pane], "--size", "300x270", "-o", one}));
    INFO("pane " << pane);
    CHECK(inside(part_of(image, 316 * pane, 0, 300, 270)) == inside(read_png(one)));
  }
}

TEST_CASE("with free cameras each pane shows all that is in it, as it would alone") {
  const TemporaryFolder folder;
  const std::string all = (folder / "all.png").string();
  const std::vector<std::string> common{kDude, "--layers", "points,curve", "--no-source"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), common.begin(), common.end());
    return more;
  };
  const std::vector<std::string> steps{"--compare", "step=0,200", "--evolution", "smooth"};
  const auto compared = [&](std::vector<std::string> more) {
    more.insert(more.begin(), steps.begin(), steps.end());
    return with(more);
  };
  drawn(compared({"--free-cameras", "--size", "616x330", "-o", all}));
  const Image image = read_png(all);
  const std::string one = (folder / "one.png").string();
  drawn(with({"--size", "300x300", "-o", one}));
  CHECK(inside(part_of(image, 0, 0, 300, 300)) == inside(read_png(one)));
  // The smoothed shape is smaller: seen by itself it is larger.
  const std::string locked = (folder / "locked.png").string();
  drawn(compared({"--size", "616x330", "-o", locked}));
  CHECK(inside(part_of(read_png(locked), 316, 0, 300, 300)) != inside(part_of(image, 316, 0, 300, 300)));
}

TEST_CASE("a title stands once, above all panes") {
  const TemporaryFolder folder;
  constexpr int kBand = 38;  // of one line
  const std::vector<std::string> common{kDude,         "--layers",  "points,curve",  "--view",
                                        "0,0,800,700", "--compare", "p-scale=1,1.2", "--no-source"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), common.begin(), common.end());
    return more;
  };
  const std::string plain = (folder / "plain.png").string();
  const std::string titled = (folder / "titled.png").string();
  const std::string vector = (folder / "titled.svg").string();
  drawn(with({"--size", "616x300", "-o", plain}));
  drawn(with({"--title", "Above", "--size", "616x" + std::to_string(300 + kBand), "-o", titled}));
  drawn(with({"--title", "Above", "--size", "616x" + std::to_string(300 + kBand), "-o", vector}));
  const Image whole = read_png(titled);
  CHECK(part_of(whole, 0, kBand, 616, 300) == read_png(plain));
  const Image band = part_of(whole, 0, 0, 616, kBand - 1);
  CHECK(std::ranges::any_of(band.rgba, [](std::uint8_t byte) { return byte < 0x80; }));
  const std::string svg = contents_of(vector);
  CHECK(occurrences(svg, ">Above</text>") == 1);
  CHECK(occurrences(svg, "<rect y=\"28.5\" width=\"225\" height=\"202.5\"/>") > 0);
}

TEST_CASE("panes of steps show what `evolve` gives") {
  const TemporaryFolder folder;
  const std::string all = (folder / "all.svg").string();
  drawn({kBean, "--layers", "points,medial-axis", "--compare", "step=0,7", "--evolution",
         "noise:noise-factor=0.2,seed=5", "--view", "-200,-200,600,600", "--size", "616x330", "--set-style",
         "points:thin-when-dense=off", "-o", all});
  const std::string later = (folder / "later.poff").string();
  REQUIRE(run({"evolve", kBean, "--evolution", "noise", "--set", "noise-factor=0.2", "--seed", "5", "--steps", "7",
               "-o", later})
              .exit_code == 0);
  const std::string svg = contents_of(all);
  for (const auto& [pane, file] : {std::pair{"a", std::string(kBean)}, std::pair{"b", later}}) {
    const std::string alone = (folder / "alone.svg").string();
    drawn({file, "--layers", "points,medial-axis", "--compare", "a-scale=1,2", "--view", "-200,-200,600,600",
           "--size", "616x330", "--set-style", "points:thin-when-dense=off", "-o", alone});
    const std::string expected = contents_of(alone);
    INFO("pane " << pane);
    const std::string id = std::string("pane-") + pane;
    CHECK(occurrences(group_of(svg, id + "-points"), "<circle") ==
          occurrences(group_of(expected, id + "-points"), "<circle"));
    CHECK(group_of(svg, id + "-medial-axis") == group_of(expected, id + "-medial-axis"));
    CHECK_FALSE(group_of(svg, id + "-medial-axis").empty());
  }
  CHECK(group_of(svg, "pane-a-medial-axis").size() != group_of(svg, "pane-b-medial-axis").size());
}

TEST_CASE("differences mark what only some panes have, and nothing else") {
  const TemporaryFolder folder;
  const std::string file = (folder / "differences.svg").string();
  drawn({kDude, "--layers", "points,curve,p-union-boundary", "--compare", "p-scale=1,1.2", "--differences", "-o",
         file});
  const std::string svg = contents_of(file);
  // Points and curve are the same in both: each group once a pane. The boundaries differ.
  for (const std::string pane : {"pane-a-", "pane-b-"}) {
    CHECK(occurrences(svg, "<g id=\"" + pane + "points\"") == 1);
    CHECK(occurrences(svg, "<g id=\"" + pane + "curve\"") == 1);
    CHECK(occurrences(svg, "<g id=\"" + pane + "p-union-boundary\"") == 1);
    CHECK(occurrences(svg, "<g id=\"" + pane + "p-union-boundary-only-here\"") == 1);
  }
  const RunResult same = render_panes(
      {kBean, "--layers", "points,curve", "--compare", "precision=fast,exact", "--differences", "-o", file});
  CHECK(same.exit_code == 0);
  CHECK(same.err == "mesecina: the panes show no differences\n");
}

TEST_CASE("what cannot be compared is a usage error, and nothing is written") {
  const TemporaryFolder folder;
  const std::string file = (folder / "not.png").string();
  struct Wrong {
    std::vector<std::string> arguments;
    const char* complaint;
  };
  const std::vector<Wrong> wrong{
      {{"--compare", "precision=naive"}, "give 2 to 16 values, not 1"},
      {{"--compare", "precision"}, "expects WHAT=VALUE,VALUE"},
      {{"--compare", "precision=naive,best"}, "unknown number type \"best\""},
      {{"--compare", "speed=1,2"}, "unknown subject \"speed\""},
      {{"--compare", "a-scale=1,,2"}, "a value is empty"},
      {{"--compare", "a-scale=1,1000"}, "--compare a-scale expects a number from "},
      {{"--compare", "family=a,q"}, "\"q\" is not one of a, p or b"},
      {{"--compare", "family=a,p", "--layers", "points"}, "name layers of a family"},
      {{"--compare", "step=0,2"}, "name the evolution with --evolution"},
      {{"--compare", "step=0,-2", "--evolution", "smooth"},
       "--compare step expects a whole number from 0 to 2^64 - 1, not"},
      {{"--compare", "step=0,2", "--evolution", "smooth:speed=1"}, "unknown parameter \"speed\""},
      {{"--compare", "precision=fast,exact", "--evolution", "smooth"}, "needs --compare step"},
      {{"--compare", "bundle=Crust,Nonsense"}, "unknown bundle \"Nonsense\""},
      {{"--compare", "precision=fast,exact", "--size", "30x30"}, "too small for 2 panes"},
      {{"--differences"}, "requires --compare"},
      {{"--free-cameras"}, "requires --compare"},
      {{"--compare", "precision=fast,exact", "--free-cameras", "--view", "0,0,1,1"}, "excludes --view"},
  };
  for (const Wrong& each : wrong) {
    std::vector<std::string> arguments = each.arguments;
    arguments.insert(arguments.begin(), kBean);
    arguments.insert(arguments.end(), {"-o", file});
    const RunResult result = render_panes(arguments);
    INFO(each.arguments[0] << ' ' << (each.arguments.size() > 1 ? each.arguments[1] : "") << ": " << result.err);
    CHECK(result.exit_code == 2);
    CHECK(result.err.find(each.complaint) != std::string::npos);
    CHECK(std::ranges::count(result.err, '\n') == 1);
    CHECK_FALSE(std::filesystem::exists(file));
  }
}

TEST_CASE("a picture of panes carries them, as the window would show them") {
  using namespace mes;
  const TemporaryFolder folder;
  const auto session_of = [&](std::vector<std::string> arguments) {
    const std::string file = (folder / "carrier.svg").string();
    arguments.insert(arguments.begin(), kDude);
    arguments.insert(arguments.end(), {"--force", "-o", file});
    drawn(arguments);
    const auto read = read_sample_file(file);
    REQUIRE(read);
    REQUIRE(read->session);
    return *read->session;
  };
  const Session precisions = session_of({"--compare", "precision=naive,exact,fast"});
  CHECK(precisions.pane_views.empty());
  CHECK(session_of({"--compare", "precision=naive,exact,fast", "--free-cameras"}).pane_views.size() == 2);
  CHECK(precisions.settings.precision == Precision::naive);
  CHECK(precisions.panes == std::vector<PaneChoice>{Precision::exact, Precision::fast});
  const Session scales =
      session_of({"--layers", "points,a-union-boundary", "--compare", "a-scale=1.5,1,1.1,1.2,1.3,1.4"});
  CHECK(scales.settings[Parameter::a_scale] == 1.5);
  CHECK(scales.panes == std::vector<PaneChoice>{ParameterChoice{Parameter::a_scale, 1.0},
                                                ParameterChoice{Parameter::a_scale, 1.1},
                                                ParameterChoice{Parameter::a_scale, 1.2}});
  const Session families = session_of({"--layers", "points,a-union-boundary", "--compare", "family=p,a"});
  CHECK(families.panes == std::vector<PaneChoice>{FamilyKind::inner});
  REQUIRE(families.layers.layers.size() == 2);
  CHECK(families.layers.layers[1].layer == "p-union-boundary");
  const Session bundles = session_of({"--compare", "bundle=Samples,Crust"});
  REQUIRE(bundles.panes.size() == 1);
  CHECK(std::get<Bundle>(bundles.panes[0]).name == "Crust");
  const Session steps = session_of({"--compare", "step=0,3", "--evolution", "noise:noise-factor=0.2,seed=5"});
  CHECK(steps.panes == std::vector<PaneChoice>{EvolvedChoice{3}});
  CHECK(steps.evolution.id == "noise");
  CHECK(steps.evolution.seed == 5);
  const Session later = session_of({"--compare", "step=2,3", "--evolution", "smooth"});
  CHECK(later.panes == std::vector<PaneChoice>{EvolvedChoice{2}, EvolvedChoice{3}});
  // Where a parameter is moved, steps are counted from what it was.
  const Session scaled =
      session_of({"--layers", "points,a-union-boundary", "--compare", "step=2,5", "--evolution", "a-growing"});
  CHECK(scaled.settings == ComputationSettings{});
  CHECK(scaled.panes == std::vector<PaneChoice>{EvolvedChoice{2}, EvolvedChoice{5}});
  CHECK(session_of({}).panes.empty());
}
