// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/driver/mutation.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>
#include <optional>
#include <string_view>

namespace mes::fuzz {
namespace {

constexpr std::array<std::string_view, 28> kNumbers{"0",
                                                    "1",
                                                    "-1",
                                                    "2",
                                                    "3",
                                                    "255",
                                                    "256",
                                                    "4096",
                                                    "65535",
                                                    "65536",
                                                    "2147483647",
                                                    "2147483648",
                                                    "4294967294",
                                                    "4294967295",
                                                    "4294967296",
                                                    "9007199254740993",
                                                    "18446744073709551615",
                                                    "18446744073709551616",
                                                    "0.5",
                                                    "-0.0",
                                                    "1e-5",
                                                    "1e16",
                                                    "1.7976931348623157e308",
                                                    "1e309",
                                                    "5e-324",
                                                    "1e-400",
                                                    "nan",
                                                    "0x1p4"};
constexpr std::array<std::uint64_t, 12> kIntegers{0,      1,          0x7f,       0x80,        0xff,        0x7fff,
                                                  0x8000, 0x7fffffff, 0x80000000, 0xffffffffU, 0xfffffffeU, ~0ULL};

bool is_of_number(char c) {
  return (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '+' || c == 'e';
}

/// What stands between the quotes; nothing when that cannot be read.
std::optional<std::string> unescaped(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '\\') {
      out += text[i];
    } else if (text.substr(i + 1).starts_with('x')) {
      unsigned value = 0;
      const std::string_view digits = text.substr(i + 2, 2);
      const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
      if (digits.size() != 2 || read.ptr != digits.data() + 2) return std::nullopt;
      out += static_cast<char>(value);
      i += 3;
    } else {
      if (++i == text.size()) return std::nullopt;
      out += text[i];
    }
  }
  return out;
}

}  // namespace

bool Mutator::read_dictionary(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) return false;
  for (std::string line; std::getline(stream, line);) {
    if (line.empty() || line.starts_with('#')) continue;
    const auto word = line.size() > 2 && line.front() == '"' && line.back() == '"'
                          ? unescaped(std::string_view(line).substr(1, line.size() - 2))
                          : std::nullopt;
    if (!word) return false;
    words_.push_back(*word);
  }
  return true;
}

std::string Mutator::changed(std::string input, const std::string& other) {
  for (std::size_t changes = std::size_t{1} << pick(5); changes > 0; --changes) {
    change_once(input, other);
    if (input.size() > longest_) input.resize(longest_);
  }
  return input;
}

void Mutator::change_once(std::string& input, const std::string& other) {
  switch (pick(10)) {
    case 0: change_byte(input); break;
    case 1: change_integer(input); break;
    case 2:
    case 3: change_digits(input); break;
    case 4:
    case 5: put_word(input); break;
    case 6: {  // something is missing
      const auto [begin, length] = part_of(input);
      input.erase(begin, length);
      break;
    }
    case 7: {  // something is there twice
      const auto [begin, length] = part_of(input);
      input.insert(pick(input.size() + 1), input.substr(begin, length));
      break;
    }
    case 8: {  // something of another input
      const auto [begin, length] = part_of(other);
      const auto [at, replaced] = part_of(input);
      input.replace(at, pick(2) == 0 ? 0 : replaced, other, begin, length);
      break;
    }
    default: {  // the beginning of this one, the end of the other
      const std::size_t cut = pick(std::min(input.size(), other.size()) + 1);
      if (pick(4) == 0)
        input = input.substr(0, cut) + other.substr(cut);
      else
        input.insert(pick(input.size() + 1), 1, static_cast<char>(pick(256)));
    }
  }
}

void Mutator::change_byte(std::string& input) {
  if (input.empty()) return;
  char& byte = input[pick(input.size())];
  const auto old = static_cast<unsigned char>(byte);
  switch (pick(3)) {
    case 0: byte = static_cast<char>(old ^ (1U << pick(8))); break;
    case 1: byte = static_cast<char>(pick(256)); break;
    default: byte = static_cast<char>(old + pick(32) - 16U);
  }
}

void Mutator::change_integer(std::string& input) {
  const std::size_t bytes = std::size_t{1} << pick(4);
  if (input.size() < bytes) return;
  const std::size_t at = pick(input.size() - bytes + 1);
  const std::uint64_t value = kIntegers[pick(kIntegers.size())];
  const bool is_little = pick(2) == 0;
  for (std::size_t i = 0; i < bytes; ++i)
    input[at + (is_little ? i : bytes - 1 - i)] = static_cast<char>(value >> (8 * i));
}

void Mutator::change_digits(std::string& input) {
  const std::size_t from = pick(input.size() + 1);
  const auto begin = std::find_if(input.begin() + static_cast<std::ptrdiff_t>(from), input.end(), is_of_number);
  const auto end = std::find_if_not(begin, input.end(), is_of_number);
  if (begin == end) return;
  input.replace(begin, end, kNumbers[pick(kNumbers.size())]);
}

void Mutator::put_word(std::string& input) {
  if (words_.empty()) return change_byte(input);
  const std::string& word = words_[pick(words_.size())];
  const std::size_t at = pick(input.size() + 1);
  input.replace(at, pick(2) == 0 ? 0 : word.size(), word);
}

std::pair<std::size_t, std::size_t> Mutator::part_of(const std::string& text) {
  const std::size_t begin = pick(text.size() + 1);
  // Short parts are more common than long ones.
  const std::size_t most = std::min(text.size() - begin, std::size_t{1} << pick(12));
  return {begin, pick(most + 1)};
}

}  // namespace mes::fuzz
