// SPDX-License-Identifier: GPL-3.0-or-later
// The lower right panel, which shows one page at a time: statistics, parameters, log, lesson, selection, curves,
// sampling, branches, persistence, experiments.
#pragma once

#include "app/actions/action_bindings.h"
#include "app/model/settings.h"
#include "app/panels/pages/branches_panel.h"
#include "app/panels/pages/curves_panel.h"
#include "app/panels/pages/experiments_panel.h"
#include "app/panels/pages/lesson_panel.h"
#include "app/panels/pages/log_panel.h"
#include "app/panels/pages/parameters_panel.h"
#include "app/panels/pages/persistence_panel.h"
#include "app/panels/pages/sampling_panel.h"
#include "app/panels/pages/selection_panel.h"
#include "app/panels/pages/statistics_panel.h"
#include "app/ui/widgets.h"

namespace mes {

class DetailsPanel {
 public:
  /// `shown` holds the page that is shown.
  DetailsPanel(const Gui& gui, const ActionBindings& actions, DetailsPage& shown, StatisticsPanel statistics,
               ParametersPanel parameters, LogPanel log, LessonPanel lesson, SelectionPanel selection,
               CurvesPanel curves, BranchesPanel branches, PersistencePanel persistence,
               const SamplingPanel& sampling, ExperimentsPanel experiments)
      : gui_(gui),
        actions_(actions),
        shown_(shown),
        statistics_(statistics),
        parameters_(std::move(parameters)),
        log_(log),
        lesson_(std::move(lesson)),
        selection_(std::move(selection)),
        curves_(std::move(curves)),
        branches_(std::move(branches)),
        persistence_(std::move(persistence)),
        sampling_(sampling),
        experiments_(std::move(experiments)) {}

  void draw(const PanelArea& area);
  /// Lists the parameters of this name.
  void search_parameters(const std::string& name) { parameters_.search(name); }

 private:
  void draw_titles();

  const Gui& gui_;
  const ActionBindings& actions_;
  DetailsPage& shown_;
  StatisticsPanel statistics_;
  ParametersPanel parameters_;
  LogPanel log_;
  LessonPanel lesson_;
  SelectionPanel selection_;
  CurvesPanel curves_;
  BranchesPanel branches_;
  PersistencePanel persistence_;
  SamplingPanel sampling_;
  ExperimentsPanel experiments_;
};

}  // namespace mes
