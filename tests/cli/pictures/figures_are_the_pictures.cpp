// SPDX-License-Identifier: GPL-3.0-or-later
// The vector formats, drawn by other programs, against the picture in pixels of the same view.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <string_view>

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
using mes::test::with;

namespace {

void render_figure(std::vector<std::string> arguments, const std::string& file) {
  arguments.insert(arguments.begin(), "render");
  arguments.insert(arguments.end(), {"-o", file});
  RunOptions headless;
  headless.environment = {"DISPLAY=", "WAYLAND_DISPLAY="};
  const RunResult result = run(arguments, headless);
  INFO(result.err);
  REQUIRE(result.exit_code == 0);
  CHECK(result.err.empty());
}

void other_program(const std::string& program, const std::vector<std::string>& arguments) {
  const RunResult result = run(arguments, {.program = program});
  INFO(program << ": " << result.err);
  REQUIRE(result.exit_code == 0);
}

/// The figure in pixels, as another program draws it, `width` pixels wide.
/// With a height of 0 it follows from the width.
Image rasterised(const std::string& file, int width, int height = 0) {
  const std::string png = file + ".png";
  const std::string extension = std::filesystem::path(file).extension().string();
  const std::string size = std::to_string(width);
  if (extension == ".ps" || extension == ".eps") {
    // At four times the size of pixels of 1/96 inch, since Ghostscript draws no line thinner than its pixels.
    std::vector<std::string> arguments{"-q",
                                       "-dSAFER",
                                       "-dBATCH",
                                       "-dNOPAUSE",
                                       "-sDEVICE=png16m",
                                       "-r384",
                                       "-dDownScaleFactor=4",
                                       "-sOutputFile=" + png,
                                       file};
    if (extension == ".eps") arguments.insert(arguments.begin(), "-dEPSCrop");
    other_program("gs", arguments);
    return read_png(png);
  }
  if (extension == ".ipe") {
    other_program("ipetoipe", {"-pdf", file, file + ".pdf"});
    return rasterised(file + ".pdf", width, height);
  }
  if (extension == ".tex") {
    const std::filesystem::path path(file);
    other_program("pdflatex", {"-interaction=nonstopmode", "-halt-on-error",
                               "-output-directory=" + path.parent_path().string(), file});
    return rasterised((path.parent_path() / path.stem()).string() + ".pdf", width, height);
  }
  if (extension == ".svg") {
    std::vector<std::string> arguments{"--width", size, file, "--output", png};
    if (height > 0) arguments.insert(arguments.begin(), {"--height", std::to_string(height)});
    other_program("rsvg-convert", arguments);
  } else {
    // pdftoppm would move thin lines to whole pixels.
    std::vector<std::string> arguments{"-singlefile", "-png", "-scale-to-x", size, "-scale-to-y"};
    arguments.insert(arguments.end(), {height > 0 ? std::to_string(height) : "-1", file, file});
    other_program("pdftocairo", arguments);
  }
  return read_png(png);
}

/// Mean difference of the channels, in [0, 1], without counting alpha.
double difference(const Image& a, const Image& b) {
  REQUIRE(a.width == b.width);
  REQUIRE(a.height == b.height);
  double sum = 0.0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i)
    if (i % 4 != 3) sum += std::abs(static_cast<int>(a.rgba[i]) - static_cast<int>(b.rgba[i]));
  return sum / 255.0 / (0.75 * static_cast<double>(a.rgba.size()));
}

bool has_program(const std::string& program) {
  const RunResult found = run({"-c", "command -v " + program}, {.program = "sh"});
  if (found.exit_code != 0) WARN(program << " is not installed: what it would draw is not compared");
  return found.exit_code == 0;
}

struct Case {
  const char* name;
  std::vector<std::string> arguments;
  /// As measured: what rims of a pixel and the letters of another font differ by, and some more.
  double tolerance;
};

