// SPDX-License-Identifier: GPL-3.0-or-later
// Tables with a column of geometries, as databases and geographic information systems write them: commas, semicolons or
// tabs between the columns (RFC 4180), one of which has WKT, or WKB in hexadecimal digits. The other columns are
// attributes. The first line has their names unless it has a geometry. An empty field and NULL are no geometry.
#include <fmt/core.h>
#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "core/io/format_spec.h"
#include "core/io/maps/feature_properties.h"
#include "core/io/maps/map_features.h"
#include "core/io/text/ascii_text.h"
#include "core/io/text/text_numbers.h"

namespace mes {

Format wkt_format();
Format wkb_format();

namespace {

/// The geometries of a column.
enum class GeometryNotation : std::uint8_t { none, wkt, wkb };

bool is_null(std::string_view field) {
  return field.empty() || field == "NULL" || field == "null" || field == "\\N";
}

/// Splits a table into records, and these into fields without the quotes around them. A comma within the parentheses of
/// WKT does not end a field without quotes. Fields after the 4,096th of a record are passed over.
class TableRecords {
 public:
  TableRecords(std::string_view text, char separator) : rest_(text), separator_(separator) {}

  /// Returns whether there was a record; blank lines are none.
  bool next(std::vector<std::string_view>& fields) {
    while (!rest_.empty() && (rest_.front() == '\n' || rest_.front() == '\r')) rest_.remove_prefix(1);
    fields.clear();
    if (rest_.empty()) return false;
    has_text_behind_quotes_ = false;
    while (true) {
      constexpr std::size_t kMostFields = 4096;
      const std::string_view field = take_field();
      if (fields.size() < kMostFields) fields.push_back(field);
      if (rest_.empty() || rest_.front() != separator_) return true;
      rest_.remove_prefix(1);
    }
  }
  /// Whether the last record has a field that goes on behind the quote at its end: the separator is another.
  bool has_text_behind_quotes() const { return has_text_behind_quotes_; }

 private:
  std::string_view take_field() {
    while (!rest_.empty() && rest_.front() == ' ') rest_.remove_prefix(1);
    if (!rest_.starts_with('"')) return trimmed(take(end_of_plain_field()));
    std::size_t end = 1;
    while (end < rest_.size() && (rest_[end] != '"' || rest_.substr(end).starts_with("\"\"")))
      end += rest_[end] == '"' ? 2U : 1U;
    end = std::min(end, rest_.size());
    const std::string_view field = rest_.substr(1, end - 1);
    rest_.remove_prefix(end);
    const std::size_t behind_quote = std::min<std::size_t>(rest_.size(), 1);
    rest_.remove_prefix(behind_quote);
    if (!trimmed(take(end_of_plain_field())).empty()) has_text_behind_quotes_ = true;
    return trimmed(field);
  }

  std::size_t end_of_plain_field() const {
    std::size_t depth = 0;
    const bool has_parentheses = begins_wkt(rest_);
    std::size_t i = 0;
    for (; i < rest_.size() && rest_[i] != '\n' && rest_[i] != '\r'; ++i) {
      if (rest_[i] == separator_ && depth == 0) break;
      if (!has_parentheses) continue;
      if (rest_[i] == '(') ++depth;
      if (rest_[i] == ')' && depth > 0) --depth;
    }
    return i;
  }

  std::string_view take(std::size_t count) {
    const std::string_view out = rest_.substr(0, count);
    rest_.remove_prefix(count);
    return out;
  }

