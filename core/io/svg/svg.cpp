// SPDX-License-Identifier: GPL-3.0-or-later
// SVG: samples of the curves of a drawing. A figure of this program that carries a session is read as that session
// (core/io/carried_session.h).
#include <utility>

#include "core/io/curve_samples.h"
#include "core/io/format_spec.h"
#include "core/io/svg/svg_drawing.h"
#include "core/io/text/text_numbers.h"

namespace mes {
namespace {

Match match_svg(std::string_view bytes) {
  return looks_like_svg(bytes) ? Match::surely : Match::no;
}

/// Appends "; left out: ...", which may explain an empty drawing.
std::string with_reasons(std::string text, const std::vector<std::string>& warnings, const std::string& name) {
  for (const std::string& warning : warnings) {
    const std::size_t place = warning.starts_with(name) ? name.size() : 0;
    const std::size_t words = warning.find(": ", place);
    text += "; " + (words == std::string::npos ? warning : warning.substr(words + 2));
  }
  return text;
}

Expected<LoadedFile> read_svg(std::string_view bytes, const std::string& name, ReadJob& job) {
  auto drawing = read_svg_drawing(bytes, name, job);
  if (!drawing) return std::unexpected(drawing.error());
  if (drawing->curves.curves.empty())
    return bad_input(with_reasons("no shape is drawn in it", drawing->warnings, name), name, 1, 1);
  const MapPlane plane{.unit = drawing->unit, .page = drawing->page};
  const SamplingRequest request = default_sampling(drawing->curves);
  auto file = load_samples(std::move(drawing->curves), request, name, job);
  if (!file) return file;
  file->warnings = std::move(drawing->warnings);
  file->data.map = plane;
  return file;
}

}  // namespace

Format svg_format() {
  return {.descriptor = {.id = "svg", .name = "SVG drawing", .extensions = {".svg"}, .can_read = true},
          .match = match_svg,
          .read = read_svg,
          .may_look_foreign = true};
}

}  // namespace mes
