// SPDX-License-Identifier: GPL-3.0-or-later
// Adds parts of C++20 that the standard library of emscripten (libc++ 18) lacks. The compiler reads it before each
// source of the rooms that use it (cmake/web.cmake). It is for this library alone, so it adds to namespace std.
#pragma once

#include <atomic>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <string>
#include <string_view>

namespace std {

#ifndef __cpp_lib_atomic_ref
/// The operations that the program uses.
template <class T>
class atomic_ref {
 public:
  explicit atomic_ref(T& value) : value_(&value) {}
  T load(memory_order order) const {
    T out;
    __atomic_load(value_, &out, static_cast<int>(order));
    return out;
  }
  bool compare_exchange_weak(T& expected, T wanted, memory_order order) const {
    const int as_number = static_cast<int>(order);
    return __atomic_compare_exchange(value_, &expected, &wanted, true, as_number, as_number);
  }
  T fetch_add(T term, memory_order order) const { return __atomic_fetch_add(value_, term, static_cast<int>(order)); }
  void store(T value, memory_order order) const { __atomic_store(value_, &value, static_cast<int>(order)); }

 private:
  T* value_;
};
#endif

#ifndef __cpp_lib_to_chars
/// `strtod` of musl rounds to the nearest double and knows one decimal point only. It also skips blanks and reads plus
/// signs and hexadecimal digits, which `from_chars` does not.
inline from_chars_result from_chars(const char* begin, const char* end, double& value) {
  const string_view all(begin, end);
  const string text(all.substr(0, all.find_first_of("xX")));
  if (text.empty() || string_view(" \t\n\v\f\r+").contains(text.front())) return {begin, errc::invalid_argument};
  char* stop = nullptr;
  errno = 0;
  const double found = strtod(text.c_str(), &stop);
  const char* const after = begin + (stop - text.c_str());
  if (after == begin) return {begin, errc::invalid_argument};
  if (errno == ERANGE && (found == 0.0 || isinf(found))) return {after, errc::result_out_of_range};
  value = found;
  return {after, errc()};
}
#endif

}  // namespace std
