// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/tables/xy_table.h"

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <numeric>
#include <ranges>
#include <unordered_map>
#include <vector>

#include "core/base/lower_case.h"
#include "core/io/text/ascii_text.h"
#include "core/io/text/line_end.h"
#include "core/io/text/text_numbers.h"

namespace mes {
namespace {

// A header is searched only up to this column, so that a line of a million words costs no memory.
constexpr std::size_t kMostColumns = 256;
constexpr std::size_t kMostSamples = 0xfffffffe;

using Fields = std::vector<std::string_view>;

/// Iterates over the lines with content.
class TableLines {
 public:
  explicit TableLines(std::string_view bytes) : rest_(without_bom(bytes)) {}

  bool next() {
    while (!rest_.empty()) {
      const std::size_t end = end_of_line(rest_);
      text_ = rest_.substr(0, end);
      ++number_;
      const bool is_pair = rest_.substr(end).starts_with("\r\n");
      rest_.remove_prefix(std::min(end + (is_pair ? 2 : 1), rest_.size()));
      const std::string_view content = trimmed(text_);
      if (!content.empty() && !content.starts_with('#')) return true;
    }
    return false;
  }
  std::string_view text() const { return text_; }
  std::uint64_t number() const { return number_; }
  std::uint64_t column_of(std::string_view field) const {
    return static_cast<std::uint64_t>(field.data() - text_.data()) + 1;
  }

 private:
  std::string_view rest_;
  std::string_view text_;
  std::uint64_t number_ = 0;
};

void split_at_blanks(std::string_view line, std::size_t most, Fields& out) {
  const char* at = line.data();
  const char* const end = at + line.size();
  while (out.size() < most) {
    while (at != end && is_blank(*at)) ++at;
    if (at == end) return;
    const char* const begin = at;
    while (at != end && !is_blank(*at)) ++at;
    out.emplace_back(begin, at);
  }
}

// Splits at separators; a quoted field may contain them.
void split_at(char separator, std::string_view line, std::size_t most, Fields& out) {
  while (out.size() < most) {
    const std::size_t skipped = std::min(line.find_first_not_of(separator == '\t' ? " " : " \t"), line.size());
    std::size_t from = 0;
    if (line.substr(skipped).starts_with('"')) {
      from = skipped + 1;
      while (from < line.size() && (line[from] != '"' || line.substr(from).starts_with("\"\"")))
        from += line[from] == '"' ? 2U : 1U;
      from = std::min(from, line.size());
    }
    const std::size_t end = std::min(line.find(separator, from), line.size());
    std::string_view field = trimmed(line.substr(0, end));
    if (field.size() >= 2 && field.starts_with('"') && field.ends_with('"'))
      field = trimmed(field.substr(1, field.size() - 2));
    out.push_back(field);
    if (end == line.size()) return;
    line.remove_prefix(end + 1);
  }
}

void split(const TableKind& kind, std::string_view line, std::size_t most, Fields& out) {
  out.clear();
  switch (kind.separator) {
    case TableSeparator::semicolon: return split_at(';', line, most, out);
    case TableSeparator::tabulator: return split_at('\t', line, most, out);
    case TableSeparator::comma: return split_at(',', line, most, out);
    case TableSeparator::blanks: return split_at_blanks(line, most, out);
  }
}

/// The meaning of the columns.
struct Columns {
  std::size_t x = 0;
  std::size_t y = 1;
  std::vector<std::size_t> groups;
  bool groups_are_closed = false;  ///< contours that do not repeat their first point are closed nevertheless
  bool is_guess = false;           ///< the names do not say which columns are x and y, and there are others