const std::vector<Case>& cases() {
  static const std::vector<Case> kCases{
      {"start", {kDude}, 0.004},
      {"crust", {kDude, "--bundle", "Voronoi and Delaunay"}, 0.004},
      {"union", {kDude, "--bundle", "Union of balls 3: v-points"}, 0.004},
      {"triangles", {kBean, "--bundle", "Union of balls 5: axis"}, 0.005},
      {"every layer", {kBean, "--layers", "all", "--no-legend"}, 0.012},
      {"every layer, close", {kBean, "--layers", "all", "--no-legend", "--view=100,50,104,53"}, 0.012},
      {"maps",
       {kBean, "--layers", "interior-voronoi-disks,medial-axis,points", "--no-legend", "--set-style",
        "medial-axis:color-map=viridis,line-width=4", "--set-style",
        "interior-voronoi-disks:color-map=inferno,flat=on,opacity=0.4"},
       0.004},
      {"dashes",
       {kBean, "--layers", "voronoi,interior-voronoi-circles,curve,a-union-boundary", "--set-style",
        "voronoi:dashed=on,line-width=2", "--set-style", "interior-voronoi-circles:dashed=on,line-width=1.5",
        "--set-style", "curve:dashed=on,line-width=3"},
       0.012},
      {"scale", {kBean, "--scale-bar", "--axes", "--grid"}, 0.006},
      {"key", {kBean, "--key", "--layers", "interior-voronoi-disks,interior-voronoi-circles,curve,points"}, 0.006},
      {"title", {kBean, "--title", "Beans of $r_i^2 \\le \\varepsilon$\\\\\\textbf{second} line", "--key"}, 0.006},
      {"places",
       {kBean, "--layers", "curve,medial-axis,points", "--key", "--legend-at", "top-left:20,10", "--scale-bar-at",
        "top-right:5,30"},
       0.004},
      {"places within axes and below a title",
       {kBean, "--layers", "curve,medial-axis,points", "--key", "--axes", "--title", "Beans", "--legend-at",
        "top-left:0,0", "--scale-bar-at", "bottom-left:9,9"},
       0.006},
      {"numbers",
       {kDude, "--layers", "curve,points,indices", "--set-style", "indices:color=D55E00,opacity=0.6,point-size=16"},
       0.004},
      {"on a dark ground", {kDude, "--background", "1b1e22", "--scale", "1.5"}, 0.006},
  };
  return kCases;
}

constexpr const char* kSize = "640x480";

/// The picture of a case in pixels, which all formats are compared with: drawn once.
const Image& picture_of(const Case& wanted) {
  static std::map<std::string, Image> drawn;
  Image& picture = drawn[wanted.name];
  if (picture.rgba.empty()) {
    const TemporaryFolder folder;
    const std::string file = (folder / "pixels.png").string();
    std::vector<std::string> arguments = wanted.arguments;
    arguments.insert(arguments.end(), {"--size", kSize});
    render_figure(arguments, file);
    picture = read_png(file);
  }
  return picture;
}

/// `factor`: of the tolerances, for programs that draw thin lines, or letters, otherwise. `only`: the names of some cases.
void compare_all(const std::string& extension, double factor = 1.0, const std::vector<std::string_view>& only = {}) {
  const TemporaryFolder folder;
  for (const Case& each : cases()) {
    if (!only.empty() && std::ranges::find(only, each.name) == only.end()) continue;
    // More shapes than pdflatex has memory for.
    if (extension == ".tex" && std::string_view(each.name).starts_with("every layer")) continue;
    std::vector<std::string> arguments = each.arguments;
    arguments.insert(arguments.end(), {"--size", kSize});
    const std::string figure = (folder / ("figure" + extension)).string();
    render_figure(arguments, figure);
    INFO(each.name);
    CHECK(difference(picture_of(each), rasterised(figure, 640, 480)) < factor * each.tolerance);
  }
}

}  // namespace

TEST_CASE("an SVG looks as the picture of the same view") {
  compare_all(".svg");
}

TEST_CASE("a PDF looks as the picture of the same view") {
  compare_all(".pdf");
}

TEST_CASE("PostScript looks as the picture of the same view") {
  compare_all(".ps", 2.5);
}

TEST_CASE("encapsulated PostScript looks as the picture of the same view") {
  // The drawing commands are those of PostScript; only the page differs.
  compare_all(".eps", 2.5, {"start", "title", "places"});
}

// Ipe and LaTeX take more room than all else that the tests need, so where they are not installed the tests of text and
// structure (tests/figure) are the only ones.
TEST_CASE("an Ipe file looks as the picture of the same view") {
  if (has_program("ipetoipe")) compare_all(".ipe", 2.0);
}

