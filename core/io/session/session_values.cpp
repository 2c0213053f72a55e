// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/session/session_values.h"

#include <fmt/core.h>
#include <limits>
#include <optional>

#include "core/document/delta.h"

namespace mes {
namespace {

/// Iterates over the numbers of a list.
struct Numbers {
  JsonView::Elements::Iterator at;
  const std::string& where;
  JsonView next() {
    const JsonView out = *at;
    ++at;
    return out;
  }
};

void take(Numbers& from, double& out) {
  out = number_of(from.next(), from.where);
}
void take(Numbers& from, std::uint32_t& out) {
  out = count_of(from.next(), from.where);
}
void take(Numbers& from, Vec2& out) {
  take(from, out.x);
  take(from, out.y);
}
void take(Numbers& from, Disk& out) {
  take(from, out.center);
  take(from, out.radius);
}
template <class Place>
void take(Numbers& from, std::pair<std::uint32_t, Place>& out) {
  take(from, out.first);
  take(from, out.second);
}
/// The first number that no document can hold, and why; `index` counts within the thing.
struct BadNumber {
  std::size_t index = 0;
  std::string why;
};
std::optional<BadNumber> bad_number_of(std::uint32_t /*count*/) {
  return std::nullopt;
}
template <class Place>
std::optional<BadNumber> bad_number_of(const Place& place) {
  std::optional<BadNumber> out;
  std::size_t index = 0;
  for_each_number(place, [&](double x) {
    if (const auto fault = range_fault_of(x); fault && !out) out = BadNumber{index, describe(*fault, x)};
    ++index;
  });
  return out;
}
template <class Place>
std::optional<BadNumber> bad_number_of(const std::pair<std::uint32_t, Place>& thing) {
  auto out = bad_number_of(thing.second);
  if (out) ++out->index;
  return out;
}

/// An element of a list.
JsonView element_of(JsonView list, std::size_t index) {
  auto at = list.elements().begin();
  while (index-- > 0) ++at;
  return *at;
}

template <class T>
constexpr std::size_t kNumbersEach = 1;
template <>
constexpr std::size_t kNumbersEach<Vec2> = 2;
template <>
constexpr std::size_t kNumbersEach<Disk> = 3;
template <class Place>
constexpr std::size_t kNumbersEach<std::pair<std::uint32_t, Place>> = 1 + kNumbersEach<Place>;

}  // namespace

void complain(const std::string& where, const std::string& what) {
  throw Nonsense{where + ": " + what};
}

std::string text_from(JsonView value, const char* key, const std::string& where) {
  if (!value) return {};
  if (!value.is_text()) complain(where, fmt::format("\"{}\" is not a text", key));
  return value.text();
}

std::string short_text_from(JsonView value, const char* key, std::size_t longest, const std::string& where) {
  constexpr std::size_t kLongestEscape = 6;
  if (!value) return {};
  if (!value.is_text()) throw Nonsense{fmt::format("{}: \"{}\" is not a text", where, key), value};
  std::string out = value.text_length() <= kLongestEscape * longest ? value.text() : std::string();
  if (value.text_length() > kLongestEscape * longest || out.size() > longest)
    throw Nonsense{fmt::format("{}: \"{}\" is longer than {} bytes", where, key, longest), value};
  return out;
}

double number_of(JsonView value, const std::string& where) {
  if (!value.is_number()) complain(where, "not a number");
  return value.number();
}

std::uint32_t count_of(JsonView value, const std::string& where) {
  const auto count = value.is_number() ? value.count() : std::nullopt;
  if (!count || *count > std::numeric_limits<std::uint32_t>::max())
    complain(where, "not a whole number that counts something");
  return static_cast<std::uint32_t>(*count);
}

std::vector<Vec2> places_of(JsonView list, const std::string& where) {
  std::vector<Vec2> out(list.size() / kNumbersEach<Vec2>);
  Numbers numbers{list.elements().begin(), where};
  for (Vec2& place : out) take(numbers, place);
  return out;
}

template <class T>
void read_flat(JsonView list, const char* key, std::vector<T>& out, const std::string& where) {
  if (!list) return;
  const std::string here = fmt::format("{} \"{}\"", where, key);
  constexpr std::size_t each = kNumbersEach<T>;
  if (!list.is_list()) complain(here, "not a list");
  const std::size_t count = list.size();
  if (count % each != 0) complain(here, fmt::format("the number of numbers is not a multiple of {}", each));
  out.resize(count / each);
  Numbers numbers{list.elements().begin(), here};
  for (std::size_t i = 0; i < out.size(); ++i) {
    take(numbers, out[i]);
    if (const auto bad = bad_number_of(out[i]))
      throw Nonsense{here + ": " + bad->why, element_of(list, each * i + bad->index)};
  }
}

template void read_flat(JsonView, const char*, std::vector<std::uint32_t>&, const std::string&);
template void read_flat(JsonView, const char*, std::vector<Vec2>&, const std::string&);
template void read_flat(JsonView, const char*, std::vector<Disk>&, const std::string&);
template void read_flat(JsonView, const char*, std::vector<std::pair<std::uint32_t, Vec2>>&, const std::string&);
template void read_flat(JsonView, const char*, std::vector<std::pair<std::uint32_t, Disk>>&, const std::string&);

template <class T>
void require_together(const std::vector<T>& things, JsonView list, const char* key, const std::string& where,
                      Magnitudes& seen) {
  std::size_t index = 0;
  for (const T& thing : things) {
    for_each_number(thing, [&](double x) {
      if (const auto fault = seen.fault_of(x))
        throw Nonsense{fmt::format("{} \"{}\": {}", where, key, describe(*fault, x, seen)), element_of(list, index)};
      seen.add(x);
      ++index;
    });
  }
}

template void require_together(const std::vector<Vec2>&, JsonView, const char*, const std::string&, Magnitudes&);
template void require_together(const std::vector<Disk>&, JsonView, const char*, const std::string&, Magnitudes&);

}  // namespace mes
