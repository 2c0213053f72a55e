// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/store/looks/window_bundles.h"

#include <fmt/core.h>
#include <algorithm>

#include "core/io/bundle_file.h"
#include "core/io/files/atomic_file.h"
#include "core/io/text/text_numbers.h"

namespace mes {

namespace fs = std::filesystem;

WindowBundles::WindowBundles(fs::path file, const fs::path& assets, LayerStack& layers)
    : layers_(layers), store_(layers.descriptors(), std::move(file)) {
  StartingBundles starting = read_starting_bundles(layers.descriptors(), assets);
  starting_ = std::move(starting.bundles);
  BundleStore::Loaded loaded = store_.load(starting_);
  list_.replace(std::move(loaded.bundles));
  message_ = loaded.message.empty() ? std::move(starting.message) : std::move(loaded.message);
}

std::optional<std::size_t> WindowBundles::current() const {
  const Bundle* const found = list_.find(current_.name());
  if (found == nullptr) return std::nullopt;
  return static_cast<std::size_t>(found - list_.bundles().data());
}

Expected<void> WindowBundles::write() {
  offers_undo_ = true;
  auto written = store_.write(list_.bundles());
  if (!written) return std::unexpected(written.error());
  if (!written->message.empty()) message_ = std::move(written->message);
  if (!std::ranges::equal(written->bundles, list_.bundles())) list_.replace(std::move(written->bundles));
  return {};
}

void WindowBundles::choose(std::size_t index, const LayerConfiguration& as) {
  current_.choose(list_.bundles()[index].name, as, layers_);
  offers_undo_ = false;
}

void WindowBundles::replace_layers(const std::function<void()>& replace) {
  const bool is_shown = current() && !is_changed();
  replace();
  store_.set_descriptors(layers_.descriptors());
  if (is_shown) current_.note_saved(current_.name(), layers_);
}

Expected<void> WindowBundles::save(const std::string& name) {
  auto checked = checked_bundle_name(name);
  if (!checked) return std::unexpected(checked.error());
  if (auto saved = list_.save(*checked, layers_.configuration()); !saved) return saved;
  current_.note_saved(std::move(*checked), layers_);
  return write();
}

Expected<void> WindowBundles::rename(std::size_t index, const std::string& name) {
  const bool is_current = current() == index;
  if (auto renamed = list_.rename(index, name); !renamed) return renamed;
  if (is_current) current_.note_renamed(list_.bundles()[index].name);
  return write();
}

Expected<void> WindowBundles::move(std::size_t index, std::size_t to) {
  list_.move(index, to);
  return write();
}

Expected<void> WindowBundles::remove(std::size_t index) {
  list_.remove(index);
  return write();
}

Expected<void> WindowBundles::undo() {
  list_.undo();
  auto written = write();
  offers_undo_ = false;
  return written;
}

Expected<std::string> WindowBundles::import(const fs::path& file) {
  const auto loaded = read_bundle_file(file, known_layers(layers_.descriptors()));
  if (!loaded) return std::unexpected(loaded.error());
  const std::vector<std::string> names = list_.import(loaded->bundles);
  auto written = write();
  if (const Bundle* first = list_.find(names.front())) current_.choose(*first, layers_);
  if (!written) return std::unexpected(written.error());
  if (!loaded->warnings.empty()) return loaded->warnings.front();
  return names.size() == 1 ? fmt::format("Imported the bundle {}", in_quotes(names.front()))
                           : fmt::format("Imported {} bundles", names.size());
}

Expected<void> WindowBundles::add_starting_set() {
  const std::uint64_t before = list_.revision();
  list_.import(starting_);
  return list_.revision() == before ? Expected<void>{} : write();
}

Expected<void> WindowBundles::export_to(const fs::path& file, std::optional<std::size_t> index) const {
  return write_file_atomically(file, write_bundles(index ? list_.bundles().subspan(*index, 1) : list_.bundles()));
}

}  // namespace mes
