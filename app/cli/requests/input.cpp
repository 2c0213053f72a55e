// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/requests/input.h"

#include <unistd.h>

#include <algorithm>
#include <utility>

#include "app/cli/console/messages.h"
#include "core/graph/registry.h"
#include "core/io/format_spec.h"
#include "core/io/systems/coordinate_system.h"
#include "core/io/text/text_numbers.h"

namespace mes::cli {

namespace {

Expected<ReadRequest> understood_reading(const ReadingOptions& options) {
  ReadRequest request;
  TraceRequest& out = request.trace;
  if (!options.threshold.empty()) {
    const auto value = parse_count(options.threshold);
    if (!value || *value > 254)
      return usage_error("--threshold expects a grey value from 0 to 254, not " + in_quotes(options.threshold));
    out.threshold = static_cast<int>(*value);
  }
  if (!options.specks.empty()) {
    const auto value = parse_number(options.specks);
    if (!value || *value < 0.0)
      return usage_error("--specks expects a number of square pixels, not " + in_quotes(options.specks));
    out.specks = *value;
  }
  if (options.figure == "dark") out.figure = FigureSide::dark;
  if (options.figure == "light") out.figure = FigureSide::light;
  if (!options.figure.empty() && out.figure == FigureSide::found)
    return usage_error("--figure-side expects dark or light, not " + in_quotes(options.figure));
  if (options.keeps_degrees) request.degrees = MapDegrees::kept;
  request.keeps_vertices = options.keeps_vertices;
  request.wants_curves = options.wants_curves;
  request.system = options.system;
  if (!request.system.empty())
    if (auto known = find_coordinate_system(request.system); !known)
      return usage_error("--crs: " + known.error().text);
  return request;
}

bool is_map(const Registry& registry, std::string_view format) {
  const auto found = registry.formats().find(format);
  return found != nullptr && found->descriptor.is_map;
}

}  // namespace

std::vector<std::string> figure_sides() {
  return {"dark", "light"};
}

Expected<LoadedFile> read_input(const Registry& registry, const std::string& file, const std::string& format,
                                const ReadingOptions& options) {
  auto request = understood_reading(options);
  if (!request) return std::unexpected(request.error());
  request->formats = &registry.formats();
  auto loaded = file == "-" ? read_sample_stream(STDIN_FILENO, file, format, *request)
                            : read_sample_file(file, format, nullptr, *request);
  if (!loaded) return loaded;
  if (options.keeps_degrees && !loaded->degrees && !is_map(registry, loaded->format))
    return std::unexpected(Error{ErrorCode::usage, "only maps have degrees to keep, and this is none", file});
  for (const std::string& warning : loaded->warnings) say(warning);
  if (loaded->has_added_samples) say("--vertices takes the vertices alone");
  return loaded;
}

Expected<LoadedFile> read_input_bytes(const Registry& registry, std::string_view bytes, const std::string& name,
                                      const std::string& format, const ReadingOptions& options) {
  auto request = understood_reading(options);
  if (!request) return std::unexpected(request.error());
  request->formats = &registry.formats();
  return read_sample_bytes(bytes, name, format, *request);
}

}  // namespace mes::cli
