// SPDX-License-Identifier: GPL-3.0-or-later
// `mesecina text`: makes samples of the outlines of a text.
#include "app/cli/commands/commands.h"
#include "app/cli/console/messages.h"
#include "app/cli/console/output.h"
#include "app/cli/requests/sampling_request.h"
#include "app/store/own_font.h"
#include "app/store/sample_shapes.h"
#include "core/document/commands.h"
#include "core/glyphs/text_outlines.h"
#include "core/io/format.h"

namespace mes::cli {
namespace {

Expected<TextRequest> text_of(const TextCommand& request) {
  TextRequest out{.text = request.text, .has_kerning = !request.no_kerning};
  auto font = request.font.empty() ? own_font(find_assets({})) : find_font(request.font);
  if (!font) return std::unexpected(std::move(font.error()));
  out.font = *std::move(font);
  const auto size = parse_real("--size", request.size);
  if (!size) return std::unexpected(size.error());
  out.size = *size;
  const auto line_spacing = parse_real("--line-spacing", request.line_spacing);
  if (!line_spacing) return std::unexpected(line_spacing.error());
  out.line_spacing = *line_spacing;
  return out;
}

}  // namespace

Expected<void> run_text(const TextCommand& request, Interruption& interruption) {
  const auto text = text_of(request);
  if (!text) return std::unexpected(text.error());
  const auto sampling = parse_sampling(request.samples, request.spacing, request.jitter, request.seed);
  if (!sampling) return std::unexpected(sampling.error());
  if (auto good = check_output(request.output); !good) return good;
  const auto outlines = outlines_of_text(*text);
  if (!outlines) return std::unexpected(outlines.error());
  for (const std::string& remark : outlines->remarks) say(remark);
  const auto data = sample_curves(outlines->curves, *sampling);
  if (!data) return std::unexpected(data.error());
  Document document;
  const auto delta = replace_all(document, *data);
  if (!delta) return std::unexpected(delta.error());
  document.apply(*delta);
  return write_output(request.output, write_poff(document), interruption, {{}, request.force});
}

}  // namespace mes::cli
