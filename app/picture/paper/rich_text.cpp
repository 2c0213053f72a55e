// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/picture/paper/rich_text.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "app/picture/paper/internal/utf8_letter.h"

namespace mes {
namespace {

constexpr auto kSigns = std::to_array<RichSign>({
    {"alpha", "α"},      {"beta", "β"},   {"gamma", "γ"},   {"delta", "δ"},    {"epsilon", "ϵ"}, {"varepsilon", "ε"},
    {"zeta", "ζ"},       {"eta", "η"},    {"theta", "θ"},   {"vartheta", "ϑ"}, {"iota", "ι"},    {"kappa", "κ"},
    {"lambda", "λ"},     {"mu", "μ"},     {"nu", "ν"},      {"xi", "ξ"},       {"pi", "π"},      {"rho", "ρ"},
    {"sigma", "σ"},      {"tau", "τ"},    {"upsilon", "υ"}, {"phi", "ϕ"},      {"varphi", "φ"},  {"chi", "χ"},
    {"psi", "ψ"},        {"omega", "ω"},  {"Gamma", "Γ"},   {"Delta", "Δ"},    {"Theta", "Θ"},   {"Lambda", "Λ"},
    {"Xi", "Ξ"},         {"Pi", "Π"},     {"Sigma", "Σ"},   {"Upsilon", "Υ"},  {"Phi", "Φ"},     {"Psi", "Ψ"},
    {"Omega", "Ω"},      {"le", "≤"},     {"leq", "≤"},     {"ge", "≥"},       {"geq", "≥"},     {"ne", "≠"},
    {"neq", "≠"},        {"approx", "≈"}, {"times", "×"},   {"cdot", "·"},     {"pm", "±"},      {"to", "→"},
    {"rightarrow", "→"}, {"infty", "∞"},  {"partial", "∂"}, {"ldots", "…"},    {"ell", "ℓ"},     {"emptyset", "∅"},
    {"leftarrow", "←"},  {"circ", "°"},
});

constexpr std::array<std::string_view, 15> kRelations{"=", "<", ">", "+", "−", "≤", "≥", "≠",
                                                      "≈", "×", "·", "±", "→", "←", ":"};
constexpr double kScriptSize = 0.7;
constexpr double kRaised = 0.36;
constexpr double kLowered = 0.17;
constexpr double kSpaceAroundRelations = 0.22;
constexpr int kDeepest = 8;

bool is_letter(char c) {
  return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z');
}

/// The number of bytes of the first letter; 0 if they are not UTF-8 (RFC 3629).
std::size_t bytes_of_valid_letter(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned lead = byte(0);
  const std::size_t size = lead < 0x80U   ? 1
                           : lead < 0xC2U ? 0
                           : lead < 0xE0U ? 2
                           : lead < 0xF0U ? 3
                           : lead < 0xF5U ? 4
                                          : 0;
  if (size > text.size()) return 0;
  for (std::size_t i = 1; i < size; ++i)
    if (byte(i) >> 6U != 2U) return 0;
  // Rejects overlong forms, surrogates, and values beyond the last code point.
  if (size > 2) {
    const unsigned second = byte(1);
    if ((lead == 0xE0U && second < 0xA0U) || (lead == 0xEDU && second >= 0xA0U) ||
        (lead == 0xF0U && second < 0x90U) || (lead == 0xF4U && second >= 0x90U))
      return 0;
  }
  return size;
}

std::string escaped(std::string_view letter) {
  if (letter == "\\") return "\\textbackslash{}";
  if (letter == "~") return "\\textasciitilde{}";
  if (letter == "^") return "\\textasciicircum{}";
  if (letter == "°") return "$^\\circ$";
  for (const RichSign& sign : kSigns)
    if (sign.sign == letter) return "$\\" + std::string(sign.command) + "$";
  if (letter.size() == 1 && std::string_view("$%&#_{}").find(letter.front()) != std::string_view::npos)
    return "\\" + std::string(letter);
  return std::string(letter);
}

/// Sets one line in a single pass over its source. The end of the line closes open groups, so its TeX is always
/// closed.
class LineSetter {
 public:
  LineSetter(std::string_view source, std::string_view value, double letters, const MeasureText& measure,
             std::string& complaint)
      : source_(source), value_(value), measure_(measure), letters_(letters), complaint_(complaint) {}

