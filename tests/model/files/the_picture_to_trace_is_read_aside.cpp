// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <semaphore>

#include "app/store/background_loader.h"
#include "render/image/png.h"
#include "tests/io/temporary_folder.h"

using namespace mes;

namespace {

std::string write_picture(const test::TemporaryFolder& folder, const std::string& name, int width, int height) {
  const render::Image image{
      width, height,
      std::vector<std::uint8_t>(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height))};
  const auto png = render::encode_png(image);
  REQUIRE(png);
  return folder.write(name, {reinterpret_cast<const char*>(png->data()), png->size()}).string();
}

/// A loader, and the way to wait for what it reads.
struct LoaderBench {
  std::counting_semaphore<> woken{0};
  BackgroundLoader loader{[this] { woken.release(); }};

  BackgroundLoader::Outcome next() {
    while (true) {
      if (auto outcome = loader.poll()) return std::move(*outcome);
      woken.acquire();
    }
  }
};

}  // namespace

TEST_CASE("each file that is followed is delivered once, a missing one as an error") {
  const test::TemporaryFolder folder;
  const std::string small = write_picture(folder, "small.png", 3, 2);
  LoaderBench desk;
  CHECK_FALSE(desk.loader.follow({}));
  CHECK(desk.loader.follow({.file = small}));
  CHECK_FALSE(desk.loader.follow({.file = small}));
  auto outcome = desk.next();
  CHECK(outcome.file == small);
  REQUIRE(outcome.image);
  CHECK(outcome.image->width == 3);
  CHECK_FALSE(desk.loader.poll());
  CHECK_FALSE(desk.loader.is_reading());

  const std::string missing = (folder / "missing.png").string();
  CHECK(desk.loader.follow({.file = missing}));
  outcome = desk.next();
  REQUIRE_FALSE(outcome.image);
  CHECK(outcome.image.error().message() == missing + ": there is no such file");
  CHECK_FALSE(desk.loader.follow({.file = missing}));
}

TEST_CASE("of pictures asked for in a row only the last comes") {
  const test::TemporaryFolder folder;
  const std::string large = write_picture(folder, "large.png", 1500, 1200);
  const std::string small = write_picture(folder, "small.png", 3, 2);
  LoaderBench desk;
  desk.loader.follow({.file = large});
  desk.loader.follow({.file = small});
  CHECK(desk.next().file == small);
  CHECK_FALSE(desk.loader.poll());
  desk.loader.follow({.file = large});
  desk.loader.follow({});
  CHECK_FALSE(desk.loader.is_reading());
  CHECK_FALSE(desk.loader.poll());
}

TEST_CASE("a picture that is turned in another way is read again") {
  const test::TemporaryFolder folder;
  const std::string file = write_picture(folder, "a.png", 3, 2);
  LoaderBench desk;
  CHECK(desk.loader.follow({.file = file, .is_upright = false}));
  CHECK(desk.next().file == file);
  CHECK_FALSE(desk.loader.follow({.file = file, .center = {1, 2}, .is_upright = false}));
  CHECK(desk.loader.follow({.file = file}));
  CHECK(desk.next().file == file);
  desk.loader.take_as_read(file);
  CHECK_FALSE(desk.loader.follow({.file = file}));
}

TEST_CASE("a picture is laid into the middle of a box, whatever the box is") {
  const BackgroundImage wide = placed_in({{0, 0}, {10, 100}}, {.file = "a.png"}, 0.5);
  CHECK(wide.file == "a.png");
  CHECK(wide.center == Vec2{5, 50});
  CHECK(wide.width == 10.0);
  CHECK(placed_in({{0, 0}, {100, 10}}, {.file = "a.png"}, 0.5).width == 20.0);
  CHECK(placed_in({}, {.file = "a.png"}, 2.0).width == 0.5);
  CHECK(placed_in({{3, 4}, {3, 4}}, {.file = "a.png"}, 2.0).width == 1.0);
  // What a view shows may be out of the range of coordinates; a place in a document is not.
  const BackgroundImage deep = placed_in({{1e-290, 0}, {3e-290, 1e-290}}, {.file = "a.png"}, 0.5);
  CHECK(deep.center == Vec2{0, 0});
  CHECK(deep.width == 0x1p-500);
  const BackgroundImage far = placed_in({{-1e280, 1e280}, {1e280, 2e280}}, {.file = "a.png"}, 0.5);
  CHECK(far.center == Vec2{0, 0x1.fffffffffffffp499});
  CHECK(far.width == 0x1.fffffffffffffp499);
}
