// SPDX-License-Identifier: GPL-3.0-or-later
// Bundles: their actions, and files of them.
#include <algorithm>
#include <utility>

#include "app/window/app.h"
#include "core/io/bundle_file.h"
#include "core/io/text_numbers.h"

namespace mes {

namespace fs = std::filesystem;

void App::bind_bundle_actions() {
  constexpr std::size_t kDigits = 9;
  for (std::size_t index = 0; index < kDigits; ++index) {
    const auto id = static_cast<ActionId>(static_cast<std::size_t>(ActionId::bundle_1) + index);
    actions_.bind(id, {[this, index] {
                         const std::string name = bundles_.bundles()[index].name;
                         editor_.change_layers("Bundle " + in_quotes(name), [&] { bundles_.choose(index); });
                         messages_.remark("Bundle " + std::to_string(index + 1) + ": " + name);
                       },
                       [this, index] { return index < bundles_.bundles().size(); },
                       [this, index] { return bundles_.current() == index; }});
  }
  const auto has_some = [this] { return !bundles_.bundles().empty(); };
  actions_.bind(ActionId::save_bundle, {[this] {
                  show_panels_ = true;
                  settings_.show_layers = true;
                  bundles_panel_.ask_name();
                }});
  actions_.bind(ActionId::import_bundles, {[this] {
                  when_chosen_ = [this](const fs::path& file) { import_bundles(file); };
                  browser_.ask_open(browse_folder(), "Import bundles");
                }});
  actions_.bind(ActionId::export_bundles, {[this] { ask_export({}); }, has_some});
  actions_.bind(ActionId::undo_bundles, {[this] {
                                           if (const auto done = bundles_.undo(); !done) report(done.error());
                                         },
                                         [this] { return bundles_.can_undo(); }});
}

void App::ask_export(std::optional<std::size_t> index) {
  std::string name = index ? bundles_.bundles()[*index].name : "bundles";
  std::ranges::replace(name, '/', '-');
  when_chosen_ = [this, index](const fs::path& file) {
    if (const auto done = bundles_.export_to(file, index); !done)
      report(done.error());
    else
      messages_.remark("Saved " + file.string());
  };
  browser_.ask_save(browse_folder(), name + ".json", index ? "Export the bundle" : "Export all bundles");
}

void App::import_bundles(const fs::path& file) {
  Expected<std::string> remark;
  editor_.change_layers("Import bundles", [&] { remark = bundles_.import(file); });
  if (!remark)
    report(remark.error());
  else
    messages_.remark(*remark);
  if (const std::string message = bundles_.take_message(); !message.empty()) messages_.problem(message);
}

std::vector<fs::path> App::without_bundles(const std::vector<std::string>& files) {
  std::vector<fs::path> rest;
  for (const std::string& file : files) {
    if (is_bundle_file(file))
      import_bundles(file);
    else
      rest.emplace_back(file);
  }
  return rest;
}

}  // namespace mes
