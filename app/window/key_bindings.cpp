// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/key_bindings.h"

#include <fmt/core.h>
#include <fstream>
#include <optional>
#include <sstream>
#include <utility>

#include "app/system/data_folder.h"
#include "core/io/files/atomic_file.h"

namespace mes {
namespace {

constexpr std::uintmax_t kLargestFile = 1U << 20U;

Keymap chosen(const Settings& settings) {
  return settings.classic_keys ? Keymap::classic() : Keymap::standard();
}

std::optional<std::string> text_of(const std::filesystem::path& path) {
  std::error_code error;
  // Opening a pipe would block until it is written to.
  if (!std::filesystem::is_regular_file(path, error) || std::filesystem::file_size(path, error) > kLargestFile)
    return std::nullopt;
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream bytes;
  if (std::filesystem::file_size(path, error) != 0) bytes << stream.rdbuf();
  if (!stream) return std::nullopt;
  return bytes.str();
}

}  // namespace

std::filesystem::path KeyBindings::file() {
  const std::filesystem::path folder = config_folder();
  return folder.empty() ? folder : folder / "keys.conf";
}

KeyBindings::KeyBindings(Settings& settings, Messages& messages) : settings_(settings), messages_(messages) {
  std::error_code error;
  if (!file().empty() && std::filesystem::exists(file(), error))
    read();
  else
    apply();
}

void KeyBindings::read() {
  const std::filesystem::path path = file();
  if (auto text = text_of(path))
    text_ = std::move(*text);
  else
    messages_.problem(path.string() + " cannot be read; the keys are as they were");
  apply();
  const KeymapFile read = read_keymap(chosen(settings_), text_);
  if (read.problems.empty()) return;
  std::string all;
  for (const std::string& problem : read.problems) all += (all.empty() ? "" : "; ") + problem;
  messages_.problem(fmt::format("{}: {}. Everything else in it holds.", path.string(), all));
}

void KeyBindings::apply() {
  actions_.set_keymap(read_keymap(chosen(settings_), text_).keymap);
}

void KeyBindings::write() {
  const std::filesystem::path path = file();
  std::error_code error;
  if (std::filesystem::exists(path, error)) {
    messages_.clear_problem();
    messages_.remark("The keys are those of " + path.string());
    read();
    return;
  }
  std::filesystem::create_directories(path.parent_path(), error);
  if (const auto done = write_file_atomically(path, keymap_template(actions_.keymap())); !done)
    messages_.problem(done.error().message());
  else
    messages_.remark("All commands and their keys are in " + path.string());
}

void KeyBindings::bind() {
  actions_.bind(ActionId::classic_keys, {[this] {
                                           settings_.classic_keys = !settings_.classic_keys;
                                           apply();
                                         },
                                         {},
                                         [this] { return settings_.classic_keys; }});
  actions_.bind(ActionId::write_keys,
                {[this] { write(); }, {[] { return !file().empty(); }, "there is no folder for settings"}});
}

}  // namespace mes
