// SPDX-License-Identifier: GPL-3.0-or-later
// Registry additions of an experiment, behind the public `Experiment`.
#pragma once

#include <mesecina/experiment.h>

#include "core/graph/registry.h"
#include "core/library/experiments.h"

namespace mesecina {
inline namespace v1 {

struct Experiment::Impl {
  mes::Registry& registry;
  mes::ExperimentContents added{};
};

}  // namespace v1
}  // namespace mesecina
