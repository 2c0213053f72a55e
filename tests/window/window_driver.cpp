// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/window/window_driver.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <sstream>
#include <utility>

#include "tests/window/x_connection.h"

namespace mes::test {
namespace {

bool has_program(const std::string& name) {
  return std::system(("command -v " + name + " >/dev/null 2>&1").c_str()) == 0;
}

void require_tools() {
  for (const char* tool : {"Xvfb", "xdotool", "convert"}) require_program(tool);
}

}  // namespace

void require_program(const std::string& name) {
  if (has_program(name)) return;
  if (const char* ci = std::getenv("CI"); ci != nullptr && ci[0] != '\0') FAIL(name << " is missing");
  std::fprintf(stderr, "skipped: %s is missing\n", name.c_str());
  std::exit(77);
}

Child::Child(const std::vector<std::string>& arguments, const Environment& extra,
             const std::filesystem::path& error_file) {
  std::vector<char*> pointers;
  for (const std::string& argument : arguments) pointers.push_back(const_cast<char*>(argument.c_str()));
  pointers.push_back(nullptr);
  pid_ = fork();
  REQUIRE(pid_ >= 0);
  if (pid_ != 0) return;
  setenv("MESECINA_CHECK_PATCHES", "1", 1);
  setenv("MESECINA_SHOWS_REST", "1", 1);
  setenv("MESECINA_PATIENCE", "60000", 1);
  for (const auto& [name, value] : extra) {
    if (value.empty())
      unsetenv(name.c_str());
    else
      setenv(name.c_str(), value.c_str(), 1);
  }
  if (!error_file.empty()) {
    const int file = open(error_file.c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0600);
    dup2(file, STDERR_FILENO);
  }
  execvp(pointers[0], pointers.data());
  _exit(127);
}

Child::Child(Child&& other) noexcept : pid_(std::exchange(other.pid_, -1)), status_(other.status_) {}
Child& Child::operator=(Child&& other) noexcept {
  std::swap(pid_, other.pid_);
  std::swap(status_, other.status_);
  return *this;
}

Child::~Child() {
  if (pid_ <= 0) return;
  kill(pid_, SIGTERM);
  waitpid(pid_, nullptr, 0);
}

bool Child::is_running() {
  if (pid_ <= 0) return false;
  if (waitpid(pid_, &status_, WNOHANG) == 0) return true;
  pid_ = -1;
  return false;
}

void Child::pause() const {
  ::kill(pid_, SIGSTOP);
}

void Child::go_on() const {
  ::kill(pid_, SIGCONT);
}

int Child::wait() {
  if (pid_ > 0) waitpid(pid_, &status_, 0);
  pid_ = -1;
  return WIFEXITED(status_) ? WEXITSTATUS(status_) : 128 + WTERMSIG(status_);
}

Color Screenshot::at(int x, int y) const {
  if (x < 0 || y < 0 || x >= width_ || y >= height_) return {};
  const auto base =
      3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x));
  return {rgb_[base], rgb_[base + 1], rgb_[base + 2]};
}

bool Screenshot::is_dark(int x, int y) const {
  const Color c = at(x, y);
  return !is_empty() && c.r < 60 && c.g < 60 && c.b < 60;
}

bool Screenshot::is_white(int x, int y) const {
  const Color c = at(x, y);
  return !is_empty() && c.r > 250 && c.g > 250 && c.b > 250;
}

int Screenshot::count(const std::function<bool(Color)>& condition) const {
  int out = 0;
  for (int y = 0; y < height_; ++y)
    for (int x = 0; x < width_; ++x)
      if (condition(at(x, y))) ++out;
  return out;
}

namespace {

// What holds all pixels within `where` that satisfy the condition on their place.
PixelBox box_where(const PixelBox& where, const auto& condition) {
  PixelBox out{where.right, where.bottom, where.left, where.top};
  for (int y = where.top; y < where.bottom; ++y)
    for (int x = where.left; x < where.right; ++x)
      if (condition(x, y))
        out = {std::min(out.left, x), std::min(out.top, y), std::max(out.right, x + 1), std::max(out.bottom, y + 1)};
  return out;
}

}  // namespace

PixelBox Screenshot::box_of(const PixelBox& where, const std::function<bool(Color)>& condition) const {
  return box_where(where, [&](int x, int y) { return condition(at(x, y)); });
}