  std::string_view rest_;
  char separator_;
  bool has_text_behind_quotes_ = false;
};

/// Whether a text is WKT with a number in it, as "Polygon (old)" in a column of names is not.
bool is_wkt_with_number(std::string_view field) {
  if (!field.ends_with(')') || !begins_wkt(field)) return false;
  const std::size_t inside = field.find_first_not_of("( \t\r\n", field.find('('));
  const std::string_view rest = field.substr(inside);  // at least ")"
  return is_digit(rest.front()) || rest.front() == '-' || rest.front() == '+' || rest.front() == '.' ||
         begins_wkt(rest);
}

GeometryNotation notation_of(std::string_view field) {
  if (is_wkt_with_number(field)) return GeometryNotation::wkt;
  return is_hexadecimal_wkb(field) ? GeometryNotation::wkb : GeometryNotation::none;
}

struct GeometryTable {
  char separator = ',';
  std::size_t column = 0;
  GeometryNotation notation = GeometryNotation::none;
  bool has_names = false;  ///< the first record is that of the names
};

/// The layout, from the first records; nothing if none of them has a geometry.
std::optional<GeometryTable> recognise_geometries(std::string_view bytes) {
  constexpr int kMostRecords = 32;
  constexpr std::size_t kMostBytes = std::size_t{1} << 24U;  // a field may be a whole coast
  const std::string_view text = without_bom(bytes).substr(0, kMostBytes);
  for (const char separator : {'\t', ',', ';'}) {
    TableRecords records(text, separator);
    std::vector<std::string_view> fields;
    for (int number = 0; number < kMostRecords && records.next(fields); ++number) {
      if (records.has_text_behind_quotes()) continue;
      for (std::size_t column = 0; column < fields.size(); ++column)
        if (const auto notation = notation_of(fields[column]); notation != GeometryNotation::none)
          return GeometryTable{separator, column, notation, number > 0};
    }
  }
  return std::nullopt;
}

Match match_geometry_table(std::string_view bytes) {
  return recognise_geometries(bytes) ? Match::surely : Match::no;
}

/// The text with blanks in place of all but the geometries, which keep their lines and columns.
std::string geometries_alone(std::string_view text, const GeometryTable& table, ReadJob& job) {
  std::string out(text.size(), ' ');
  for (std::size_t i = 0; i < text.size(); ++i)
    if (text[i] == '\n' || text[i] == '\r') out[i] = text[i];
  TableRecords records(text, table.separator);
  std::vector<std::string_view> fields;
  if (table.has_names) records.next(fields);
  while (records.next(fields)) {
    if (fields.size() <= table.column || is_null(fields[table.column])) continue;
    const std::string_view field = fields[table.column];
    job.passed(field.data());
    std::ranges::copy(field, out.begin() + (field.data() - text.data()));
  }
  return out;
}

Expected<LoadedFile> read_geometry_table(std::string_view bytes, const std::string& name, const ReadRequest& request,
                                         const std::filesystem::path* path, ReadJob& job) {
  const auto table = recognise_geometries(bytes);
  if (!table) return bad_input("no column has WKT, or WKB in hexadecimal digits", name, 1, 1);
  const std::string_view text = without_bom(bytes);
  constexpr double kSplitting = 0.2;
  job.begin(text, kSplitting);
  const std::string geometries = geometries_alone(text, *table, job);
  job.begin(geometries);
  const Format format = table->notation == GeometryNotation::wkt ? wkt_format() : wkb_format();
  return format.read_map(geometries, name, request, path, job);
}

/// The value of a field, in which a quote is written twice.
std::string unquoted(std::string_view field) {
  std::string out;
  for (std::size_t i = 0; i < field.size(); ++i) {
    out += field[i];
    if (field.substr(i).starts_with("\"\"")) ++i;
  }
  return out;
}

/// Whether a field is a number as JSON has it: "007" is none.
bool is_json_number(std::string_view field) {
  return (is_digit(field.front()) || field.front() == '-') && parse_number(field) && nlohmann::json::accept(field);
}

}  // namespace

std::vector<MapFeature> geometry_table_features(std::string_view bytes) {
  std::vector<MapFeature> out;
  const auto table = recognise_geometries(bytes);
  if (!table) return out;
  const std::string_view text = without_bom(bytes);
  std::vector<std::string_view> fields;
  std::vector<std::string> names;
  TableRecords records(text, table->separator);
  if (table->has_names) {
    records.next(fields);
    for (const std::string_view field : fields) names.push_back(unquoted(field));
  }
  // A column has numbers if all its values are numbers.
  const TableRecords first = records;
  std::vector<bool> has_texts;
  std::string_view code;  // of the first coordinate system
  while (records.next(fields)) {
    has_texts.resize(std::max(has_texts.size(), fields.size()));
    for (std::size_t i = 0; i < fields.size(); ++i)
      if (!is_null(fields[i]) && !is_json_number(fields[i])) has_texts[i] = true;
    if (fields.size() > table->column && code.empty()) code = srid_of_wkt(fields[table->column]);
  }
  for (std::size_t i = names.size(); i < has_texts.size(); ++i) names.push_back(fmt::format("field_{}", i + 1));
  records = first;
  while (records.next(fields)) {
    MapFeature& feature = out.emplace_back();
    FeatureProperties properties(feature);
    for (std::size_t i = 0; i < fields.size(); ++i) {
      const std::string_view field = fields[i];
      if (i == table->column) {
        feature.text = is_null(field) ? "GEOMETRYCOLLECTION EMPTY" : std::string(field);
        if (!is_null(field) && srid_of_wkt(field).empty()) feature.text.insert(0, code);
      } else if (is_null(field)) {
        properties.add(names[i], "null");
      } else if (has_texts[i]) {
        properties.add_text(names[i], unquoted(field));
      } else {
        properties.add(names[i], std::string(field));
      }
    }
  }
  return out;
}

Format geometry_table_format() {
  return {.descriptor = {.id = "geometry-table",
                         .name = "Table with a column of WKT, or of WKB in hexadecimal digits",
                         .can_read = true,
                         .is_map = true},
          .match = match_geometry_table,
          .read_map = read_geometry_table};
}

}  // namespace mes
