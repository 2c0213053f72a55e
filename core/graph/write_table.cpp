// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graph/write_table.h"

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>
#include <vector>

#include "core/base/assert.h"

namespace mes {
namespace {

constexpr std::array<std::pair<TableFormat, std::string_view>, 2> kTableFormats{
    {{TableFormat::csv, "csv"}, {TableFormat::npy, "npy"}}};

/// Passes text on in pieces.
class PieceWriter {
 public:
  explicit PieceWriter(const TableSink& sink) : sink_(sink) {}
  std::string& text() { return text_; }
  void end_row() {
    constexpr std::size_t kPiece = std::size_t{1} << 16U;
    if (text_.size() >= kPiece) flush();
  }
  void flush() {
    if (!text_.empty()) sink_(text_);
    text_.clear();
  }

 private:
  const TableSink& sink_;
  std::string text_;
};

template <class Value>
Value value_at(const std::byte* at) {
  Value out;
  std::memcpy(&out, at, sizeof(Value));
  return out;
}

template <class Number>
void append_number_to(std::string& out, Number number) {
  std::array<char, 32> digits;
  const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), number);
  MES_ASSERT(error == std::errc());
  out.append(digits.data(), end);
}

/// Appends nothing if there is no value.
void append_value(std::string& out, const TableColumn& column, const std::byte* at) {
  switch (column.type) {
    case ColumnType::float64:
      if (const auto number = value_at<double>(at); !std::isnan(number)) append_number_to(out, number);
      return;
    case ColumnType::uint32: {
      const auto number = value_at<std::uint32_t>(at);
      if (column.is_reference && number == kNoRow) return;
      if (column.infinity == number) {
        out += "inf";
        return;
      }
      return append_number_to(out, number);
    }
    case ColumnType::uint8: return append_number_to(out, unsigned{value_at<std::uint8_t>(at)});
    case ColumnType::int8: return append_number_to(out, int{value_at<std::int8_t>(at)});
    case ColumnType::boolean: out += value_at<std::uint8_t>(at) != 0 ? '1' : '0';
  }
}

/// Calls `visit(column, at)` for each value of a row in turn.
template <class Visit>
void for_each_value(const TableColumns& table, RowNumber row, std::vector<std::byte>& room, Visit visit) {
  for (const TableColumn& column : table.columns) {
    room.resize(column.row_size());
    column.copy_row(row, room.data());
    for (unsigned part = 0; part < column.width; ++part)
      visit(column, part, room.data() + part * size_of(column.type));
  }
}

void write_csv(const TableColumns& table, PieceWriter& out) {
  out.text() += "row";
  for (const TableColumn& column : table.columns)
    for (unsigned part = 0; part < column.width; ++part) out.text() += ',' + column.name_of(part);
  out.text() += '\n';
  std::vector<std::byte> room;
  for (RowNumber row = 0; row < table.rows; ++row) {
    if (!table.is_alive(row)) continue;
    append_number_to(out.text(), row);
    for_each_value(table, row, room, [&](const TableColumn& column, unsigned, const std::byte* at) {
      out.text() += ',';
      append_value(out.text(), column, at);
    });
    out.text() += '\n';
    out.end_row();
  }
}

std::string_view numpy_type(ColumnType type) {
  switch (type) {
    case ColumnType::float64: return "<f8";
    case ColumnType::uint32: return "<u4";
    case ColumnType::uint8: return "|u1";
    case ColumnType::int8: return "|i1";
    case ColumnType::boolean: return "|b1";
  }
  return {};
}

/// The header of an array, as a Python dictionary.
std::string numpy_header(const TableColumns& table) {
  std::string out = "{'descr': [('is_alive', '|b1')";
  for (const TableColumn& column : table.columns) {
    out += ", ('" + column.name + "', '" + std::string(numpy_type(column.type)) + "'";
    if (column.width > 1) out += ", (" + std::to_string(column.width) + ",)";
    out += ")";
  }
  return out + "], 'fortran_order': False, 'shape': (" + std::to_string(table.rows) + ",), }";
}

void write_npy(const TableColumns& table, PieceWriter& out) {
  static_assert(std::endian::native == std::endian::little);
  constexpr std::size_t kAlignment = 64;
  constexpr std::string_view kMagic("\x93NUMPY\x01\x00", 8);
  std::string header = numpy_header(table);
  const std::size_t before = kMagic.size() + 2;
  // Spaces and a line end pad the header, so that values begin at a multiple of the alignment.
  header.append(kAlignment - 1 - (before + header.size()) % kAlignment, ' ');
  header += '\n';
  MES_ASSERT(header.size() <= std::numeric_limits<std::uint16_t>::max());
  out.text() += kMagic;
  out.text() += static_cast<char>(header.size() & 0xffU);
  out.text() += static_cast<char>(header.size() >> 8U);
  out.text() += header;
  for (RowNumber row = 0; row < table.rows; ++row) {
    out.text() += table.is_alive(row) ? '\1' : '\0';
    for (const TableColumn& column : table.columns) {
      const std::size_t begin = out.text().size();
      out.text().resize(begin + column.row_size());
      column.copy_row(row, out.text().data() + begin);
    }
    out.end_row();
  }
}

}  // namespace

std::string_view name_of(TableFormat format) {
  return kTableFormats[static_cast<std::size_t>(format)].second;
}

std::optional<TableFormat> find_table_format(std::string_view name) {
  for (const auto& [format, its_name] : kTableFormats)
    if (its_name == name) return format;
  return std::nullopt;
}

void write_table(const TableColumns& table, TableFormat format, const TableSink& sink) {
  PieceWriter out(sink);
  switch (format) {
    case TableFormat::csv: write_csv(table, out); break;
    case TableFormat::npy: write_npy(table, out); break;
  }
  out.flush();
}

std::vector<std::string> row_texts(const TableColumns& table, RowNumber row) {
  std::vector<std::string> out;
  std::vector<std::byte> room;
  for_each_value(table, row, room, [&](const TableColumn& column, unsigned part, const std::byte* at) {
    if (part == 0) out.emplace_back();
    if (part != 0) out.back() += ", ";
    const std::size_t before = out.back().size();
    if (column.type == ColumnType::boolean) {
      out.back() += value_at<std::uint8_t>(at) != 0 ? "yes" : "no";
    } else {
      append_value(out.back(), column, at);
    }
    if (out.back().size() == before) out.back() += "none";
  });
  return out;
}

}  // namespace mes
