// SPDX-License-Identifier: GPL-3.0-or-later
// Sessions in pictures and figures, and the compressed streams that hold them.
#include "core/io/carried_session.h"
#include "core/base/carried_session.h"
#include "core/base/zlib.h"
#include "tests/fuzz/sample_files.h"

using namespace mes;
using namespace mes::fuzz;

void mes::fuzz::run_carried_session(std::string_view bytes) {
  const auto text = carried_session(bytes, "a.png");
  if (!text) require_error(text.error(), bytes);
  if (text && *text) {
    require((*text)->size() <= kMostCarriedBytes, "no text is longer than a picture may carry");
    require(may_carry_session(bytes), "what carries a session may carry one");
  }
  const auto file = read_sample_bytes(bytes, "a.png");
  if (!file) {
    require_error(file.error(), bytes);
  } else if (file->is_carried) {
    require(file->session != nullptr && text && *text, "what is carried is a session");
  }
  const std::string packed = zlib_compressed(bytes);
  require(require_read(zlib_expanded(packed + "more", bytes.size())) == bytes,
          "what is compressed expands to itself");
  if (!bytes.empty()) require(!zlib_expanded(packed, bytes.size() - 1), "no more is expanded than asked for");
  if (!bytes.empty())
    require(!zlib_expanded(std::string_view(packed).substr(0, packed.size() - 1), bytes.size()), "cut");
}
