// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <catch2/catch.hpp>

#include "app/store/looks/window_bundles.h"
#include "core/io/bundle_file.h"
#include "tests/io/temporary_folder.h"
#include "tests/support/builtin_layers.h"

using namespace mes;
using mes::test::contents_of;
using mes::test::TemporaryFolder;

namespace {

LayerConfiguration look(const std::string& layer) {
  return {{{layer, true, {}}}, {}};
}
std::string names_of_bundles(std::span<const Bundle> bundles) {
  std::string out;
  for (const Bundle& bundle : bundles) out += bundle.name + (bundle.layers.layers.empty() ? "" : "!") + ' ';
  return out;
}

}  // namespace

TEST_CASE("every change of the list of bundles can be undone") {
  BundleList list({{"a"}, {"b"}, {"c"}, {"a"}, {""}});
  CHECK(names_of_bundles(list.bundles()) == "a b c ");
  CHECK(list.undo_name().empty());
  list.undo();
  REQUIRE(list.save(" d ", look("points")));
  CHECK(list.undo_name() == "Saved \"d\"");
  REQUIRE(list.save("a", look("points")));
  CHECK(list.undo_name() == "Overwrote \"a\"");
  REQUIRE(list.rename(1, "B"));
  list.move(0, 2);
  CHECK(names_of_bundles(list.bundles()) == "B c a! d! ");
  list.move(3, 0);
  CHECK(names_of_bundles(list.bundles()) == "d! B c a! ");
  list.remove(1);
  CHECK(list.undo_name() == "Deleted \"B\"");
  CHECK(names_of_bundles(list.bundles()) == "d! c a! ");
  for (int i = 0; i < 6; ++i) list.undo();
  CHECK(names_of_bundles(list.bundles()) == "a b c ");
  CHECK(list.undo_name().empty());
}

TEST_CASE("an overwritten bundle is not described as what it was") {
  BundleList list({{"a", look("curve"), "the curve"}});
  REQUIRE(list.rename(0, "b"));
  CHECK(list.bundles()[0].description == "the curve");
  REQUIRE(list.save("b", look("points")));
  CHECK(list.bundles()[0].description.empty());
  list.undo();
  CHECK(list.bundles()[0].description == "the curve");
}

TEST_CASE("names of bundles are any text but nothing, and one bundle's only") {
  BundleList list({{"a"}, {"b"}});
  CHECK(list.save(" \n", {}).error().text == "a bundle needs a name");
  CHECK(list.save(std::string(201, 'x'), {}).error().text == "this name is too long");
  CHECK(list.rename(0, "b").error().text == "there is a bundle \"b\" already");
  CHECK(list.rename(0, "").error().text == "a bundle needs a name");
  CHECK(list.rename(0, "a"));
  CHECK(list.undo_name().empty());
  CHECK(list.save("../\xe2\x88\x82 \"\\\x01", {}));
}

TEST_CASE("imported bundles take no name that is in use, and come once") {
  BundleList list({{"a"}});
  const std::vector<Bundle> more{{"a", look("points")}, {"a", look("curve")}, {"b"}, {"a"}};
  CHECK(list.import(more) == std::vector<std::string>{"a (2)", "a (3)", "b", "a"});
  CHECK(names_of_bundles(list.bundles()) == "a a (2)! a (3)! b ");
  const std::uint64_t revision = list.revision();
  CHECK(list.import(more).size() == 4);
  CHECK(list.revision() == revision);
  list.undo();
  CHECK(names_of_bundles(list.bundles()) == "a ");
}

TEST_CASE("what two windows made of the bundles is put together") {
  const std::vector<Bundle> base{{"kept"}, {"mine"}, {"theirs"}, {"mine gone"}, {"theirs gone"}, {"both"}};
  const std::vector<Bundle> mine{{"theirs gone"},     {"kept"}, {"mine", look("x")}, {"theirs"},
                                 {"both", look("x")}, {"new"}};
  const std::vector<Bundle> theirs{{"kept"}, {"mine"}, {"theirs", look("y")}, {"mine gone"}, {"both", look("y")},
                                   {"newer"}};
  const std::vector<Bundle> merged = merge_bundles(base, mine, theirs);
  CHECK(names_of_bundles(merged) == "kept mine! theirs! both! new both (2)! newer ");
  CHECK(merged[3].layers == look("x"));
  CHECK(merged[5].layers == look("y"));
  // Changed alike, or changed by one and removed by the other.
  CHECK(names_of_bundles(merge_bundles({{{"a"}}}, {{{"a", look("x")}}}, {{{"a", look("x")}}})) == "a! ");
  CHECK(names_of_bundles(merge_bundles({{{"a"}}}, {}, {{{"a", look("y")}}})) == "a! ");
  CHECK(names_of_bundles(merge_bundles({{{"a"}}}, {{{"a", look("x")}}}, {})) == "a! ");
  CHECK(merge_bundles(base, base, theirs) != base);
  CHECK(merge_bundles(base, mine, base) == mine);
}

