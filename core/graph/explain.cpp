// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graph/explain.h"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>

namespace mes {

void ProvenanceShapes::add(PrimitiveKind kind, std::array<double, 7> values) {
  if (std::ranges::all_of(values, [](double x) { return std::isfinite(x); })) shapes_.push_back({kind, values});
}

std::string number_text(double x) {
  return fmt::format("{:.6g}", x);
}
std::string place_text(Vec2 p) {
  return fmt::format("({:.6g}, {:.6g})", p.x, p.y);
}
std::string count_text(std::size_t count, const std::string& one, const std::string& many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

void Explanation::about(const Element& element) {
  const auto ask = [&](const Structure& structure) {
    if (is_current_(structure)) structure.explain(element.type.kind, element.row, *this);
  };
  if (element.type.owner != nullptr) return ask(*element.type.owner);
  for (const auto& structure : set_.all()) ask(*structure);
}

std::vector<ProvenanceLine> explain(const StructureSet& set, const std::function<bool(const Structure&)>& is_current,
                                    const Element& element) {
  Explanation explanation(set, is_current);
  explanation.about(element);
  return explanation.take();
}

}  // namespace mes
