// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recording/picture_clipboard.h"

#include <string>
#include <string_view>
#include <system_error>

#include "app/system/child_process.h"
#include "core/io/files/atomic_file.h"
#include "core/io/files/temporary.h"

namespace mes {
namespace {

std::unexpected<Error> clipboard_error(std::string text) {
  return std::unexpected(Error{ErrorCode::cannot_write, std::move(text), {}, 0, 0});
}

}  // namespace

Expected<void> copy_png(std::span<const std::byte> png, const std::stop_token& stop) {
  if (!is_program_on_path("xclip"))
    return clipboard_error("copying pictures needs the program xclip, which is not installed");
  const auto folder = ScratchFolder::make();
  if (!folder) return std::unexpected(folder.error());
  const std::filesystem::path file = folder->path() / "picture.png";
  if (auto done = write_file_atomically(file, {reinterpret_cast<const char*>(png.data()), png.size()}); !done)
    return done;
  ChildProcess xclip;
  const int reason =
      xclip.start({"xclip", "-selection", "clipboard", "-target", "image/png", "-in", file.string()}, folder->path());
  if (reason != 0) return clipboard_error("xclip cannot be started: " + std::generic_category().message(reason));
  // `xclip` has read the file when it returns; a background copy serves the clipboard.
  if (!xclip.wait(stop)) {
    const std::string complaint = xclip.complaint();
    return clipboard_error("xclip failed" + (complaint.empty() ? std::string() : ": " + complaint));
  }
  return {};
}

}  // namespace mes
