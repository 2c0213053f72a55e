// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/picture/paper/caption_text.h"

#include <algorithm>
#include <array>
#include <utility>

#include "app/picture/paper/internal/utf8_letter.h"
#include "app/picture/paper/rich_text.h"

namespace mes {
namespace {

constexpr int kDeepestHeading = 3;
constexpr std::string_view kEscapable = "*$#-\\_`[]()!+.";

std::string_view trimmed_line(std::string_view line) {
  const std::size_t begin = line.find_first_not_of(" \t\r");
  if (begin == std::string_view::npos) return {};
  return line.substr(begin, line.find_last_not_of(" \t\r") - begin + 1);
}

/// The level of a heading line; 0 for any other line.
int heading_level(std::string_view line) {
  const std::size_t signs = std::min(line.find_first_not_of('#'), line.size());
  if (signs == 0 || signs > kDeepestHeading || signs == line.size() || line[signs] != ' ') return 0;
  return static_cast<int>(signs);
}

bool is_item(std::string_view line) {
  return line.starts_with("- ") || line.starts_with("* ");
}

/// Reads the spans of one block.
class SpanReader {
 public:
  std::vector<CaptionSpan> read(std::string_view text) {
    read(text, false, false);
    return std::move(spans_);
  }

 private:
  void put(std::string_view letters, bool is_bold, bool is_italic) {
    if (spans_.empty() || spans_.back().is_mathematics || spans_.back().is_bold != is_bold ||
        spans_.back().is_italic != is_italic)
      spans_.push_back({.text = {}, .is_bold = is_bold, .is_italic = is_italic});
    spans_.back().text += letters;
  }

  /// The position that closes the sign opened before `from`; npos if there is none.
  static std::size_t closing(std::string_view text, std::size_t from, std::string_view sign) {
    for (std::size_t at = from; at < text.size(); ++at) {
      if (text[at] == '\\') {
        ++at;
      } else if (text[at] == '$' && sign != "$") {
        const std::size_t end = closing(text, at + 1, "$");
        if (end != std::string_view::npos) at = end;
      } else if (sign == "*" && text.substr(at).starts_with("**")) {
        ++at;
      } else if (text.substr(at).starts_with(sign)) {
        if (at > from && (sign == "$" || text[at - 1] != ' ')) return at;
        if (sign == "$") return std::string_view::npos;
      }
    }
    return std::string_view::npos;
  }

  void read(std::string_view text, bool is_bold, bool is_italic) {
    for (std::size_t at = 0; at < text.size();) {
      const char c = text[at];
      if (c == '\\' && at + 1 < text.size() && kEscapable.find(text[at + 1]) != std::string_view::npos) {
        put(text.substr(at + 1, 1), is_bold, is_italic);
        at += 2;
        continue;
      }
      const bool is_strong = !is_bold && text.substr(at).starts_with("**");
      const std::string_view sign = c == '$'                                                       ? "$"
                                    : is_strong                                                    ? "**"
                                    : c == '*' && !is_italic && !text.substr(at).starts_with("**") ? "*"
                                                                                                   : "";
      const std::size_t from = at + sign.size();
      const bool may_open = !sign.empty() && from < text.size() && (sign == "$" || text[from] != ' ');
      const std::size_t end = may_open ? closing(text, from, sign) : std::string_view::npos;
      if (end == std::string_view::npos) {
        const std::size_t letters = std::max<std::size_t>(sign.size(), 1);
        put(text.substr(at, letters), is_bold, is_italic);
        at += letters;
        continue;
      }
      const std::string_view inside = text.substr(from, end - from);
      if (sign == "$")
        spans_.push_back(
            {.text = std::string(inside), .is_bold = is_bold, .is_italic = is_italic, .is_mathematics = true});
      else
        read(inside, is_bold || sign == "**", is_italic || sign == "*");
      at = end + sign.size();
    }
  }

