// SPDX-License-Identifier: GPL-3.0-or-later
// Puts the pieces of shaders together into programs. Sources: `render/shaders/`.
#pragma once

#include "render/device.h"
#include "render/gl_handles.h"

namespace mes::render {

/// True when programs may compute in double (ARB_gpu_shader_fp64 and what goes with it).
bool context_has_double();

/// Compiles and links. Throws AssertionFailure with the compiler's words when a program is wrong.
GlProgram build_program(const ProgramKey& key, bool use_double);
GlProgram build_composite_program();

}  // namespace mes::render
