// SPDX-License-Identifier: GPL-3.0-or-later
// What a pane beside the main one shows otherwise. Plain data.
#pragma once

#include <cstddef>
#include <cstdint>
#include <variant>

#include "core/document/bundle.h"
#include "core/document/computation_settings.h"

namespace mes {

/// The three families of balls whose union is studied.
enum class FamilyKind : std::uint8_t { inner, polar, own };

struct ParameterChoice {
  Parameter parameter{};
  double value = 0.0;  ///< within the range of the parameter
  friend bool operator==(const ParameterChoice&, const ParameterChoice&) = default;
};
/// State `step` of the evolution of the window.
struct EvolvedChoice {
  std::uint64_t step = 0;
  friend bool operator==(const EvolvedChoice&, const EvolvedChoice&) = default;
};
/// A gesture under way is the last edit.
struct BeforeLastEdit {
  friend bool operator==(const BeforeLastEdit&, const BeforeLastEdit&) = default;
};
/// A document of its own.
using VersionChoice = std::variant<EvolvedChoice, BeforeLastEdit>;

using PaneChoice = std::variant<Precision, ParameterChoice, FamilyKind, Bundle, EvolvedChoice, BeforeLastEdit>;

/// Panes beside the main one.
inline constexpr std::size_t kMostPanesBeside = 3;
/// The furthest state of an evolution that a file may ask for.
inline constexpr std::uint64_t kMostPaneStep = 1'000'000;

}  // namespace mes