TEST_CASE("bundles outlive the window, and two windows lose nothing") {
  const TemporaryFolder folder;
  const auto file = folder / "data/bundles.json";
  BundleStore one(layer_descriptors(), file);
  BundleStore two(layer_descriptors(), file);
  const std::vector<Bundle> starting{{"start", look("points")}};
  BundleList first(one.load(starting).bundles);
  BundleList second(two.load(starting).bundles);
  CHECK(names_of_bundles(first.bundles()) == "start! ");
  CHECK_FALSE(std::filesystem::exists(file));
  REQUIRE(first.save("first", {}));
  REQUIRE(one.write(first.bundles()));
  REQUIRE(second.save("second", {}));
  const auto both = two.write(second.bundles());
  REQUIRE(both);
  CHECK(names_of_bundles(both->bundles) == "start! second first ");
  CHECK(both->message.empty());
  CHECK(names_of_bundles(BundleStore(layer_descriptors(), file).load({}).bundles) == "start! second first ");
  second.replace({});
  REQUIRE(two.write(second.bundles()));
  CHECK(BundleStore(layer_descriptors(), file).load(starting).bundles.empty());
}

TEST_CASE("undo takes back what was done here and nothing that another window did") {
  const TemporaryFolder folder;
  const auto file = folder / "bundles.json";
  const std::vector<LayerDescriptor> descriptors{{.id = "points", .visible_at_start = true}};
  LayerStack layers(descriptors);
  WindowBundles one(file, {}, layers);
  REQUIRE(one.save("a"));
  REQUIRE(one.save("b"));
  WindowBundles other(file, {}, layers);
  REQUIRE(other.save("other's"));
  REQUIRE(one.remove(0));
  CHECK(names_of_bundles(one.bundles()) == "b! other's! ");
  CHECK(one.undo_offer() == "Deleted \"a\"");
  REQUIRE(one.undo());
  CHECK(names_of_bundles(one.bundles()) == "a! b! other's! ");
  REQUIRE(one.undo());
  CHECK(names_of_bundles(one.bundles()) == "a! other's! ");
  CHECK(names_of_bundles(BundleStore(layer_descriptors(), file).load({}).bundles) == "a! other's! ");
}

TEST_CASE("a program that has the lock and goes no further stops no other") {
  const TemporaryFolder folder;
  const auto file = folder / "bundles.json";
  BundleStore store(layer_descriptors(), file, std::chrono::milliseconds(0));
  static_cast<void>(store.load({}));
  const int held = ::open((file.string() + ".lock").c_str(), O_RDWR | O_CREAT, 0600);
  REQUIRE(::flock(held, LOCK_EX) == 0);
  CHECK(store.write(std::vector<Bundle>{{"a"}}));
  ::close(held);
  CHECK(names_of_bundles(BundleStore(layer_descriptors(), file).load({}).bundles) == "a ");
}

TEST_CASE("a file of bundles that cannot be used is set aside") {
  const TemporaryFolder folder;
  const auto file = folder / "bundles.json";
  const std::string future = "{\"mesecina\":\"bundles\",\"schema\":9}";
  for (const std::string& bytes : {std::string("{ broken"), future, std::string("still broken")}) {
    folder.write("bundles.json", bytes);
    BundleStore store(layer_descriptors(), file);
    const auto loaded = store.load({{"start"}});
    CHECK(names_of_bundles(loaded.bundles) == "start ");
    CHECK(loaded.message.find("they were set aside as") != std::string::npos);
    CHECK_FALSE(std::filesystem::exists(file));
  }
  CHECK(contents_of(folder / "bundles.json.later") == future);
  CHECK(contents_of(folder / "bundles.json.broken") == "{ broken");
  CHECK(contents_of(folder / "bundles.json.broken-2") == "still broken");
  BundleStore store(layer_descriptors(), file);
  static_cast<void>(store.load({}));
  folder.write("bundles.json", future);
  const auto written = store.write(std::vector<Bundle>{{"a"}});
  REQUIRE(written);
  CHECK(contents_of(folder / "bundles.json.later-2") == future);
  CHECK(names_of_bundles(BundleStore(layer_descriptors(), file).load({}).bundles) == "a ");
}

TEST_CASE("a pipe in the place of the bundles is set aside") {
  const TemporaryFolder folder;
  const auto file = folder / "bundles.json";
  REQUIRE(mkfifo(file.c_str(), 0600) == 0);
  const auto loaded = BundleStore(layer_descriptors(), file).load({{"start"}});
  CHECK(names_of_bundles(loaded.bundles) == "start ");
  CHECK(loaded.message.find("this is not a file") != std::string::npos);
  CHECK(std::filesystem::is_fifo(folder / "bundles.json.broken"));
}

TEST_CASE("without a home bundles live as long as the window") {
  BundleStore store(layer_descriptors(), {});
  CHECK(names_of_bundles(store.load({{"start"}}).bundles) == "start ");
  CHECK(store.write(std::vector<Bundle>{{"a"}}));
}

