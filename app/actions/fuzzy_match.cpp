// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/fuzzy_match.h"

#include <algorithm>
#include <limits>

#include "core/base/lower_case.h"

namespace mes {
namespace {

constexpr double kLetter = 1.0;
constexpr double kWordBegins = 6.0;
constexpr double kTextBegins = 2.0;  // added if the match is at the beginning of the text
constexpr double kSideBySide = 7.0;  // more than a beginning: "sa" means "Save" rather than "Select all"
constexpr double kWordEnds = 1.0;    // a whole word was typed
constexpr double kGap = 0.15;        // for each letter skipped between two matching ones
constexpr double kLength = 0.02;     // for each letter of the text
constexpr double kImpossible = -std::numeric_limits<double>::infinity();

bool is_part_of_word(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || byte >= 0x80U;
}

/// Finds the best match of one word. `score[i][j]`: letters 0 to i of the word match, the last of them at j.
class WordSearch {
 public:
  WordSearch(std::string_view word, std::string_view text)
      : word_(word),
        text_(text),
        score_(word.size() * text.size(), kImpossible),
        from_(word.size() * text.size(), text.size()) {}

  std::optional<FuzzyMatch> best() {
    if (word_.size() > text_.size()) return std::nullopt;
    for (std::size_t i = 0; i < word_.size(); ++i) fill_row(i);
    const auto last = score_.end() - static_cast<std::ptrdiff_t>(text_.size());
    const auto top = std::max_element(last, score_.end());
    if (*top == kImpossible) return std::nullopt;
    FuzzyMatch out{.score = *top, .letters = {}};
    std::size_t j = static_cast<std::size_t>(top - last);
    for (std::size_t i = word_.size(); i-- > 0;) {
      out.letters.push_back(j);
      j = from_[at(i, j)];
    }
    std::ranges::reverse(out.letters);
    for (std::size_t i = 1; i < out.letters.size(); ++i)
      if (out.letters[i] != out.letters[i - 1] + 1 && !begins_word(out.letters[i])) ++out.scattered;
    return out;
  }

 private:
  std::size_t at(std::size_t i, std::size_t j) const { return i * text_.size() + j; }

  bool begins_word(std::size_t j) const {
    return j == 0 || (is_part_of_word(text_[j]) && !is_part_of_word(text_[j - 1]));
  }

  double value_of(std::size_t i, std::size_t j) const {
    double out = kLetter;
    if (j == 0) out += kTextBegins;
    if (begins_word(j)) out += kWordBegins;
    const bool ends = j + 1 == text_.size() || !is_part_of_word(text_[j + 1]);
    if (i + 1 == word_.size() && ends) out += kWordEnds;
    return out;
  }

  void fill_row(std::size_t i) {
    // The best position of the previous letter that is not adjacent, including the gap up to here.
    double before = kImpossible;
    std::size_t before_at = text_.size();
    for (std::size_t j = 0; j < text_.size(); ++j) {
      before -= kGap;
      if (i > 0 && j >= 2 && score_[at(i - 1, j - 2)] - kGap > before) {
        before = score_[at(i - 1, j - 2)] - kGap;
        before_at = j - 2;
      }
      if (text_[j] != word_[i]) continue;
      if (i == 0) {
        score_[at(i, j)] = value_of(i, j);
        continue;
      }
      const double beside = j > 0 ? score_[at(i - 1, j - 1)] + kSideBySide : kImpossible;
      const bool is_beside = beside >= before;
      const double best = is_beside ? beside : before;
      if (best == kImpossible) continue;
      score_[at(i, j)] = best + value_of(i, j);
      from_[at(i, j)] = is_beside ? j - 1 : before_at;
    }
  }

  std::string_view word_;
  std::string_view text_;
  std::vector<double> score_;
  std::vector<std::size_t> from_;
};

}  // namespace

std::optional<FuzzyMatch> fuzzy_match(std::string_view query, std::string_view text) {
  constexpr std::size_t kLongestText = 300;
  const std::string small_query = lower_case(query);
  const std::string small_text = lower_case(text.substr(0, kLongestText));
  std::string_view rest = small_query;
  FuzzyMatch out;
  for (;;) {
    rest.remove_prefix(std::min(rest.find_first_not_of(' '), rest.size()));
    if (rest.empty()) break;
    const std::string_view word = rest.substr(0, rest.find(' '));
    rest.remove_prefix(word.size());
    const auto found = WordSearch(word, small_text).best();
    if (!found) return std::nullopt;
    out.score += found->score;
    out.scattered += found->scattered;
    out.letters.insert(out.letters.end(), found->letters.begin(), found->letters.end());
  }
  out.score -= kLength * static_cast<double>(small_text.size());
  std::ranges::sort(out.letters);
  const auto twice = std::ranges::unique(out.letters);
  out.letters.erase(twice.begin(), twice.end());
  return out;
}

}  // namespace mes
