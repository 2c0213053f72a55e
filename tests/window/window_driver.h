// SPDX-License-Identifier: GPL-3.0-or-later
// The real window on a virtual display, driven by real mouse and key events.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <sys/types.h>

#include "tests/io/temporary_folder.h"
#include "tests/support/eventually.h"

namespace mes::test {

using Environment = std::map<std::string, std::string>;

/// Five samples, as a file.
inline constexpr const char* kHouse = "POFF 5 0 0\n0 0\n4 0\n4 3\n2 5\n0 3\n";

/// A program of its own process; killed with this object.
class Child {
 public:
  Child() = default;
  /// Runs `arguments[0]`; a window of it checks each patch it draws and ends at a broken one, and has a minute to end in
  /// order after a signal. Standard error goes to
  /// `error_file` if that is given. Values in `extra` are set, empty ones unset.
  Child(const std::vector<std::string>& arguments, const Environment& extra,
        const std::filesystem::path& error_file = {});
  ~Child();
  Child(Child&& other) noexcept;
  Child& operator=(Child&& other) noexcept;

  pid_t pid() const { return pid_; }
  bool is_running();
  /// Exit code, or 128 + signal; waits.
  int wait();
  /// Hears of no event until `go_on`; then of all at once, as on a busy machine.
  void pause() const;
  void go_on() const;

 private:
  pid_t pid_ = -1;
  int status_ = 0;
};

struct Color {
  int r = 0;
  int g = 0;
  int b = 0;
};

/// Pixels from (left, top) to before (right, bottom).
struct PixelBox {
  int left = 0;
  int top = 0;
  int right = 0;
  int bottom = 0;
  bool is_empty() const { return right <= left; }
  std::array<int, 2> middle() const { return {(left + right) / 2, (top + bottom) / 2}; }
};

class Screenshot {
 public:
  Screenshot(int width, int height, std::vector<std::uint8_t> rgb)
      : width_(width), height_(height), rgb_(std::move(rgb)) {}
  bool is_empty() const { return rgb_.empty(); }
  Color at(int x, int y) const;
  bool is_dark(int x, int y) const;
  bool is_white(int x, int y) const;
  /// Pixels that satisfy the condition.
  int count(const std::function<bool(Color)>& condition) const;
  /// What holds all pixels within `where` that satisfy the condition.
  PixelBox box_of(const PixelBox& where, const std::function<bool(Color)>& condition) const;
  /// What holds all pixels within `where` that differ from the other picture.
  PixelBox box_of_changes(const PixelBox& where, const Screenshot& other) const;
  /// Pixels within `where` that differ from the other picture.
  int changes(const PixelBox& where, const Screenshot& other) const;
  /// Pixels of which some channel differs by more than `tolerance`; all of them when the sizes differ.
  int differences(const Screenshot& other, int tolerance) const;
  int width() const { return width_; }
  int height() const { return height_; }

 private:
  int width_;
  int height_;
  std::vector<std::uint8_t> rgb_;
};

/// Reads any picture ImageMagick can; empty when there is none.
Screenshot read_picture(const std::filesystem::path& file);

/// Where the program is missing the test is skipped (exit code 77), on a build machine (CI set) it fails.
void require_program(const std::string& name);

class XConnection;

/// A virtual screen of 1280 x 800 pixels, if the tools for it are there (`require_program`).
class VirtualScreen {
 public:
  VirtualScreen();
  const std::string& display() const { return display_; }
  Screenshot shoot() const;
  /// The screen once the program has acted on all that was done before, and has nothing left to draw; before a program is
  /// on the screen, once two pictures in a row are equal. A test fails here if its program has ended.
  Screenshot settled() const;
  /// Forgets the program that has ended, because another one begins.
  void expect_program() { has_program_ = false; }
  /// What the title of the program's window says; empty without one.
  std::string title() const { return window().title; }
  /// One call of xdotool; its standard output.
  std::string xdotool(const std::string& arguments) const;
  /// The rest of the arguments one by one, so that a program draws between them.
  void drag(std::array<int, 2> from, std::array<int, 2> to, int steps) const;
  void click(std::array<int, 2> at) const;
  /// Drops a file onto the program's window.
  void drop(const std::filesystem::path& file) const;
  /// The text on the clipboard.
  std::string clipboard() const;
  /// Types into the field that has the keyboard, in place of what is there.
  void type_over(const std::string& text) const;

 private:
  struct Window {
    std::string title;
    int rests = 0;  // how often the program has answered that it is at rest
  };
  Window window() const;

  std::string display_;
  Child server_;
  std::shared_ptr<const XConnection> connection_;
  mutable bool has_program_ = false;  // `settled` has met one
};

/// What of a window of the screen's size lies between toolbar and panels, without the status bar.
inline constexpr PixelBox kCanvas{80, 40, 930, 760};

/// The program with its window on a screen, in a folder of its own for its files, settings and data.
struct DrivenProgram {
  TemporaryFolder folder;
  VirtualScreen screen;
  Child program;
  std::vector<std::string> options;  // of the program, before the file

  DrivenProgram() = default;
  DrivenProgram(const DrivenProgram&) = delete;
  DrivenProgram& operator=(const DrivenProgram&) = delete;
  /// Ends the program and prints its errors.
  ~DrivenProgram();
  /// Opens this file of the folder, and moves the pointer where nothing lies. What ran before is ended.
  void start(const std::string& name, const Environment& extra = {});
  /// Waits for nothing: a picture that is to be traced does not give the window its name.
  void begin(const std::string& name, const Environment& extra = {});
  void press(const std::string& keys) const { screen.xdotool("key " + keys); }
  std::string title() const { return screen.title(); }
  /// The screen once the light has its verdict on a document with samples, and nothing moves any more.
  Screenshot drawn() const;
  /// True once the canvas looks as in this picture.
  bool shows(const Screenshot& look) const;
  /// The same but for a few pixels: where things overlap, the one that was drawn last is on top, and that depends on what
  /// was edited before.
  bool nearly_shows(const Screenshot& look) const;
  /// The screen when its canvas looks otherwise and has come to rest.
  Screenshot other_than(const Screenshot& look) const;
  /// Saves by the dialog; the title names the file afterwards.
  void save_as(const std::string& name) const;
};

/// Standard output of a shell command.
std::string output_of(const std::string& command);
std::string bytes_of(const std::filesystem::path& file);

}  // namespace mes::test
