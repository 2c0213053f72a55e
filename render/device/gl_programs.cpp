// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/device/gl_programs.h"

#include <fmt/core.h>
#include <initializer_list>
#include <string>
#include <string_view>

#include "core/base/assert.h"
#include "render/device/gl_dialect.h"
#include "render/device/shader_sources.h"

namespace mes::render {
namespace {

using Sources = std::initializer_list<std::string_view>;

std::string preamble(const ProgramKey& key, const ProgramFeatures& features) {
  std::string out(shader_head());
  // The compiler must not reorder sums whose rounding matters. `precise` forbids it; without `precise`, each term is
  // combined with zero bits that the compiler cannot know.
  if (features.use_precise) {
    out += "#extension GL_ARB_gpu_shader5 : enable\n#define PRECISE precise\n#define HOLD(x) (x)\n";
  } else {
    out += "#define PRECISE\n#define HOLD(x) uintBitsToFloat(floatBitsToUint(x) ^ u_nothing)\n";
  }
  if (features.use_double) out += "#extension GL_ARB_gpu_shader_fp64 : enable\n";
  const int reach = key.reach == Reach::near ? 0 : (features.use_double ? 2 : 1);
  out += fmt::format("#define REACH {}\n#define DASHED {:d}\n#define MAPPED {:d}\n", reach, key.dashed, key.mapped);
  for (const PrimitiveKind kind : {PrimitiveKind::segment, PrimitiveKind::ray, PrimitiveKind::line}) {
    std::string name(name_of(kind));
    for (char& c : name) c = static_cast<char>(c - 'a' + 'A');
    out += fmt::format("#define KIND_{} {:d}\n", name, key.kind == kind);
  }
  return out;
}

GlShader compile(GLenum stage, const std::string& source) {
  GlShader shader(glCreateShader(stage));
  const char* text = source.c_str();
  glShaderSource(shader.get(), 1, &text, nullptr);
  glCompileShader(shader.get());
  GLint good = 0;
  glGetShaderiv(shader.get(), GL_COMPILE_STATUS, &good);
  if (good == 0) {
    std::string log(4096, '\0');
    GLsizei size = 0;
    glGetShaderInfoLog(shader.get(), static_cast<GLsizei>(log.size()), &size, log.data());
    log.resize(static_cast<std::size_t>(size));
    throw AssertionFailure("a shader does not compile: " + log);
  }
  return shader;
}

GlProgram link(const std::string& head, Sources vertex, Sources fragment) {
  const auto join = [&](Sources sources) {
    std::string out = head;
    for (const std::string_view source : sources) out += source;
    return out;
  };
  const GlShader vertex_shader = compile(GL_VERTEX_SHADER, join(vertex));
  const GlShader fragment_shader = compile(GL_FRAGMENT_SHADER, join(fragment));
  GlProgram program(glCreateProgram());
  glAttachShader(program.get(), vertex_shader.get());
  glAttachShader(program.get(), fragment_shader.get());
  glLinkProgram(program.get());
  GLint good = 0;
  glGetProgramiv(program.get(), GL_LINK_STATUS, &good);
  if (good == 0) {
    std::string log(4096, '\0');
    GLsizei size = 0;
    glGetProgramInfoLog(program.get(), static_cast<GLsizei>(log.size()), &size, log.data());
    log.resize(static_cast<std::size_t>(size));
    throw AssertionFailure("a program does not link: " + log);
  }
  glDetachShader(program.get(), vertex_shader.get());
  glDetachShader(program.get(), fragment_shader.get());
  return program;
}

GlProgram link_for(PrimitiveKind kind, const std::string& head) {
  using namespace shaders;
  switch (kind) {
    case PrimitiveKind::point:
      return link(head, {uniforms_glsl, mapped_glsl, place_glsl, point_vert},
                  {uniforms_glsl, paint_glsl, point_frag});
    case PrimitiveKind::disk:
      return link(head, {uniforms_glsl, mapped_glsl, place_glsl, wide_glsl, round_glsl, disk_vert},
                  {uniforms_glsl, paint_glsl, round_distance_glsl, disk_frag});
    case PrimitiveKind::circle:
      return link(head, {uniforms_glsl, mapped_glsl, place_glsl, wide_glsl, round_glsl, ring_glsl, circle_vert},
                  {uniforms_glsl, paint_glsl, round_distance_glsl, dash_glsl, circle_frag});
    case PrimitiveKind::arc:
      return link(
          head,
          {uniforms_glsl, mapped_glsl, place_glsl, wide_glsl, round_glsl, round_distance_glsl, ring_glsl, arc_vert},
          {uniforms_glsl, paint_glsl, round_distance_glsl, dash_glsl, arc_frag});
    case PrimitiveKind::segment:
    case PrimitiveKind::ray:
    case PrimitiveKind::line:
      return link(head, {uniforms_glsl, mapped_glsl, place_glsl, wide_glsl, stroke_vert},
                  {uniforms_glsl, paint_glsl, dash_glsl, stroke_frag});
    case PrimitiveKind::parabola:
      return link(head, {uniforms_glsl, mapped_glsl, place_glsl, wide_glsl, parabola_vert},
                  {uniforms_glsl, paint_glsl, dash_glsl, stroke_frag});
    case PrimitiveKind::triangle:
      return link(head, {uniforms_glsl, mapped_glsl, place_glsl, wide_glsl, triangle_vert},
                  {uniforms_glsl, paint_glsl, triangle_frag});
  }
  MES_ASSERT(false && "every kind has a program");
  return {};
}

}  // namespace

GlProgram build_program(const ProgramKey& key, const ProgramFeatures& features) {
  GlProgram program = link_for(key.kind, preamble(key, features));
  const GLuint block = glGetUniformBlockIndex(program.get(), "DrawUniforms");
  GLint bytes = 0;
  glGetActiveUniformBlockiv(program.get(), block, GL_UNIFORM_BLOCK_DATA_SIZE, &bytes);
  MES_ASSERT(static_cast<std::size_t>(bytes) == sizeof(DrawUniforms));
  glUniformBlockBinding(program.get(), block, kUniformBindingPoint);
  return program;
}

GlProgram build_picture_program() {
  return link(std::string(shader_head()), {shaders::picture_vert}, {shaders::picture_frag});
}

GlProgram build_composite_program() {
  return link(std::string(shader_head()), {shaders::composite_vert}, {shaders::composite_frag});
}

}  // namespace mes::render
