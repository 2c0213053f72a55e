// SPDX-License-Identifier: GPL-3.0-or-later
// `mesecina shape`: samples or balls of a shape with parameters.
#include <fmt/core.h>
#include <algorithm>

#include "app/cli/commands/commands.h"
#include "app/cli/console/messages.h"
#include "app/cli/console/output.h"
#include "app/cli/requests/names.h"
#include "app/cli/requests/sampling_request.h"
#include "core/document/commands.h"
#include "core/graph/registry.h"
#include "core/io/format.h"
#include "core/io/text/text_numbers.h"
#include "core/shapes/shape.h"

namespace mes::cli {
namespace {

Expected<std::shared_ptr<const ShapeDescriptor>> select_shape(const Registry& registry, const std::string& id) {
  if (auto shape = registry.shapes().find(id)) return shape;
  const auto ids = registry.shapes().ids();
  const std::vector<std::string_view> names(ids.begin(), ids.end());
  return usage_error("there is no shape " + in_quotes(id) + "; did you mean " + one_of(nearest_names(id, names)) +
                     "? (mesecina list shapes)");
}

/// Reads numbers and formulas by name.
Expected<ShapeValues> values_of(const ShapeDescriptor& shape, const std::vector<std::string>& settings) {
  ShapeValues out = mes::values_of(shape);
  for (const std::string& setting : settings) {
    const std::string_view name = std::string_view(setting).substr(0, setting.find('='));
    const auto formula = std::ranges::find(shape.formulas, name, &FormulaParameter::id);
    if (formula != shape.formulas.end() && name.size() < setting.size()) {
      out.formulas[static_cast<std::size_t>(formula - shape.formulas.begin())] = setting.substr(name.size() + 1);
      continue;
    }
    if (std::ranges::find(shape.parameters, name, &Parameter::id) == shape.parameters.end())
      return usage_error(
          fmt::format("--set: {} has no parameter {} (mesecina list shapes)", shape.id, in_quotes(name)));
    const auto parsed = parse_setting(setting, shape.parameters);
    if (!parsed) return std::unexpected(parsed.error());
    out.numbers[shape.parameters[parsed->first]] = parsed->second;
  }
  return out;
}

}  // namespace

Expected<void> run_shape(const Registry& registry, const ShapeCommand& request, Interruption& interruption) {
  const auto shape = select_shape(registry, request.name);
  if (!shape) return std::unexpected(shape.error());
  const auto values = values_of(**shape, request.settings);
  if (!values) return std::unexpected(values.error());
  const auto sampling = parse_sampling(request.samples, request.spacing, request.jitter, request.seed);
  if (!sampling) return std::unexpected(sampling.error());
  if (auto good = check_output(request.output); !good) return good;
  const auto data = make_shape(**shape, {*values, *sampling});
  if (!data) return std::unexpected(data.error());
  Document document;
  const auto delta = replace_all(document, *data);
  if (!delta) return std::unexpected(delta.error());
  document.apply(*delta);
  return write_output(request.output, data->balls.empty() ? write_poff(document) : write_wpoff(document),
                      interruption, {{}, request.force});
}

}  // namespace mes::cli
