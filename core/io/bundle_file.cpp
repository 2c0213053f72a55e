// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/bundle_file.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/io/bnd.h"
#include "core/io/json_layers.h"
#include "core/io/json_text.h"
#include "core/io/read_file.h"

namespace mes {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

constexpr int kSchema = 1;
constexpr std::uintmax_t kLargestFile = 16U << 20U;
constexpr std::size_t kMostBundles = 1000;
constexpr std::size_t kLongestName = 1000;
constexpr std::size_t kLongestDescription = 1000;

std::unexpected<Error> refuse(std::string text, const std::string& file) {
  return std::unexpected(Error{ErrorCode::bad_input, std::move(text), file});
}

/// 0: not a version at all.
int schema_of(const json& object) {
  const auto found = object.find("schema");
  return found != object.end() && found->is_number_unsigned() && found->get<std::uint64_t>() < 1'000'000
             ? found->get<int>()
             : 0;
}

Expected<Bundle> bundle_from(const json& object, std::size_t number, const std::string& file,
                             const LayerStyleSource& style_of) {
  const std::string where = "bundle " + std::to_string(number);
  const auto name = object.is_object() ? object.find("name") : object.end();
  if (!object.is_object() || name == object.end() || !name->is_string() ||
      name->get_ref<const std::string&>().empty())
    return refuse(where + " has no name", file);
  Bundle out{name->get<std::string>()};
  if (out.name.size() > kLongestName) return refuse(where + " has a name that is too long", file);
  auto layers = layer_configuration_from(object, style_of);
  if (!layers) return refuse(where + ": " + layers.error().text, file);
  out.layers = std::move(*layers);
  if (const auto description = object.find("description"); description != object.end()) {
    if (!description->is_string() || description->get_ref<const std::string&>().size() > kLongestDescription)
      return refuse(where + ": \"description\" is not a short text", file);
    out.description = description->get<std::string>();
  }
  return out;
}

Expected<LoadedBundles> read_json(std::string_view bytes, const std::string& file,
                                  std::span<const KnownLayer> known) {
  const auto style_of = [known](std::string_view layer) {
    const auto found = std::ranges::find(known, layer, &KnownLayer::id);
    return found == known.end() ? LayerStyle{} : found->style;
  };
  const auto parsed = parse_json(bytes, file);
  if (!parsed) return std::unexpected(parsed.error());
  if (!parsed->is_object() || parsed->value("mesecina", json()) != "bundles")
    return refuse("this is no file of bundles", file);
  const int schema = schema_of(*parsed);
  if (schema == 0) return refuse("this file of bundles has no version", file);
  if (schema > kSchema) return refuse("these bundles are of a later version of the program", file);
  const auto list = parsed->find("bundles");
  if (list == parsed->end() || !list->is_array()) return refuse("\"bundles\" is not a list", file);
  if (list->size() > kMostBundles) return refuse("more than " + std::to_string(kMostBundles) + " bundles", file);
  LoadedBundles out;
  for (const json& object : *list) {
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
  // The key that tells what it is comes first, where it is looked for.
  nlohmann::ordered_json out = {{"mesecina", "bundles"}, {"schema", kSchema}, {"bundles", std::move(list)}};
  return out.dump(1, ' ', false, json::error_handler_t::replace) + '\n';
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
  if (!looks_like_bnd(bytes) && file.ends_with(".bnd")) return refuse("this is no file of bundles", file);
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
  const auto parsed = parse_json(bytes, {});
  return parsed && parsed->is_object() && parsed->value("mesecina", json()) == "bundles" &&
         schema_of(*parsed) > kSchema;
}

}  // namespace mes
