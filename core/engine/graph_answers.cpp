// SPDX-License-Identifier: GPL-3.0-or-later
// Questions to the graph: what lies at a place, what an insertion would change, what elements come from.
#include <algorithm>
#include <new>
#include <utility>

#include "core/engine/graph.h"
#include "core/graph/explain.h"

namespace mes {

void Graph::ask(ProvenanceQuestion question) {
  std::erase_if(questions_, [&](const ProvenanceQuestion& earlier) { return earlier.wish == question.wish; });
  questions_.push_back(std::move(question));
}

// What the elements are and come from, as one line; the elements themselves count as far as they are samples or balls.
std::vector<ProvenanceLine> Graph::sources_of_values(const ProvenanceQuestion& question,
                                                     const std::function<bool(const Structure&)>& is_current,
                                                     JobControl& job) const {
  constexpr std::size_t kMost = 20'000;
  constexpr std::size_t kLook = 4096;  // instances between two looks at the job
  struct Found {
    Element element;
    ProvenanceShape shape;
  };
  std::vector<Found> found;
  std::size_t seen = 0;
  for (const LayerIndex layer : question.layers) {
    const LayerNode& node = layer_nodes_[layer];
    if (!node.demanded || node.state != NodeState::up_to_date) continue;
    for (const auto& part : layers_[layer].parts)
      part->for_each_instance([&](PrimitiveKind kind, const double* values, const Element& element) {
        if (++seen % kLook == 0) job.checkpoint();
        const std::size_t last = stride_of(kind) - 1;
        if (found.size() > kMost) return;
        if (!(values[last] >= question.low && values[last] <= question.high)) return;
        ProvenanceShape shape{kind, {}};
        std::copy_n(values, last, shape.values.begin());
        found.push_back({element, shape});
      });
  }
  if (found.empty()) return {};
  if (found.size() > kMost)
    return {{ProvenanceRole::itself, "more than 20,000 elements have such a value", {}, false}};
  ProvenanceLine out{ProvenanceRole::origin, count_text(found.size(), "element", "elements"), {}, false};
  for (const auto& [element, shape] : found) {
    job.checkpoint();  // some elements are found by looking at all
    out.shapes.push_back(shape);
    for (const ProvenanceLine& line :
         explain(structures(question.layers.front() / static_cast<LayerIndex>(layer_count_)), is_current, element))
      if (line.role != ProvenanceRole::product)
        out.shapes.insert(out.shapes.end(), line.shapes.begin(), line.shapes.end());
  }
  return {std::move(out)};
}

// Without memory for it an answer is empty.
std::vector<Provenance> Graph::answer(JobControl& job) {
  std::vector<Provenance> out;
  try {
    out.reserve(questions_.size());
    // Those of a place take no time, and are not to wait for the others.
    std::ranges::stable_partition(questions_, [](const ProvenanceQuestion& question) {
      return question.wish != ProvenanceWish::sources_of_values;
    });
    while (!questions_.empty()) {
      const ProvenanceQuestion& question = questions_.front();
      Provenance& found = out.emplace_back();
      found.ticket = question.ticket;
      try {
        find_answer(question, found, job);
      } catch (const Cancelled&) {
        out.pop_back();
        break;
      } catch (const std::bad_alloc&) {
        found.lines.clear();
      }
      questions_.erase(questions_.begin());
    }
  } catch (const std::bad_alloc&) {
    // Not even for the list; they stay asked.
  }
  return out;
}

void Graph::find_answer(const ProvenanceQuestion& question, Provenance& out, JobControl& job) const {
  const auto is_current = [this](const Structure& structure) {
    const auto found = std::ranges::find(nodes_, &structure, &StructureNode::structure);
    return found != nodes_.end() && found->needed && found->state == NodeState::up_to_date;
  };
  if (question.wish == ProvenanceWish::sources_of_values) {
    out.lines = sources_of_values(question, is_current, job);
    return;
  }
  if (question.wish == ProvenanceWish::insertion) {
    out.lines = explain_insertion(structures(0), is_current, question.at);
    return;
  }
  for (const LayerIndex layer : question.layers) {
    const LayerNode& node = layer_nodes_[layer];
    if (!node.demanded || node.state != NodeState::up_to_date) continue;
    HitSearch search(question.at, question.reach);
    for (const auto& part : layers_[layer].parts)
      part->for_each_instance([&search](PrimitiveKind kind, const double* values, const Element& element) {
        search.look_at(kind, values, element.type, element.row);
      });
    if (!search.best()) continue;
    out.layer = layer;
    if (question.wish == ProvenanceWish::shape) {
      out.lines.push_back({ProvenanceRole::itself, {}, {search.best()->shape}, false});
      break;
    }
    out.lines =
        explain(structures(layer / static_cast<LayerIndex>(layer_count_)), is_current, search.best()->element);
    if (out.lines.empty())
      out.lines.push_back({ProvenanceRole::itself, std::string(layers_[layer].descriptor.tooltip), {}, false});
    if (out.lines.front().shapes.empty()) out.lines.front().shapes.push_back(search.best()->shape);
    break;
  }
}

}  // namespace mes