  std::vector<CaptionSpan> spans_;
};

Face face_of(const CaptionSpan& span, bool is_heading) {
  if (span.is_bold || is_heading) return Face::bold;
  return span.is_italic ? Face::italic : Face::plain;
}

RichText mathematics(const CaptionSpan& span, double letters, const MeasureText& measure) {
  return rich_text('$' + span.text + '$', "", letters, measure);
}

/// A part of a word; lines are not broken within a word.
struct Atom {
  const CaptionSpan* span = nullptr;
  std::string text;  // empty for mathematics
};
using Word = std::vector<Atom>;

std::vector<Word> words_of(const CaptionBlock& block) {
  std::vector<Word> out;
  bool goes_on = false;  // the next atom belongs to the last word
  const auto put = [&](Atom atom) {
    if (!goes_on) out.emplace_back();
    out.back().push_back(std::move(atom));
    goes_on = true;
  };
  for (const CaptionSpan& span : block.spans) {
    if (span.is_mathematics) {
      put({&span, {}});
      continue;
    }
    for (std::string_view rest = span.text; !rest.empty();) {
      const std::size_t space = std::min(rest.find(' '), rest.size());
      if (space > 0) put({&span, std::string(rest.substr(0, space))});
      if (space < rest.size()) goes_on = false;
      rest.remove_prefix(std::min(space + 1, rest.size()));
    }
  }
  return out;
}

/// Sets blocks below each other.
class ColumnSetter {
 public:
  ColumnSetter(const CaptionLook& look, const MeasureText& measure) : look_(look), measure_(measure) {}

  void set(const CaptionBlock& block, bool is_first, bool follows_item) {
    constexpr std::array<double, kDeepestHeading> kHeadings{1.55, 1.25, 1.08};
    constexpr double kSpaceBefore = 0.55;
    constexpr double kSpaceBeforeHeading = 0.9;
    constexpr double kSpaceBetweenItems = 0.25;
    constexpr double kIndent = 1.1;
    is_heading_ = block.kind == CaptionBlock::Kind::heading;
    const bool is_item = block.kind == CaptionBlock::Kind::item;
    letters_ = look_.letters * (is_heading_ ? kHeadings[static_cast<std::size_t>(block.level - 1)] : 1.0);
    indent_ = is_item ? kIndent * look_.letters : 0.0;
    if (!is_first)
      top_ += look_.letters * (is_heading_               ? kSpaceBeforeHeading
                               : is_item && follows_item ? kSpaceBetweenItems
                                                         : kSpaceBefore);
    if (is_item) put_text("•", 0.25 * look_.letters, Face::plain);
    x_ = indent_;
    last_ = kNone;
    line_has_words_ = false;
    for (const Word& word : words_of(block)) set(word);
    end_line();
  }

  CaptionDrawing finish() && {
    out_.drawing.height = top_;
    return std::move(out_);
  }

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  double width_of(const Word& word) const {
    double out = 0.0;
    for (const Atom& atom : word) out += width_of(atom);
    return out;
  }
  double width_of(const Atom& atom) const {
    if (!atom.span->is_mathematics) return measure_(atom.text, letters_, face_of(*atom.span, is_heading_));
    const RichText text = mathematics(*atom.span, letters_, measure_);
    return text.lines.empty() ? 0.0 : text.lines.front().width;
  }

  void set(const Word& word) {
    const double space = line_has_words_ ? measure_(" ", letters_, Face::plain) : 0.0;
    const double width = width_of(word);
    if (line_has_words_ && x_ + space + width > look_.width) end_line();
    if (line_has_words_) put_space(word);
    for (const Atom& atom : word) put(atom);
    line_has_words_ = true;
  }

  // Words of one look form one text, so that they can be found and copied as they were written.
  void put_space(const Word& word) {
    const Atom& first = word.front();
    if (last_ != kNone && !first.span->is_mathematics &&
        out_.drawing.lines[last_].face == face_of(*first.span, is_heading_)) {
      pending_space_ = true;
    } else {
      x_ += measure_(" ", letters_, Face::plain);
      last_ = kNone;
    }
  }

  void put(const Atom& atom) {
    if (atom.span->is_mathematics) {
      put_mathematics(*atom.span);
      return;
    }
    const Face face = face_of(*atom.span, is_heading_);
    std::string_view rest = atom.text;
    // Breaks a word that is longer than a line at the end of the line.
    while (x_ + measure_(std::string(rest), letters_, face) > look_.width && !pending_space_) {
      std::size_t fits = 0;
      for (std::size_t end = bytes_of_letter(rest);
           end < rest.size() && x_ + measure_(std::string(rest.substr(0, end)), letters_, face) <= look_.width;
           end += bytes_of_letter(rest.substr(end)))
        fits = end;
      if (fits == 0 && !line_has_words_) fits = bytes_of_letter(rest);
      if (fits >= rest.size()) break;
      if (fits > 0) put_text(rest.substr(0, fits), x_, face);
      rest.remove_prefix(fits);
      end_line();
    }
    put_text(rest, x_, face);
  }

