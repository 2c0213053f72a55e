// SPDX-License-Identifier: GPL-3.0-or-later
#include <sys/stat.h>

#include <array>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "app/settings/settings.h"
#include "app/store/sample_shapes.h"

using namespace mes;
namespace fs = std::filesystem;

namespace {

struct Folder {
  fs::path path;
  Folder() {
    std::string pattern = (fs::temp_directory_path() / "mesecina-settings-XXXXXX").string();
    REQUIRE(mkdtemp(pattern.data()) != nullptr);
    path = pattern;
  }
  ~Folder() { fs::remove_all(path); }
};

void write(const fs::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

}  // namespace

TEST_CASE("what is saved is loaded") {
  const Folder folder;
  const fs::path path = folder.path / "new" / "settings.json";
  Settings settings;
  settings.spray_spacing_px = 17.5;
  settings.brush.radius_px = 33.5;
  settings.window_width = 1000;
  settings.panels = PanelChoice(std::array{PanelPage::log, PanelPage::lesson}, PanelPage::lesson);
  settings.column_width = 412.5;
  settings.favorite_layers = {"voronoi", "of-an-experiment"};
  settings.unfolded_layers = {};
  settings.lower_panel_share = 0.25;
  settings.diagram = {PaperPlace{PaperCorner::top_left, {3.0, 4.0}}, 500.0, 320.5};
  settings.legend_at = PaperPlace{PaperCorner::top_left, {12.5, 3.0}};
  settings.marks.bar_at = PaperPlace{PaperCorner::top_right};
  settings.theme = Theme::dark;
  settings.for_projector = true;
  settings.keep_degrees = true;
  settings.canvas_background = Rgb{1, 2, 3};
  settings.record = {.width = 1920,
                     .height = 1080,
                     .supersampling = 2,
                     .transparent = true,
                     .background = Rgb{255, 0, 9},
                     .fps = 24.0,
                     .real_time = true,
                     .all_panes = false};
  remember_file(settings, "/tmp/a.poff");
  remember_file(settings, "/tmp/b.poff");
  remember_file(settings, "/tmp/a.poff");
  REQUIRE(save_settings(settings, path));
  const LoadedSettings loaded = load_settings(path);
  CHECK(loaded.message.empty());
  CHECK(loaded.settings.recent_files == std::vector<std::string>{"/tmp/a.poff", "/tmp/b.poff"});
  CHECK(loaded.settings.spray_spacing_px == 17.5);
  CHECK(loaded.settings.brush.radius_px == 33.5);
  CHECK(loaded.settings.window_width == 1000);
  CHECK(loaded.settings.panels == settings.panels);
  CHECK(loaded.settings.column_width == 412.5);
  CHECK(loaded.settings.favorite_layers == settings.favorite_layers);
  CHECK(loaded.settings.unfolded_layers.empty());
  CHECK(loaded.settings.lower_panel_share == 0.25);
  CHECK(loaded.settings.diagram == settings.diagram);
  CHECK(loaded.settings.theme == Theme::dark);
  CHECK(loaded.settings.for_projector);
  CHECK(loaded.settings.keep_degrees);
  CHECK(loaded.settings.canvas_background == Rgb{1, 2, 3});
  CHECK(loaded.settings.record == settings.record);
  CHECK(loaded.settings.legend_at == settings.legend_at);
  CHECK(loaded.settings.marks == settings.marks);
}

TEST_CASE("a place that is not one is none") {
  const Folder folder;
  const fs::path path = folder.path / "settings.json";
  for (const char* place : {"3", "null", R"("left")", R"("top-left:-1,0")", R"({"corner": 1})"}) {
    write(path, std::string(R"({"schema": 1, "legend_at": )") + place + R"(, "scale_bar_at": )" + place + "}");
    CAPTURE(place);
    const LoadedSettings loaded = load_settings(path);
    CHECK(loaded.message.empty());
    CHECK_FALSE(loaded.settings.legend_at);
    CHECK_FALSE(loaded.settings.marks.bar_at);
  }
}

TEST_CASE("frames that cannot be are as large as the window") {
  const Folder folder;
  const fs::path path = folder.path / "settings.json";
  for (const char* record : {"3", R"({"width": 1920})", R"({"width": 99999, "height": 99999})",
                             R"({"supersampling": 3})", R"({"width": -5, "height": 4, "fps": "fast"})"}) {
    write(path, std::string(R"({"schema": 1, "record": )") + record + "}");
    CAPTURE(record);
    const LoadedSettings loaded = load_settings(path);
    CHECK(loaded.message.empty());
    CHECK(loaded.settings.record == RecordSettings{});
  }
}

TEST_CASE("the list of recent files does not grow for ever") {
  Settings settings;
  for (int i = 0; i < 50; ++i) remember_file(settings, "/tmp/" + std::to_string(i) + ".poff");
  CHECK(settings.recent_files.size() == kRecentFiles);
  CHECK(settings.recent_files.front() == "/tmp/49.poff");
}

TEST_CASE("a pipe is not waited for") {
  const Folder folder;
  const fs::path path = folder.path / "settings.json";
  REQUIRE(mkfifo(path.c_str(), 0600) == 0);
  CHECK_THAT(load_settings(path).message, Catch::Contains("is not a file"));
  const auto saved = save_settings({}, path);
  REQUIRE_FALSE(saved);
  CHECK(saved.error().message() == path.string() + ": this is not a file");
}

TEST_CASE("a missing file gives the defaults without a word") {
  const Folder folder;
  const LoadedSettings loaded = load_settings(folder.path / "none.json");
  CHECK(loaded.message.empty());
  CHECK(loaded.settings.window_width == Settings{}.window_width);
}

TEST_CASE("a broken file is set aside with a message") {
  for (const char* bytes : {"", "{", "[1,2]", "{\"schema\": 99}", "\x00\xff\xfe", "{\"schema\": \"one\"}"}) {
    const Folder folder;
    const fs::path path = folder.path / "settings.json";
    write(path, bytes);
    const LoadedSettings loaded = load_settings(path);
    CAPTURE(bytes);
    CHECK_FALSE(loaded.message.empty());
    CHECK_FALSE(fs::exists(path));
    CHECK(fs::exists(folder.path / "settings.json.broken"));
    CHECK(save_settings(loaded.settings, path));
  }
}

TEST_CASE("values of a wrong kind or out of range do no harm") {
  const Folder folder;
  const fs::path path = folder.path / "settings.json";
  write(path,
        R"({"schema": 1, "window_width": -5, "window_height": 1e300, "spray_spacing_px": "wide",
            "recent_files": [1, null, "/x.poff"], "show_legend": 3, "panels": [7, "log", "rail"],
            "pinned_panel": {}, "future": {"a": []}})");
  const LoadedSettings loaded = load_settings(path);
  CHECK(loaded.message.empty());
  CHECK(loaded.settings.window_width == 320);
  CHECK(loaded.settings.window_height == 16384);
  CHECK(loaded.settings.spray_spacing_px == Settings{}.spray_spacing_px);
  CHECK(loaded.settings.recent_files == std::vector<std::string>{"/x.poff"});
  CHECK(loaded.settings.show_legend);
  CHECK(loaded.settings.panels == PanelChoice(std::array{PanelPage::log}, std::nullopt));
}

