// SPDX-License-Identifier: GPL-3.0-or-later
// The setting in which a side pane differs from the main one. Plain data.
#pragma once

#include <cstddef>
#include <cstdint>
#include <variant>

#include "core/document/settings/bundle.h"
#include "core/document/settings/computation_settings.h"

namespace mes {

/// The three families of balls whose union is studied.
enum class FamilyKind : std::uint8_t { inner, polar, own };

struct ParameterChoice {
  Parameter parameter{};
  double value = 0.0;  ///< within the range of the parameter
  friend bool operator==(const ParameterChoice&, const ParameterChoice&) = default;
};
/// State `step` of the evolution in the window.
struct EvolvedChoice {
  std::uint64_t step = 0;
  friend bool operator==(const EvolvedChoice&, const EvolvedChoice&) = default;
};
/// The document before the last edit; an open gesture counts as an edit.
struct BeforeLastEdit {
  friend bool operator==(const BeforeLastEdit&, const BeforeLastEdit&) = default;
};
/// A choice that shows another document.
using VersionChoice = std::variant<EvolvedChoice, BeforeLastEdit>;

using PaneChoice = std::variant<Precision, ParameterChoice, FamilyKind, Bundle, EvolvedChoice, BeforeLastEdit>;

/// Limit for panes beside the main one.
inline constexpr std::size_t kMostPanesBeside = 3;
/// The highest state of an evolution that a file may request.
inline constexpr std::uint64_t kMostPaneStep = 1'000'000;

}  // namespace mes
