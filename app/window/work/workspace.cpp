// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/work/workspace.h"

#include <fmt/core.h>
#include <utility>

#include "app/export/lessons/carried.h"
#include "app/playing/session_evolution.h"
#include "core/draw/variant.h"
#include "core/io/text/text_numbers.h"

namespace mes {

Workspace::Workspace(LiveRegistry registry, const std::filesystem::path& assets, Messages& messages, Waker wake)
    : registry_(std::move(registry)),
      messages_(messages),
      engine_(registry_.share(), {.wake = wake}),
      layers_(registry_.now().layers()),
      bundles_(default_bundles_path(), assets, layers_),
      hold_([this](std::shared_ptr<const DocumentDelta> delta) { engine_.post(std::move(delta)); }),
      editor_([this](std::shared_ptr<const DocumentDelta> delta) { hold_.post(std::move(delta)); }, &layers_),
      curve_selector_(editor_, wake),
      contour_commands_(editor_, layers_, wake),
      curve_sampler_(editor_, wake),
      insight_(registry_, wake),
      resampling_(registry_, editor_, wake),
      evolution_(registry_, editor_,
                 {[this](const Parameter& parameter) { return computation_.settings()[parameter]; },
                  [this](const Parameter& parameter, double value) { computation_.set(parameter, value); }},
                 wake),
      pane_documents_(editor_, evolution_, wake) {
  if (const std::string message = bundles_.take_message(); !message.empty()) messages_.problem(message);
}

void Workspace::set_registry(std::shared_ptr<const Registry> registry) {
  // Keeps the old registry alive: its layers are read until the new ones replace them.
  const std::shared_ptr<const Registry> before = registry_.share();
  registry_.set(std::move(registry));
  engine_.set_registry(registry_.share());
  editor_.replace_layers(
      [this] { bundles_.replace_layers([this] { layers_.set_descriptors(registry_.now().layers()); }); });
  computation_.follow_registry();
  if (evolution_.follow_registry()) pane_documents_.forget_states();
  panes_.resolve(registry_.now());
}

void Workspace::report(const Expected<void>& done) {
  if (!done) messages_.problem(done.error().message());
}

void Workspace::report_remark(const Expected<std::string>& done) {
  if (!done) return refusal_.say(done.error());
  refusal_.forget();
  messages_.remark(*done);
}

void Workspace::follow_crust() {
  report(curve_selector_.follow());
  if (std::string remark = curve_selector_.take_remark(); !remark.empty()) messages_.remark(std::move(remark));
  const auto made = contour_commands_.follow();
  if (!made)
    messages_.problem(made.error().message());
  else if (*made)
    messages_.remark(**made);
}

void Workspace::follow_resampling() {
  const auto report = resampling_.follow();
  if (!report) return;
  std::string text;
  for (const std::string& sentence : report->sentences) text += (text.empty() ? "" : ". ") + sentence;
  if (report->is_problem)
    messages_.problem(text);
  else
    messages_.remark(text);
}

void Workspace::follow_curves(bool is_held) {
  report(curve_sampler_.follow(is_held));
  if (const auto notice = curve_sampler_.take_notice()) messages_.remark(*notice);
}

void Workspace::leave_document() {
  is_held_by_action_ = false;
  hidden_additions_.begin(document());
  annotations_.forget();
  resampling_.forget();
  computation_.give_back();
  evolution_.resume(evolution_.choice(), 0);
  computation_.set(for_another_document(computation_.settings()));
  layers_.set_image({});
  // The look stays, and shows the family of balls that a document usually has.
  if (std::exchange(family_, {}).family() != family()) show_family();
}

void Workspace::choose_bundle(std::size_t index) {
  const Bundle bundle = bundles_.bundles()[index];
  const LayerConfiguration as = adapted(layers_.descriptors(), bundle.layers, family(), document());
  editor_.change_layers("Bundle " + in_quotes(bundle.name), [&] { bundles_.choose(index, as); });
  if (const auto shown = family_of(layers_.descriptors(), as)) family_.note_shown(*shown);
  messages_.remark(fmt::format("Bundle {}: {}", index + 1, bundle.name));
}

void Workspace::choose_family(FamilyKind family) {
  family_.choose(family);
  editor_.change_layers(std::string(title_of(group_of(family))), [&] { show_family(); });
}

void Workspace::take_family_of_layers() {
  if (const auto shown = family_of(layers_.descriptors(), layers_.configuration())) family_.note_shown(*shown);
}

// An unchanged bundle stays the chosen one.
void Workspace::show_family() {
  const auto current = bundles_.current();
  if (!current || bundles_.is_changed()) {
    layers_.set_configuration(in_family(layers_.descriptors(), layers_.configuration(), family()));
    return;
  }
  LayerConfiguration as = in_family(layers_.descriptors(), bundles_.bundles()[*current].layers, family());
  as.image = layers_.image();
  bundles_.choose(*current, as);
}

// Undo and redo restore the layers themselves.
void Workspace::follow_family() {
  if (editor_.in_gesture() || !family_.follow(document()) || editor_.can_redo()) return;
  editor_.note_layers();
  show_family();
  editor_.join_layers();
}

void Workspace::import_bundles(const std::filesystem::path& file) {
  Expected<std::string> remark;
  editor_.change_layers("Import bundles", [&] { remark = bundles_.import(file); });
  if (!remark)
    messages_.problem(remark.error().message());
  else
    messages_.remark(*remark);
  if (const std::string message = bundles_.take_message(); !message.empty()) messages_.problem(message);
}

void Workspace::export_bundles(const std::filesystem::path& file, std::optional<std::size_t> index) {
  const Expected<void> done = bundles_.export_to(file, index);
  report(done);
  if (done) messages_.remark("Saved " + file.string());
}

void Workspace::follow_evolution(std::uint64_t shown_document, double now) {
  evolution_.follow(shown_document == document().revision() && !engine_.status().busy, now);
  if (std::string remark = evolution_.take_remark(); !remark.empty()) messages_.remark(std::move(remark));
  if (evolution_.take_restart()) messages_.remark("Evolution restarted from here: the samples were edited");
  if (const auto problem = evolution_.take_problem()) messages_.problem(problem->message());
  if (const auto problem = pane_documents_.take_problem())
    messages_.problem("A pane cannot show its version of the document: " + problem->message());
}

bool Workspace::follow_layers(bool picture_is_lost, bool shows_annotations) {
  first_ball_.follow(editor_, layers_);
  hidden_additions_.follow(document(), layers_, shows_annotations);
  follow_family();
  bundles_.follow_layers();
  return demand_.follow(engine_, wanted(), picture_is_lost, &pane_documents_);
}

std::vector<std::string> Workspace::words_of_panes() const {
  const auto current = bundles_.current();
  const bool is_bundle = current && !bundles_.is_changed();
  return words_of(panes_, {computation_.settings(), family(),
                           is_bundle ? bundles_.bundles()[*current].name : std::string(), evolution_.position()});
}

SessionEvolution Workspace::evolution_now() const {
  return session_evolution(registry_.now(), evolution_.choice(), evolution_.position());
}

// Without the history, the document is in state 0.
Session Workspace::session_for_picture(std::string title, const Box2& view, std::vector<Box2> pane_views) const {
  Session out = mes::session_for_picture(std::move(title), data_of(document()), layers_.configuration(),
                                         computation_.settings(), view);
  if (!panes_.is_empty()) {
    out.panes = panes_now();
    out.pane_views = std::move(pane_views);
    out.evolution = evolution_now();
    out.evolution.step = 0;
  }
  return out;
}

std::vector<PaneRequest> Workspace::pane_requests(const std::shared_ptr<const SampleData>& data) const {
  return mes::pane_requests({shown_panes(), layers_, computation_.settings(), words_of_panes()}, data,
                            [this](std::size_t pane) { return data_of_pane(pane); });
}

const Document& Workspace::document_of_pane(std::size_t pane) const {
  // A pane added since the last request to the engine shows the document.
  if (pane >= shown_panes().variant.size()) return document();
  const Document* const own = pane_documents_.document_of(shown_panes().variant[pane]);
  return own != nullptr ? *own : document();
}

std::shared_ptr<const SampleData> Workspace::data_of_pane(std::size_t pane) const {
  return pane_documents_.data_of(shown_panes().variant[pane]);
}

bool Workspace::is_complete() const {
  const EngineStatus status = engine_.status();
  return !status.busy && !status.cancelled && hold_.waiting().empty() && demand_.is_told(wanted()) &&
         pane_documents_.is_complete();
}

}  // namespace mes
