// SPDX-License-Identifier: GPL-3.0-or-later
// The version of the library, and the version of its binary interface (ABI).
//
// Guarantees:
//  1. `kVersion` is the version of the headers that a program was compiled with; `version()` is that of the library it
//     runs with.
//  2. Libraries with the same `MESECINA_ABI` can replace one another without compiling a program again. The number is
//     part of the name of the shared library (libmesecina.so.1) and of the inline namespace (v1), so that a program
//     never starts with a library of another ABI.
//  3. A number, a type or a function is removed, or changes its meaning or its layout, only with another ABI number.
//     Plain structs such as `LayerInfo` count as layout.
//
// Smallest use:
//     if (!mesecina::is_compatible()) std::puts("the library is older than the headers");
//
// Threads: all functions may be called from any thread.
#pragma once

#include <string_view>

#define MESECINA_ABI 1

// Symbols of the library are hidden unless they are marked with this.
#if defined(__GNUC__)
#define MESECINA_API __attribute__((visibility("default")))
#else
#define MESECINA_API
#endif

namespace mesecina {
inline namespace v1 {

/// Semantic version of these headers.
inline constexpr std::string_view kVersion = "0.1.0";
inline constexpr int kVersionMajor = 0;
inline constexpr int kVersionMinor = 1;
inline constexpr int kVersionPatch = 0;

/// Returns the version of the library in use, "0.1.0". The text lives as long as the program.
MESECINA_API std::string_view version() noexcept;

/// Says whether the library in use is at least as new as the headers with the given version, and of the same major
/// version. Before 1.0.0 the minor version counts as the major one.
MESECINA_API bool is_compatible(int major = kVersionMajor, int minor = kVersionMinor,
                                int patch = kVersionPatch) noexcept;

}  // namespace v1
}  // namespace mesecina