TEST_CASE("a theme or canvas that cannot be is the usual one") {
  const Folder folder;
  const fs::path path = folder.path / "settings.json";
  for (const char* look : {R"("theme": "pink", "canvas_background": "white")", R"("theme": 1)",
                           R"("canvas_background": -1, "for_projector": "yes", "keep_degrees": 1)",
                           R"("canvas_background": 16777216)", R"("canvas_background": 1.5)"}) {
    write(path, std::string(R"({"schema": 1, )") + look + "}");
    CAPTURE(look);
    const LoadedSettings loaded = load_settings(path);
    CHECK(loaded.message.empty());
    CHECK(loaded.settings.theme == Theme::light);
    CHECK_FALSE(loaded.settings.for_projector);
    CHECK_FALSE(loaded.settings.keep_degrees);
    CHECK_FALSE(loaded.settings.canvas_background);
  }
}

TEST_CASE("an unwritable place is an error, not a crash") {
  CHECK_FALSE(save_settings({}, "/proc/nowhere/settings.json"));
}

TEST_CASE("shapes that are listed but missing are left out") {
  const Folder folder;
  fs::create_directory(folder.path / "shapes");
  CHECK(read_sample_shapes(folder.path).empty());
  write(folder.path / "shapes" / "a.poff", "POFF 0 0 0\n");
  write(
      folder.path / "shapes" / "index.json",
      R"([{"file": "a.poff", "name": "A", "description": "d"}, {"file": "b.poff", "name": "B"}, 7, {"name": "C"}])");
  const auto shapes = read_sample_shapes(folder.path);
  REQUIRE(shapes.size() == 1);
  CHECK(shapes[0].name == "A");
  write(folder.path / "shapes" / "index.json", "{broken");
  CHECK(read_sample_shapes(folder.path).empty());
}

TEST_CASE("closed panels stay closed") {
  const Folder folder;
  const fs::path path = folder.path / "settings.json";
  Settings settings;
  settings.panels.close(PanelPage::layers);
  settings.panels.close(PanelPage::bundles);
  REQUIRE(save_settings(settings, path));
  CHECK(load_settings(path).settings.panels.all().empty());
  CHECK(load_settings(path).settings.panels.pinned() == PanelPage::layers);
}

TEST_CASE("two windows keep each other's settings") {
  Settings at_start;
  at_start.recent_files = {"/old.poff"};
  Settings there = at_start;
  there.interface_scale = 1.5;
  there.panels.open(PanelPage::log);
  there.recent_files = {"/theirs.poff", "/old.poff"};
  Settings ours = at_start;
  ours.show_legend = false;
  ours.panels.open(PanelPage::statistics);
  ours.recent_files = {"/ours.poff", "/old.poff"};
  const Settings both = merged(ours, at_start, there);
  CHECK(both.interface_scale == 1.5);
  CHECK_FALSE(both.show_legend);
  CHECK(both.panels == ours.panels);
  CHECK(both.recent_files == std::vector<std::string>{"/ours.poff", "/old.poff", "/theirs.poff"});
  // What was forgotten here stays forgotten.
  ours.recent_files.clear();
  CHECK(merged(ours, at_start, there).recent_files == std::vector<std::string>{"/theirs.poff"});
}