TEST_CASE("the current bundle knows whether the layers are still its own") {
  const std::vector<LayerDescriptor> descriptors{{.id = "points", .visible_at_start = true}, {.id = "curve"}};
  LayerStack layers(descriptors);
  CurrentBundle current;
  CHECK(current.name().empty());
  current.choose({"a", look("curve")}, layers);
  CHECK(layers.is_visible(1));
  CHECK_FALSE(layers.is_visible(0));
  CHECK(current.name() == "a");
  CHECK_FALSE(current.is_changed(layers));
  layers.set_visible(0, true);
  CHECK(current.is_changed(layers));
  layers.set_visible(0, false);
  CHECK_FALSE(current.is_changed(layers));
  layers.move(0, 1, true);
  CHECK(current.is_changed(layers));
  current.note_saved("b", layers);
  CHECK_FALSE(current.is_changed(layers));
}

TEST_CASE("undo of a bundle leads back to the one before, changed as it was") {
  const std::vector<LayerDescriptor> descriptors{{.id = "points", .visible_at_start = true}, {.id = "curve"}};
  LayerStack layers(descriptors);
  CurrentBundle current;
  const LayerConfiguration start = layers.configuration();
  current.choose({"a", look("curve")}, layers);
  const LayerConfiguration a = layers.configuration();
  layers.set_visible(0, true);
  const LayerConfiguration changed = layers.configuration();
  current.choose({"b", look("points")}, layers);
  const LayerConfiguration b = layers.configuration();
  const auto shows = [&](const LayerConfiguration& configuration) {
    layers.set_configuration(configuration);
    current.follow(layers);
    return current.name() + (current.is_changed(layers) ? "*" : "");
  };
  CHECK(shows(changed) == "a*");
  CHECK(shows(a) == "a");
  CHECK(current.name() == "a");
  current.note_renamed("A");
  CHECK(shows(b) == "b");
  CHECK(shows(a) == "A");
  CHECK(shows(start) == "*");
  CHECK(shows(b) == "b");
}

TEST_CASE("the starting bundles name layers that exist") {
  const auto [bundles, message] = read_starting_bundles(layer_descriptors(), "assets");
  CHECK(message.empty());
  CHECK(bundles.size() >= 9);
  for (const Bundle& bundle : bundles) {
    INFO(bundle.name);
    CHECK_FALSE(bundle.layers.layers.empty());
    CHECK_FALSE(bundle.description.empty());
    for (const LayerConfiguration::Entry& entry : bundle.layers.layers) {
      INFO(entry.layer);
      CHECK(find_layer(entry.layer) != kNoLayer);
    }
  }
}

TEST_CASE("starting bundles that are broken or missing are reported, and the others are there") {
  const TemporaryFolder assets;
  CHECK_THAT(read_starting_bundles(layer_descriptors(), assets.path()).message, Catch::Contains("missing"));
  std::filesystem::create_directories(assets / "bundles");
  assets.write("bundles/a.json", "{");
  std::filesystem::copy_file("assets/bundles/starting.json", assets / "bundles/b.json");
  const auto [starting, message] = read_starting_bundles(layer_descriptors(), assets.path());
  CHECK(starting.size() >= 9);
  CHECK_THAT(message, Catch::Contains("a.json"));
  LayerStack layers(layer_descriptors());
  WindowBundles bundles(assets / "own.json", assets.path(), layers);
  CHECK(bundles.take_message() == message);
}

TEST_CASE("what the window does to bundles is on disk at once and can be undone") {
  const TemporaryFolder folder;
  const auto file = folder / "bundles.json";
  const auto on_disk = [&] { return names_of_bundles(BundleStore(layer_descriptors(), file).load({}).bundles); };
  const std::vector<LayerDescriptor> descriptors{{.id = "points", .visible_at_start = true}, {.id = "curve"}};
  LayerStack layers(descriptors);
  WindowBundles bundles(file, {}, layers);
  CHECK_FALSE(bundles.current());
  CHECK_FALSE(bundles.save(" "));
  REQUIRE(bundles.save("a"));
  CHECK(bundles.current() == 0U);
  layers.set_visible(1, true);
  CHECK(bundles.is_changed());
  REQUIRE(bundles.save("b"));
  CHECK(on_disk() == "a! b! ");
  bundles.choose(0);
  CHECK_FALSE(layers.is_visible(1));
  CHECK(bundles.undo_offer().empty());
  REQUIRE(bundles.rename(0, "c"));
  CHECK(bundles.current() == 0U);
  REQUIRE(bundles.move(0, 1));
  CHECK(bundles.current() == 1U);
  REQUIRE(bundles.remove(0));
  CHECK(on_disk() == "c! ");
  CHECK(bundles.undo_offer() == "Deleted \"b\"");
  REQUIRE(bundles.undo());
  CHECK(on_disk() == "b! c! ");
  REQUIRE(bundles.export_to(folder / "one.json", 1));
  REQUIRE(bundles.export_to(folder / "all.json", {}));
  REQUIRE(bundles.remove(1));
  CHECK(bundles.import(folder / "one.json") == "Imported the bundle \"c\"");
  CHECK(bundles.current() == 1U);
  CHECK(on_disk() == "b! c! ");
  CHECK(bundles.import(folder / "all.json") == "Imported 2 bundles");
  CHECK(on_disk() == "b! c! ");
  CHECK_FALSE(bundles.import(folder / "none.json"));
}
