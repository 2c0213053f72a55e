// SPDX-License-Identifier: GPL-3.0-or-later
// CSV and npy files of a table read back as what the table holds.
#include <array>
#include <catch2/catch.hpp>
#include <cstring>
#include <limits>
#include <sstream>
#include <string>

#include "core/graph/table_maker.h"
#include "core/graph/write_table.h"

using namespace mes;

namespace {

enum class Shade : std::uint8_t { light, dark };
using TileSlot = Slot<struct TileTag>;
struct Tile {
  TileSlot next[2]{};
  Vec2 at{};
  double size = 0.0;
  Shade shade = Shade::light;
  std::uint8_t is_dead = 0;
  std::int8_t sign = 0;
};

constexpr TileSlot kFarTile{0xfffffffeU};

Table<TileSlot, Tile> some_tiles() {
  Table<TileSlot, Tile> out;
  out.push_back({{TileSlot(2), kNoSlot}, {0.1, -1.0 / 3.0}, 1e300, Shade::dark, 0, -1});
  out.push_back({{}, {}, 0.0, Shade::light, 1, 0});
  out.push_back(
      {{kFarTile, TileSlot(0)}, {5e-324, 2.0}, std::numeric_limits<double>::infinity(), Shade::light, 0, 1});
  return out;
}

TableColumns columns_of(const Table<TileSlot, Tile>& tiles) {
  TableMaker<TileSlot> out("tiles", "Tiles of a test", tiles.size(),
                           [&tiles](TileSlot row) { return tiles[row].is_dead == 0; });
  out.reference("next", "Neighbours", tiles, &Tile::next, {"test/tiles", kFarTile.index()});
  out.column("position", "Where it is", tiles, &Tile::at);
  out.column("size", "How large it is", tiles, &Tile::size);
  out.column("shade", "0 light, 1 dark", tiles, &Tile::shade);
  out.flag("is_dead", "It is no more", tiles, &Tile::is_dead);
  out.column("sign", "-1, 0 or 1", tiles, &Tile::sign);
  out.computed("half", "Half the size of what is small",
               [&tiles](TileSlot row) { return tiles[row].at.x > 0.01 ? 0.5 * tiles[row].at.x : kNoValue; });
  out.computed("is_big", "Wide and high", [](TileSlot row) {
    return std::array{row.index() == 0, row.index() == 2};
  });
  return out.take();
}

std::string written(const TableColumns& table, TableFormat format) {
  std::string out;
  write_table(table, format, [&out](std::string_view piece) { out += piece; });
  return out;
}

template <class WrittenValue>
WrittenValue read(const std::string& bytes, std::size_t& at) {
  WrittenValue out;
  REQUIRE(at + sizeof(WrittenValue) <= bytes.size());
  std::memcpy(&out, bytes.data() + at, sizeof(WrittenValue));
  at += sizeof(WrittenValue);
  return out;
}

}  // namespace

TEST_CASE("Type, width and stride of a column follow from the C++ type") {
  const Table<TileSlot, Tile> tiles = some_tiles();
  const TableColumns table = columns_of(tiles);
  REQUIRE(table.rows == 3);
  const std::array<ColumnType, 8> types{ColumnType::uint32,  ColumnType::float64, ColumnType::float64,
                                        ColumnType::uint8,   ColumnType::boolean, ColumnType::int8,
                                        ColumnType::float64, ColumnType::boolean};
  const std::array<unsigned, 8> widths{2, 2, 1, 1, 1, 1, 1, 2};
  REQUIRE(table.columns.size() == types.size());
  for (std::size_t i = 0; i < types.size(); ++i) {
    CHECK(table.columns[i].type == types[i]);
    CHECK(table.columns[i].width == widths[i]);
    CHECK(table.columns[i].is_stored() == (i < 6));
    if (i < 6) CHECK(table.columns[i].stride == sizeof(Tile));
  }
  CHECK(table.columns[2].data == &tiles[TileSlot(0)].size);
  // Computed values of a dead row are not asked for.
  double half = 1.0;
  table.columns[6].copy_row(1, &half);
  CHECK(half == 0.0);
}