  void put_text(std::string_view text, double x, Face face) {
    std::vector<PaperDrawing::Line>& lines = out_.drawing.lines;
    if (last_ != kNone && lines[last_].face == face) {
      PaperDrawing::Line& line = lines[last_];
      if (std::exchange(pending_space_, false)) line.text += ' ';
      line.text += text;
      x_ = line.x + measure_(line.text, letters_, face);
    } else {
      pending_space_ = false;
      lines.push_back(
          {.x = x, .top = top_, .size = letters_, .face = face, .color = look_.ink, .text = std::string(text)});
      last_ = lines.size() - 1;
      x_ = std::max(x_, x + measure_(lines.back().text, letters_, face));
    }
    out_.drawing.width = std::max(out_.drawing.width, x_);
    line_has_words_ = true;
  }

  void put_mathematics(const CaptionSpan& span) {
    constexpr double kAscent = 0.8;  // the same for all lines on paper
    const RichText text = mathematics(span, letters_, measure_);
    if (out_.complaint.empty()) out_.complaint = text.complaint;
    if (text.lines.empty()) return;
    const double baseline = top_ + kAscent * letters_;
    for (const RichPiece& piece : text.lines.front().pieces)
      out_.drawing.lines.push_back({.x = x_ + piece.x,
                                    .top = baseline - piece.raise - kAscent * piece.size,
                                    .size = piece.size,
                                    .face = is_heading_ && piece.face == Face::plain ? Face::bold : piece.face,
                                    .color = look_.ink,
                                    .text = piece.text});
    x_ += text.lines.front().width;
    out_.drawing.width = std::max(out_.drawing.width, x_);
    last_ = kNone;
    line_has_words_ = true;
  }

  void end_line() {
    top_ += (is_heading_ ? 1.08 : 1.28) * letters_;
    x_ = indent_;
    last_ = kNone;
    pending_space_ = false;
    line_has_words_ = false;
  }

