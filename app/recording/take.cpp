// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recording/take.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <ctime>
#include <nlohmann/json.hpp>
#include <system_error>

#include "core/base/base64.h"
#include "core/base/carried_session.h"
#include "core/io/carried_session.h"
#include "core/io/files/read_file.h"
#include "core/io/session/json_text.h"

namespace mes {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

constexpr int kTakeSchema = 1;
// More equal names than this within one second are an error.
constexpr int kMostTwins = 10'000;

std::string time_text(std::chrono::system_clock::time_point now) {
  const std::time_t seconds = std::chrono::system_clock::to_time_t(now);
  std::tm parts{};
  ::localtime_r(&seconds, &parts);
  std::array<char, 32> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%d-%H%M%S", &parts);
  return text.data();
}

std::unexpected<Error> cannot_make(const fs::path& path, const std::string& why) {
  return std::unexpected(Error{ErrorCode::cannot_write, "cannot be made: " + why, path.string()});
}

std::string twin_suffix(int twin) {
  return twin == 1 ? "" : fmt::format("-{}", twin);
}

std::string hex(std::uint64_t value) {
  return fmt::format("{:016x}", value);
}

std::uint64_t unhex(const std::string& text) {
  return std::strtoull(text.c_str(), nullptr, 16);
}

// Missing values, and values of another type, give the default.
template <class T>
T value_of(const json& object, const char* key, T otherwise) {
  const auto entry = object.find(key);
  if (entry == object.end()) return otherwise;
  if constexpr (std::is_same_v<T, std::string>)
    return entry->is_string() ? entry->get<std::string>() : otherwise;
  else if constexpr (std::is_same_v<T, bool>)
    return entry->is_boolean() ? entry->get<bool>() : otherwise;
  else
    return entry->is_number() ? entry->get<T>() : otherwise;
}

Expected<Manifest> read_manifest(const fs::path& file) {
  std::error_code error;
  if (!fs::exists(file, error)) return Manifest{};
  const auto bytes = read_regular_file(file);
  const json object = bytes ? parse_json(*bytes) : json();
  if (!object.is_object())
    return std::unexpected(Error{ErrorCode::bad_input, "not a manifest of a take", file.string()});
  if (value_of(object, "schema", 0) != kTakeSchema)
    return std::unexpected(Error{ErrorCode::bad_input, "a manifest of another version", file.string()});
  Manifest out;
  out.format = {value_of(object, "width", 0), value_of(object, "height", 0), value_of(object, "fps", 0.0)};
  out.complete = value_of(object, "complete", false);
  out.problem = value_of(object, "problem", std::string());
  if (const auto frames = object.find("frames"); frames != object.end() && frames->is_array()) {
    for (const json& frame : *frames) {
      if (!frame.is_object()) continue;
      out.frames.push_back({value_of(frame, "interaction", std::string()),
                            unhex(value_of(frame, "document", std::string())), value_of(frame, "seconds", 0.0)});
    }
  }
  return out;
}

}  // namespace

Expected<Take> begin_take(const fs::path& parent, const TakeFormat& format,
                          std::chrono::system_clock::time_point now) {
  std::error_code error;
  fs::create_directories(parent, error);
  if (error) return cannot_make(parent, error.message());
  const fs::path base = parent / ("take-" + time_text(now));
  for (int twin = 1; twin < kMostTwins; ++twin) {
    const fs::path folder = base.string() + twin_suffix(twin);
    if (fs::create_directory(folder, error)) return Take{folder, format};
    if (error && error != std::errc::file_exists) return cannot_make(folder, error.message());
  }
  return cannot_make(base, "all its names are taken");
}

Expected<fs::path> claim_file(const fs::path& folder, const std::string& stem, const std::string& extension,
                              std::chrono::system_clock::time_point now) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) return cannot_make(folder, error.message());
  const std::string base = stem + '-' + time_text(now);
  for (int twin = 1; twin < kMostTwins; ++twin) {
    fs::path file = folder / (base + twin_suffix(twin) + '.' + extension);
    const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor >= 0) {
      ::close(descriptor);
      return file;
    }
    if (errno != EEXIST) return cannot_make(file, std::generic_category().message(errno));
  }
  return cannot_make(folder / base, "all its names are taken");
}

std::string frame_name(std::uint64_t number) {
  return fmt::format("{:05}.png", number);
}

std::string manifest_text(const Manifest& manifest) {
  json frames = json::array();
  std::uint64_t number = 0;
  for (const FrameInfo& frame : manifest.frames) {
    ++number;
    frames.push_back({{"number", number},
                      {"file", frame_name(number)},
                      {"interaction", frame.what},
                      {"document", hex(frame.document)},
                      {"seconds", frame.seconds}});
  }
  json object = {{"schema", kTakeSchema},          {"version", MESECINA_VERSION},
                 {"width", manifest.format.width}, {"height", manifest.format.height},
                 {"fps", manifest.format.fps},     {"complete", manifest.complete},
                 {"frames", std::move(frames)}};
  if (!manifest.problem.empty()) object["problem"] = manifest.problem;
  if (!manifest.session.empty()) object[std::string(kCarriedSession)] = base64(manifest.session);
  // The kind of the file comes first, where readers look for it.
  return std::string(kManifestBeginning) + json_text(object, 1).substr(1) + '\n';
}

Expected<Manifest> read_take(const fs::path& folder) {
  auto manifest = read_manifest(folder / kManifestName);
  if (!manifest) return manifest;
  std::vector<FrameInfo> found;
  std::error_code error;
  while (fs::is_regular_file(folder / frame_name(found.size() + 1), error)) {
    const std::size_t known = found.size();
    found.push_back(known < manifest->frames.size() ? manifest->frames[known] : FrameInfo{});
  }
  if (found.empty())
    return std::unexpected(Error{ErrorCode::bad_input, "this folder holds no frames of a take", folder.string()});
  manifest->frames = std::move(found);
  return manifest;
}

}  // namespace mes
