// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/store/looks/color_maps.h"

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>
#include <utility>

#include "app/system/data_folder.h"
#include "core/io/text/text_numbers.h"

namespace mes {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostColors = 4096;
constexpr std::uintmax_t kLargestColorMap = 1U << 20U;
// Maps are rows of one texture. The limit is far more than anybody chooses from.
constexpr std::size_t kMostMaps = 256;

/// The files of a folder by name, except that the program's recommended maps come first.
std::vector<fs::path> map_files(const fs::path& folder) {
  std::vector<fs::path> out;
  std::error_code error;
  fs::directory_iterator entry(folder, error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error))
    if (entry->path().extension() == ".map") out.push_back(entry->path());
  constexpr std::array<std::string_view, 3> kLeading{"viridis", "cividis", "inferno"};
  const auto rank = [&](const fs::path& file) {
    return std::pair(std::ranges::find(kLeading, file.stem().string()) - kLeading.begin(), file);
  };
  std::ranges::sort(out, {}, rank);
  return out;
}

void add(LoadedColorMaps& out, Expected<render::ColorMap> map, const fs::path& file) {
  if (!map) {
    out.problems.push_back(map.error());
  } else if (std::ranges::find(out.maps, map->name, &render::ColorMap::name) != out.maps.end()) {
    out.problems.push_back({ErrorCode::bad_input, "there is another colour map of this name", file.string()});
  } else if (out.maps.size() == kMostMaps) {
    out.problems.push_back(
        {ErrorCode::bad_input, fmt::format("there are {} colour maps before it", kMostMaps), file.string()});
  } else {
    out.maps.push_back(std::move(*map));
  }
}

}  // namespace

Expected<render::ColorMap> parse_color_map(std::string_view bytes, std::string name, const std::string& file) {
  if (const std::string_view kind = foreign_kind(bytes); !kind.empty())
    return std::unexpected(Error{ErrorCode::bad_input, "this is " + std::string(kind) + ", no colour map", file});
  render::ColorMap map{std::move(name), {}, false};
  std::size_t numbers = 0;
  Scanner scanner(bytes);
  const auto fail = [&](std::string text) {
    return bad_input(std::move(text), file, scanner.line(), scanner.column());
  };
  while (scanner.next()) {
    const auto value = parse_number(scanner.token());
    if (!value) return fail(describe(value.error(), scanner.token()));
    if (*value < 0.0 || *value > 1.0)
      return fail("red, green and blue are numbers from 0 to 1, not " + in_quotes(scanner.token()));
    if (numbers % 3 == 0) {
      if (map.colors.size() == kMostColors)
        return fail(fmt::format("a colour map has at most {} colours", kMostColors));
      map.colors.emplace_back();
    }
    map.colors.back()[static_cast<glm::length_t>(numbers % 3)] = static_cast<float>(*value);
    ++numbers;
  }
  if (numbers % 3 != 0) return fail(fmt::format("the last colour has {} of three numbers", numbers % 3));
  if (map.colors.size() < 2) return fail(fmt::format("a colour map needs two colours, found {}", map.colors.size()));
  return map;
}

Expected<render::ColorMap> read_color_map(const fs::path& file) {
  const auto fail = [&](std::string text) {
    return std::unexpected(Error{ErrorCode::bad_input, std::move(text), file.string()});
  };
  std::error_code error;
  // The check also avoids waiting for pipes and devices.
  if (!fs::is_regular_file(file, error)) return fail("this is not a file");
  if (fs::file_size(file, error) > kLargestColorMap || error) return fail("far too large for a colour map");
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream bytes;
  bytes << stream.rdbuf();
  if (!stream) return fail("cannot be read");
  const std::string text = bytes.str();
  return parse_color_map(without_bom(text), printable(file.stem().string()), file.string());
}

fs::path user_color_map_folder() {
  const fs::path data = data_folder();
  return data.empty() ? fs::path() : data / "colormaps";
}

LoadedColorMaps load_color_maps(const fs::path& assets, const fs::path& user_folder) {
  LoadedColorMaps out;
  if (!assets.empty())
    for (const fs::path& file : map_files(assets / "colormaps")) add(out, read_color_map(file), file);
  for (render::ColorMap& map : render::builtin_color_maps()) add(out, std::move(map), {});
  if (!user_folder.empty())
    for (const fs::path& file : map_files(user_folder)) add(out, read_color_map(file), file);
  return out;
}

}  // namespace mes