  const CaptionLook& look_;
  const MeasureText& measure_;
  CaptionDrawing out_;
  double top_ = 0.0;
  double x_ = 0.0;
  double letters_ = 0.0;
  double indent_ = 0.0;
  std::size_t last_ = kNone;  // the text that the next word may extend
  bool pending_space_ = false;
  bool is_heading_ = false;
  bool line_has_words_ = false;
};

// Widths do not matter here, only whether there is a gap between two pieces.
double one_each(const std::string& text, double size, Face /*face*/) {
  return size * static_cast<double>(text.size());
}

std::string html_of_mathematics(const CaptionSpan& span) {
  std::string out = "<span class=\"math\">";
  const RichText text = mathematics(span, 1.0, one_each);
  double end = 0.0;
  for (const RichLine& line : text.lines) {
    for (const RichPiece& piece : line.pieces) {
      if (piece.x > end + 1e-9 && piece.raise == 0.0) out += "&#8239;";
      end = std::max(end, piece.x + one_each(piece.text, piece.size, piece.face));
      const char* const script = piece.raise > 0.0 ? "sup" : "sub";
      const char* const look = piece.face == Face::italic ? "i" : piece.face == Face::bold ? "b" : nullptr;
      if (piece.raise != 0.0) out += std::string("<") + script + '>';
      if (look != nullptr) out += std::string("<") + look + '>';
      out += escaped_html(piece.text);
      if (look != nullptr) out += std::string("</") + look + '>';
      if (piece.raise != 0.0) out += std::string("</") + script + '>';
    }
  }
  return out + "</span>";
}

std::string html_of(const CaptionSpan& span) {
  std::string out = span.is_mathematics ? html_of_mathematics(span) : escaped_html(span.text);
  if (span.is_italic) out = "<em>" + out + "</em>";
  if (span.is_bold) out = "<strong>" + out + "</strong>";
  return out;
}

}  // namespace

CaptionText caption_text(std::string_view markdown) {
  const std::string readable = readable_text(markdown);
  CaptionText out;
  std::string block;
  CaptionBlock::Kind kind = CaptionBlock::Kind::paragraph;
  const auto end_block = [&](int level = 1) {
    const std::string text = std::exchange(block, {});
    const CaptionBlock::Kind ended = std::exchange(kind, CaptionBlock::Kind::paragraph);
    std::vector<CaptionSpan> spans = SpanReader().read(trimmed_line(text));
    if (!spans.empty()) out.push_back({ended, level, std::move(spans)});
  };
  for (std::string_view rest = readable; !rest.empty();) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::string_view line = trimmed_line(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
    const int level = heading_level(line);
    if (line.empty() || level > 0 || is_item(line)) end_block();
    if (level > 0) {
      block = line.substr(static_cast<std::size_t>(level) + 1);
      kind = CaptionBlock::Kind::heading;
      end_block(level);
    } else if (is_item(line)) {
      block = line.substr(2);
      kind = CaptionBlock::Kind::item;
    } else if (!line.empty()) {
      if (!block.empty()) block += ' ';
      block += line;
    }
  }
  end_block();
  return out;
}

std::string plain_text(const CaptionBlock& block) {
  std::string out;
  for (const CaptionSpan& span : block.spans) {
    if (!span.is_mathematics) {
      out += span.text;
      continue;
    }
    const RichText text = mathematics(span, 1.0, one_each);
    for (const RichLine& line : text.lines)
      for (const RichPiece& piece : line.pieces) out += piece.text;
  }
  return out;
}

std::string name_of(const CaptionText& text) {
  constexpr std::size_t kLongest = 72;
  const auto heading = std::ranges::find(text, CaptionBlock::Kind::heading, &CaptionBlock::kind);
  if (heading != text.end()) return plain_text(*heading);
  if (text.empty()) return {};
  std::string out = plain_text(text.front());
  if (out.size() <= kLongest) return out;
  const std::size_t space = out.rfind(' ', kLongest);
  std::size_t end = space != std::string::npos && space > kLongest / 2 ? space : kLongest;
  while (end > 0 && (static_cast<unsigned char>(out[end]) & 0xC0U) == 0x80U) --end;
  return out.substr(0, end) + " …";
}

CaptionDrawing layout_caption(const CaptionText& text, const CaptionLook& look, const MeasureText& measure) {
  ColumnSetter setter(look, measure);
  bool is_first = true;
  bool follows_item = false;
  for (const CaptionBlock& block : text) {
    setter.set(block, is_first, follows_item);
    is_first = false;
    follows_item = block.kind == CaptionBlock::Kind::item;
  }
  return std::move(setter).finish();
}

FittedCaption fit_caption(const CaptionText& text, CaptionLook look, double height, const MeasureText& measure,
                          std::span<const CaptionText> beside) {
  constexpr double kSmaller = 0.95;
  constexpr double kSmallest = 0.42;
  const double least = kSmallest * look.letters;
  const auto fits = [&](const CaptionDrawing& drawn) {
    return drawn.drawing.height <= height && drawn.drawing.width <= 1.001 * look.width;
  };
  const auto drawn_smaller = [&](const CaptionText& one) {
    CaptionDrawing out = layout_caption(one, look, measure);
    while (!fits(out) && look.letters * kSmaller > least) {
      look.letters *= kSmaller;
      out = layout_caption(one, look, measure);
    }
    return out;
  };
  for (const CaptionText& one : beside) static_cast<void>(drawn_smaller(one));
  CaptionDrawing drawn = drawn_smaller(text);
  const bool is_whole = fits(drawn);
  if (!is_whole)
    std::erase_if(drawn.drawing.lines, [&](const PaperDrawing::Line& line) { return line.top + line.size > height; });
  return {std::move(drawn.drawing), std::move(drawn.complaint), is_whole};
}

std::string html_of(const CaptionText& text) {
  std::string out;
  bool in_list = false;
  for (const CaptionBlock& block : text) {
    const bool is_item = block.kind == CaptionBlock::Kind::item;
    if (is_item != in_list) out += is_item ? "<ul>\n" : "</ul>\n";
    in_list = is_item;
    const std::string element = is_item                                     ? "li"
                                : block.kind == CaptionBlock::Kind::heading ? "h" + std::to_string(block.level + 1)
                                                                            : "p";
    out += '<' + element + '>';
    for (const CaptionSpan& span : block.spans) out += html_of(span);
    out += "</" + element + ">\n";
  }
  if (in_list) out += "</ul>\n";
  return out;
}

std::string escaped_html(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (const char c : text) switch (c) {
      case '&': out += "&amp;"; break;
      case '<': out += "&lt;"; break;
      case '>': out += "&gt;"; break;
      case '"': out += "&quot;"; break;
      case '\'': out += "&#39;"; break;
      default: out += c;
    }
  return out;
}

}  // namespace mes
