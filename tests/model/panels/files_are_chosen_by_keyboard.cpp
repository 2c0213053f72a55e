// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "app/ui/dialogs/file_list.h"
#include "tests/io/temporary_folder.h"

using namespace mes;
using namespace mes::test;

namespace {

struct Listing {
  TemporaryFolder folder;
  FileList list;
  Listing() {
    std::filesystem::create_directory(folder / "shapes");
    for (const char* name : {"gecko.poff", "Circle.poff", "ellipse.poff", "notes.odt", ".hidden"})
      std::ofstream(folder / name) << "12345";
    list.set_filter([](const std::string& name) { return name.ends_with(".poff"); });
    REQUIRE(list.enter(folder.path()));
  }
  std::string names() const {
    std::string out;
    for (const FileList::Entry& row : list.rows()) out += row.name + ' ';
    return out;
  }
  std::string marked() const { return list.marked_row() == nullptr ? "" : list.marked_row()->name; }
};

}  // namespace

TEST_CASE("folders come first, and only what is asked for is listed") {
  Listing listing;
  CHECK(listing.names() == "shapes Circle.poff ellipse.poff gecko.poff ");
  CHECK(listing.list.rows()[0].is_folder);
  CHECK(listing.list.rows()[1].size == 5);
  listing.list.set_filter({});
  CHECK(listing.names() == "shapes Circle.poff ellipse.poff gecko.poff notes.odt ");
}

TEST_CASE("arrows move the mark within the list, and begin at its ends") {
  Listing listing;
  FileList& list = listing.list;
  CHECK(listing.marked().empty());
  list.move(1);
  CHECK(listing.marked() == "shapes");
  list.move(2);
  CHECK(listing.marked() == "ellipse.poff");
  list.move(10);
  CHECK(listing.marked() == "gecko.poff");
  list.move(-10);
  CHECK(listing.marked() == "shapes");
  list.unmark();
  list.move(-1);
  CHECK(listing.marked() == "gecko.poff");
  FileList nothing;
  nothing.move(1);
  CHECK_FALSE(nothing.marked());
}

TEST_CASE("letters jump to what begins with them, whatever the case") {
  Listing listing;
  listing.list.mark_by_name("c");
  CHECK(listing.marked() == "Circle.poff");
  listing.list.mark_by_name("GE");
  CHECK(listing.marked() == "gecko.poff");
  listing.list.mark_by_name("gx");
  CHECK(listing.marked().empty());
  listing.list.mark_by_name("");
  CHECK(listing.marked().empty());
}

TEST_CASE("a folder that cannot be read is an error, and the list stays") {
  Listing listing;
  const std::string before = listing.names();
  const auto done = listing.list.enter(listing.folder / "no such folder");
  REQUIRE_FALSE(done);
  CHECK(done.error().file.ends_with("no such folder"));
  CHECK(listing.names() == before);
  CHECK(listing.list.folder() == std::filesystem::weakly_canonical(listing.folder.path()));
  REQUIRE(listing.list.enter(listing.folder / "shapes"));
  CHECK(listing.list.rows().empty());
}
