// SPDX-License-Identifier: GPL-3.0-or-later
// Inputs made of other inputs: bits turned over, ranges moved, numbers and words put in.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/rng.h"

namespace mes::fuzz {

class Mutator {
 public:
  Mutator(std::uint64_t seed, std::size_t longest) : random_(seed), longest_(longest) {}

  /// Words worth trying, in the notation of libFuzzer and AFL: a line `"..."` each, with `\\`, `\"` and `\xHH`.
  /// False when there is a line that is none.
  bool read_dictionary(const std::filesystem::path& file);

  /// One to sixteen changes of `input`; some of them take parts of `other`.
  std::string changed(std::string input, const std::string& other);
  /// A number below `count`, which is not zero.
  std::size_t pick(std::size_t count) { return static_cast<std::size_t>(random_.below(count)); }

 private:
  void change_once(std::string& input, const std::string& other);
  void change_byte(std::string& input);
  void change_integer(std::string& input);
  void change_digits(std::string& input);
  void put_word(std::string& input);
  /// A random part of the text: where it begins and how long it is.
  std::pair<std::size_t, std::size_t> part_of(const std::string& text);

  Rng random_;
  std::size_t longest_;
  std::vector<std::string> words_;
};

}  // namespace mes::fuzz
