// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/bundle_file.h"

#include <fmt/core.h>
#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/io/bnd.h"
#include "core/io/files/read_file.h"
#include "core/io/session/json_layers.h"
#include "core/io/session/json_text.h"
#include "core/io/session/json_view.h"

namespace mes {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

constexpr std::uint64_t kSchema = 1;
constexpr std::uintmax_t kLargestFile = 16U << 20U;
constexpr std::size_t kLongestBundleName = 1000;
constexpr std::size_t kLongestDescription = 1000;

std::unexpected<Error> refuse(std::string text, const std::string& file) {
  return std::unexpected(Error{ErrorCode::bad_input, std::move(text), file});
}

/// Schema number of the file; 0 if there is no valid one.
std::uint64_t bundle_schema(JsonView object) {
  const JsonView schema = object.find("schema");
  const auto version = schema.is_number() ? schema.count() : std::nullopt;
  return version && *version < 1'000'000 ? *version : 0;
}

bool holds_bundles(JsonView object) {
  const JsonView what = object.find("mesecina");
  return what.is_text() && what.text() == "bundles";
}

Expected<Bundle> bundle_from(JsonView object, std::size_t number, const std::string& file,
                             const LayerStyleSource& style_of) {
  const std::string where = fmt::format("bundle {}", number);
  const auto [name, description] = object.pick<2>({"name", "description"});
  Bundle out{name.is_text() ? name.text() : std::string()};
  if (out.name.empty()) return refuse(where + " has no name", file);
  if (out.name.size() > kLongestBundleName) return refuse(where + " has a name that is too long", file);
  auto layers = layer_configuration_from(object, style_of);
  if (!layers) return refuse(where + ": " + layers.error().text, file);
  out.layers = std::move(*layers);
  if (description) {
    out.description = description.is_text() ? description.text() : std::string();
    if (!description.is_text() || out.description.size() > kLongestDescription)
      return refuse(where + ": \"description\" is not a short text", file);
  }
  return out;
}

Expected<LoadedBundles> read_json(std::string_view bytes, const std::string& file,
                                  std::span<const KnownLayer> known) {
  const auto style_of = [known](std::string_view layer) {
    const auto found = std::ranges::find(known, layer, &KnownLayer::id);
    return found == known.end() ? LayerStyle{} : found->style;
  };
  if (auto good = check_json(bytes, file); !good) return std::unexpected(std::move(good.error()));
  const JsonView whole = JsonView::whole(bytes);
  if (!holds_bundles(whole)) return refuse("this is not a file of bundles", file);
  const std::uint64_t schema = bundle_schema(whole);
  if (schema == 0) return refuse("this file of bundles has no version", file);
  if (schema > kSchema) return refuse("these bundles are of a later version of the program", file);
  const JsonView list = whole.find("bundles");
  if (!list.is_list()) return refuse("\"bundles\" is not a list", file);
  LoadedBundles out;
  for (const JsonView object : list.elements()) {
    if (out.bundles.size() == kMostBundles) return refuse(fmt::format("more than {} bundles", kMostBundles), file);
    auto bundle = bundle_from(object, out.bundles.size() + 1, file, style_of);
    if (!bundle) return std::unexpected(bundle.error());
    out.bundles.push_back(std::move(*bundle));
  }
  return out;
}

}  // namespace

std::string write_bundles(std::span<const Bundle> bundles) {
  json list = json::array();
  for (const Bundle& bundle : bundles) {
    json object = to_json(bundle.layers);
    object["name"] = bundle.name;
    if (!bundle.description.empty()) object["description"] = bundle.description;
    list.push_back(std::move(object));
  }
  // The identifying key must be first: the detection looks for it there.
  nlohmann::ordered_json out = {{"mesecina", "bundles"}, {"schema", kSchema}, {"bundles", std::move(list)}};
  return json_text(out, 1) + '\n';
}

bool looks_like_bundles(std::string_view bytes) {
  if (looks_like_bnd(bytes)) return true;
  constexpr std::string_view kKey = "\"mesecina\"";
  const std::string_view begin = bytes.substr(0, 256);
  const std::size_t key = begin.find(kKey);
  if (key == std::string_view::npos) return false;
  const std::size_t value = begin.find_first_not_of(" \t\r\n:", key + kKey.size());
  return value != std::string_view::npos && begin.substr(value).starts_with("\"bundles\"");
}

bool is_bundle_file(const fs::path& path) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return false;
  if (path.extension() == ".bnd") return true;
  std::string begin(256, '\0');
  std::ifstream stream(path, std::ios::binary);
  stream.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  begin.resize(static_cast<std::size_t>(stream.gcount()));
  return looks_like_bundles(begin);
}

Expected<LoadedBundles> read_bundles(std::string_view bytes, const std::string& file,
                                     std::span<const KnownLayer> known) {
  if (!looks_like_bnd(bytes) && file.ends_with(".bnd")) return refuse("this is not a file of bundles", file);
  auto out = looks_like_bnd(bytes) ? read_bnd(bytes, file, known) : read_json(bytes, file, known);
  if (out && out->bundles.empty()) return refuse("there is no bundle in it", file);
  return out;
}

Expected<LoadedBundles> read_bundle_file(const fs::path& path, std::span<const KnownLayer> known) {
  const std::string file = path.string();
  std::error_code error;
  if (!fs::exists(path, error)) return refuse("there is no such file", file);
  if (!fs::is_regular_file(path, error)) return refuse("this is not a file", file);
  if (fs::file_size(path, error) > kLargestFile || error) return refuse("far too large for a file of bundles", file);
  const auto bytes = read_regular_file(path, {.most_bytes = kLargestFile});
  if (!bytes) return std::unexpected(bytes.error());
  return read_bundles(*bytes, file, known);
}

bool are_bundles_of_the_future(std::string_view bytes) {
  if (!check_json(bytes, {})) return false;
  const JsonView whole = JsonView::whole(bytes);
  return holds_bundles(whole) && bundle_schema(whole) > kSchema;
}

}  // namespace mes
