// SPDX-License-Identifier: GPL-3.0-or-later
// Reads samples and balls from a session: its last state.
#include "core/document/sample_data.h"
#include "core/io/format_spec.h"
#include "core/io/session/session.h"
#include "core/io/text/repeated_corners.h"

namespace mes {
namespace {

Match match_session_file(std::string_view bytes) {
  return looks_like_session(bytes) ? Match::surely : Match::no;
}

Expected<LoadedFile> read_session_file(std::string_view bytes, const std::string& name, ReadJob& job) {
  auto session = read_session(bytes, name, job.control(), job.done());
  if (!session) return std::unexpected(session.error());
  job.checkpoint();
  DocumentReplay replay;
  if (const auto done = replay_session(*session, replay, name, job.control()); !done)
    return std::unexpected(done.error());
  LoadedFile file;
  file.data = data_of(replay.document());
  RepeatedCorners repeated;
  for (const SampleData::Contour& contour : file.data.contours) repeated.add(contour);
  if (auto remark = repeated.remark(name)) file.warnings.push_back(*std::move(remark));
  file.session = std::make_shared<const Session>(std::move(*session));
  return file;
}

}  // namespace

Format session_file_format() {
  return {
      {.id = "session", .name = "Mesecina session", .extensions = {".json"}, .can_read = true, .can_write = false},
      match_session_file,
      read_session_file};
}

}  // namespace mes