PixelBox Screenshot::box_of_changes(const PixelBox& where, const Screenshot& other) const {
  return box_where(where, [&](int x, int y) {
    const Color a = at(x, y);
    const Color b = other.at(x, y);
    return a.r != b.r || a.g != b.g || a.b != b.b;
  });
}

int Screenshot::changes(const PixelBox& where, const Screenshot& other) const {
  int out = 0;
  for (int y = where.top; y < where.bottom; ++y) {
    for (int x = where.left; x < where.right; ++x) {
      const Color a = at(x, y);
      const Color b = other.at(x, y);
      out += a.r != b.r || a.g != b.g || a.b != b.b ? 1 : 0;
    }
  }
  return out;
}

int Screenshot::differences(const Screenshot& other, int tolerance) const {
  if (width_ != other.width_ || height_ != other.height_) return width_ * height_;
  int out = 0;
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      const Color a = at(x, y);
      const Color b = other.at(x, y);
      if (std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)}) > tolerance) ++out;
    }
  }
  return out;
}

std::string output_of(const std::string& command) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  std::string out;
  std::array<char, 65536> block{};
  while (const std::size_t got = std::fread(block.data(), 1, block.size(), pipe.get())) out.append(block.data(), got);
  return out;
}

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream out;
  out << stream.rdbuf();
  return out.str();
}

namespace {

// "P6 WIDTH HEIGHT 255 " and the pixels.
Screenshot parse_ppm(const std::string& bytes) {
  std::istringstream stream(bytes);
  std::string magic;
  int width = 0;
  int height = 0;
  int depth = 0;
  stream >> magic >> width >> height >> depth;
  stream.get();
  const auto size = 3 * static_cast<std::size_t>(std::max(0, width)) * static_cast<std::size_t>(std::max(0, height));
  if (magic != "P6" || depth != 255 || size == 0) return {0, 0, {}};
  std::vector<std::uint8_t> rgb(size);
  stream.read(reinterpret_cast<char*>(rgb.data()), static_cast<std::streamsize>(size));
  if (!stream) return {0, 0, {}};
  return {width, height, std::move(rgb)};
}

}  // namespace

Screenshot read_picture(const std::filesystem::path& file) {
  return parse_ppm(output_of("convert '" + file.string() + "' -depth 8 ppm:- 2>/dev/null"));
}

VirtualScreen::VirtualScreen() {
  require_tools();
  // The server chooses a free number itself and tells it, so that tests may run side by side.
  std::array<int, 2> ends{};
  REQUIRE(pipe(ends.data()) == 0);
  server_ = Child(
      {"Xvfb", "-displayfd", std::to_string(ends[1]), "-screen", "0", "1280x800x24", "-nolisten", "tcp", "-noreset"},
      {}, "/dev/null");
  close(ends[1]);
  std::string number;
  char c = 0;
  while (read(ends[0], &c, 1) == 1 && c != '\n') number += c;
  close(ends[0]);
  REQUIRE_FALSE(number.empty());
  display_ = ":" + number;
  connection_ = std::make_shared<const XConnection>(display_);
  REQUIRE(connection_->is_open());
}

Screenshot VirtualScreen::shoot() const {
  return connection_->shoot();
}

VirtualScreen::Window VirtualScreen::window() const {
  const std::vector<std::string> names = connection_->window_names();
  const auto named = std::ranges::find_if(names, [](const std::string& name) { return name.contains("Mesecina"); });
  if (named == names.end()) return {};
  // "house.poff - Mesecina (2)": the second answer.
  std::string words = *named;
  const std::size_t bracket = words.rfind(" (");
  if (!words.ends_with(')') || bracket == std::string::npos) return {std::move(words), 0};
  return {words.substr(0, bracket), std::atoi(words.c_str() + bracket + 2)};
}

Screenshot VirtualScreen::settled() const {
  const Window before = window();
  if (!before.title.empty()) {
    has_program_ = true;
    // The key comes after all events before it, so the answer does as well.
    xdotool("key Pause");
    REQUIRE(eventually([&] {
      const Window now = window();
      return now.title.empty() || now.rests > before.rests;
    }));
    return shoot();
  }
  INFO("the program's window is gone");
  REQUIRE_FALSE(has_program_);
  Screenshot last = shoot();
  REQUIRE(eventually([&] {
    Screenshot next = shoot();
    const bool is_still = next.differences(last, 0) == 0;
    last = std::move(next);
    return is_still;
  }));
  return last;
}

