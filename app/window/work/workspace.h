// SPDX-License-Identifier: GPL-3.0-or-later
// The objects the user works on: the document, the layers that show it, and the engine that computes them.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

#include "app/actions/action_bindings.h"
#include "app/actions/messages.h"
#include "app/actions/refusal.h"
#include "app/editing/curves/contour_commands.h"
#include "app/editing/curves/curve_sampler.h"
#include "app/editing/curves/curve_selector.h"
#include "app/editing/curves/resample_job.h"
#include "app/editing/editor.h"
#include "app/editing/first_ball.h"
#include "app/editing/hidden_additions.h"
#include "app/editing/selection_commands.h"
#include "app/editing/tools/annotation_editor.h"
#include "app/editing/update_hold.h"
#include "app/export/comparison.h"
#include "app/insight/computation_control.h"
#include "app/insight/insight.h"
#include "app/layers/ball_families.h"
#include "app/layers/layer_stack.h"
#include "app/panes/engine_demand.h"
#include "app/panes/pane_list.h"
#include "app/playing/evolution_player.h"
#include "app/settings/settings.h"
#include "app/store/looks/window_bundles.h"
#include "app/system/waker.h"
#include "core/engine/engine.h"
#include "core/graph/live_registry.h"
#include "core/io/session/session.h"

namespace mes {

/// Guarantees: each edit reaches the engine, which is asked for the visible layers; nothing waits for the engine.
/// Depends on no window, panels or OpenGL. Threads: the window's; `wake` is called from others.
class Workspace {
 public:
  Workspace(LiveRegistry registry, const std::filesystem::path& assets, Messages& messages, Waker wake);

  /// Takes another registry, made from the present one by removals and additions. Layers, parameters and the
  /// evolution that it lacks disappear, and look as before if they return. Computations begun with the present
  /// registry end with it. Undo skips the change.
  void set_registry(std::shared_ptr<const Registry> registry);
  /// Valid until the next `set_registry`.
  const Registry& registry() const { return registry_.now(); }
  /// A reference that follows `set_registry`.
  const LiveRegistry& live_registry() const { return registry_; }
  Engine& engine() { return engine_; }
  const Engine& engine() const { return engine_; }
  ComputationControl& computation() { return computation_; }
  const ComputationControl& computation() const { return computation_; }
  LayerStack& layers() { return layers_; }
  const LayerStack& layers() const { return layers_; }
  WindowBundles& bundles() { return bundles_; }
  /// The family of balls that the layers show.
  FamilyKind family() const { return family_.family(); }
  Editor& editor() { return editor_; }
  const Editor& editor() const { return editor_; }
  const Document& document() const { return editor_.document(); }
  AnnotationEditor& annotations() { return annotations_; }
  const AnnotationEditor& annotations() const { return annotations_; }
  SelectionCommands& selection_commands() { return selection_commands_; }
  Insight& insight() { return insight_; }
  ResampleJob& resampling() { return resampling_; }
  HiddenAdditions& hidden_additions() { return hidden_additions_; }
  CurveSampler& curve_sampler() { return curve_sampler_; }
  const CurveSampler& curve_sampler() const { return curve_sampler_; }
  EvolutionPlayer& evolution() { return evolution_; }
  const EvolutionPlayer& evolution() const { return evolution_; }

  /// The panes beside the main one, and their contents.
  PaneList& panes() { return panes_; }
  const PaneList& panes() const { return panes_; }
  const ShownPanes& shown_panes() const { return demand_.shown(); }
  /// Keeps the density of up to so many samples up to date even if no layer shows it.
  void measure_density(std::size_t most_samples) { most_measured_ = most_samples; }
  /// Asks the engine for all layers again.
  void ask_again_for_layers() { demand_.ask_again(); }
  /// A description of each pane, the main one first.
  std::vector<std::string> words_of_panes() const;
  /// The panes in the form of sessions.
  std::vector<PaneChoice> panes_now() const { return {panes_.panes().begin(), panes_.panes().end()}; }
  SessionEvolution evolution_now() const;
  /// The session that a picture carries: the document as it is, without its history.
  Session session_for_picture(std::string title, const Box2& view, std::vector<Box2> pane_views) const;
  /// All panes in the form of figures, with the main one for these data first.
  std::vector<PaneRequest> pane_requests(const std::shared_ptr<const SampleData>& data) const;
  /// The document of a pane beside the main one.
  const Document& document_of_pane(std::size_t pane) const;
  /// The same as data if the pane has its own version; null: it has the main pane's document.
  std::shared_ptr<const SampleData> data_of_pane(std::size_t pane) const;

