// SPDX-License-Identifier: GPL-3.0-or-later
// `DrawUniforms` is copied into a uniform block byte by byte, so driver and compiler have to agree on each offset.
#include <epoxy/gl.h>

#include <array>
#include <bit>
#include <catch2/catch.hpp>
#include <glm/packing.hpp>
#include <limits>
#include <numbers>

#include "render/device/draw_uniforms.h"
#include "render/device/egl_context.h"
#include "render/device/gl_programs.h"

namespace mes::render {
namespace {

GLint of_uniform(GLuint program, GLuint index, GLenum what) {
  GLint value = -1;
  glGetActiveUniformsiv(program, 1, &index, what, &value);
  return value;
}

TEST_CASE("the driver lays the uniform block out as the compiler lays out the structure", "[render]") {
  auto context = EglContext::create();
  REQUIRE(context);
  const GlProgram program = build_program({.kind = PrimitiveKind::circle, .dashed = true, .mapped = true}, {});
  GLint members = 0;
  glGetActiveUniformBlockiv(program.get(), glGetUniformBlockIndex(program.get(), "DrawUniforms"),
                            GL_UNIFORM_BLOCK_ACTIVE_UNIFORMS, &members);
  CHECK(static_cast<std::size_t>(members) == kDrawUniformMembers.size());
  for (const Std140Member& member : kDrawUniformMembers) {
    CAPTURE(member.name);
    GLuint index = GL_INVALID_INDEX;
    glGetUniformIndices(program.get(), 1, &member.name, &index);
    REQUIRE(index != GL_INVALID_INDEX);
    CHECK(static_cast<std::size_t>(of_uniform(program.get(), index, GL_UNIFORM_OFFSET)) == member.offset);
    CHECK(of_uniform(program.get(), index, GL_UNIFORM_SIZE) == 1);
  }
}

TEST_CASE("only structures laid out by std140 are taken for uniform blocks", "[render]") {
  struct Tight {
    glm::vec3 first;
    glm::vec3 second;  // at 12; a block has it at 16
  };
  constexpr std::array kTight{std140_member<glm::vec3>("first", offsetof(Tight, first)),
                              std140_member<glm::vec3>("second", offsetof(Tight, second))};
  CHECK_FALSE(is_std140(kTight, sizeof(Tight)));

  struct Filled {
    glm::vec3 first;
    float between;
    glm::vec3 second;
    float end;
  };
  constexpr std::array kFilled{std140_member<glm::vec3>("first", offsetof(Filled, first)),
                               std140_member<float>("between", offsetof(Filled, between)),
                               std140_member<glm::vec3>("second", offsetof(Filled, second)),
                               std140_member<float>("end", offsetof(Filled, end))};
  CHECK(is_std140(kFilled, sizeof(Filled)));
  CHECK_FALSE(is_std140(std::span(kFilled).first(3), sizeof(Filled) + 16));
  CHECK_FALSE(is_std140(std::span(kFilled).subspan(1), sizeof(Filled)));
}

TEST_CASE("words of doubles are those that programs put together", "[render]") {
  for (const double value : {0.0, -0.0, 1.0, -std::numbers::pi, 0x1p-1074, std::numeric_limits<double>::max()}) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    const glm::uvec2 words = glm::unpackDouble2x32(value);
    CHECK(words.x == static_cast<std::uint32_t>(bits));
    CHECK(words.y == static_cast<std::uint32_t>(bits >> 32U));
    CHECK(std::bit_cast<std::uint64_t>(glm::packDouble2x32(words)) == bits);
  }
}

}  // namespace
}  // namespace mes::render