  std::size_t count() const {
    std::size_t last = std::max(x, y);
    for (const std::size_t group : groups) last = std::max(last, group);
    return last + 1;
  }
};

// No known word of a header is longer than this.
std::string word_of(std::string_view field) {
  return lower_case(field.substr(0, 64));
}

/// Whether these are the names of longitude and latitude.
bool are_degrees(std::string_view x, std::string_view y) {
  return (word_of(x) == "lon" || word_of(x) == "longitude") && (word_of(y) == "lat" || word_of(y) == "latitude");
}

bool are_on_earth(const std::vector<Vec2>& positions) {
  return std::ranges::all_of(positions, [](Vec2 p) { return std::abs(p.x) <= 180.0 && std::abs(p.y) <= 90.0; });
}

Columns columns_of(const Fields& header) {
  constexpr std::array<std::string_view, 7> kX{"x", "x1", "lon", "longitude", "easting", "east", "x_coord"};
  constexpr std::array<std::string_view, 7> kY{"y", "y1", "lat", "latitude", "northing", "north", "y_coord"};
  constexpr std::array<std::string_view, 10> kClosed{"contour", "contour_id", "ring", "ring_id", "polygon",
                                                     "poly",    "polygon_id", "loop", "loop_id", "outline"};
  constexpr std::array<std::string_view, 14> kAny{"id",    "part",     "part_id", "path",     "path_id",
                                                  "line",  "line_id",  "curve",   "stroke",   "group",
                                                  "shape", "shape_id", "piece",   "component"};
  constexpr std::array<std::string_view, 8> kTime{"t",        "time", "timestamp", "date",
                                                  "datetime", "year", "seconds",   "frame"};
  Columns columns;
  bool has_x = false;
  bool has_y = false;
  std::vector<std::size_t> others;
  std::vector<std::size_t> times;
  for (std::size_t i = 0; i < header.size(); ++i) {
    const std::string word = word_of(header[i]);
    if (!has_x && is_one_of(word, kX)) {
      columns.x = i;
      has_x = true;
    } else if (!has_y && is_one_of(word, kY)) {
      columns.y = i;
      has_y = true;
    } else if (is_one_of(word, kClosed)) {
      columns.groups.push_back(i);
      columns.groups_are_closed = true;
    } else if (is_one_of(word, kAny)) {
      columns.groups.push_back(i);
    } else if (is_one_of(word, kTime)) {
      times.push_back(i);
    } else {
      others.push_back(i);
    }
  }
  if (has_x && has_y) return columns;
  if (others.size() < 2) {
    others.insert(others.end(), times.begin(), times.end());
    std::ranges::sort(others);
    times.clear();
  }
  if (others.size() >= 2) {
    columns.x = others[0];
    columns.y = others[1];
  }
  columns.is_guess = others.size() + times.size() > 2;
  return columns;
}

bool is_number(std::string_view field, bool decimal_comma) {
  return parse_number(field, decimal_comma).has_value();
}

bool holds_a_point(const Fields& fields, const Columns& columns, bool decimal_comma) {
  return fields.size() > std::max(columns.x, columns.y) && is_number(fields[columns.x], decimal_comma) &&
         is_number(fields[columns.y], decimal_comma);
}

// "nan" and numbers beyond the range of doubles count: a line of these is bad data and not a header.
bool holds_a_number(const Fields& fields, bool decimal_comma) {
  return std::ranges::any_of(fields, [=](std::string_view field) {
    const auto value = parse_number(field, decimal_comma);
    return value || value.error() != NumberFault::not_a_number;
  });
}

/// The format of the table, and the first line of its rows.
struct Plan {
  TableKind kind;
  Columns columns;
  bool has_header = false;
  bool has_count_line = false;
  bool is_sure = false;  ///< the inspected lines fit
};

// If commas separate columns, a comma is a decimal sign only within quotes.
constexpr std::array<TableKind, 6> kKinds{{{TableSeparator::semicolon, true},
                                           {TableSeparator::tabulator, true},
                                           {TableSeparator::comma, false},
                                           {TableSeparator::comma, true},
                                           {TableSeparator::blanks, false},
                                           {TableSeparator::blanks, true}}};

Plan make_plan(std::string_view bytes) {
  TableLines lines(bytes);
  if (!lines.next()) return {};
  const std::string_view first = lines.text();
  const bool has_second = lines.next();
  const std::string_view second = has_second ? lines.text() : std::string_view{};
  Fields fields;

  Plan plan;
  for (const TableKind& kind : kKinds) {
    plan.kind = kind;
    plan.columns = {};
    plan.is_sure = true;
    split(kind, first, kMostColumns, fields);
    plan.kind.columns = fields.size();
    if (holds_a_point(fields, plan.columns, kind.decimal_comma)) {
      plan.columns.is_guess = kind.separator != TableSeparator::blanks &&
                              std::ranges::any_of(fields | std::views::drop(2), [&kind](std::string_view field) {
                                return is_number(field, kind.decimal_comma);
                              });
      return plan;
    }
    if (holds_a_number(fields, kind.decimal_comma)) continue;
    plan.columns = columns_of(fields);
    plan.has_header = true;
    split(kind, second, kMostColumns, fields);
    plan.kind.columns = fields.size();
    if (holds_a_point(fields, plan.columns, kind.decimal_comma)) return plan;
    plan.has_header = false;
  }
  if (parse_count(trimmed(first))) {
    // A line "n", then n rows.
    for (const TableKind& kind : kKinds) {
      plan.kind = kind;
      plan.columns = {};
      split(kind, second, kMostColumns, fields);
      plan.kind.columns = fields.size();
      plan.has_count_line = holds_a_point(fields, plan.columns, kind.decimal_comma);
      if (plan.has_count_line) return plan;
    }
  }

  // Nothing fits. Choose the nearest format, so that the reader stops at the faulty field.
  plan.is_sure = false;
  plan.columns = {};
  for (const TableKind& kind : kKinds) {
    plan.kind = kind;
    split(kind, first, kMostColumns, fields);
    if (fields.size() >= 2) break;
  }
  const bool header_alone = fields.size() >= 2 && !holds_a_number(fields, plan.kind.decimal_comma);
  if (header_alone) {
    const Columns columns = columns_of(fields);
    const bool names_both = columns.x < fields.size() && columns.y < fields.size() &&
                            word_of(fields[columns.x]) == "x" && word_of(fields[columns.y]) == "y";
    if (has_second || names_both) {
      plan.columns = columns;
      plan.has_header = true;
      plan.is_sure = names_both && !has_second;
    }
  }
  plan.kind.columns = fields.size();
  return plan;
}

/// Puts rows with the same value on one contour.
class Grouping {
 public:
  explicit Grouping(const Columns& columns) : columns_(columns) {}

