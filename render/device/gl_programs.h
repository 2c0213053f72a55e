// SPDX-License-Identifier: GPL-3.0-or-later
// Builds the OpenGL programs from the pieces in `render/shaders/`.
#pragma once

#include "render/device/device.h"
#include "render/device/gl_handles.h"

namespace mes::render {

/// Extensions of OpenGL 3.3 that programs may use.
struct ProgramFeatures {
  bool use_double = false;   ///< ARB_gpu_shader_fp64
  bool use_precise = false;  ///< ARB_gpu_shader5
};

/// The binding point at which programs of `build_program` read their `DrawUniforms`.
inline constexpr GLuint kUniformBindingPoint = 0;

/// Compiles and links. Throws AssertionFailure with the compiler's message if the driver refuses a program.
GlProgram build_program(const ProgramKey& key, const ProgramFeatures& features);
GlProgram build_composite_program();
GlProgram build_picture_program();

}  // namespace mes::render