  RichLine set() {
    text({letters_, 0.0, Face::plain}, 0);
    line_.width = std::max(x_, widest_);
    return std::move(line_);
  }

 private:
  struct Look {
    double size;
    double raise;
    Face face;
  };

  void complain(std::string what) {
    if (complaint_.empty()) complaint_ = std::move(what);
  }
  bool is_at_end() const { return at_ >= source_.size(); }

  void put(std::string_view letters, const Look& look) {
    if (letters.empty()) return;
    std::vector<RichPiece>& pieces = line_.pieces;
    const bool goes_on = !pieces.empty() && pieces_end_ == x_ && pieces.back().face == look.face &&
                         pieces.back().size == look.size && pieces.back().raise == look.raise;
    if (goes_on)
      pieces.back().text += letters;
    else
      pieces.push_back({x_, look.raise, look.size, look.face, std::string(letters)});
    x_ = pieces.back().x + measure_(pieces.back().text, look.size, look.face);
    pieces_end_ = x_;
  }
  void skip(double width) { x_ += width; }

  /// Reads the letters of a command after its backslash.
  std::string_view command() {
    const std::size_t begin = at_;
    while (!is_at_end() && is_letter(source_[at_])) ++at_;
    return source_.substr(begin, at_ - begin);
  }

  static std::optional<std::string_view> sign_of(std::string_view command) {
    const auto found = std::ranges::find(kSigns, command, &RichSign::command);
    if (found == kSigns.end()) return std::nullopt;
    return found->sign;
  }

  /// Reads a group in braces, and gives its content to `inside`.
  template <class Inside>
  void group(Inside inside) {
    if (is_at_end() || source_[at_] != '{') return complain("a command lacks its {...}");
    ++at_;
    inside();
    if (is_at_end() || source_[at_] != '}') return complain("a { is not closed");
    ++at_;
  }

  /// Reads up to the brace that closes the group, exclusively, or to the end; with `depth` > 0 a group is open.
  void text(const Look& look, int depth) {
    if (depth > kDeepest) return complain("too many braces within each other");
    while (!is_at_end() && !(depth > 0 && source_[at_] == '}')) {
      const char c = source_[at_];
      if (c == '$') {
        ++at_;
        line_.latex += '$';
        after_operand_ = false;
        mathematics(look, depth + 1);
        line_.latex += '$';
        if (is_at_end() || source_[at_] != '$')
          complain("a $ is not closed");
        else
          ++at_;
      } else if (c == '\\') {
        ++at_;
        text_command(look, depth);
      } else {
        const std::string_view letter = source_.substr(at_, bytes_of_letter(source_, at_));
        at_ += letter.size();
        put(letter, look);
        line_.latex += escaped(letter);
      }
    }
  }

  void text_command(const Look& look, int depth) {
    if (is_at_end()) return put_escaped("\\", look);
    const std::string_view name = command();
    if (name.empty()) {
      const std::string_view letter = source_.substr(at_, bytes_of_letter(source_, at_));
      at_ += letter.size();
      if (std::string_view("$%&#_{}").find(letter) == std::string_view::npos) put_escaped("\\", look);
      return put_escaped(letter, look);
    }
    if (name == "value") return put_escaped(value_, look);
    if (const auto sign = sign_of(name)) {
      put_escaped(*sign, look);
      // TeX takes the space after a command as its end.
      if (!is_at_end() && source_[at_] == ' ') ++at_;
      return;
    }
    if (name == "textbf" || name == "textit" || name == "emph") {
      line_.latex += '\\' + std::string(name) + '{';
      group([&] { text({look.size, look.raise, name == "textbf" ? Face::bold : Face::italic}, depth + 1); });
      line_.latex += '}';
      return;
    }
    complain("\\" + std::string(name) + " is not known");
    put_escaped("\\" + std::string(name), look);
  }

  void put_escaped(std::string_view text, const Look& look) {
    put(text, look);
    while (!text.empty()) {
      const std::size_t size = bytes_of_letter(text, 0);
      line_.latex += escaped(text.substr(0, size));
      text.remove_prefix(size);
    }
  }