TEST_CASE("CSV has a line a row that is alive, and empty fields for what is none") {
  const Table<TileSlot, Tile> tiles = some_tiles();
  CHECK(written(columns_of(tiles), TableFormat::csv) ==
        "row,next_0,next_1,position_x,position_y,size,shade,is_dead,sign,half,is_big_0,is_big_1\n"
        "0,2,,0.1,-0.3333333333333333,1e+300,1,0,-1,0.05,1,0\n"
        "2,inf,0,5e-324,2,inf,0,0,1,,0,1\n");
  CHECK(written(columns_of({}), TableFormat::csv) ==
        "row,next_0,next_1,position_x,position_y,size,shade,is_dead,sign,half,is_big_0,is_big_1\n");
}

TEST_CASE("An npy file is a header of version 1.0 and all rows side by side") {
  const Table<TileSlot, Tile> tiles = some_tiles();
  const std::string bytes = written(columns_of(tiles), TableFormat::npy);
  REQUIRE(bytes.substr(0, 8) == std::string("\x93NUMPY\x01\x00", 8));
  std::size_t at = 8;
  const std::size_t size = read<std::uint16_t>(bytes, at);
  CHECK((at + size) % 64 == 0);
  const std::string header = bytes.substr(at, size);
  CHECK(header.find_last_not_of(" \n") == header.rfind('}'));
  CHECK(header.back() == '\n');
  CHECK(header.substr(0, header.rfind('}') + 1) ==
        "{'descr': [('is_alive', '|b1'), ('next', '<u4', (2,)), ('position', '<f8', (2,)), ('size', '<f8'), "
        "('shade', '|u1'), ('is_dead', '|b1'), ('sign', '|i1'), ('half', '<f8'), ('is_big', '|b1', (2,))], "
        "'fortran_order': False, 'shape': (3,), }");
  at += size;
  for (const TileSlot row : tiles.rows()) {
    const Tile& tile = tiles[row];
    CHECK(read<std::uint8_t>(bytes, at) == (tile.is_dead == 0 ? 1 : 0));
    CHECK(read<std::uint32_t>(bytes, at) == tile.next[0].index());
    CHECK(read<std::uint32_t>(bytes, at) == tile.next[1].index());
    CHECK(read<double>(bytes, at) == tile.at.x);
    CHECK(read<double>(bytes, at) == tile.at.y);
    CHECK(read<double>(bytes, at) == tile.size);
    CHECK(read<std::uint8_t>(bytes, at) == static_cast<std::uint8_t>(tile.shade));
    CHECK(read<std::uint8_t>(bytes, at) == tile.is_dead);
    CHECK(read<std::int8_t>(bytes, at) == tile.sign);
    const double half = read<double>(bytes, at);
    if (row == TileSlot(0)) CHECK(half == 0.05);
    if (row == TileSlot(2)) CHECK(half != half);
    CHECK(read<std::uint8_t>(bytes, at) == (row == TileSlot(0) ? 1 : 0));
    CHECK(read<std::uint8_t>(bytes, at) == (row == TileSlot(2) ? 1 : 0));
  }
  CHECK(at == bytes.size());
}

TEST_CASE("A long table is written in pieces") {
  Table<TileSlot, double> values;
  for (int i = 0; i < 20'000; ++i) values.push_back(0.1 * i);
  TableMaker<TileSlot> maker("values", "Numbers", values.size(), [](TileSlot) { return true; });
  maker.column("value", "A number", values);
  const TableColumns table = maker.take();
  std::size_t pieces = 0, largest = 0;
  std::string text;
  write_table(table, TableFormat::csv, [&](std::string_view piece) {
    ++pieces;
    largest = std::max(largest, piece.size());
    text += piece;
  });
  CHECK(pieces > 3);
  CHECK(largest < 70'000);
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  for (std::size_t i = 0; i < values.size(); ++i) {
    REQUIRE(std::getline(lines, line));
    REQUIRE(std::stod(line.substr(line.find(',') + 1)) == values[TileSlot(i)]);
  }
  CHECK_FALSE(std::getline(lines, line));
}

TEST_CASE("Formats of tables are found by their names") {
  CHECK(find_table_format("csv") == TableFormat::csv);
  CHECK(find_table_format("npy") == TableFormat::npy);
  CHECK_FALSE(find_table_format("xlsx").has_value());
  CHECK(name_of(TableFormat::npy) == "npy");
}

TEST_CASE("Values of a row are said as text") {
  const Table<TileSlot, Tile> tiles = some_tiles();
  CHECK(row_texts(columns_of(tiles), 2) ==
        std::vector<std::string>{"inf, 0", "5e-324, 2", "inf", "0", "no", "1", "none", "no, yes"});
}