TEST_CASE("a TikZ picture compiles, by itself and within a document") {
  if (!has_program("pdflatex")) return;
  compare_all(".tex", 2.0);
  const TemporaryFolder folder;
  const std::string alone = (folder / "alone.tex").string();
  render_figure({kBean, "--title", "Beans of $r_i^2$", "--figure-size", "60mmx45mm"}, alone);
  const std::string page = (folder / "page.tex").string();
  std::ofstream(page) << "\\documentclass{article}\\usepackage[paperwidth=60mm,paperheight=45mm,margin=0pt]{geometry}"
                         "\\usepackage{tikz}\\pagestyle{empty}\\setlength{\\topskip}{0pt}\\begin{document}\\noindent"
                         "\\input{"
                      << alone << "}\\end{document}\n";
  // The page has its size in millimetres, the picture in points with two decimals.
  CHECK(difference(rasterised(page, 480, 360), rasterised(alone, 480, 360)) < 1e-4);
}

TEST_CASE("a TikZ picture of more shapes than TeX keeps of a page compiles, and looks as the others do") {
  if (!has_program("pdflatex")) return;
  const TemporaryFolder folder;
  const std::string samples = (folder / "many.xy").string();
  std::ofstream out(samples);
  // Without parts pdflatex ends at some 12,400.
  for (int i = 0; i < 14'000; ++i) out << i % 140 << ' ' << i / 140 << '\n';
  out.close();
  const std::string tex = (folder / "many.tex").string();
  const std::string svg = (folder / "many.svg").string();
  for (const std::string& file : {tex, svg})
    render_figure({samples, "--layers", "points", "--figure-size", "60mmx45mm"}, file);
  CHECK(difference(rasterised(tex, 480, 360), rasterised(svg, 480, 360)) < 0.02);
}

TEST_CASE("letters that the fonts lack are named in one line") {
  const TemporaryFolder folder;
  for (const char* const extension : {".png", ".svg", ".pdf", ".ps", ".tex"}) {
    INFO(extension);
    const std::string file = (folder / ("figure" + std::string(extension))).string();
    const RunResult one = run({"render", kBean, "--title", "\u6f22 and \u2603", "-o", file});
    CHECK(one.exit_code == 0);
    CHECK(one.err == "mesecina: the fonts have no letter U+2603, U+6F22: empty boxes are drawn\n");
    const RunResult none = run({"render", kBean, "--title", "\u03b1 \u00e4", "-o", file, "--force"});
    CHECK(none.err.empty());
  }
}

namespace {

/// A session of four samples with one annotation of each kind.
std::string annotated(const TemporaryFolder& folder) {
  const std::string file = (folder / "annotated.json").string();
  std::ofstream(file) << R"({"mesecina":"session","schema":1,"data":{"samples":[0,0,4,0,4,3,0,3],"annotations":[
    {"kind":"text","at":[0.4,2.3],"text":"four samples, $\\varepsilon_i^2 \\le 1$\\\\\\textbf{bold}","letters":24},
    {"kind":"leader","at":[0,0],"follows":[[2]],"text":"here","shift":[-90,70],"color":"#D55E00"},
    {"kind":"arrow","at":[1,0.5,2,1.5],"follows":[[],[0,1,2]],"text":"centre"},
    {"kind":"distance","at":[0,0,4,0],"follows":[[0],[1]],"shift":[0,-40],"text":"$d = \\value$"},
    {"kind":"angle","at":[4,0,0,0,4,3],"follows":[[1],[0],[2]]},
    {"kind":"radius","at":[0,0,4,0,4,3],"follows":[[0],[1],[2]],"letters":20},
    {"kind":"highlight","at":[4,3,0,3,0,0,2,1.5,2,1.5,0,0,0,3,4,0,4,3,0,3,2.5,1.5,3,1.5,2.5,2],
     "follows":[[2],[3],[0],[0,2,3],[0,2,3],[0],[3],[1],[2],[3],[],[],[]],"text":"$T_1$",
     "elements":[["triangle","itself"],["circle","itself",1],["ray","product"],["segment","origin"],
                 ["point","origin"],["arc","product"]]}]}})";
  return file;
}

}  // namespace