  void put_operator(std::string_view sign, const Look& look) {
    const bool is_relation = std::ranges::find(kRelations, sign) != kRelations.end();
    // A sign before a number is close to it, and so is everything in scripts.
    const bool is_spaced = is_relation && after_operand_ && look.size == letters_;
    if (is_spaced) skip(kSpaceAroundRelations * look.size);
    put(sign, {look.size, look.raise, Face::plain});
    if (is_spaced) skip(kSpaceAroundRelations * look.size);
    after_operand_ = !is_relation && sign != "(" && sign != "[" && sign != ",";
    if (sign == ",") skip(kSpaceAroundRelations * look.size);
  }

  /// Reads mathematics up to its closing sign, exclusively, or to the end.
  void mathematics(const Look& look, int depth) {
    if (depth > kDeepest) return complain("too many braces within each other");
    while (!is_at_end() && source_[at_] != '$' && source_[at_] != '}') {
      const char c = source_[at_];
      if (c == '_' || c == '^')
        scripts(look, depth);
      else
        atom(look, depth);
    }
  }

  /// Sets one letter, command or group.
  void atom(const Look& look, int depth) {
    const char c = source_[at_];
    if (c == ' ') {
      ++at_;
      if (!line_.latex.ends_with(' ')) line_.latex += ' ';
      return;
    }
    if (c == '{') {
      line_.latex += '{';
      group([&] { mathematics(look, depth + 1); });
      line_.latex += '}';
      return;
    }
    if (c == '\\') {
      ++at_;
      return math_command(look, depth);
    }
    const std::string_view letter = source_.substr(at_, bytes_of_letter(source_, at_));
    at_ += letter.size();
    if (is_letter(c)) {
      put(letter, {look.size, look.raise, Face::italic});
      after_operand_ = true;
    } else {
      put_operator(letter == "-" ? std::string_view("−") : letter == "'" ? std::string_view("′") : letter, look);
    }
    line_.latex += in_mathematics(letter);
  }

  static std::string in_mathematics(std::string_view letter) {
    if (letter.size() == 1 && std::string_view("%&#").find(letter.front()) != std::string_view::npos)
      return '\\' + std::string(letter);
    if (letter == "°") return "^\\circ ";
    if (letter == "~") return "\\sim ";
    for (const RichSign& sign : kSigns)
      if (sign.sign == letter) return '\\' + std::string(sign.command) + ' ';
    if (letter.size() > 1) return "\\mbox{" + std::string(letter) + '}';
    return std::string(letter);
  }

  void math_command(const Look& look, int depth) {
    const std::string_view name = command();
    if (name.empty()) {
      const std::string_view letter =
          is_at_end() ? std::string_view() : source_.substr(at_, bytes_of_letter(source_, at_));
      at_ += letter.size();
      if (letter == "," || letter == ";" || letter == "!") {
        if (letter != "!") skip(kSpaceAroundRelations * look.size);
        line_.latex += '\\' + std::string(letter);
        return;
      }
      if (letter.empty() || std::string_view("$%&#_{}").find(letter) == std::string_view::npos)
        return complain("a backslash without a command");
      put_operator(letter, look);
      line_.latex += '\\' + std::string(letter);
      return;
    }
    if (name == "value") {
      put(value_, {look.size, look.raise, Face::plain});
      line_.latex += "\\mbox{";
      for (std::string_view rest = value_; !rest.empty();) {
        const std::size_t size = bytes_of_letter(rest, 0);
        line_.latex += escaped(rest.substr(0, size));
        rest.remove_prefix(size);
      }
      line_.latex += '}';
      after_operand_ = true;
      return;
    }
    if (const auto sign = sign_of(name)) {
      const bool is_greek = static_cast<unsigned char>(sign->front()) == 0xCEU || sign->front() == '\xCF';
      const bool is_capital = 'A' <= name.front() && name.front() <= 'Z';
      if (name == "circ") {
        // The degree sign is raised already.
        put(*sign, {letters_, 0.0, Face::plain});
      } else if (is_greek) {
        put(*sign, {look.size, look.raise, is_capital ? Face::plain : Face::italic});
        after_operand_ = true;
      } else {
        put_operator(*sign, look);
      }
      line_.latex += '\\' + std::string(name) + ' ';
      return;
    }
    if (name == "mathrm" || name == "textrm" || name == "text" || name == "mathbf" || name == "textbf") {
      // Set as text: the content keeps its spaces and is not in italics.
      const bool is_bold = name.ends_with("bf");
      line_.latex += is_bold ? "\\mbox{\\bfseries " : "\\mbox{";
      group([&] { text({look.size, look.raise, is_bold ? Face::bold : Face::plain}, depth + 1); });
      line_.latex += '}';
      after_operand_ = true;
      return;
    }
    complain("\\" + std::string(name) + " is not known");
    put("\\" + std::string(name), {look.size, look.raise, Face::plain});
    line_.latex += "\\mbox{\\textbackslash{}" + std::string(name) + '}';
    after_operand_ = true;
  }

