// SPDX-License-Identifier: GPL-3.0-or-later
// Sessions as a source of samples and balls: their last state.
#include <unordered_map>

#include "core/io/format_registry.h"
#include "core/io/session.h"

namespace mes {
namespace {

Match match(std::string_view bytes) {
  return looks_like_session(bytes) ? Match::surely : Match::no;
}

SampleData data_of(const Document& document) {
  SampleData out;
  std::unordered_map<SampleId, std::uint32_t> number;
  for (const SampleSlot slot : document.slots_in_input_order()) {
    number.emplace(document.id(slot), static_cast<std::uint32_t>(out.positions.size()));
    out.positions.push_back(document.position(slot));
  }
  for (const CurveOrder::Contour& contour : document.curve_order()->contours) {
    SampleData::Contour to{contour.closed, {}};
    for (const SampleId id : contour.samples)
      if (const auto found = number.find(id); found != number.end()) to.points.push_back(found->second);
    if (!to.points.empty()) out.contours.push_back(std::move(to));
  }
  for (const BallSlot slot : document.ball_slots_in_input_order()) out.balls.push_back(document.disk(slot));
  return out;
}

Expected<LoadedFile> read(std::string_view bytes, const std::string& name) {
  auto session = read_session(bytes, name);
  if (!session) return std::unexpected(session.error());
  DocumentReplay replay;
  if (const auto done = replay_session(*session, replay, name); !done) return std::unexpected(done.error());
  return LoadedFile{.data = data_of(replay.document()),
                    .format = {},
                    .warnings = {},
                    .session = std::make_shared<const Session>(std::move(*session))};
}

}  // namespace

Format session_file_format() {
  return {
      {.id = "session", .name = "Mesecina session", .extensions = {".json"}, .can_read = true, .can_write = false},
      match,
      read};
}

}  // namespace mes
