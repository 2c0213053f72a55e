// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/settings/parameter_values.h"

#include <algorithm>
#include <iterator>

namespace mes {
namespace {

auto place_of(auto& entries, std::string_view id) {
  return std::ranges::lower_bound(entries, id, {}, [](const auto& entry) -> std::string_view { return entry.id; });
}

/// Whether `b` contains every value of `a` that is not a default.
bool agrees(const std::vector<ParameterValues::Entry>& a, const std::vector<ParameterValues::Entry>& b) {
  return std::ranges::all_of(a, [&b](const ParameterValues::Entry& entry) {
    if (entry.default_value == entry.value) return true;
    const auto other = place_of(b, entry.id);
    return other != b.end() && other->id == entry.id && other->value == entry.value;
  });
}

}  // namespace

double ParameterValues::operator[](const Parameter& parameter) const {
  const auto found = place_of(entries_, parameter.id);
  if (found == entries_.end() || found->id != parameter.id) return parameter.default_value;
  return found->default_value ? found->value : within(parameter, found->value);
}

double& ParameterValues::operator[](const Parameter& parameter) {
  auto found = place_of(entries_, parameter.id);
  if (found == entries_.end() || found->id != parameter.id)
    found = entries_.insert(found, Entry{parameter.id, parameter.default_value, parameter.default_value, true});
  else if (!found->default_value)
    found->value = within(parameter, found->value);
  found->default_value = parameter.default_value;
  found->is_of_document = parameter.is_of_document;
  return found->value;
}

void ParameterValues::keep(std::string_view id, double value) {
  const auto found = place_of(entries_, id);
  if (found != entries_.end() && found->id == id)
    *found = Entry{std::move(found->id), value, {}, true};
  else
    entries_.insert(found, Entry{std::string(id), value, {}, true});
}

std::vector<ParameterValues::Entry> ParameterValues::changed() const {
  std::vector<Entry> out;
  std::ranges::copy_if(entries_, std::back_inserter(out),
                       [](const Entry& entry) { return entry.default_value != entry.value; });
  return out;
}

void ParameterValues::reset_for_another_document() {
  std::erase_if(entries_, [](const Entry& entry) { return entry.is_of_document; });
}

bool operator==(const ParameterValues& a, const ParameterValues& b) {
  return agrees(a.entries_, b.entries_) && agrees(b.entries_, a.entries_);
}

}  // namespace mes
