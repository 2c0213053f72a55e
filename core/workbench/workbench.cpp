// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workbench/workbench.h"

#include <algorithm>
#include <cmath>
#include <new>

#include "core/io/session/session.h"
#include "core/workbench/internal/refusals.h"

namespace mes {
namespace {

/// The value that a parameter will have. Error: `usage`.
Expected<double> accepted(const Parameter& parameter, double value) {
  const bool is_whole = !parameter.is_whole || value == std::floor(value);
  if (parameter.is_limit && is_whole && !std::isnan(value)) return std::clamp(value, parameter.low, parameter.high);
  if (is_whole && value >= parameter.low && value <= parameter.high) return value;
  std::string text =
      fmt::format("parameter {} expects a {} from ", parameter.id, parameter.is_whole ? "whole number" : "number");
  append_number(text, parameter.low);
  text += " to ";
  append_number(text, parameter.high);
  text += ", not ";
  append_number(text, value);
  return refusals::usage(std::move(text));
}

template <class Edit>
auto inserted_by(const std::vector<Edit>& edits) {
  std::vector<decltype(Edit::id)> out;
  out.reserve(edits.size());
  for (const Edit& edit : edits) out.push_back(edit.id);
  return out;
}

ReadRequest with_formats(ReadRequest request, const Registry& registry) {
  if (request.formats == nullptr) request.formats = &registry.formats();
  return request;
}

}  // namespace

Workbench::Workbench(const Registry& registry, WorkbenchOptions options)
    : registry_(&registry), options_(std::move(options)), graph_(std::make_unique<Graph>(registry)) {
  if (options_.take_instances) {
    options_.keeps_document = options_.keeps_instances = false;
    graph_->make_one_shot(options_.take_instances, options_.needs_scalars);
  }
  options_.keeps_history = options_.keeps_history && options_.keeps_document;
}

void Workbench::set_registry(const Registry& registry) {
  graph_->set_registry(registry);
  registry_ = &registry;
  graph_->set_demand(shown_);
  patch_.nodes.clear();
  patch_.reports.clear();
}

Expected<LoadedFile> Workbench::open(const std::filesystem::path& path, JobControl& job, const ReadRequest& request,
                                     std::string_view format) {
  return take(read_sample_file(path, format, &job, with_formats(request, *registry_)));
}

Expected<LoadedFile> Workbench::open_bytes(std::string_view bytes, const std::string& name, JobControl& job,
                                           const ReadRequest& request, std::string_view format) {
  return take(read_sample_bytes(bytes, name, format, with_formats(request, *registry_), &job));
}

Expected<LoadedFile> Workbench::take(Expected<LoadedFile> file) {
  if (!file) return file;
  if (auto done = load(file->data); !done) return std::unexpected(std::move(done.error()));
  if (file->session) choose(file->session->settings);
  return file;
}

Expected<void> Workbench::load(const SampleData& data) {
  return apply(replace_all(document_, data));
}

Expected<std::vector<SampleId>> Workbench::insert(std::span<const Vec2> positions) {
  auto delta = insert_samples(document_, positions);
  auto ids = delta ? inserted_by(delta->edits) : std::vector<SampleId>();
  if (auto done = apply(std::move(delta)); !done) return std::unexpected(std::move(done.error()));
  return ids;
}

Expected<std::vector<BallId>> Workbench::insert_balls(std::span<const Disk> disks) {
  auto delta = mes::insert_balls(document_, disks);
  auto ids = delta ? inserted_by(delta->ball_edits) : std::vector<BallId>();
  if (auto done = apply(std::move(delta)); !done) return std::unexpected(std::move(done.error()));
  return ids;
}

Expected<void> Workbench::move(std::span<const std::pair<SampleId, Vec2>> targets) {
  return apply(move_samples(document_, targets));
}

Expected<void> Workbench::remove(std::span<const SampleId> ids) {
  return apply(remove_samples(document_, ids));
}

Expected<void> Workbench::change_balls(std::span<const std::pair<BallId, Disk>> targets) {
  return apply(mes::change_balls(document_, targets));
}

Expected<void> Workbench::remove_balls(std::span<const BallId> ids) {
  return apply(mes::remove_balls(document_, ids));
}

Expected<void> Workbench::set_contours(std::span<const SampleData::Contour> contours) {
  const std::vector<SampleSlot> slots = document_.slots_in_input_order();
  CurveOrder order;
  for (const SampleData::Contour& contour : contours) {
    CurveOrder::Contour& out = order.contours.emplace_back(CurveOrder::Contour{contour.closed, {}});
    for (const std::uint32_t place : contour.points) {
      if (place >= slots.size())
        return std::unexpected(Error{ErrorCode::bad_input, "a contour names a sample that does not exist"});
      out.samples.push_back(document_.id(slots[place]));
    }
  }
  return apply(mes::set_contours(document_, std::move(order)));
}

Expected<void> Workbench::apply(Expected<DocumentDelta> delta, const std::string& name) {
  if (!delta) return std::unexpected(std::move(delta.error()));
  if (!options_.keeps_document && !delta->replaces_all())
    return refusals::usage("this workbench keeps no document to edit");
  auto shared = std::make_shared<const DocumentDelta>(std::move(*delta));
  if (options_.keeps_document) document_.apply(*shared);
  if (options_.keeps_history) history_.record(*shared, name);
  graph_->post(std::move(shared));
  return {};
}

bool Workbench::apply_all(const std::vector<DocumentDelta>& deltas) {
  for (const DocumentDelta& delta : deltas) {
    document_.apply(delta);
    graph_->post(std::make_shared<const DocumentDelta>(delta));
  }
  return !deltas.empty();
}

void Workbench::choose(const ComputationSettings& settings) {
  settings_ = settings;
  graph_->post_settings(settings_);
}

Expected<void> Workbench::set(std::string_view parameter, double value) {
  const Parameter* const known = registry_->find_parameter(parameter);
  if (known == nullptr) return refusals::unknown("parameter", parameter);
  return set(*known, value);
}

Expected<void> Workbench::set(const Parameter& parameter, double value) {
  const auto good = accepted(parameter, value);
  if (!good) return std::unexpected(good.error());
  ComputationSettings settings = settings_;
  settings[parameter] = *good;
  choose(settings);
  return {};
}

void Workbench::set_precision(Precision precision) {
  ComputationSettings settings = settings_;
  settings.precision = precision;
  choose(settings);
}

Expected<void> Workbench::set_precision(std::string_view id) {
  const auto found = std::ranges::find(kPrecisionDescriptors, id, &PrecisionDescriptor::id);
  if (found == kPrecisionDescriptors.end()) return refusals::unknown("number type", id);
  set_precision(found->precision);
  return {};
}

Expected<void> Workbench::compare_with(std::span<const WorkbenchVariant> variants) {
  std::vector<Document> documents(variants.size());
  std::vector<VariantRequest> requests;
  std::vector<std::shared_ptr<const DocumentDelta>> deltas;
  for (std::size_t i = 0; i < variants.size(); ++i) {
    const bool has_document = variants[i].data != nullptr;
    requests.push_back({variants[i].settings, has_document});
    deltas.emplace_back();
    if (!has_document) continue;
    auto delta = replace_all(documents[i], *variants[i].data);
    if (!delta) return std::unexpected(std::move(delta.error()));
    deltas.back() = std::make_shared<const DocumentDelta>(std::move(*delta));
    documents[i].apply(*deltas.back());
  }
  std::erase_if(shown_, [](VariantLayer layer) { return layer.variant != kMainVariant; });
  graph_->set_variants({});  // earlier variants would keep their documents
  graph_->set_variants(requests);
  for (std::size_t i = 0; i < deltas.size(); ++i)
    if (deltas[i]) graph_->post(static_cast<VariantIndex>(i + 1), std::move(deltas[i]));
  variant_documents_ = std::move(documents);
  graph_->set_demand(shown_);
  return {};
}

Expected<void> Workbench::show(std::span<const std::string_view> layers) {
  std::vector<VariantLayer> shown;
  for (const std::string_view layer : layers) {
    shown.emplace_back(registry_->find_layer(layer));
    if (shown.back().layer == kNoLayer) return refusals::unknown("layer", layer);
  }
  show(std::move(shown));
  return {};
}

void Workbench::show(std::vector<VariantLayer> layers) {
  shown_ = std::move(layers);
  graph_->set_demand(shown_);
}

Expected<void> Workbench::need(std::span<const std::string_view> structures) {
  for (const std::string_view structure : structures)
    if (std::ranges::find(registry_->structures(), structure) == registry_->structures().end())
      return refusals::unknown("structure", structure);
  graph_->set_needed_structures(structures);
  return {};
}

Expected<void> Workbench::run(JobControl& job) {
  if (job.stop_requested()) {
    patch_.complete = false;
    return refusals::stopped();
  }
  if (!graph_->run(patch_, job)) return refusals::stopped();
  if (options_.keeps_instances) {
    try {
      mirror_.apply(patch_);
    } catch (const std::bad_alloc&) {
      // The mirror missed a patch, so the next run must send every layer whole.
      mirror_ = {};
      patch_.reports.clear();  // no layer's instances can be read
      graph_->set_demand(std::span<const VariantLayer>());
      graph_->set_demand(shown_);
      return refusals::out_of_memory();
    }
  }
  if (patch_.nodes.empty()) return refusals::out_of_memory();  // there was no memory for the reports
  // A failed structure is the cause; blocked ones and layers follow from it.
  for (const NodeReport& node : patch_.nodes)
    if (node.state == NodeState::failed) return refusals::failed("structure", node.structure, node.reason);
  for (const LayerReport& report : patch_.reports)
    if (has_failed(report.state))
      return refusals::failed("layer", registry_->layers()[report.layer.layer].id, report.reason);
  return {};
}

Expected<void> Workbench::run_or_throw(JobControl& job) {
  auto done = run(job);
  if (!done && done.error().code == ErrorCode::cancelled) throw Cancelled{};
  return done;
}

}  // namespace mes
