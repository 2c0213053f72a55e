// SPDX-License-Identifier: GPL-3.0-or-later
// A browser shows pages no list of installed fonts: there are those that the program brings.
#include "core/glyphs/fonts.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <system_error>

#include "core/base/lower_case.h"

namespace mes {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kFamily = "Inter";

struct ShippedFont {
  std::string_view file;
  std::string_view full_name;
  std::string_view style;  // as in fontconfig's syntax
};
constexpr std::array<ShippedFont, 3> kShipped{{{"Inter-Regular.otf", "Inter Regular", ""},
                                               {"Inter-SemiBold.otf", "Inter Semi Bold", ":bold"},
                                               {"Inter-Italic.otf", "Inter Italic", ":italic"}}};

std::unexpected<Error> no_font(std::string text) {
  return std::unexpected(Error{ErrorCode::usage, std::move(text)});
}

}  // namespace

Expected<FontFile> find_font(const std::string& name) {
  std::error_code error;
  if (name.find('/') != std::string::npos) {
    if (!fs::is_regular_file(name, error)) return no_font(fmt::format("the font file \"{}\" does not exist", name));
    return FontFile{.path = name, .index = 0, .name = fs::path(name).filename().string()};
  }
  const std::string wanted = lower_case(std::string_view(name));
  const std::string family = wanted.substr(0, wanted.find(':'));
  const std::string style = wanted.substr(family.size());
  constexpr std::array<std::string_view, 6> kOfThisFamily{"inter", "sans",      "sans-serif",
                                                          "serif", "monospace", "mono"};
  const bool is_family = std::ranges::find(kOfThisFamily, family) != kOfThisFamily.end();
  for (const ShippedFont& font : kShipped)
    if ((is_family && style == font.style) || wanted == lower_case(font.full_name))
      return FontFile{.path = fs::path("/assets/fonts") / font.file, .index = 0, .name = std::string(font.full_name)};
  return no_font(fmt::format("there is no font \"{}\"; in a browser there is {}", name, kFamily));
}

std::string font_name(const std::string& family, bool is_bold, bool is_italic) {
  return family + (is_bold ? ":bold" : "") + (is_italic ? ":italic" : "");
}

std::vector<std::string> font_families() {
  return {std::string(kFamily)};
}

}  // namespace mes
