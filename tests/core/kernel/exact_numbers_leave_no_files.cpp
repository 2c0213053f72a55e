// SPDX-License-Identifier: GPL-3.0-or-later
// CORE warns of doubtful divisions in a file of the current folder, unless third_party/cgal_core keeps it from that.
#include <CGAL/CORE_Expr.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <stdexcept>

#include "tests/io/temporary_folder.h"

namespace fs = std::filesystem;

namespace {

/// In an empty folder as long as it lives.
class InFolder {
 public:
  InFolder() { fs::current_path(folder_.path()); }
  ~InFolder() { fs::current_path(before_); }
  InFolder(const InFolder&) = delete;
  InFolder& operator=(const InFolder&) = delete;
  bool is_empty() const { return fs::is_empty(folder_.path()); }

 private:
  fs::path before_ = fs::current_path();
  mes::test::TemporaryFolder folder_;
};

}  // namespace

TEST_CASE("a divisor whose double is zero is divided by exactly, and warned of nowhere") {
  const InFolder here;
  // 2^-60, of which nothing is left beside 1 in doubles.
  const CORE::Expr small = CORE::Expr(1) + CORE::Expr(0x1p-60) - CORE::Expr(1);
  CHECK(CORE::Expr(1) / small == CORE::Expr(0x1p60));
  CHECK(here.is_empty());
}

TEST_CASE("an error of CORE is thrown, division by zero among them") {
  const InFolder here;
  CHECK_THROWS_AS(CORE::Expr(1) / CORE::Expr(0), std::domain_error);
  CHECK_THROWS_AS(CORE::core_error("an error", __FILE__, __LINE__, true), std::domain_error);
  CHECK_NOTHROW(CORE::core_error("a warning", __FILE__, __LINE__, false));
  CHECK(here.is_empty());
}