TEST_CASE("annotations are in every picture and every figure, or in none") {
  const TemporaryFolder folder;
  const std::string session = annotated(folder);
  const std::string with = (folder / "with.png").string();
  const std::string without = (folder / "without.png").string();
  const std::vector<std::string> look{session, "--layers", "points,curve", "--size", "640x480"};
  const auto looking = [&](const std::string& more) {
    std::vector<std::string> out = look;
    if (!more.empty()) out.push_back(more);
    return out;
  };
  render_figure(looking(""), with);
  render_figure(looking("--no-annotations"), without);
  const Image shown = read_png(with);
  const Image bare = read_png(without);
  CHECK(difference(shown, bare) > 0.011);
  for (const char* extension : {".svg", ".pdf"}) {
    INFO(extension);
    const std::string figure = (folder / ("figure" + std::string(extension))).string();
    render_figure(looking(""), figure);
    // As measured: less than half of what is missing without them, of which another font takes the most.
    CHECK(difference(shown, rasterised(figure, 640, 480)) < 0.0045);
    render_figure(looking("--no-annotations"), figure);
    CHECK(difference(bare, rasterised(figure, 640, 480)) < 0.005);
  }
  for (const char* extension : {".svg", ".ipe", ".tex"}) {
    INFO(extension);
    const std::string figure = (folder / ("source" + std::string(extension))).string();
    render_figure(looking(""), figure);
    const std::string text = contents_of(figure);
    CHECK(text.find("annotations") != std::string::npos);
    CHECK(text.find("highlights") != std::string::npos);
    if (extension != std::string(".svg")) CHECK(text.find("varepsilon_{i}^{2}") != std::string::npos);
    render_figure(looking("--no-annotations"), figure);
    CHECK(contents_of(figure).find("annotations") == std::string::npos);
  }
  // A picture carries them, and a file that is made of it has them again.
  const std::string again = (folder / "again.png").string();
  render_figure({with, "--layers", "points,curve", "--size", "640x480"}, again);
  CHECK(difference(shown, read_png(again)) == 0.0);
}

TEST_CASE("a legend and a scale bar stand where they are asked to, in pixels and in vectors") {
  const TemporaryFolder folder;
  // Nothing but them is drawn there: the disk is seen far away.
  const std::vector<std::string> empty{kBean, "--layers", "curve", "--view=0,0,1e6,1e6", "--size", "640x480"};
  struct Extent {
    int left = 640, top = 480, right = 0, bottom = 0;
  };
  const auto extent = [](const Image& image) {
    Extent out;
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) {
        const auto* const pixel = &image.rgba[image.offset(x, y)];
        // The samples themselves are one dot in the lower left corner.
        const bool is_dot = x < 90 && y > 420;
        if (is_dot || (pixel[0] > 235 && pixel[1] > 235 && pixel[2] > 235)) continue;
        out = {std::min(out.left, x), std::min(out.top, y), std::max(out.right, x), std::max(out.bottom, y)};
      }
    return out;
  };
  const auto drawn = [&](const std::string& extension, const std::vector<std::string>& more) {
    std::vector<std::string> arguments = empty;
    arguments.insert(arguments.end(), more.begin(), more.end());
    const std::string file = (folder / ("a" + extension)).string();
    render_figure(arguments, file);
    return extent(extension == ".png" ? read_png(file) : rasterised(file, 640, 480));
  };
  for (const char* extension : {".png", ".svg", ".pdf"}) {
    INFO(extension);
    // An inch is 96 pixels.
    const Extent legend = drawn(extension, {"--key", "--legend-at", "top-right:25.4,50.8"});
    CHECK(std::abs(legend.right - (640 - 96 - 1)) <= 1);
    CHECK(std::abs(legend.top - 2 * 96) <= 1);
    const Extent bar = drawn(extension, {"--scale-bar-at", "bottom-right:25.4,25.4"});
    CHECK(std::abs(bar.right - (640 - 96 - 1)) <= 1);
    CHECK(std::abs(bar.bottom - (480 - 96 - 1)) <= 1);
    // Kept on the page.
    const Extent kept = drawn(extension, {"--key", "--legend-at", "bottom-left:5080,5080"});
    CHECK(kept.right >= 638);
    CHECK(kept.top <= 1);
  }
}

