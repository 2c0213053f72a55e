// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/meshes/off_header.h"

#include <fmt/core.h>
#include <algorithm>
#include <utility>

#include "core/base/counted.h"

namespace mes {
namespace {

// Ids and rows are 32 bits wide.
constexpr std::uint64_t kMostThings = 0xfffffffe;

}  // namespace

bool has_off_magic(std::string_view bytes, const OffKind& kind) {
  Scanner scanner(bytes.substr(0, 4096));
  return scanner.next() && scanner.token() == kind.magic;
}

std::unexpected<Error> OffReader::fail(std::string text) const {
  return bad_input(std::move(text), name_, scanner_.line(), scanner_.column());
}

std::string OffReader::warning(std::string text) const {
  return Error{ErrorCode::bad_input, std::move(text), name_, scanner_.line(), scanner_.column()}.message();
}

Expected<std::uint64_t> OffReader::read_header() {
  const std::string magic = in_quotes(kind_.magic);
  const std::string_view things = kind_.things;
  if (!scanner_.next()) return fail(fmt::format("expected {}, found the end of the file", magic));
  if (scanner_.token() != kind_.magic)
    return fail(fmt::format("expected {}, found {}", magic, in_quotes(scanner_.token())));

  if (!scanner_.next()) return fail(fmt::format("expected the number of {}, found the end of the file", things));
  const auto count = parse_count(scanner_.token());
  if (!count || *count > kMostThings) {
    if (!count && count.error() == NumberFault::not_a_number)
      return fail(fmt::format("expected the number of {}, found {}", things, in_quotes(scanner_.token())));
    return fail(fmt::format("more than {} {} are announced: {}", kMostThings, things, in_quotes(scanner_.token())));
  }
  for (int i = 0; i < 2; ++i) {
    if (!scanner_.next()) return fail("the header must end with two integers, \"0 0\"; found the end of the file");
    std::string_view digits = scanner_.token();
    if (digits.starts_with('-')) digits.remove_prefix(1);
    if (!parse_count(digits))
      return fail("the header must end with two integers, \"0 0\"; found " + in_quotes(scanner_.token()));
  }
  count_ = *count;
  layout_ = LineLayout(kind_.numbers_each, scanner_.line());
  if (auto good = survey(); !good) return std::unexpected(good.error());
  return count_;
}

bool OffReader::next() {
  if (!scanner_.next()) {
    layout_.end();
    return false;
  }
  job_.passed(scanner_.token().data());
  layout_.add(scanner_.line(), scanner_.column(), scanner_.token().size());
  return true;
}

Expected<void> OffReader::survey() const {
  Scanner ahead = scanner_;
  LineLayout layout = layout_;
  constexpr std::size_t kOften = 1U << 14U;
  for (std::size_t i = 0; !layout.is_free() && ahead.next(); ++i) {
    if (i % kOften == 0) job_.checkpoint();
    layout.add(ahead.line(), ahead.column(), ahead.token().size());
  }
  if (layout.is_free()) return {};
  layout.end();
  if (auto error = contradiction(layout)) return std::unexpected(std::move(*error));
  return {};
}

std::optional<Error> OffReader::contradiction(const LineLayout& layout) const {
  const auto line = layout.contradiction(count_);
  if (!line) return std::nullopt;
  std::string text = fmt::format("{} {}, but {} have {}", counted(line->columns, "number"),
                                 line->are_all_alike ? "a line" : "on this line", kind_.things, kind_.numbers_each);
  if (const std::string_view guess = kind_.guess(line->columns); line->are_all_alike && !guess.empty())
    text += fmt::format(": probably {}", guess);
  return Error{ErrorCode::bad_input, std::move(text), name_, line->place.line, line->place.column};
}

std::size_t OffReader::likely_count() const {
  // Each number takes at least a digit and a white space, which bounds the number of things that can follow.
  return static_cast<std::size_t>(std::min<std::uint64_t>(count_, bytes_.size() / (2 * kind_.numbers_each) + 1));
}

Expected<void> OffReader::read_next(std::span<double> numbers) {
  for (double& number : numbers) {
    if (!next()) {
      if (auto error = contradiction(layout_)) return std::unexpected(std::move(*error));
      return fail(
          fmt::format("the file ends after {} of {} {}", numbers_read_, kind_.numbers_each * count_, kind_.numbers));
    }
    auto value = coordinates_.read(scanner_.token());
    if (!value) return fail(std::move(value.error()));
    number = *value;
    ++numbers_read_;
  }
  return {};
}

Expected<std::vector<std::string>> OffReader::finish() {
  std::vector<std::string> warnings;
  if (!next()) return warnings;
  warnings.push_back(warning(fmt::format("everything after the {} announced {} is ignored", count_, kind_.things)));
  while (next()) {
  }
  if (auto error = contradiction(layout_)) return std::unexpected(std::move(*error));
  return warnings;
}

}  // namespace mes
