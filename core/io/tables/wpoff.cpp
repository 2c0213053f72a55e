// SPDX-License-Identifier: GPL-3.0-or-later
// WPOFF: "WPOFF n 0 0" and n times "x y radius", white space anywhere unless the lines contradict this. Radii are used
// unchanged.
#include <fmt/core.h>
#include <array>

#include "core/document/document.h"
#include "core/io/format_spec.h"
#include "core/io/meshes/off_header.h"

namespace mes {
namespace {

std::string_view other_than_balls(std::size_t columns) {
  return columns == 2 ? "points (POFF)" : (columns == 4 ? "balls in space" : "");
}

constexpr OffKind kBalls{
    .magic = "WPOFF", .things = "balls", .numbers = "numbers", .numbers_each = 3, .guess = other_than_balls};

Match match_wpoff(std::string_view bytes) {
  return has_off_magic(bytes, kBalls) ? Match::surely : Match::no;
}

Expected<LoadedFile> read_wpoff(std::string_view bytes, const std::string& name, ReadJob& job) {
  Scanner scanner(bytes);
  OffReader reader(kBalls, scanner, bytes, name, job);
  const auto count = reader.read_header();
  if (!count) return std::unexpected(count.error());

  LoadedFile file;
  file.data.balls.reserve(reader.likely_count());
  std::uint64_t zeros = 0;
  std::string at_first_zero;
  for (std::uint64_t i = 0; i < *count; ++i) {
    std::array<double, 3> ball{};
    if (auto read = reader.read_next(ball); !read) return std::unexpected(read.error());
    const Disk disk{{ball[0], ball[1]}, ball[2]};
    if (disk.radius < 0.0) return reader.fail("the radius is negative: " + in_quotes(scanner.token()));
    if (disk.radius == 0.0 && zeros++ == 0) at_first_zero = reader.warning("");
    file.data.balls.push_back(disk);
  }
  if (zeros != 0)
    file.warnings.push_back(
        at_first_zero +
        (zeros == 1 ? "a ball has radius zero; it is kept, but adds nothing to unions"
                    : fmt::format("{} balls have radius zero, the first of them here; they are kept, but add nothing "
                                  "to unions",
                                  zeros)));
  auto remarks = reader.finish();
  if (!remarks) return std::unexpected(remarks.error());
  for (std::string& remark : *remarks) file.warnings.push_back(std::move(remark));
  return file;
}

}  // namespace

Format wpoff_format() {
  return {.descriptor =
              {.id = "wpoff", .name = "WPOFF balls", .extensions = {".wpoff"}, .can_read = true, .can_write = true},
          .match = match_wpoff,
          .read = read_wpoff};
}

std::string write_wpoff(std::span<const Disk> balls) {
  constexpr std::size_t kTypicalLine = 60;
  std::string out = fmt::format("WPOFF {} 0 0\n", balls.size());
  out.reserve(out.size() + balls.size() * kTypicalLine);
  for (const Disk& ball : balls) {
    append_number(out, ball.center.x);
    out += ' ';
    append_number(out, ball.center.y);
    out += ' ';
    append_number(out, ball.radius);
    out += '\n';
  }
  return out;
}

std::string write_wpoff(const Document& document) {
  std::vector<Disk> balls;
  balls.reserve(document.ball_count());
  for (const BallSlot slot : document.ball_slots_in_input_order()) balls.push_back(document.disk(slot));
  return write_wpoff(balls);
}

}  // namespace mes
