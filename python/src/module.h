// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of the compiled module.
#pragma once

#include <string_view>

#include <mesecina/mesecina.h>

#include "arrays.h"

namespace mes_python {

/// Parses the name of a kind. Error: `ValueError`.
mesecina::PrimitiveKind kind_of(std::string_view name);
/// The catalogue with a structure or a layer that `_experiments.py` describes. Throws the errors of
/// `mesecina::with_experiment`.
mesecina::Catalogue with_python(const mesecina::Catalogue& catalogue, const py::dict& spec);

/// The name of the capsule `add_file`, which holds a function `void(mesecina::Experiment&, const char* file)`. The
/// function may throw.
inline constexpr const char* kAddFile = "mesecina.add_file";

/// A text that may name a path, and need not be UTF-8.
py::str text_of(std::string_view text);
void add_errors();
void add_inputs(py::module_& module);

}  // namespace mes_python
