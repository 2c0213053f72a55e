// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graph/explain.h"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/base/counted.h"
#include "core/graph/table_columns.h"
#include "core/graph/write_table.h"

namespace mes {

void ProvenanceShapes::add(PrimitiveKind kind, const std::array<double, 7>& values,
                           const std::array<Followed, 3>& follows) {
  if (std::ranges::all_of(values, [](double x) { return std::isfinite(x); }))
    shapes_.push_back({kind, values, follows});
}

std::string number_text(double x) {
  return fmt::format("{:.6g}", x);
}
std::string place_text(Vec2 p) {
  return fmt::format("({:.6g}, {:.6g})", p.x, p.y);
}

void Explanation::about(const Element& element) {
  const auto ask = [&](const Structure& structure) {
    if (is_current_(structure)) structure.explain(element.type.kind, element.row, *this);
  };
  if (element.type.owner != nullptr) return ask(*element.type.owner);
  for (const auto& structure : set_.all()) ask(*structure);
}

void Explanation::say_itself(std::string name, std::string rest, ProvenanceShapes& shapes) {
  named_ = lines_.size();
  lines_.push_back({{ProvenanceRole::itself, std::move(name) + rest, shapes.take(), false}, std::move(rest)});
}

void Explanation::rename(std::string name) {
  if (!named_) return;
  Draft& draft = lines_[*named_];
  draft.line.text = std::move(name) + draft.key;
}

void Explanation::say_any(ProvenanceRole role, const std::string& one, const std::string& many,
                          ProvenanceShapes& shapes) {
  if (shapes.size() == 0) return;
  auto draft =
      std::ranges::find_if(lines_, [&](const Draft& other) { return other.line.role == role && other.key == one; });
  if (draft == lines_.end()) draft = lines_.insert(draft, {{role, {}, {}, false}, one});
  std::ranges::move(shapes.take(), std::back_inserter(draft->line.shapes));
  draft->line.text = counted(draft->line.shapes.size(), one, many);
}

std::vector<ProvenanceLine> Explanation::take() {
  std::vector<ProvenanceLine> out;
  for (Draft& draft : lines_) out.push_back(std::move(draft.line));
  std::ranges::stable_sort(out, {}, &ProvenanceLine::role);
  return out;
}

std::vector<ProvenanceLine> explain_insertion(const StructureSet& set,
                                              const std::function<bool(const Structure&)>& is_current, Vec2 at,
                                              JobControl& job) {
  if (!std::isfinite(at.x) || !std::isfinite(at.y)) return {};
  Explanation explanation(set, is_current, job);
  for (const auto& structure : set.all())
    if (is_current(*structure)) structure->explain_insertion(at, explanation);
  return explanation.take();
}

std::vector<ProvenanceRow> rows_of(const StructureSet& set, const std::function<bool(const Structure&)>& is_current,
                                   const Element& element) {
  std::vector<ProvenanceRow> out;
  if (element.type.kind == ElementKind::other) return out;
  const auto add_from = [&](const Structure& structure) {
    if (!is_current(structure)) return;
    for (const TableColumns& table : structure.table_columns()) {
      if (table.kind != element.type.kind || element.row >= table.rows || !table.is_alive(element.row)) continue;
      ProvenanceRow& row = out.emplace_back();
      row.table = table_name(structure.id(), table.name);
      row.row = element.row;
      const std::vector<std::string> texts = row_texts(table, element.row);
      for (std::size_t i = 0; i < texts.size(); ++i)
        row.values.push_back({table.columns[i].name, texts[i], table.columns[i].description});
    }
  };
  if (element.type.owner != nullptr) {
    add_from(*element.type.owner);
  } else {
    for (const auto& structure : set.all()) add_from(*structure);
  }
  return out;
}

std::vector<ProvenanceLine> explain(const StructureSet& set, const std::function<bool(const Structure&)>& is_current,
                                    const Element& element, JobControl& job) {
  Explanation explanation(set, is_current, job);
  explanation.about(element);
  return explanation.take();
}

}  // namespace mes
