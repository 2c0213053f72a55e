// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/json_text.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/io/text_numbers.h"

namespace mes {
namespace {

using nlohmann::json;

constexpr int kDeepest = 64;

struct TooDeep {};

std::unexpected<Error> complaint(std::string_view text, std::size_t offset, std::string what,
                                 const std::string& file) {
  const std::string_view before = text.substr(0, std::min(offset, text.size()));
  const auto line = static_cast<std::uint64_t>(std::ranges::count(before, '\n')) + 1;
  const std::size_t newline = before.rfind('\n');
  const std::size_t start = newline == std::string_view::npos ? 0 : newline + 1;
  return bad_input(std::move(what), file, line, before.size() - start + 1);
}

}  // namespace

Expected<json> parse_json(std::string_view text, const std::string& file) {
  const auto not_too_deep = [](int depth, json::parse_event_t /*event*/, const json& /*value*/) {
    if (depth > kDeepest) throw TooDeep{};
    return true;
  };
  try {
    return json::parse(text, not_too_deep);
  } catch (const json::parse_error& error) {
    // The number of bytes read, the offending one included.
    return complaint(text, error.byte == 0 ? 0 : error.byte - 1, "this is not JSON", file);
  } catch (const json::exception&) {
    return complaint(text, 0, "a number in this JSON is too large", file);
  } catch (const TooDeep&) {
    return complaint(text, 0, "this JSON is nested too deeply", file);
  }
}

}  // namespace mes