  /// Binds the actions for undo and redo, selection, evolution, computation and bundles.
  void bind(ActionBindings& actions, Settings& settings);

  /// Another document replaces this one: discards what belongs to this one alone
  /// (docs/decisions/document_parameters.md).
  void leave_document();
  /// Shows the bundle for the present family of balls.
  void choose_bundle(std::size_t index);
  /// Shows the same layers for another family of balls.
  void choose_family(FamilyKind family);
  /// Call it when a session has replaced the layers.
  void take_family_of_layers();
  void import_bundles(const std::filesystem::path& file);
  void export_bundles(const std::filesystem::path& file, std::optional<std::size_t> index);

  /// Changes that the engine has not received yet.
  const UpdateHold& hold() const { return hold_; }
  /// Called once per turn: holds the update if it may be held and a held action or key wants that, else releases it.
  void follow_hold(bool may_hold, bool is_held_by_key) {
    hold_.set_held(may_hold && (is_held_by_action_ || is_held_by_key));
  }
  /// Releases the hold, because it would hide a display that changes step by step.
  void release_hold() {
    is_held_by_action_ = false;
    hold_.set_held(false);
  }
  /// Called once per turn: selects along the crust or makes contours of it, once it has been found.
  void follow_crust();
  /// The same for samples of curves. `is_held`: the user holds a control of the panels.
  void follow_curves(bool is_held);
  /// Called once per turn: inserts or removes the samples that were found.
  void follow_resampling();
  /// Called once per turn: shows the state of the evolution that is ready.
  void follow_evolution(std::uint64_t shown_document, double now);
  /// Called once per frame: asks the engine for the visible layers. Returns true if they have changed.
  bool follow_layers(bool picture_is_lost, bool shows_annotations);
  /// True if everything requested is computed and nothing was cancelled.
  bool is_complete() const;

 private:
  void bind_editing(ActionBindings& actions);
  void bind_evolution(ActionBindings& actions, Settings& settings);
  void bind_computation(ActionBindings& actions);
  void bind_bundles(ActionBindings& actions);
  EngineDemand::Wanted wanted() const {
    return {registry_.now(),
            layers_,
            panes_,
            computation_.settings(),
            document().revision(),
            {evolution_.choice(), evolution_.first_value()},
            !hold_.waiting().empty(),
            document().sample_count() <= most_measured_};
  }
  void report(const Expected<void>& done);
  void report_remark(const Expected<std::string>& done);
  void show_family();
  void follow_family();

  LiveRegistry registry_;
  Messages& messages_;
  Refusal refusal_{messages_};
  Engine engine_;
  ComputationControl computation_{registry_, engine_};
  LayerStack layers_;
  WindowBundles bundles_;
  UpdateHold hold_;
  bool is_held_by_action_ = false;
  Editor editor_;
  AnnotationEditor annotations_{editor_};
  SelectionCommands selection_commands_{registry_, editor_};
  CurveSelector curve_selector_;
  ContourCommands contour_commands_;
  CurveSampler curve_sampler_;
  Insight insight_;
  ResampleJob resampling_;
  EvolutionPlayer evolution_;
  PaneList panes_;
  PaneDocuments pane_documents_;
  EngineDemand demand_;
  std::size_t most_measured_ = 0;
  FirstBall first_ball_;
  HiddenAdditions hidden_additions_;
  FamilyChoice family_;
};

}  // namespace mes
