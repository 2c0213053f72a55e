// SPDX-License-Identifier: GPL-3.0-or-later
// Errors that a workbench returns.
#pragma once

#include <fmt/core.h>

#include <string>
#include <string_view>
#include <utility>

#include "core/base/error.h"
#include "core/draw/patch.h"
#include "core/io/text/text_numbers.h"

namespace mes {

inline bool has_failed(NodeState state) {
  return state != NodeState::up_to_date && state != NodeState::inactive;
}

namespace refusals {

inline std::unexpected<Error> refused(ErrorCode code, std::string text) {
  return std::unexpected(Error{code, std::move(text), {}, 0, 0});
}

inline std::unexpected<Error> usage(std::string text) {
  return refused(ErrorCode::usage, std::move(text));
}

inline std::unexpected<Error> unknown(std::string_view what, std::string_view id) {
  return usage(fmt::format("unknown {} {}", what, in_quotes(id)));
}

inline std::unexpected<Error> not_computed(std::string_view what, std::string_view id) {
  return usage(fmt::format("{} {} was not computed", what, id));
}

inline std::unexpected<Error> failed(std::string_view what, std::string_view id, std::string_view reason) {
  return refused(ErrorCode::cannot_compute, fmt::format("{} {} failed: {}", what, id, reason));
}

inline std::unexpected<Error> out_of_memory() {
  return refused(ErrorCode::out_of_memory, "there is not enough memory");
}

inline std::unexpected<Error> stopped() {
  return refused(ErrorCode::cancelled, "the computation was stopped");
}

}  // namespace refusals

}  // namespace mes
