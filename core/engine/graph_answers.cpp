// SPDX-License-Identifier: GPL-3.0-or-later
// Answers questions to the graph: elements at a position, effects of an insertion, origins of elements.
#include <algorithm>
#include <exception>
#include <new>
#include <utility>

#include "core/base/counted.h"
#include "core/engine/graph.h"
#include "core/graph/explain.h"

namespace mes {
namespace {

constexpr std::size_t kLook = 4096;  // instances between two checks of the job

}  // namespace

void Graph::ask(ProvenanceQuestion question) {
  questions_[static_cast<std::size_t>(question.wish)] = std::move(question);
}

bool Graph::has_questions() const {
  return std::ranges::any_of(questions_, [](const auto& question) { return question.has_value(); });
}

bool Graph::is_up_to_date(const Structure& structure) const {
  const auto found = std::ranges::find(nodes_, &structure, &StructureNode::structure);
  return found != nodes_.end() && found->needed && found->state == NodeState::up_to_date;
}

// The elements and their origins, as one line; elements that are samples or balls are included.
std::vector<ProvenanceLine> Graph::sources_of_values(const ProvenanceQuestion& question,
                                                     const std::function<bool(const Structure&)>& is_current,
                                                     JobControl& job) const {
  constexpr std::size_t kMost = 20'000;
  struct Found {
    VariantIndex variant;
    Element element;
    ProvenanceShape shape;
  };
  std::vector<Found> found;
  std::size_t seen = 0;
  for (const VariantLayer layer : question.layers) {
    const LayerNode* const node = find(layer);
    if (node == nullptr || !node->demanded || node->state != NodeState::up_to_date) continue;
    for (const auto& part : node->layer.parts)
      part->for_each_instance([&](PrimitiveKind kind, const double* values, const Element& element) {
        if (++seen % kLook == 0) job.checkpoint();
        const std::size_t last = stride_of(kind) - 1;
        if (found.size() > kMost) return;
        if (!(values[last] >= question.low && values[last] <= question.high)) return;
        ProvenanceShape shape{kind, {}};
        std::copy_n(values, last, shape.values.begin());
        found.push_back({layer.variant, element, shape});
      });
  }
  if (found.empty()) return {};
  if (found.size() > kMost)
    return {{ProvenanceRole::itself, "more than 20,000 elements have such a value", {}, false}};
  ProvenanceLine out{ProvenanceRole::origin, counted(found.size(), "element", "elements"), {}, false};
  for (const auto& [variant, element, shape] : found) {
    job.checkpoint();  // some lookups scan all rows
    out.shapes.push_back(shape);
    for (const ProvenanceLine& line : explain(structures(variant), is_current, element, job))
      if (line.role != ProvenanceRole::product)
        out.shapes.insert(out.shapes.end(), line.shapes.begin(), line.shapes.end());
  }
  return {std::move(out)};
}

// An answer is empty if memory runs out or a structure fails. Questions about a position are fast and come first.
void Graph::answer(std::vector<Provenance>& out, JobControl& job) {
  static_assert(static_cast<std::size_t>(ProvenanceWish::sources_of_values) + 1 == kProvenanceWishes);
  for (std::optional<ProvenanceQuestion>& question : questions_) {
    if (!question) continue;
    Provenance found;
    found.ticket = question->ticket;
    try {
      find_answer(*question, found, job);
    } catch (const Cancelled&) {
      return;
    } catch (const std::exception&) {
      found.lines.clear();
      found.rows.clear();
    }
    out.push_back(std::move(found));
    question.reset();
  }
}

void Graph::find_answer(const ProvenanceQuestion& question, Provenance& out, JobControl& job) const {
  const auto is_current = [this](const Structure& structure) { return is_up_to_date(structure); };
  if (question.wish == ProvenanceWish::sources_of_values) {
    out.lines = sources_of_values(question, is_current, job);
    return;
  }
  if (question.wish == ProvenanceWish::insertion) {
    out.lines = explain_insertion(structures(0), is_current, question.at, job);
    return;
  }
  for (const VariantLayer layer : question.layers) {
    const LayerNode* const node = find(layer);
    if (node == nullptr || !node->demanded || node->state != NodeState::up_to_date) continue;
    HitSearch search(question.at, question.reach);
    std::size_t seen = 0;
    for (const auto& part : node->layer.parts)
      part->for_each_instance([&](PrimitiveKind kind, const double* values, const Element& element) {
        if (++seen % kLook == 0) job.checkpoint();
        search.look_at(kind, values, element.type, element.row);
      });
    if (!search.best()) continue;
    out.layer = layer;
    if (question.wish == ProvenanceWish::shape) {
      out.lines.push_back({ProvenanceRole::itself, {}, {search.best()->shape}, false});
      break;
    }
    out.lines = explain(structures(layer.variant), is_current, search.best()->element, job);
    out.rows = rows_of(structures(layer.variant), is_current, search.best()->element);
    if (out.lines.empty())
      out.lines.push_back({ProvenanceRole::itself, std::string(node->layer.descriptor.tooltip), {}, false});
    if (out.lines.front().shapes.empty()) out.lines.front().shapes.push_back(search.best()->shape);
    break;
  }
}

}  // namespace mes
