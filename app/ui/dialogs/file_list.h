// SPDX-License-Identifier: GPL-3.0-or-later
// The files of a folder in a dialog, with one of them marked.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"

namespace mes {

/// Guarantees: a folder is read once, when it is entered; folders are first, folders and files each in alphabetical
/// order, without hidden ones; the mark is on a listed row, or nowhere. Threads: none.
class FileList {
 public:
  struct Entry {
    std::string name;
    bool is_folder = false;
    std::uintmax_t size = 0;  ///< size of a file in bytes
  };
  using Filter = std::function<bool(const std::string& name)>;

  /// Reads a folder. Error: it cannot be read; then nothing changes.
  Expected<void> enter(const std::filesystem::path& folder);
  const std::filesystem::path& folder() const { return folder_; }
  /// Lists the files for which the filter is true, and every folder.
  void set_filter(Filter filter);

  const std::vector<Entry>& rows() const { return rows_; }
  std::optional<std::size_t> marked() const { return marked_; }
  const Entry* marked_row() const { return marked_ ? &rows_[*marked_] : nullptr; }
  void mark(std::size_t row) { marked_ = row; }
  void unmark() { marked_.reset(); }
  /// Moves the mark by this many rows, as far as possible; from nowhere to the first or the last.
  void move(int rows);
  void move_to_end(bool last);
  /// Marks the first row whose name begins with the text, in either case; nowhere if there is none, or the text is
  /// empty.
  void mark_by_name(const std::string& text);

 private:
  void relist();

  std::filesystem::path folder_;
  std::vector<Entry> entries_;
  std::vector<Entry> rows_;
  Filter filter_;
  std::optional<std::size_t> marked_;
};

}  // namespace mes
