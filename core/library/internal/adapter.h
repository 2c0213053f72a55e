// SPDX-License-Identifier: GPL-3.0-or-later
// Conversions between the public types and those of the program: errors, jobs, catalogues, plain values.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <mesecina/catalogue.h>
#include <mesecina/error.h>
#include <mesecina/geometry.h>
#include <mesecina/workbench.h>

#include "core/base/error.h"
#include "core/base/geometry/disk.h"
#include "core/base/geometry/vec2.h"
#include "core/base/ids.h"
#include "core/base/jobs/job_control.h"
#include "core/document/sample_data.h"
#include "core/document/settings/parameter.h"
#include "core/graph/registry.h"

namespace mesecina {
inline namespace v1 {

/// Throws the public error that corresponds to one of the program.
[[noreturn]] void raise(const mes::Error& error);
[[noreturn]] void refuse(std::string text);
[[noreturn]] void refuse_unknown(std::string_view what, std::string_view id);
/// Throws the public error that corresponds to the exception being handled.
[[noreturn]] void raise_current();

/// Calls `work` and converts exceptions of the program to public errors.
template <class Work>
decltype(auto) guarded(Work&& work) {
  try {
    return std::forward<Work>(work)();
  } catch (const Error&) {
    throw;
  } catch (...) {
    raise_current();
  }
}

template <class T>
T taken(mes::Expected<T> result) {
  if (!result) raise(result.error());
  if constexpr (!std::is_void_v<T>) return std::move(*result);
}

struct JobAccess {
  static mes::JobControl& control(Job& job);
  static void begin_task(Job& job, std::string_view task);
};

struct CatalogueAccess {
  static const std::shared_ptr<const mes::Registry>& registry(const Catalogue& catalogue);
  static Catalogue make(std::shared_ptr<const mes::Registry> registry);
};

inline mes::Vec2 inner(const Point& point) {
  return {point.x, point.y};
}
inline mes::Disk inner(const Ball& ball) {
  return {inner(ball.center), ball.radius};
}
inline mes::SampleId inner(SampleId id) {
  return {id.value};
}
inline mes::BallId inner(BallId id) {
  return {id.value};
}
inline Point outer(mes::Vec2 point) {
  return {point.x, point.y};
}
inline Ball outer(const mes::Disk& ball) {
  return {outer(ball.center), ball.radius};
}
inline SampleId outer(mes::SampleId id) {
  return {id.value};
}
inline BallId outer(mes::BallId id) {
  return {id.value};
}
template <class From>
auto all_inner(const From& from) {
  std::vector<decltype(inner(*from.begin()))> out;
  out.reserve(from.size());
  for (const auto& value : from) out.push_back(inner(value));
  return out;
}
template <class From>
auto all_outer(const From& from) {
  std::vector<decltype(outer(*from.begin()))> out;
  out.reserve(from.size());
  for (const auto& value : from) out.push_back(outer(value));
  return out;
}
template <class From>
std::vector<std::string> all_texts(const From& from) {
  std::vector<std::string> out;
  out.reserve(from.size());
  for (const auto& text : from) out.emplace_back(text);
  return out;
}

mes::SampleData inner(const Data& data);
Data outer(const mes::SampleData& data);

}  // namespace v1
}  // namespace mesecina
