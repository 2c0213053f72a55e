// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/ui/dialogs/file_list.h"

#include <algorithm>
#include <utility>

#include "core/base/lower_case.h"

namespace mes {

namespace fs = std::filesystem;

Expected<void> FileList::enter(const fs::path& folder) {
  std::error_code error;
  fs::path target = fs::weakly_canonical(folder, error);
  if (error) target = folder;
  fs::directory_iterator iterator(target, error);
  if (error) return std::unexpected(Error{ErrorCode::bad_input, error.message(), target.string()});
  std::vector<Entry> entries;
  for (; !error && iterator != fs::directory_iterator(); iterator.increment(error)) {
    Entry entry{iterator->path().filename().string(), false, 0};
    if (entry.name.starts_with(".")) continue;
    std::error_code ignored;  // a broken link is an entry without size
    entry.is_folder = iterator->is_directory(ignored);
    if (!entry.is_folder) entry.size = iterator->file_size(ignored);
    if (ignored) entry.size = 0;
    entries.push_back(std::move(entry));
  }
  std::ranges::sort(entries, [](const Entry& a, const Entry& b) {
    return a.is_folder != b.is_folder ? a.is_folder : a.name < b.name;
  });
  folder_ = std::move(target);
  entries_ = std::move(entries);
  relist();
  return {};
}

void FileList::set_filter(Filter filter) {
  filter_ = std::move(filter);
  relist();
}

void FileList::relist() {
  marked_.reset();
  rows_.clear();
  std::ranges::copy_if(entries_, std::back_inserter(rows_),
                       [this](const Entry& entry) { return entry.is_folder || !filter_ || filter_(entry.name); });
}

void FileList::move(int rows) {
  if (rows_.empty() || rows == 0) return;
  const auto last = static_cast<std::ptrdiff_t>(rows_.size()) - 1;
  if (!marked_) return move_to_end(rows < 0);
  marked_ =
      static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(static_cast<std::ptrdiff_t>(*marked_) + rows, 0, last));
}

void FileList::move_to_end(bool last) {
  if (!rows_.empty()) marked_ = last ? rows_.size() - 1 : 0;
}

void FileList::mark_by_name(const std::string& text) {
  marked_.reset();
  if (text.empty()) return;
  const std::string wanted = lower_case(text);
  const auto found =
      std::ranges::find_if(rows_, [&](const Entry& entry) { return lower_case(entry.name).starts_with(wanted); });
  if (found != rows_.end()) marked_ = static_cast<std::size_t>(found - rows_.begin());
}

}  // namespace mes