  void add(const Fields& fields, std::uint32_t point) {
    if (columns_.groups.empty()) return;
    key_.clear();
    for (const std::size_t group : columns_.groups) {
      if (group < fields.size()) key_ += fields[group];
      key_ += '\x1f';
    }
    if (contours_.empty() || key_ != last_key_) {
      const auto [found, is_new] = index_of_.try_emplace(key_, contours_.size());
      if (is_new) contours_.emplace_back();
      last_ = found->second;
      last_key_ = key_;
    }
    contours_[last_].push_back(point);
  }

  /// Makes the contours of the finished table. A column that numbers the rows groups nothing.
  void finish(SampleData& data) && {
    if (columns_.groups.empty()) {
      contours_.emplace_back(data.positions.size());
      std::iota(contours_.front().begin(), contours_.front().end(), 0U);
    }
    const auto is_single = [](const std::vector<std::uint32_t>& points) { return points.size() < 2; };
    if (std::ranges::all_of(contours_, is_single)) return;

    std::vector<std::uint32_t> dropped;
    std::vector<bool> repeats;
    for (std::vector<std::uint32_t>& points : contours_) {
      constexpr std::size_t kTriangleAndRepetition = 4;
      repeats.push_back(points.size() >= kTriangleAndRepetition &&
                        data.positions[points.front()] == data.positions[points.back()]);
      if (!repeats.back()) continue;
      dropped.push_back(points.back());
      points.pop_back();
    }
    if (columns_.groups.empty() && dropped.empty()) return;
    const bool others_are_closed = dropped.empty() && columns_.groups_are_closed;
    drop(dropped, data.positions);
    for (std::size_t i = 0; i < contours_.size(); ++i)
      data.contours.push_back({repeats[i] || others_are_closed, std::move(contours_[i])});
  }

 private:
  void drop(std::vector<std::uint32_t>& dropped, std::vector<Vec2>& positions) {
    if (dropped.empty()) return;
    std::ranges::sort(dropped);
    constexpr std::uint32_t kGone = 0xffffffff;
    std::vector<std::uint32_t> new_index(positions.size());
    auto next_dropped = dropped.begin();
    std::uint32_t kept = 0;
    for (std::uint32_t i = 0; i < positions.size(); ++i) {
      if (next_dropped != dropped.end() && *next_dropped == i) {
        ++next_dropped;
        new_index[i] = kGone;
        continue;
      }
      positions[kept] = positions[i];
      new_index[i] = kept++;
    }
    positions.resize(kept);
    for (std::vector<std::uint32_t>& points : contours_)
      for (std::uint32_t& point : points) point = new_index[point];
  }