  /// Sets a subscript, a superscript, or one above the other.
  void scripts(const Look& look, int depth) {
    const double begin = x_;
    double end = x_;
    bool has[2] = {false, false};
    while (!is_at_end() && (source_[at_] == '_' || source_[at_] == '^')) {
      const bool is_raised = source_[at_] == '^';
      if (std::exchange(has[is_raised ? 1 : 0], true)) {
        complain("a letter has two scripts of one kind");
        line_.latex += "{}";
      }
      if (line_.latex.ends_with(' ')) line_.latex.pop_back();
      line_.latex += source_[at_++];
      const Look smaller{kScriptSize * look.size, look.raise + (is_raised ? kRaised : -kLowered) * look.size,
                         look.face};
      x_ = begin;
      pieces_end_.reset();
      while (!is_at_end() && source_[at_] == ' ') ++at_;
      line_.latex += '{';
      if (is_at_end() || std::string_view("$}_^").find(source_[at_]) != std::string_view::npos) {
        complain("a script lacks its letters");
      } else if (source_[at_] == '{') {
        group([&] { mathematics(smaller, depth + 1); });
      } else if (depth < kDeepest) {
        atom(smaller, depth + 1);
      } else {
        ++at_;
        complain("too many braces within each other");
      }
      line_.latex += '}';
      end = std::max(end, x_);
    }
    x_ = end;
    widest_ = std::max(widest_, end);
    after_operand_ = true;
    pieces_end_.reset();
  }

  std::string_view source_;
  std::string_view value_;
  const MeasureText& measure_;
  double letters_;
  std::string& complaint_;
  RichLine line_;
  std::size_t at_ = 0;
  double x_ = 0.0;
  double widest_ = 0.0;
  std::optional<double> pieces_end_;  // end of the last piece, where letters of the same look may continue
  bool after_operand_ = false;
};

/// The position of the next line break by two backslashes; the end of the source if there is none.
std::size_t end_by_command(std::string_view source, std::size_t at) {
  for (; at + 1 < source.size(); ++at) {
    if (source[at] != '\\') continue;
    if (source[at + 1] == '\\') return at;
    ++at;  // an escaped sign
  }
  return source.size();
}

}  // namespace

std::string readable_text(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  while (!text.empty()) {
    const std::size_t size = bytes_of_valid_letter(text);
    const bool is_control = size == 1 && static_cast<unsigned char>(text.front()) < 0x20U && text.front() != '\n';
    out += size == 0 ? "?" : is_control ? " " : text.substr(0, size);
    text.remove_prefix(std::max<std::size_t>(size, 1));
  }
  return out;
}

std::span<const RichSign> rich_text_signs() {
  return kSigns;
}

RichText rich_text(std::string_view words, std::string_view value, double letters, const MeasureText& measure) {
  const std::string source = readable_text(words);
  RichText out;
  bool has_letters = false;
  for (std::size_t at = 0; at <= source.size();) {
    const std::size_t end = std::min({source.find('\n', at), end_by_command(source, at), source.size()});
    out.lines.push_back(
        LineSetter(std::string_view(source).substr(at, end - at), value, letters, measure, out.complaint).set());
    has_letters = has_letters || !out.lines.back().pieces.empty();
    at = end + (end < source.size() && source[end] == '\\' ? 2 : 1);
  }
  if (!has_letters) out.lines.clear();
  return out;
}

void add_pieces(const RichLine& line, Vec2 start, Rgb color, std::vector<PaperDrawing::Line>& to) {
  bool is_first = true;
  for (const RichPiece& piece : line.pieces) {
    to.push_back({.x = start.x + piece.x,
                  .top = start.y - piece.raise - kPaperAscent * piece.size,
                  .size = piece.size,
                  .face = piece.face,
                  .color = color,
                  .text = piece.text,
                  .latex = is_first ? line.latex : std::string(),
                  .continues = !is_first});
    is_first = false;
  }
}

}  // namespace mes
