// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <utility>

#include "core/io/maps/feature_properties.h"
#include "core/io/maps/map_features.h"
#include "core/io/text/text_numbers.h"
#include "core/io/xml/xml_source.h"

namespace mes {
namespace {

using pugi::xml_node;

/// The text of an element without blanks at both ends.
std::string_view text_of(xml_node node) {
  const std::string_view text = node.child_value();
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r\n") + 1 - first);
}

/// The properties of one placemark.
class KmlAttributes {
 public:
  /// Types of fields by the id of their schema and their name.
  using Types = std::map<std::pair<std::string, std::string>, std::string>;

  KmlAttributes(MapFeature& feature, const Types& types) : properties_(feature), types_(types) {}

  void add_all(xml_node placemark) {
    constexpr std::array<std::string_view, 4> kTexts{"name", "description", "address", "phoneNumber"};
    for (const xml_node child : placemark.children()) {
      const std::string_view kind = local_name(child.name());
      if (std::ranges::find(kTexts, kind) != kTexts.end()) properties_.add_text(kind, text_of(child));
      if (kind == "ExtendedData") add_extended(child);
      if (kind != "TimeStamp" && kind != "TimeSpan") continue;
      for (const xml_node time : child.children()) properties_.add_text(local_name(time.name()), text_of(time));
    }
  }

 private:
  void add_extended(xml_node data) {
    for (const xml_node child : data.children()) {
      const std::string_view kind = local_name(child.name());
      if (kind == "Data") {
        for (const xml_node value : child.children())
          if (local_name(value.name()) == "value")
            properties_.add_text(child.attribute("name").value(), text_of(value));
      } else if (kind == "SchemaData") {
        std::string_view schema = child.attribute("schemaUrl").value();
        schema.remove_prefix(std::min(schema.size(), schema.find('#') + 1));
        for (const xml_node field : child.children())
          if (local_name(field.name()) == "SimpleData") add_typed(std::string(schema), field);
      } else if (child.first_child().type() == pugi::node_pcdata || child.first_child().type() == pugi::node_cdata) {
        properties_.add_text(kind, text_of(child));  // an element of another language
      }
    }
  }

  void add_typed(const std::string& schema, xml_node field) {
    const std::string name = field.attribute("name").value();
    const std::string_view value = text_of(field);
    const auto found = types_.find({schema, name});
    const std::string_view type = found == types_.end() ? std::string_view{} : std::string_view(found->second);
    constexpr std::array<std::string_view, 6> kNumbers{"int", "uint", "short", "ushort", "float", "double"};
    const bool is_number =
        std::ranges::find(kNumbers, type) != kNumbers.end() && parse_number(value) && nlohmann::json::accept(value);
    const bool is_yes = value == "1" || value == "true";
    if (is_number)
      properties_.add(name, std::string(value));
    else if (type == "bool" && (is_yes || value == "0" || value == "false"))
      properties_.add(name, is_yes ? "true" : "false");
    else
      properties_.add_text(name, value);
  }

  FeatureProperties properties_;
  const Types& types_;
};

}  // namespace

Expected<std::vector<MapFeature>> kml_features(std::string_view bytes, const std::string& name) {
  XmlSource source(without_bom(bytes), name);
  ReadJob job;
  const auto root = source.parse(job);
  if (!root) return std::unexpected(root.error());
  KmlAttributes::Types types;
  std::vector<xml_node> placemarks;
  for (xml_node node = *root; node; node = next_in_document(node, *root)) {
    const std::string_view kind = local_name(node.name());
    if (kind == "Placemark") placemarks.push_back(node);
    if (kind != "Schema") continue;
    for (const xml_node field : node.children())
      types[{node.attribute("id").value(), field.attribute("name").value()}] = field.attribute("type").value();
  }
  std::vector<MapFeature> out;
  for (const xml_node placemark : placemarks) {
    MapFeature& feature = out.emplace_back();
    std::ostringstream text;
    placemark.print(text, "", pugi::format_raw);
    feature.text = "<kml>" + text.str() + "</kml>";
    const std::string_view id = placemark.attribute("id").value();
    if (!id.empty()) feature.id = json_of_text(id);
    KmlAttributes(feature, types).add_all(placemark);
  }
  return out;
}

}  // namespace mes
