// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/layers/words/statistics_text.h"

#include <fmt/core.h>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/io/session/json_text.h"

namespace mes {
namespace {

// All digits, for programs.
std::string exactly(const StatValue& value) {
  return std::visit([](const auto& v) { return json_text(nlohmann::json(v)); }, value);
}

}  // namespace

std::string to_text(const StatValue& value) {
  if (const auto* number = std::get_if<std::int64_t>(&value)) return std::to_string(*number);
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  if (const auto* real = std::get_if<double>(&value)) {
    return std::isfinite(*real) ? fmt::format("{:.6g}", *real) : "-";
  }
  std::string out;
  for (const std::int64_t number : std::get<std::vector<std::int64_t>>(value)) {
    if (!out.empty()) out += ", ";
    out += std::to_string(number);
  }
  return out;
}

std::string statistics_as_tsv(std::span<const NodeReport> nodes) {
  std::string out;
  for (const NodeReport& node : nodes) {
    if (node.state == NodeState::inactive) continue;
    const auto line = [&](const std::string& key, const std::string& value) {
      out += fmt::format("{}\t{}\t{}\n", node.structure, key, value);
    };
    line("ms", exactly(node.update_ms));
    line("touched", exactly(static_cast<std::int64_t>(node.touched)));
    for (const Stat& stat : node.stats) {
      const auto* text = std::get_if<std::string>(&stat.value);
      line(stat.key, text != nullptr ? *text : exactly(stat.value));
    }
  }
  return out;
}

nlohmann::ordered_json json_of(const NodeReport& node, bool with_timing) {
  nlohmann::ordered_json out = nlohmann::ordered_json::object();
  // Clocks count no less than nanoseconds.
  if (with_timing) out["ms"] = std::round(node.update_ms * 1e6) / 1e6;
  if (!node.kernel.empty()) out["kernel"] = node.kernel;
  for (const Stat& stat : node.stats) std::visit([&](const auto& value) { out[stat.key] = value; }, stat.value);
  return out;
}

std::string statistics_as_json(std::span<const NodeReport> nodes) {
  nlohmann::ordered_json out = nlohmann::ordered_json::object();
  for (const NodeReport& node : nodes)
    if (node.state != NodeState::inactive) out[node.structure] = json_of(node, true);
  return json_text(out, 2) + '\n';
}

}  // namespace mes
