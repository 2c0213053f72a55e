// SPDX-License-Identifier: GPL-3.0-or-later
// Where experiments are written, compiled and run.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "tests/cli/output_of.h"
#include "tests/cli/run_binary.h"
#include "tests/io/temporary_folder.h"

namespace mes::test {

namespace fs = std::filesystem;

inline std::string content_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// A compiler that counts how often it was called and optimises little, which is quicker, and a cache of its own.
class Workshop {
 public:
  Workshop() {
    std::ofstream(compiler()) << "#!/bin/sh\necho called >>'" << calls_file().string() << "'\nexec c++ \"$@\" -O1\n";
    fs::permissions(compiler(), fs::perms::owner_all);
  }
  fs::path operator/(const std::string& name) const { return folder_ / name; }
  RunOptions options() const {
    return {.environment = {"CXX=" + compiler().string(), "XDG_CACHE_HOME=" + (folder_ / "cache").string()}};
  }
  RunResult run(const std::vector<std::string>& arguments) const { return mes::test::run(arguments, options()); }
  std::string output_of(const std::vector<std::string>& arguments) const {
    return mes::test::output_of(arguments, options());
  }
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return (folder_ / name).string();
  }
  std::size_t calls() const {
    const std::string text = content_of(calls_file());
    return static_cast<std::size_t>(std::ranges::count(text, '\n'));
  }

 private:
  fs::path compiler() const { return folder_ / "counting-compiler"; }
  fs::path calls_file() const { return folder_ / "calls"; }
  TemporaryFolder folder_;
};

}  // namespace mes::test