  const Columns& columns_;
  std::string key_;
  std::string last_key_;
  std::size_t last_ = 0;
  std::unordered_map<std::string, std::size_t> index_of_;
  std::vector<std::vector<std::uint32_t>> contours_;
};

// Reserves memory for all rows of a long table, by the size of the rows so far: reallocated memory is touched twice.
void make_room(std::vector<Vec2>& positions, std::size_t bytes_so_far, std::size_t bytes) {
  constexpr std::size_t kMany = 4096;
  const std::size_t count = positions.size();
  if (count < kMany || count < positions.capacity()) return;
  const double rows = static_cast<double>(count) / static_cast<double>(bytes_so_far) * static_cast<double>(bytes);
  positions.reserve(std::max(count + count / 4, static_cast<std::size_t>(1.01 * rows)));
}

}  // namespace

std::optional<TableKind> recognise_table(std::string_view bytes) {
  // A longer first line is not part of a table.
  constexpr std::size_t kLookedAt = std::size_t{1} << 20U;
  const Plan plan = make_plan(bytes.substr(0, kLookedAt));
  if (!plan.is_sure) return std::nullopt;
  return plan.kind;
}

Expected<LoadedFile> read_xy_table(std::string_view bytes, const std::string& name, ReadJob& job) {
  const Plan plan = make_plan(bytes);
  const Columns& columns = plan.columns;
  const std::size_t needed = columns.count();

  LoadedFile file;
  Grouping grouping(columns);
  CoordinateReader coordinates;
  TableLines lines(bytes);
  Fields fields;
  std::uint64_t announced = 0;
  std::uint64_t announced_line = 0;
  if ((plan.has_header || plan.has_count_line) && lines.next() && plan.has_count_line) {
    announced = parse_count(trimmed(lines.text())).value_or(0);
    announced_line = lines.number();
  }
  bool has_degrees = false;
  if (plan.has_header) {
    split(plan.kind, lines.text(), needed, fields);
    has_degrees = std::max(columns.x, columns.y) < fields.size() && are_degrees(fields[columns.x], fields[columns.y]);
  }
  if (columns.is_guess) {
    std::string text = fmt::format("x and y are the first two of {} columns", plan.kind.columns);
    if (plan.has_header) {
      text = fmt::format("x and y are the columns {} and {}", in_quotes(fields[columns.x]),
                         in_quotes(fields[columns.y]));
    }
    file.warnings.push_back(Error{ErrorCode::bad_input, std::move(text), name}.message());
  }
  while (lines.next()) {
    job.passed(lines.text().data());
    split(plan.kind, lines.text(), needed, fields);
    Vec2 point;
    for (double* coordinate : {&point.x, &point.y}) {
      const bool is_x = coordinate == &point.x;
      const std::size_t column = is_x ? columns.x : columns.y;
      const char which = is_x ? 'x' : 'y';
      if (column >= fields.size()) {
        // A lone word that is not a number: report the word, not the missing column.
        if (!is_x || fields.empty() || is_number(fields.back(), plan.kind.decimal_comma))
          return bad_input(fmt::format("expected a number for {}, found the end of the line", which), name,
                           lines.number(), lines.text().size() + 1);
        return bad_input(describe(NumberFault::not_a_number, fields.back()), name, lines.number(),
                         lines.column_of(fields.back()));
      }
      const std::string_view field = fields[column];
      if (field.empty())
        return bad_input(fmt::format("expected a number for {}, found nothing", which), name, lines.number(),
                         lines.column_of(field));
      auto value = coordinates.read(field, plan.kind.decimal_comma);
      if (!value) return bad_input(std::move(value.error()), name, lines.number(), lines.column_of(field));
      *coordinate = *value;
    }
    if (file.data.positions.size() == kMostSamples)
      return bad_input("there are too many samples", name, lines.number(), 1);
    grouping.add(fields, static_cast<std::uint32_t>(file.data.positions.size()));
    make_room(file.data.positions, static_cast<std::size_t>(fields.back().end() - bytes.begin()), bytes.size());
    file.data.positions.push_back(point);
  }
  if (file.data.positions.empty()) {
    if (!plan.has_header) return bad_input("there are no samples in it", name, 1, 1);
    file.warnings.push_back(Error{ErrorCode::bad_input, "there are no samples after the header", name}.message());
  }
  if (const std::size_t found = file.data.positions.size(); plan.has_count_line && announced != found) {
    std::string text = fmt::format("{} samples are announced, there are {}", announced, found);
    file.warnings.push_back(Error{ErrorCode::bad_input, std::move(text), name, announced_line, 1}.message());
  }
  std::move(grouping).finish(file.data);
  file.has_degrees = has_degrees && !file.data.positions.empty() && are_on_earth(file.data.positions);
  return file;
}

}  // namespace mes
