// SPDX-License-Identifier: GPL-3.0-or-later
// The file with the sizes of contours beside a POFF file. The first byte is the number of points.
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "tests/fuzz/sample_files.h"

namespace {

namespace fs = std::filesystem;

/// A folder of this process, gone at the end of the run.
struct Folder {
  fs::path path = fs::temp_directory_path() / ("mesecina-fuzz-" + std::to_string(::getpid()));
  Folder() { fs::create_directories(path); }
  ~Folder() {
    std::error_code error;
    fs::remove_all(path, error);
  }
};

void write(const fs::path& file, std::string_view bytes) {
  std::ofstream(file, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

}  // namespace

void mes::fuzz::run_contours(std::string_view bytes) {
  if (bytes.empty()) return;
  const std::size_t count = first_byte(bytes) % 100U;
  const Folder folder;
  std::string points = "POFF " + std::to_string(count) + " 0 0\n";
  for (std::size_t i = 0; i < count; ++i) points += std::to_string(i) + " 0\n";
  write(folder.path / "a.poff", points);
  write(folder.path / "a.contours", bytes.substr(1));
  const auto file = mes::read_sample_file(folder.path / "a.poff");
  require(file && file->data.positions.size() == count, "the points are read whatever lies beside them");
  for (const std::string& warning : file->warnings) require_message(warning);
  std::size_t in_contours = 0;
  for (const auto& contour : file->data.contours)
    for (const std::uint32_t point : contour.points)
      require(contour.closed && point == in_contours++, "contours are closed and in the order of the file");
  require(in_contours == (file->data.contours.empty() ? 0 : count), "contours take all points or there are none");
  require(file->data.contours.empty() || file->warnings.empty(), "contours are taken or complained about");
  require_round_trip(file->data);
}
