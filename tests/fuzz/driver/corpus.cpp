// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/driver/corpus.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>

namespace mes::fuzz {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void give_up(const fs::path& file, const char* what) {
  std::fprintf(stderr, "%s: %s\n", file.c_str(), what);
  std::exit(EXIT_FAILURE);
}

Input read_input(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) give_up(file, "cannot be read");
  return {{std::istreambuf_iterator<char>(stream), {}}, file.string()};
}

/// FNV-1a.
std::uint64_t hash_of(const std::string& bytes) {
  std::uint64_t out = 0xcbf29ce484222325U;
  for (const char byte : bytes) out = (out ^ static_cast<unsigned char>(byte)) * 0x100000001b3U;
  return out;
}

}  // namespace

std::vector<Input> read_inputs(std::span<const fs::path> places) {
  std::vector<Input> out;
  for (const fs::path& place : places) {
    if (!fs::is_directory(place)) {
      if (fs::exists(place)) out.push_back(read_input(place));
      continue;
    }
    std::vector<fs::path> files;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(place))
      if (entry.is_regular_file()) files.push_back(entry.path());
    std::ranges::sort(files);
    for (const fs::path& file : files) out.push_back(read_input(file));
  }
  return out;
}

fs::path keep_input(const fs::path& folder, const std::string& prefix, const std::string& bytes) {
  fs::create_directories(folder);
  char name[17];
  std::snprintf(name, sizeof name, "%016llx", static_cast<unsigned long long>(hash_of(bytes)));
  const fs::path file = folder / (prefix + name);
  std::ofstream stream(file, std::ios::binary);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  stream.close();
  if (!stream) give_up(file, "cannot be written");
  return file;
}

}  // namespace mes::fuzz
