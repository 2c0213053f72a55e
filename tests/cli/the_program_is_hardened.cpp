// SPDX-License-Identifier: GPL-3.0-or-later
// What the compiler and the linker were asked for is in the program.
#include <array>
#include <catch2/catch.hpp>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>

#include "tests/io/temporary_folder.h"

namespace {

std::string said_by_readelf(const std::string& options) {
  const std::string command = "readelf -W " + options + " '" + std::getenv("MESECINA_BINARY") + "'";
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(::popen(command.c_str(), "r"), ::pclose);
  REQUIRE(pipe);
  std::string out;
  std::array<char, 4096> piece{};
  while (std::fgets(piece.data(), piece.size(), pipe.get()) != nullptr) out += piece.data();
  return out;
}

}  // namespace

TEST_CASE("tables of functions are complete and read only before anything runs") {
  CHECK_THAT(said_by_readelf("--program-headers"), Catch::Contains("GNU_RELRO"));
  CHECK_THAT(said_by_readelf("--dynamic"), Catch::Contains("BIND_NOW"));
}

TEST_CASE("the stack is guarded, and functions of the C library check what they write to") {
  const std::string symbols = said_by_readelf("--dyn-syms");
  CHECK_THAT(symbols, Catch::Contains("__stack_chk_fail"));
  CHECK_THAT(symbols, Catch::Contains("__snprintf_chk"));
}

TEST_CASE("nothing in the program says where it was built") {
  const std::string bytes = mes::test::contents_of(std::getenv("MESECINA_BINARY"));
  REQUIRE(bytes.size() > 100000);
  // Not compared within CHECK, which would print the program.
  const bool is_named = bytes.find(std::filesystem::current_path().string()) != std::string::npos;
  CHECK_FALSE(is_named);
}
