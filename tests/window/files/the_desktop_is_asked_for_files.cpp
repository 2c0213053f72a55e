// SPDX-License-Identifier: GPL-3.0-or-later
// The file dialog of the desktop, by a portal of the tests on a bus of their own, and the own dialog where it fails.
#include <signal.h>

#include <catch2/catch.hpp>
#include <cstdlib>

#include "tests/window/window_driver.h"

using namespace mes;
using namespace mes::test;

namespace {

/// A bus on which nothing is but what the test puts there.
class Bus {
 public:
  explicit Bus(const TemporaryFolder& folder) : address_("unix:path=" + (folder / "bus").string()) {
    require_program("dbus-daemon");
    const auto config = folder.write("bus.conf", "<busconfig><type>session</type><listen>" + address_ +
                                                     "</listen><auth>EXTERNAL</auth><policy context=\"default\">"
                                                     "<allow send_destination=\"*\" eavesdrop=\"true\"/>"
                                                     "<allow eavesdrop=\"true\"/><allow own=\"*\"/>"
                                                     "</policy></busconfig>");
    daemon_ = Child({"dbus-daemon", "--nofork", "--config-file=" + config.string()}, {}, folder / "bus-errors");
    const bool is_there = eventually([&] { return std::filesystem::exists(folder / "bus"); });
    INFO(bytes_of(folder / "bus-errors"));
    REQUIRE(is_there);
  }
  const std::string& address() const { return address_; }

 private:
  std::string address_;
  Child daemon_;
};

struct PortalWindow : DrivenProgram {
  Bus bus{folder};
  Child portal;

  PortalWindow() {
    folder.write("house.poff", "POFF 5 0 0\n0 0\n4 0\n4 3\n2 5\n0 3\n");
    folder.write("square.poff", "POFF 4 0 0\n0 0\n4 0\n4 4\n0 4\n");
  }
  /// In place of the one before.
  void set_portal(const std::string& words) {
    portal = Child();
    const std::string log = (folder / "portal.log").string();
    // What the one before wrote would be taken for this one's "ready".
    std::filesystem::remove(log);
    portal = Child({"sh", "-c", "exec " FAKE_PORTAL " " + words + " > " + log},
                   {{"DBUS_SESSION_BUS_ADDRESS", bus.address()}}, folder / "portal-errors");
    REQUIRE(eventually([&] { return asked().starts_with("ready"); }));
  }
  std::string asked() const { return bytes_of(folder / "portal.log"); }
  void open_house() { start("house.poff", {{"DBUS_SESSION_BUS_ADDRESS", bus.address()}}); }
  /// The own dialog is there: letters find a file, and Enter opens it.
  bool opens_by_own_dialog() const {
    const Screenshot empty = screen.settled();
    screen.xdotool("type --delay 20 sq");
    if (!eventually([&] { return screen.shoot().differences(empty, 0) > 0; })) return false;
    static_cast<void>(screen.settled());
    press("Return");
    return eventually([&] { return title().starts_with("square.poff"); });
  }
  /// Below a dialog the canvas is dimmed.
  bool is_dimmed() const {
    return eventually([&] { return !screen.shoot().is_white(90, 750); });
  }
};

}  // namespace

TEST_CASE("the dialog of the desktop opens and saves, and to cancel it changes nothing") {
  PortalWindow window;
  window.set_portal("choose " + (window.folder / "square.poff").string());
  window.open_house();
  window.press("ctrl+o");
  CHECK(eventually([&] { return window.title().starts_with("square.poff"); }));
  CHECK(window.asked().find("OpenFile|x11:") != std::string::npos);
  CHECK(window.asked().find('|' + window.folder.path().string() + '|') != std::string::npos);

  window.set_portal("cancel");
  window.press("ctrl+o");
  CHECK(eventually([&] { return window.asked().find("OpenFile") != std::string::npos; }));
  CHECK(eventually([&] { return window.screen.shoot().is_white(90, 750); }));
  const Screenshot first = window.screen.settled();
  window.press("2");
  static_cast<void>(window.other_than(first));

  window.set_portal("choose " + (window.folder / "copy.poff").string());
  window.press("ctrl+shift+s");
  CHECK(eventually([&] { return window.title().starts_with("copy.poff"); }));
  CHECK(window.asked().find("|square.poff\n") != std::string::npos);
  CHECK(bytes_of(window.folder / "copy.poff").starts_with("POFF 4"));
}

TEST_CASE("a name that the dialog of the desktop did not show is not overwritten without a question") {
  PortalWindow window;
  window.set_portal("choose " + (window.folder / "square").string());
  window.open_house();
  window.press("ctrl+shift+s");
  // It becomes square.poff, which is there already.
  CHECK(window.is_dimmed());
  static_cast<void>(window.screen.settled());
  CHECK(bytes_of(window.folder / "square.poff").starts_with("POFF 4"));
  CHECK(window.title().starts_with("house.poff"));
  window.press("Left");
  window.press("Return");
  CHECK(eventually([&] { return window.title().starts_with("square.poff"); }));
  CHECK(bytes_of(window.folder / "square.poff").starts_with("POFF 5"));
}

TEST_CASE("where the dialog of the desktop fails, refuses or does not answer, there is the own one") {
  const std::string words = GENERATE("fail", "refuse", "deaf", "none");
  CAPTURE(words);
  PortalWindow window;
  if (words != "none") window.set_portal(words);
  window.open_house();
  window.press("ctrl+o");
  REQUIRE(window.is_dimmed());
  // The own dialog has a field and a list, and covers the middle of the canvas from here on.
  REQUIRE(eventually([&] { return window.screen.shoot().is_white(400, 250); }));
  CHECK(window.opens_by_own_dialog());
}

TEST_CASE("an unanswered dialog of the desktop is left by Esc, or for the own one, and the portal may end") {
  PortalWindow window;
  window.set_portal("silent");
  window.open_house();
  const Screenshot first = window.screen.settled();
  window.press("ctrl+o");
  REQUIRE(eventually([&] { return window.asked().find("OpenFile") != std::string::npos; }));
  REQUIRE(window.is_dimmed());
  window.press("Escape");
  CHECK(eventually([&] { return window.asked().find("Close") != std::string::npos; }));
  CHECK(window.shows(first));
  window.press("ctrl+o");
  REQUIRE(window.is_dimmed());
  static_cast<void>(window.screen.settled());
  kill(window.portal.pid(), SIGKILL);
  REQUIRE(eventually([&] { return window.screen.shoot().is_white(400, 250); }));
  CHECK(window.opens_by_own_dialog());
}

TEST_CASE("the window ends in order while the desktop is asked") {
  PortalWindow window;
  window.set_portal("silent");
  window.open_house();
  window.press("ctrl+o");
  REQUIRE(eventually([&] { return window.asked().find("OpenFile") != std::string::npos; }));
  kill(window.program.pid(), SIGTERM);
  CHECK(window.program.wait() == 128 + SIGTERM);
  CHECK(eventually([&] { return window.asked().find("Close") != std::string::npos; }));
}
