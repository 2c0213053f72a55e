// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panes/pane_documents.h"

#include <algorithm>
#include <new>
#include <stop_token>

#include "core/base/jobs/job_control.h"

namespace mes {
namespace {

/// The keys of the samples of a document: their ids.
std::vector<std::uint64_t> keys_of(const Document& document) {
  std::vector<std::uint64_t> out;
  out.reserve(document.sample_count());
  for (const SampleSlot slot : document.slots_in_input_order()) out.push_back(document.id(slot).value);
  return out;
}

/// The keys of a state: its first samples are those of the document, the others have keys of their own.
std::vector<std::uint64_t> keys_of_state(const std::vector<std::uint64_t>& document, std::size_t samples) {
  constexpr std::uint64_t kOwn = std::uint64_t{1} << 63U;
  std::vector<std::uint64_t> out(document.begin(),
                                 document.begin() + static_cast<std::ptrdiff_t>(std::min(samples, document.size())));
  for (std::uint64_t own = 0; out.size() < samples; ++own) out.push_back(kOwn + own);
  return out;
}

/// The same annotations, with samples and balls renumbered for a document that has those of the data in the same
/// order.
Annotations numbered(Annotations annotations, const Document& document) {
  const std::vector<SampleSlot> slots = document.slots_in_input_order();
  const std::uint32_t first = document.first_id().value;
  const std::vector<BallSlot> balls = document.ball_slots_in_input_order();
  const std::uint32_t first_ball = document.first_ball_id().value;
  for (Annotation& annotation : annotations) {
    for (Anchor& anchor : annotation.anchors) {
      for (std::uint32_t& sample : anchor.samples) sample = document.id(slots[sample]).value - first;
      for (std::uint32_t& ball : anchor.balls) ball = document.ball_id(balls[ball]).value - first_ball;
    }
  }
  return annotations;
}

/// The part of a version that the engine needs.
SampleData drawn_part(const SampleData& data) {
  return {.positions = data.positions, .balls = data.balls};
}

}  // namespace

PaneDocuments::PaneDocuments(const Editor& editor, const EvolutionPlayer& evolution, Waker wake)
    : editor_(editor), evolution_(evolution), computing_(std::move(wake)) {}

const Document* PaneDocuments::document_of(VariantIndex variant) const {
  const bool has_own = variant != kMainVariant && variant <= panes_.size() && panes_[variant - 1];
  return has_own ? &panes_[variant - 1]->document : nullptr;
}

std::shared_ptr<const SampleData> PaneDocuments::data_of(VariantIndex variant) const {
  return document_of(variant) != nullptr ? panes_[variant - 1]->version.data : nullptr;
}

// Like `Graph::set_variants`, replaces all panes from the first one that differs in kind.
void PaneDocuments::keep_kinds(const std::vector<std::optional<VersionChoice>>& versions) {
  std::size_t kept = 0;
  while (kept < panes_.size() && kept < versions.size() && panes_[kept].has_value() == versions[kept].has_value())
    ++kept;
  panes_.resize(kept);
  for (std::size_t i = 0; i < kept; ++i)
    if (panes_[i] && panes_[i]->choice != *versions[i]) {
      panes_[i]->choice = *versions[i];
      panes_[i]->origin.reset();
    }
  for (std::size_t i = kept; i < versions.size(); ++i)
    panes_.push_back(versions[i] ? std::optional(Pane{.choice = *versions[i]}) : std::nullopt);
}

void PaneDocuments::follow(const std::vector<std::optional<VersionChoice>>& versions, bool is_held) {
  keep_kinds(versions);
  if (is_held) return;
  follow_edit();
  follow_evolution();
}

void PaneDocuments::follow_edit() {
  std::optional<Version> before;
  for (std::size_t i = 0; i < panes_.size(); ++i) {
    if (!panes_[i] || !std::holds_alternative<BeforeLastEdit>(panes_[i]->choice)) continue;
    const std::uint64_t revision = editor_.revision_before_last_edit();
    if (panes_[i]->origin == revision) continue;
    if (!before) {
      const Document document = editor_.before_last_edit();
      before = Version{keys_of(document), std::make_shared<const SampleData>(mes::data_of(document))};
    }
    panes_[i]->origin = revision;
    show(static_cast<VariantIndex>(i + 1), *before);
  }
}

PaneDocuments::Beginning PaneDocuments::beginning() const {
  return {evolution_.beginning_revision(), editor_.document().revision(), evolution_.choice()};
}

std::vector<std::uint64_t> PaneDocuments::steps_wanted() const {
  std::vector<std::uint64_t> out;
  for (const std::optional<Pane>& pane : panes_)
    if (const auto* const evolved = pane ? std::get_if<EvolvedChoice>(&pane->choice) : nullptr)
      out.push_back(evolved->step);
  std::ranges::sort(out);
  const auto [first, last] = std::ranges::unique(out);
  out.erase(first, last);
  return out;
}

bool PaneDocuments::is_complete() const {
  const std::vector<std::uint64_t> steps = steps_wanted();
  const bool has_edit = std::ranges::all_of(panes_, [this](const std::optional<Pane>& pane) {
    const bool is_before = pane && std::holds_alternative<BeforeLastEdit>(pane->choice);
    return !is_before || pane->origin == editor_.revision_before_last_edit();
  });
  return has_edit && deltas_.empty() && (steps.empty() || has_found(beginning(), steps));
}

void PaneDocuments::forget_states() {
  computing_.give_up();
  begun_.reset();
  found_.reset();
}

void PaneDocuments::follow_evolution() {
  std::vector<std::uint64_t> steps = steps_wanted();
  if (steps.empty()) return forget_states();
  if (auto found = computing_.poll()) {
    begun_.reset();
    take(std::move(*found));
  }
  // Waits for work on an earlier document: otherwise nothing would be shown while samples are dragged.
  const Beginning now = beginning();
  const bool is_under_way = begun_ && begun_->choice == now.choice && wanted_ == steps;
  if (!is_under_way && !has_found(now, steps)) begin(now, std::move(steps));
  if (found_) show_states();
}

void PaneDocuments::show_states() {
  for (std::size_t i = 0; i < panes_.size(); ++i) {
    const auto* const evolved = panes_[i] ? std::get_if<EvolvedChoice>(&panes_[i]->choice) : nullptr;
    if (evolved == nullptr || panes_[i]->origin == answers_) continue;
    const auto step =
        static_cast<std::size_t>(std::ranges::find(found_->steps, evolved->step) - found_->steps.begin());
    if (step >= found_->found.size()) continue;
    const EvolutionState& state = *found_->found[step];
    panes_[i]->origin = answers_;
    show(static_cast<VariantIndex>(i + 1),
         {keys_of_state(found_->document.keys, state.positions.size()),
          std::make_shared<const SampleData>(version_of(*found_->document.data, state))});
  }
}

void PaneDocuments::begin(const Beginning& beginning, std::vector<std::uint64_t> steps) {
  Found found{
      .beginning = beginning,
      .document = {keys_of(editor_.document()), std::make_shared<const SampleData>(mes::data_of(editor_.document()))},
      .states = nullptr,
      .steps = steps,
      .found = {}};
  const bool goes_on =
      found_ && found_->beginning.revision == beginning.revision && found_->beginning.choice == beginning.choice;
  // A call that was given up may still be computing states, so those are left to it.
  if (goes_on && !begun_)
    found.states = found_->states;
  else
    found.states = std::make_shared<EvolutionStates>(evolution_.beginning(), beginning.choice);
  begun_ = beginning;
  wanted_ = std::move(steps);
  computing_.begin([found = std::move(found)](const std::stop_token& stop) mutable {
    JobControl job(stop);
    try {
      for (const std::uint64_t step : found.steps) {
        auto state = found.states->at(step, job);
        if (!state) {
          found.problem = state.error();
          break;
        }
        found.found.push_back(std::move(*state));
      }
    } catch (const Cancelled&) {
      // The result of a call that was given up is dropped.
    } catch (const std::bad_alloc&) {
      found.problem = Error{ErrorCode::out_of_memory, "there is not enough memory", {}, 0, 0};
    }
    return std::move(found);
  });
}

void PaneDocuments::take(Found found) {
  if (found.problem) problem_ = found.problem;
  found_ = std::move(found);
  ++answers_;
}

void PaneDocuments::show(VariantIndex variant, Version version) {
  Pane& pane = *panes_[variant - 1];
  if (!change(pane, variant, version) &&
      !post(pane, variant, replace_all(pane.document, drawn_part(*version.data)))) {
    // A part of the change may have been applied, so the pane has no known version; the next one replaces it
    // completely.
    pane.version = {};
    return;
  }
  static_cast<void>(post(pane, variant, annotate(pane.document, numbered(version.data->annotations, pane.document))));
  pane.version = std::move(version);
}

bool PaneDocuments::post(Pane& pane, VariantIndex variant, const Expected<DocumentDelta>& delta) {
  if (!delta) {
    problem_ = delta.error();
    return false;
  }
  if (delta->is_empty()) return true;
  deltas_.push_back({variant, std::make_shared<const DocumentDelta>(*delta)});
  pane.document.apply(*delta);
  return true;
}

// Handles versions in which samples were removed, moved or appended, and balls at most changed. Returns false if the
// whole version must be replaced.
bool PaneDocuments::change(Pane& pane, VariantIndex variant, const Version& to) {
  const Version& from = pane.version;
  if (!from.data || from.data->balls.size() != to.data->balls.size()) return false;
  const std::vector<SampleSlot> slots = pane.document.slots_in_input_order();
  std::vector<SampleId> removed;
  std::vector<std::pair<SampleId, Vec2>> moved;
  std::size_t at = 0;
  for (std::size_t i = 0; i < from.keys.size(); ++i) {
    const SampleId id = pane.document.id(slots[i]);
    if (at == to.keys.size() || to.keys[at] > from.keys[i]) {
      removed.push_back(id);
      continue;
    }
    if (to.keys[at] != from.keys[i]) return false;  // a sample was inserted between the old ones
    if (to.data->positions[at] != pane.document.position(slots[i])) moved.emplace_back(id, to.data->positions[at]);
    ++at;
  }
  std::vector<std::pair<BallId, Disk>> balls;
  const std::vector<BallSlot> ball_slots = pane.document.ball_slots_in_input_order();
  for (std::size_t i = 0; i < ball_slots.size(); ++i)
    if (to.data->balls[i] != pane.document.disk(ball_slots[i]))
      balls.emplace_back(pane.document.ball_id(ball_slots[i]), to.data->balls[i]);
  const std::span<const Vec2> added = std::span(to.data->positions).subspan(at);
  // The coordinate range may allow the whole change but not each half.
  const Expected<DocumentDelta> less = remove_samples(pane.document, removed);
  if (!less) return false;
  if (!removed.empty() && !post(pane, variant, less)) return false;
  const Expected<DocumentDelta> more =
      change_document(pane.document, {.moved = moved, .inserted = added, .changed_balls = balls});
  return more && post(pane, variant, more);
}

}  // namespace mes
