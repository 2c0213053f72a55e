// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/playing/evolution_player.h"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/playing/session_evolution.h"

namespace mes {

EvolutionPlayer::EvolutionPlayer(LiveRegistry registry, Editor& editor, Settings settings, std::function<void()> wake)
    : registry_(std::move(registry)),
      editor_(editor),
      settings_(std::move(settings)),
      run_({.wake = std::move(wake)}),
      choice_{.evolution = evolutions().front()} {}

bool EvolutionPlayer::follow_registry() {
  const auto found = registry_.now().evolutions().find(descriptor().id);
  if (found == choice_.evolution || (!found && descriptor().is_missing)) return false;
  const std::uint64_t k = position();
  const std::uint64_t wanted = target();
  const Direction direction = direction_;
  const bool moved_parameter = evolution().moved_parameter() != nullptr;
  cancel();
  choice_.evolution = found ? found : missing_evolution(descriptor().id);
  if (!found) {
    if (k == 0) return true;
    if (moved_parameter) beginning_revision_ = ~std::uint64_t{0};
    shown_ = k;
    shown_revision_ = editor_.document().revision();
    return true;
  }
  choice_.values = ParameterValues(choice_.values.changed());
  for (const Parameter& parameter : parameters_of(*found))
    choice_.values[parameter] = within(parameter, choice_.values[parameter]);
  // A session may have left a missing evolution here, whose beginning was unknown.
  if (k != 0 && (found->moved_parameter() != nullptr ? moved_.k == 0 : beginning_revision_ == ~std::uint64_t{0}))
    resume(EvolutionChoice(choice_), k);
  else
    restart_from_beginning();
  if (wanted != position()) step_to(wanted);
  direction_ = direction;
  return true;
}

bool EvolutionPlayer::has_beginning() const {
  if (evolution().moved_parameter() != nullptr) return true;
  const std::uint64_t revision = editor_.document().revision();
  return revision == beginning_revision_ || revision == shown_revision_;
}

std::uint64_t EvolutionPlayer::position() const {
  if (const ParameterMove* move = evolution().moved_parameter())
    return moved_.k != 0 && settings_.value(move->parameter) == moved_.value ? moved_.k : 0;
  return editor_.document().revision() == shown_revision_ ? shown_ : 0;
}

EvolutionState EvolutionPlayer::beginning() const {
  return position() == 0 || descriptor().is_missing ? state_of(editor_.document()) : beginning_;
}

double EvolutionPlayer::first_value() const {
  const ParameterMove* move = evolution().moved_parameter();
  if (move == nullptr) return 0.0;
  return position() == 0 ? settings_.value(move->parameter) : moved_.before;
}

std::optional<double> EvolutionPlayer::parameter_value() const {
  const ParameterMove* move = evolution().moved_parameter();
  return move == nullptr ? std::nullopt : std::optional(settings_.value(move->parameter));
}

void EvolutionPlayer::begin() {
  has_restarted_ = shown_ != 0;
  shown_ = 0;
  beginning_ = state_of(editor_.document());
  beginning_revision_ = editor_.document().revision();
  shown_revision_ = ~std::uint64_t{0};
  run_.begin(beginning_, choice_);
}

void EvolutionPlayer::restart_from_beginning() {
  if (evolution().moved_parameter() == nullptr && has_beginning()) run_.begin(beginning_, choice_);
  wanted_.reset();
}

void EvolutionPlayer::resume(const EvolutionChoice& choice, std::uint64_t k) {
  cancel();
  choice_ = choice;
  // A length equal to the proposal for this document was not set by hand.
  fitted_ = proposed_length();
  beginning_revision_ = shown_revision_ = ~std::uint64_t{0};
  shown_ = 0;
  moved_ = {};
  if (k == 0) return;
  if (const ParameterMove* move = evolution().moved_parameter()) {
    const double first = move->parameter.default_value;
    const auto value = moved_value(*move, first, k, choice_.values);
    if (!value || *value != settings_.value(move->parameter)) return;
    moved_ = {k, first, *value};
    end_ = std::max(end_, k);
    return;
  }
  if (descriptor().is_missing) {
    shown_revision_ = editor_.document().revision();
    shown_ = k;
    end_ = std::max(end_, k);
    return;
  }
  const auto before = editor_.resume_evolution();
  if (!before) return;
  beginning_ = state_of(*before);
  beginning_revision_ = before->revision();
  run_.begin(beginning_, choice_);
  shown_revision_ = editor_.document().revision();
  shown_ = k;
  end_ = std::max(end_, k);
}

void EvolutionPlayer::choose(const std::shared_ptr<const Evolution>& evolution) {
  if (evolution == choice_.evolution) return;
  const std::string given_up = given_up_step();
  cancel();
  const std::uint64_t steps = position();
  std::string kept = steps == 0 ? std::string() : name_of_state(descriptor(), steps) + ": kept";
  choice_.evolution = evolution;
  if (!kept.empty()) kept += fmt::format("; {} begins from there", descriptor().name);
  if (!kept.empty() || !given_up.empty()) remark_ = given_up + (kept.empty() || given_up.empty() ? "" : ". ") + kept;
  shown_ = 0;
  beginning_revision_ = shown_revision_ = ~std::uint64_t{0};
  moved_ = {};
  fit_lengths();
}

// Nobody waits for a single step of a playback.
std::string EvolutionPlayer::given_up_step() const {
  if (!wanted_ || direction_ != Direction::none) return {};
  return fmt::format("{}: step {} was not computed yet, and is given up", descriptor().name, *wanted_);
}

void EvolutionPlayer::fit_lengths() {
  fitted_revision_ = editor_.document().revision();
  std::vector<Parameter> to_fit = parameters_of(*choice_.evolution);
  std::erase_if(to_fit, [this](const Parameter& parameter) {
    const double now = choice_.values[parameter];
    return !parameter.is_length || (now != parameter.default_value && now != fitted_);
  });
  if (to_fit.empty()) return;
  const auto length = proposed_length();
  if (!length) return;
  for (const Parameter& parameter : to_fit) {
    fitted_ = std::clamp(*length, parameter.low, parameter.high);
    choice_.values[parameter] = *fitted_;
  }
}

std::optional<double> EvolutionPlayer::proposed_length() const {
  Box2 box;
  const Document& document = editor_.document();
  for (const SampleSlot slot : slots_below<SampleSlot>(document.slot_count()))
    if (document.is_alive(slot)) box.add(document.position(slot));
  for (const BallSlot slot : slots_below<BallSlot>(document.ball_slot_count()))
    if (document.is_ball_alive(slot)) box.add(document.disk(slot).center);
  if (box.is_empty()) return std::nullopt;
  const double part = std::max(0.005 * box.high.x - 0.005 * box.low.x, 0.005 * box.high.y - 0.005 * box.low.y);
  if (!(part > 0.0)) return std::nullopt;
  const double ten = std::pow(10.0, std::floor(std::log10(part)));
  return ten > 0.0 && std::isfinite(ten) ? std::max(1.0, std::floor(part / ten)) * ten : part;
}

void EvolutionPlayer::choose_next(int places) {
  const auto all = evolutions();
  if (all.empty()) return;
  const auto count = static_cast<int>(all.size());
  // A missing evolution counts as the first.
  const auto found = std::ranges::find(all, choice_.evolution);
  const int now = found == all.end() ? 0 : static_cast<int>(found - all.begin());
  const int next = (now + places) % count;
  choose(all[static_cast<std::size_t>(next < 0 ? next + count : next)]);
}

void EvolutionPlayer::set_seed(std::uint64_t seed) {
  if (seed == choice_.seed) return;
  const std::uint64_t k = target();
  choice_.seed = seed;
  restart_from_beginning();
  if (k != 0) step_to(k);
}

void EvolutionPlayer::set_value(const Parameter& parameter, double value) {
  if (value == std::as_const(choice_.values)[parameter]) return;
  const std::uint64_t k = target();
  choice_.values[parameter] = value;
  // A length set by hand stays, whatever it is; the default value asks for the proposal.
  if (parameter.is_length) fitted_.reset();
  fit_lengths();
  restart_from_beginning();
  if (k != 0) step_to(k);
}

void EvolutionPlayer::set_end(std::uint64_t end) {
  end_ = std::max({std::uint64_t{1}, end, target()});
}

void EvolutionPlayer::step_to(std::uint64_t k) {
  if (editor_.in_gesture()) return;
  if (descriptor().is_missing) {
    direction_ = Direction::none;
    problem_ =
        Error{ErrorCode::cannot_compute, fmt::format("the evolution {} is not available here", descriptor().id)};
    return;
  }
  if (const ParameterMove* move = evolution().moved_parameter()) return move_parameter(*move, k);
  end_ = std::max(end_, k);
  if (k == 0) {
    wanted_.reset();
    run_.cancel();
    // The step of undo is the evolution, so this returns to its beginning.
    if (position() != 0) editor_.undo_edit();
    return;
  }
  if (!has_beginning()) begin();
  wanted_from_ = position();
  wanted_ = k;
  run_.want(k);
}

void EvolutionPlayer::move_parameter(const ParameterMove& move, std::uint64_t k) {
  const double before = position() == 0 ? settings_.value(move.parameter) : moved_.before;
  const auto value = k == 0 ? Expected<double>(before) : moved_value(move, before, k, choice_.values);
  if (!value) {
    problem_ = value.error();
    direction_ = Direction::none;
    return;
  }
  end_ = std::max(end_, k);
  moved_ = {k, before, *value};
  settings_.set(move.parameter, *value);
}

void EvolutionPlayer::play(Direction direction) {
  if (direction != Direction::none && !has_beginning()) begin();
  direction_ = direction;
}

double EvolutionPlayer::progress() const {
  if (!wanted_ || *wanted_ <= wanted_from_) return 0.0;
  const auto whole = static_cast<double>(*wanted_ - wanted_from_);
  const auto done = static_cast<double>(std::max(run_.reached(), wanted_from_) - wanted_from_);
  return std::min(1.0, done / whole);
}

void EvolutionPlayer::cancel() {
  direction_ = Direction::none;
  wanted_.reset();
  run_.cancel();
}

void EvolutionPlayer::show(std::uint64_t k, const EvolutionState& state) {
  const std::string name = name_of_state(descriptor(), k);
  // Contours change only if samples were added; all states of other evolutions share those of the document.
  const bool has_new_loops = state.curve != beginning_.curve;
  if (auto done =
          editor_.evolve(state.positions, has_new_loops ? contours_of(state) : std::vector<SampleData::Contour>(),
                         name, editor_.document().revision() == shown_revision_);
      !done) {
    problem_ = done.error();
    direction_ = Direction::none;
    return;
  }
  shown_revision_ = editor_.document().revision();
  shown_ = k;
}

void EvolutionPlayer::follow(bool picture_is_complete, double now) {
  if (editor_.in_gesture()) return;
  if (fitted_revision_ != editor_.document().revision() && position() == 0) fit_lengths();
  // The document was edited meanwhile, and the pending state was meant for the old one.
  if ((wanted_ || direction_ != Direction::none) && !has_beginning()) {
    if (const std::string given_up = given_up_step(); !given_up.empty())
      remark_ = given_up + ": the samples were edited";
    cancel();
  }
  if (auto answer = run_.poll(); answer && wanted_ == answer->k) {
    wanted_.reset();
    if (answer->state) {
      show(answer->k, **answer->state);
      picture_is_complete = false;
    } else {
      problem_ = answer->state.error();
      direction_ = Direction::none;
    }
  }
  if (direction_ == Direction::none || wanted_ || !picture_is_complete || next_due(now) > 0.0) return;
  last_step_ = now;
  if (direction_ == Direction::forward)
    step_forward();
  else
    step_back();
  if (direction_ == Direction::backward && target() == 0) direction_ = Direction::none;
}

std::optional<double> EvolutionPlayer::next_due(double now) const {
  if (direction_ == Direction::none || wanted_) return std::nullopt;
  return speed_ >= kFastest ? 0.0 : std::max(0.0, last_step_ + 1.0 / speed_ - now);
}

}  // namespace mes