TEST_CASE("a PDF carries the fonts of its legend and its marks") {
  const TemporaryFolder folder;
  const std::string file = (folder / "key.pdf").string();
  render_figure({kBean, "--key", "--axes", "--layers", "curve,medial-axis"}, file);
  const RunResult fonts = run({file}, {.program = "pdffonts"});
  CHECK(fonts.out.find("+Inter-Regular ") != std::string::npos);
  CHECK(fonts.out.find("Helvetica") == std::string::npos);
  const RunResult text = run({file, "-"}, {.program = "pdftotext"});
  CHECK(text.out.find("Medial axis") != std::string::npos);
}

TEST_CASE("each layer that a picture shows is missed in a figure without it") {
  const TemporaryFolder folder;
  const std::vector<std::string> layers{"interior-voronoi-disks", "curve", "medial-axis", "points"};
  const auto drawn = [&](const std::string& ids) {
    const std::string file = (folder / "part.svg").string();
    render_figure({kDude, "--size", "320x240", "--layers", ids}, file);
    return rasterised(file, 320, 240);
  };
  const std::string pixels = (folder / "pixels.png").string();
  render_figure({kDude, "--size", "320x240", "--layers", "interior-voronoi-disks,curve,medial-axis,points"}, pixels);
  const Image shown = read_png(pixels);
  const double whole = difference(shown, drawn("interior-voronoi-disks,curve,medial-axis,points"));
  for (const std::string& left_out : layers) {
    std::string ids;
    for (const std::string& layer : layers)
      if (layer != left_out) ids += (ids.empty() ? "" : ",") + layer;
    INFO(left_out);
    CHECK(difference(shown, drawn(ids)) > 1.2 * whole + 0.0005);
  }
}

TEST_CASE("a figure has the size on paper that was asked for") {
  const TemporaryFolder folder;
  const auto svg = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments{kDude};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const std::string file = (folder / "a.svg").string();
    render_figure(arguments, file);
    return contents_of(file);
  };
  CHECK_THAT(svg({"--figure-size", "84mmx60mm"}),
             Catch::Contains("width=\"84mm\" height=\"60mm\" viewBox=\"0 0 238.11 170.08\""));
  CHECK_THAT(svg({"--figure-size", "4.5inx3in"}), Catch::Contains("width=\"114.3mm\" height=\"76.2mm\""));
  CHECK_THAT(svg({"--figure-size", "960pxx480px"}), Catch::Contains("viewBox=\"0 0 720 360\""));
  CHECK_THAT(svg({"--figure-size", "square"}), Catch::Contains("width=\"84mm\" height=\"84mm\""));
  CHECK_THAT(svg({"--figure-size", "5080mmx1mm"}), Catch::Contains("width=\"5080mm\" height=\"1mm\""));
  CHECK_THAT(svg({"--figure-size", "one-column"}), Catch::Contains("width=\"84mm\" height=\""));
  // The height follows from a view: half the width.
  CHECK_THAT(svg({"--figure-size", "10cm", "--view", "0,0,200,100"}),
             Catch::Contains("width=\"100mm\" height=\"50mm\""));
  // Widths are those of paper, whatever the size.
  for (const char* size : {"84mmx60mm", "200mmx150mm"})
    CHECK_THAT(svg({"--figure-size", size, "--layers", "curve", "--set-style", "curve:line-width=0.6pt"}),
               Catch::Contains("stroke-width=\"0.6\""));
}

