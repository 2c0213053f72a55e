// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/glyphs/fonts.h"

#include <fontconfig/fontconfig.h>

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <set>
#include <string_view>
#include <system_error>

#include "core/glyphs/internal/destroyed_by.h"

namespace mes {
namespace {

namespace fs = std::filesystem;

using Config = std::unique_ptr<FcConfig, DestroyedBy<FcConfigDestroy>>;
using FontSet = std::unique_ptr<FcFontSet, DestroyedBy<FcFontSetDestroy>>;
using Pattern = std::unique_ptr<FcPattern, DestroyedBy<FcPatternDestroy>>;

const FcChar8* to_fc(const std::string& text) {
  return reinterpret_cast<const FcChar8*>(text.c_str());
}

/// The text values of a property.
std::vector<std::string> texts_of(FcPattern* font, const char* property) {
  std::vector<std::string> out;
  FcChar8* text = nullptr;
  for (int i = 0; FcPatternGetString(font, property, i, &text) == FcResultMatch; ++i)
    out.emplace_back(reinterpret_cast<const char*>(text));
  return out;
}

bool is_true(FcPattern* font, const char* property) {
  FcBool value = FcFalse;
  return FcPatternGetBool(font, property, 0, &value) == FcResultMatch && value == FcTrue;
}

/// Whether HarfBuzz can read the outlines. A variable font itself does not count; its named instances are listed.
bool has_outlines(FcPattern* font) {
  const std::vector<std::string> kinds = texts_of(font, FC_FONTFORMAT);
  const bool is_open_type =
      std::ranges::any_of(kinds, [](const std::string& kind) { return kind == "TrueType" || kind == "CFF"; });
  return is_open_type && is_true(font, FC_SCALABLE) && !is_true(font, FC_VARIABLE);
}

struct InstalledFonts {
  Config config;
  FontSet fonts;
};

InstalledFonts& installed() {
  static InstalledFonts out = [] {
    InstalledFonts made{Config(FcInitLoadConfigAndFonts()), FontSet(FcFontSetCreate())};
    if (!made.config || !made.fonts) return made;
    const FcFontSet* const all = FcConfigGetFonts(made.config.get(), FcSetSystem);
    for (int i = 0; all != nullptr && i < all->nfont; ++i) {
      if (!has_outlines(all->fonts[i])) continue;
      FcPatternReference(all->fonts[i]);
      FcFontSetAdd(made.fonts.get(), all->fonts[i]);
    }
    return made;
  }();
  return out;
}

bool are_alike(const std::string& a, const std::string& b) {
  return FcStrCmpIgnoreCase(to_fc(a), to_fc(b)) == 0;
}

bool has_name(FcPattern* font, const char* property, const std::string& name) {
  return std::ranges::any_of(texts_of(font, property),
                             [&](const std::string& text) { return are_alike(text, name); });
}

bool is_generic(const std::string& family) {
  constexpr std::array<std::string_view, 5> kGeneric{"sans", "sans-serif", "serif", "monospace", "mono"};
  return std::ranges::any_of(kGeneric, [&](std::string_view word) { return are_alike(family, std::string(word)); });
}

FontFile file_of(FcPattern* font) {
  FontFile out;
  const std::vector<std::string> files = texts_of(font, FC_FILE);
  if (!files.empty()) out.path = files.front();
  int index = 0;
  if (FcPatternGetInteger(font, FC_INDEX, 0, &index) == FcResultMatch) out.index = static_cast<std::uint32_t>(index);
  const std::vector<std::string> names = texts_of(font, FC_FULLNAME);
  out.name = names.empty() ? out.path.filename().string() : names.front();
  return out;
}

std::unexpected<Error> no_font(std::string text) {
  return std::unexpected(Error{ErrorCode::usage, std::move(text)});
}

Expected<FontFile> font_in_file(const std::string& name) {
  std::error_code error;
  if (!fs::is_regular_file(name, error)) return no_font(fmt::format("the font file \"{}\" does not exist", name));
  return FontFile{.path = name, .index = 0, .name = fs::path(name).filename().string()};
}

/// Families that begin like the name, or contain it.
std::string suggestions(const std::string& name) {
  std::string out;
  int count = 0;
  constexpr int kMost = 3;
  for (const std::string& family : font_families()) {
    const bool is_near = FcStrStrIgnoreCase(to_fc(family), to_fc(name)) != nullptr ||
                         FcStrStrIgnoreCase(to_fc(name), to_fc(family)) != nullptr;
    if (!is_near || ++count > kMost) continue;
    out += (out.empty() ? "" : ", ") + family;
  }
  return out.empty() ? out : "; there is " + out;
}

}  // namespace

Expected<FontFile> find_font(const std::string& name) {
  if (name.find('/') != std::string::npos) return font_in_file(name);
  InstalledFonts& all = installed();
  if (!all.config || !all.fonts || all.fonts->nfont == 0) return no_font("there are no fonts on this machine");
  for (const char* const property : {FC_FULLNAME, FC_POSTSCRIPT_NAME})
    for (int i = 0; i < all.fonts->nfont; ++i)
      // The full name of a single-font family, such as "Cantarell", is found below, in its regular style.
      if (has_name(all.fonts->fonts[i], property, name) && !has_name(all.fonts->fonts[i], FC_FAMILY, name))
        return file_of(all.fonts->fonts[i]);

  const Pattern wanted(FcNameParse(to_fc(name)));
  if (!wanted) return no_font(fmt::format("\"{}\" is not the name of a font", name));
  const std::vector<std::string> families = texts_of(wanted.get(), FC_FAMILY);
  FcConfigSubstitute(all.config.get(), wanted.get(), FcMatchPattern);
  FcDefaultSubstitute(wanted.get());
  FcFontSet* sets[]{all.fonts.get()};
  FcResult result = FcResultNoMatch;
  const Pattern found(FcFontSetMatch(all.config.get(), sets, 1, wanted.get(), &result));
  const bool is_meant = found && std::ranges::all_of(families, [&](const std::string& family) {
                          return is_generic(family) || has_name(found.get(), FC_FAMILY, family);
                        });
  if (!is_meant) return no_font(fmt::format("there is no font \"{}\"{}", name, suggestions(name)));
  return file_of(found.get());
}

std::string font_name(const std::string& family, bool is_bold, bool is_italic) {
  std::string out;
  for (const char c : family) {
    if (std::string_view("\\-:,").contains(c)) out += '\\';
    out += c;
  }
  if (is_bold) out += ":bold";
  if (is_italic) out += ":italic";
  return out;
}

std::vector<std::string> font_families() {
  std::set<std::string> out;
  const InstalledFonts& all = installed();
  for (int i = 0; all.fonts && i < all.fonts->nfont; ++i) {
    const std::vector<std::string> names = texts_of(all.fonts->fonts[i], FC_FAMILY);
    if (!names.empty()) out.insert(names.front());
  }
  return {out.begin(), out.end()};
}

}  // namespace mes
