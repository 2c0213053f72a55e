// SPDX-License-Identifier: GPL-3.0-or-later
// The layout `std140` of OpenGL (section 7.6.2.2 of its specification, 4.6), for scalars and vectors of 32-bit numbers.
//
// A C++ structure can be copied into a uniform block of that layout exactly if each of its members has the offset that
// the block expects. This header checks that at compile time:
//
//     struct Look { glm::vec3 color; float width; };
//     constexpr std::array kMembers{std140_member<glm::vec3>("u_color", offsetof(Look, color)),
//                                   std140_member<float>("u_width", offsetof(Look, width))};
//     static_assert(is_std140(kMembers, sizeof(Look)));
//
// Arrays and matrices are not covered: their elements are padded to 16 bytes, which no array of GLM's vectors is.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <type_traits>

namespace mes::render {

/// A member of a uniform block: its name in the shader, and its offset in the C++ structure.
struct Std140Member {
  const char* name;
  std::size_t offset;
  std::size_t size;
  std::size_t alignment;
};

/// Number of 32-bit components of a type allowed in a block.
template <class T>
inline constexpr std::size_t kComponents = 0;
template <>
inline constexpr std::size_t kComponents<float> = 1;
template <>
inline constexpr std::size_t kComponents<std::uint32_t> = 1;
template <int N, class T>
inline constexpr std::size_t kComponents<glm::vec<N, T>> =
    std::is_same_v<T, float> || std::is_same_v<T, std::uint32_t> ? N : 0;

/// Vectors of three are aligned like those of four.
template <class T>
constexpr Std140Member std140_member(const char* name, std::size_t offset) {
  static_assert(kComponents<T> != 0 && sizeof(T) == 4 * kComponents<T>);
  return {name, offset, sizeof(T), 4 * (kComponents<T> == 3 ? std::size_t{4} : kComponents<T>)};
}

/// True if `members`, in the order of the block, are all members of a structure of `size` bytes with the offsets of
/// `std140`: each at the first multiple of its alignment after the previous one, the end at a multiple of 16.
constexpr bool is_std140(std::span<const Std140Member> members, std::size_t size) {
  const auto aligned = [](std::size_t offset, std::size_t alignment) {
    return (offset + alignment - 1) / alignment * alignment;
  };
  std::size_t end = 0;
  for (const Std140Member& member : members) {
    if (member.offset != aligned(end, member.alignment)) return false;
    end = member.offset + member.size;
  }
  return size == aligned(end, 16);
}

}  // namespace mes::render