TEST_CASE("on paper lines have half a point at least, and letters seven and a half") {
  const TemporaryFolder folder;
  const std::string file = (folder / "a.svg").string();
  // The numbers that follow a word in the file.
  const auto numbers_after = [&](const std::string& word) {
    const std::string text = contents_of(file);
    std::vector<double> out;
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
      out.push_back(std::stod(text.substr(at + word.size())));
    return out;
  };
  const std::vector<std::string> dense{"assets/shapes/lizard.poff", "--layers", "voronoi,curve,points", "--key"};
  render_figure(with(dense, {"--size", "200x200"}), file);
  CHECK(std::ranges::min(numbers_after("stroke-width=\"")) < 0.5);
  for (const char* size : {"one-column", "40mm", "84mmx60mm"}) {
    CAPTURE(size);
    render_figure(with(dense, {"--figure-size", size}), file);
    CHECK(std::ranges::min(numbers_after("stroke-width=\"")) >= 0.5);
    CHECK(std::ranges::min(numbers_after("font-size=\"")) == Approx(7.5).margin(0.01));
  }
  render_figure(with(dense, {"--figure-size", "slide"}), file);
  CHECK(std::ranges::min(numbers_after("font-size=\"")) == Approx(15.0).margin(0.02));
  // A width that was given stays.
  render_figure(with(dense, {"--figure-size", "40mm", "--set-style", "voronoi:line-width=0.2pt"}), file);
  CHECK(std::ranges::min(numbers_after("stroke-width=\"")) == Approx(0.2));
  render_figure(with(dense, {"--figure-size", "slide", "--set-style", "voronoi:line-width=0.2pt"}), file);
  CHECK(std::ranges::min(numbers_after("stroke-width=\"")) == Approx(0.2));
}

TEST_CASE("a tight figure is cut to what is drawn") {
  const TemporaryFolder folder;
  const std::string file = (folder / "a.svg").string();
  render_figure({kDude, "--layers", "curve", "--size", "400x400", "--background", "none", "--bounds", "tight"}, file);
  const Image image = rasterised(file, 300);
  // The square was not filled.
  CHECK(image.height > 400);
  // Ink at each of the four sides.
  const auto is_inked = [&](auto at, int count) {
    for (int i = 0; i < count; ++i)
      if (image.rgba[at(i) + 3] > 60) return true;
    return false;
  };
  CHECK(is_inked([&](int x) { return image.offset(x, 0); }, image.width));
  // The last row may be there for a part of a pixel.
  CHECK(is_inked([&](int x) { return image.offset(x, image.height - 2); }, image.width));
  CHECK(is_inked([&](int y) { return image.offset(0, y); }, image.height));
  CHECK(is_inked([&](int y) { return image.offset(image.width - 1, y); }, image.height));
}

TEST_CASE("a figure needs no OpenGL") {
  const TemporaryFolder folder;
  RunOptions options;
  // A driver that does not exist.
  options.environment = {"DISPLAY=", "WAYLAND_DISPLAY=", "__EGL_VENDOR_LIBRARY_FILENAMES=/nonexistent.json"};
  const RunResult result = run({"render", kDude, "-o", (folder / "a.svg").string()}, options);
  INFO(result.err);
  CHECK(result.exit_code == 0);
}

TEST_CASE("a figure goes to standard output, and its format can be named") {
  const TemporaryFolder folder;
  for (const std::string format : {"svg", "pdf", "ipe", "tex", "png"}) {
    INFO(format);
    const std::string file = (folder / ("named." + format)).string();
    render_figure({kBean, "--size", "300x200"}, file);
    const RunResult piped = run({"render", kBean, "--size", "300x200", "--to", format, "-o", "-"});
    CHECK(piped.exit_code == 0);
    CHECK(piped.err.empty());
    CHECK(piped.out == contents_of(file));
    // The name that is given goes before that of the file.
    const std::string other = (folder / "named.figure").string();
    render_figure({kBean, "--size", "300x200", "--to", format}, other);
    CHECK(contents_of(other) == contents_of(file));
  }
  const RunResult refused = run({"render", kBean, "--to", "gif", "-o", "-"});
  CHECK(refused.exit_code == 2);
  CHECK(refused.out.empty());
  CHECK(refused.err == "mesecina: --to expects png, svg, pdf, ps, eps, ipe or tex, not \"gif\"\n");
}