std::string VirtualScreen::xdotool(const std::string& arguments) const {
  return output_of("DISPLAY=" + display_ + " xdotool " + arguments + " 2>/dev/null");
}

void VirtualScreen::drag(std::array<int, 2> from, std::array<int, 2> to, int steps) const {
  const auto move = [this](int x, int y, const std::string& then) {
    xdotool(fmt::format("mousemove {} {}{}", x, y, then));
  };
  move(from[0], from[1], " mousedown 1");
  for (int i = 1; i <= steps; ++i)
    move(from[0] + (to[0] - from[0]) * i / steps, from[1] + (to[1] - from[1]) * i / steps, "");
}

void VirtualScreen::click(std::array<int, 2> at) const {
  xdotool(fmt::format("mousemove {} {} click 1", at[0], at[1]));
}

void VirtualScreen::drop(const std::filesystem::path& file) const {
  REQUIRE(connection_->drop("Mesecina", file.string()));
}

std::string VirtualScreen::clipboard() const {
  return connection_->clipboard();
}

void VirtualScreen::type_over(const std::string& text) const {
  // Fields of text look once a frame which keys are down, so these are held until they were seen.
  xdotool("keydown ctrl keydown a");
  static_cast<void>(settled());
  xdotool("keyup a keyup ctrl");
  xdotool("type --delay 20 -- '" + text + "'");  // text may begin with a minus sign
  static_cast<void>(settled());
}

void DrivenProgram::start(const std::string& name, const Environment& extra) {
  begin(name, extra);
  const bool is_open = eventually([&] { return title().starts_with(name); });
  INFO("title: " << title() << ", errors: " << bytes_of(folder / "errors"));
  REQUIRE(is_open);
  screen.xdotool("mousemove 1200 6");
}

void DrivenProgram::begin(const std::string& name, const Environment& extra) {
  program = Child();
  screen.expect_program();
  Environment environment{{"DISPLAY", screen.display()},
                          {"WAYLAND_DISPLAY", ""},
                          {"DBUS_SESSION_BUS_ADDRESS", "unix:path=/nonexistent"},
                          {"XDG_CONFIG_HOME", (folder / "config").string()},
                          {"XDG_DATA_HOME", (folder / "data").string()},
                          {"LIBGL_ALWAYS_SOFTWARE", "1"},
                          // Under a sanitizer: what the graphics driver forgets is not ours to find.
                          {"ASAN_OPTIONS", "detect_leaks=0"}};
  for (const auto& [variable, value] : extra) environment[variable] = value;
  std::vector<std::string> words{MESECINA_BINARY};
  words.insert(words.end(), options.begin(), options.end());
  words.push_back((folder / name).string());
  program = Child(words, environment, folder / "errors");
}

DrivenProgram::~DrivenProgram() {
  program = Child();
  std::fputs(bytes_of(folder / "errors").c_str(), stderr);
}

bool DrivenProgram::shows(const Screenshot& look) const {
  return eventually([&] { return screen.settled().box_of_changes(kCanvas, look).is_empty(); });
}

bool DrivenProgram::nearly_shows(const Screenshot& look) const {
  constexpr int kFew = 60;  // pixels
  return eventually([&] { return screen.settled().changes(kCanvas, look) < kFew; });
}

Screenshot DrivenProgram::drawn() const {
  constexpr PixelBox kLight{640, 775, 1160, 798};  // it stands before what the verdict says beside it
  const auto is_colored = [](Color c) { return std::max({c.r, c.g, c.b}) > std::min({c.r, c.g, c.b}) + 60; };
  REQUIRE(eventually([&] { return !screen.shoot().box_of(kLight, is_colored).is_empty(); }));
  return screen.settled();
}

Screenshot DrivenProgram::other_than(const Screenshot& look) const {
  REQUIRE(eventually([&] { return !screen.shoot().box_of_changes(kCanvas, look).is_empty(); }));
  return screen.settled();
}

void DrivenProgram::save_as(const std::string& name) const {
  const Screenshot before = screen.settled();
  press("ctrl+shift+s");
  REQUIRE(eventually([&] { return screen.settled().differences(before, 30) > 500; }));
  screen.type_over((folder / name).string());
  press("Return");
  REQUIRE(eventually([&] { return title().starts_with(name); }));
}

}  // namespace mes::test