TEST_CASE("sizes that cannot be are refused in one line, and nothing is written") {
  const TemporaryFolder folder;
  const std::string file = (folder / "a.svg").string();
  for (const char* size : {"", "84", "84x60", "84mmx60", "0mmx5mm", "-3mm", "9e9mm", "84furlongs", "mm", "nanmm",
                           "84mmx60mmx3mm", "6000mmx10mm", "two-column"}) {
    const RunResult result = run({"render", kDude, "--figure-size", size, "-o", file});
    INFO(size << ": " << result.err);
    CHECK(result.exit_code == 2);
    CHECK(std::ranges::count(result.err, '\n') == 1);
    CHECK_THAT(result.err, Catch::Contains("--figure-size"));
  }
  for (const std::vector<std::string>& wrong :
       std::vector<std::vector<std::string>>{{"--bounds", "loose", "-o", file},
                                             {"--figure-size", "84mm", "--size", "10x10", "-o", file},
                                             {"--figure-size", "84mm", "-o", (folder / "a.png").string()},
                                             {"--bounds", "tight", "-o", (folder / "a.png").string()},
                                             {"-o", (folder / "a.bmp").string()}}) {
    std::vector<std::string> arguments{"render", kDude};
    arguments.insert(arguments.end(), wrong.begin(), wrong.end());
    const RunResult result = run(arguments);
    INFO(result.err);
    CHECK(result.exit_code == 2);
    CHECK(std::ranges::count(result.err, '\n') == 1);
  }
  CHECK(folder.file_count() == 0);
  CHECK(run({"render", kDude, "-o", "/nonexistent/a.svg"}).exit_code == 4);
}

TEST_CASE("numbers of samples are text in every format, in the layer's group, colour and opacity") {
  const TemporaryFolder folder;
  const std::string square = folder.write("square.csv", "0,0\n1,0\n1,1\n0,1\n").string();
  const auto drawn = [&](const std::string& name, std::vector<std::string> arguments) {
    const std::string file = (folder / name).string();
    arguments.insert(arguments.begin(), square);
    render_figure(arguments, file);
    return contents_of(file);
  };
  const std::vector<std::string> numbered{"--layers", "indices,points", "--set-style",
                                          "indices:color=D55E00,opacity=0.5,point-size=18px"};
  const std::string svg = drawn("a.svg", numbered);
  const std::size_t group = svg.find("<g id=\"indices\"");
  REQUIRE(group != std::string::npos);
  CHECK(svg.find("<g id=\"points\"") < group);
  for (const char* number : {">0</text>", ">1</text>", ">2</text>", ">3</text>"})
    CHECK(svg.find(number, group) != std::string::npos);
  CHECK(svg.find(">4</text>") == std::string::npos);
  CHECK(svg.find("fill=\"#d55e00\" fill-opacity=\"0.5\"", group) != std::string::npos);
  // No dots in their place.
  CHECK(svg.find("<circle", group) == std::string::npos);
  const std::string tikz = drawn("a.tex", numbered);
  CHECK(tikz.find("% layer indices: Indices") != std::string::npos);
  CHECK(tikz.find("text opacity=0.5") != std::string::npos);
  CHECK(tikz.find("{3};") != std::string::npos);
  const std::string ipe = drawn("a.ipe", numbered);
  CHECK(ipe.find("<group layer=\"indices\"") != std::string::npos);
  CHECK(ipe.find("\\textsf{3}</text>") != std::string::npos);
  CHECK(ipe.find("<opacity name=\"opacity-0.5\"") != std::string::npos);
  drawn("a.pdf", numbered);
  const RunResult words = run({(folder / "a.pdf").string(), "-"}, {.program = "pdftotext"});
  REQUIRE(words.exit_code == 0);
  for (const char number : {'0', '1', '2', '3'}) CHECK(words.out.find(number) != std::string::npos);
  CHECK(drawn("a.eps", numbered).size() > drawn("b.eps", {"--layers", "points"}).size());
  drawn("a.png", numbered);
  drawn("b.png", {"--layers", "points"});
  CHECK(read_png(folder / "a.png") != read_png(folder / "b.png"));
}

TEST_CASE("few samples or none have their numbers or none") {
  const TemporaryFolder folder;
  for (const int count : {0, 1, 2}) {
    std::string samples = "POFF " + std::to_string(count) + " 0 0\n";
    for (int i = 0; i < count; ++i) samples += std::to_string(i) + " 1\n";
    const std::string file = folder.write("few.poff", samples).string();
    render_figure({file, "--layers", "indices"}, (folder / "few.png").string());
    render_figure({file, "--layers", "indices", "--bounds", "tight"}, (folder / "few.svg").string());
    CHECK((contents_of(folder / "few.svg").find(">0</text>") != std::string::npos) == (count > 0));
  }
}
