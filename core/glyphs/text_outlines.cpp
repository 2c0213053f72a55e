// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/glyphs/text_outlines.h"

#include <hb-ot.h>
#include <hb.h>

#include <fmt/core.h>
#include <cmath>
#include <memory>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "core/glyphs/internal/destroyed_by.h"
#include "core/glyphs/internal/united_contours.h"

namespace mes {
namespace {

using Blob = std::unique_ptr<hb_blob_t, DestroyedBy<hb_blob_destroy>>;
using Face = std::unique_ptr<hb_face_t, DestroyedBy<hb_face_destroy>>;
using Font = std::unique_ptr<hb_font_t, DestroyedBy<hb_font_destroy>>;
using Buffer = std::unique_ptr<hb_buffer_t, DestroyedBy<hb_buffer_destroy>>;
using DrawFuncs = std::unique_ptr<hb_draw_funcs_t, DestroyedBy<hb_draw_funcs_destroy>>;

/// Collects contours, moved to the position of the glyph.
struct Pen {
  Vec2 origin{};
  std::optional<PlaneCurve> open{};
  std::vector<PlaneCurve> contours{};

  Vec2 at(float x, float y) const { return origin + Vec2{static_cast<double>(x), static_cast<double>(y)}; }
  void move_to(Vec2 p) {
    close();
    open.emplace(p);
  }
  void line_to(Vec2 p) {
    if (open && open->end() != p) open->line_to(p);
  }
  void close() {
    if (open && open->piece_count() != 0) {
      open->close();
      contours.push_back(*std::move(open));
    }
    open.reset();
  }
};

Pen& pen_of(void* data) {
  return *static_cast<Pen*>(data);
}

DrawFuncs make_draw_funcs() {
  DrawFuncs out(hb_draw_funcs_create());
  hb_draw_funcs_set_move_to_func(
      out.get(),
      [](hb_draw_funcs_t*, void* data, hb_draw_state_t*, float x, float y, void*) {
        pen_of(data).move_to(pen_of(data).at(x, y));
      },
      nullptr, nullptr);
  hb_draw_funcs_set_line_to_func(
      out.get(),
      [](hb_draw_funcs_t*, void* data, hb_draw_state_t*, float x, float y, void*) {
        pen_of(data).line_to(pen_of(data).at(x, y));
      },
      nullptr, nullptr);
  hb_draw_funcs_set_quadratic_to_func(
      out.get(),
      [](hb_draw_funcs_t*, void* data, hb_draw_state_t*, float cx, float cy, float x, float y, void*) {
        Pen& pen = pen_of(data);
        if (pen.open) pen.open->quadratic_to(pen.at(cx, cy), pen.at(x, y));
      },
      nullptr, nullptr);
  hb_draw_funcs_set_cubic_to_func(
      out.get(),
      [](hb_draw_funcs_t*, void* data, hb_draw_state_t*, float ax, float ay, float bx, float by, float x, float y,
         void*) {
        Pen& pen = pen_of(data);
        if (pen.open) pen.open->cubic_to(pen.at(ax, ay), pen.at(bx, by), pen.at(x, y));
      },
      nullptr, nullptr);
  hb_draw_funcs_set_close_path_func(
      out.get(), [](hb_draw_funcs_t*, void* data, hb_draw_state_t*, void*) { pen_of(data).close(); }, nullptr,
      nullptr);
  hb_draw_funcs_make_immutable(out.get());
  return out;
}

/// The character at a byte, with its code point: "ä" (U+00E4).
std::string character_at(std::string_view text, std::size_t byte) {
  if (byte >= text.size()) return {};
  std::size_t end = byte + 1;
  constexpr unsigned kContinues = 0x80;
  constexpr unsigned kMask = 0xC0;
  while (end < text.size() && (static_cast<unsigned char>(text[end]) & kMask) == kContinues) ++end;
  const std::string_view bytes = text.substr(byte, end - byte);
  Buffer buffer(hb_buffer_create());
  hb_buffer_add_utf8(buffer.get(), bytes.data(), static_cast<int>(bytes.size()), 0, -1);
  unsigned count = 0;
  const hb_glyph_info_t* const infos = hb_buffer_get_glyph_infos(buffer.get(), &count);
  if (count == 0) return {};
  const hb_codepoint_t code = infos[0].codepoint;
  constexpr hb_codepoint_t kFirstPrintable = 0xA1;
  const bool is_printable = (code > ' ' && code < 0x7F && code != '"') || (code >= kFirstPrintable && code != 0xFFFD);
  return is_printable ? fmt::format("\"{}\" (U+{:04X})", bytes, code) : fmt::format("U+{:04X}", code);
}

class TextReader {
 public:
  TextReader(const TextRequest& request, JobControl* job) : request_(request), job_(job) {}

  Expected<TextOutlines> read() {
    if (auto done = check(); !done) return std::unexpected(done.error());
    if (auto done = open_font(); !done) return std::unexpected(done.error());
    const DrawFuncs funcs = make_draw_funcs();
    hb_font_extents_t extents{};
    hb_font_get_extents_for_direction(font_.get(), HB_DIRECTION_LTR, &extents);
    const double step = request_.line_spacing * (extents.ascender - extents.descender + extents.line_gap);
    std::string_view rest = request_.text;
    for (double baseline = 0.0;; baseline -= step) {
      const std::size_t end = std::min(rest.find('\n'), rest.size());
      std::string_view line = rest.substr(0, end);
      if (line.ends_with('\r')) line.remove_suffix(1);
      draw_line(line, {0.0, baseline}, *funcs);
      if (end == rest.size()) break;
      rest.remove_prefix(end + 1);
    }
    return finish();
  }

 private:
  std::unexpected<Error> wrong(std::string text) const {
    return std::unexpected(Error{ErrorCode::usage, std::move(text)});
  }
  std::unexpected<Error> bad_font(std::string text) const {
    return std::unexpected(Error{ErrorCode::bad_input, std::move(text), request_.font.path.string()});
  }

  Expected<void> check() const {
    if (request_.text.size() > kLongestText)
      return wrong(fmt::format("a text has at most {} bytes, and this has {}", kLongestText, request_.text.size()));
    if (!(request_.size > 0.0 && std::isfinite(request_.size)))
      return wrong("the size of a text is a positive number");
    constexpr double kMostSpacing = 1000.0;
    if (!(request_.line_spacing >= 0.0 && request_.line_spacing <= kMostSpacing))
      return wrong("the distance of lines is a number from 0 to 1000");
    return {};
  }

  Expected<void> open_font() {
    blob_.reset(hb_blob_create_from_file_or_fail(request_.font.path.c_str()));
    if (!blob_) return bad_font("cannot be read");
    constexpr std::uint32_t kLower = 0xFFFF;
    face_.reset(hb_face_create(blob_.get(), request_.font.index & kLower));
    if (hb_face_get_glyph_count(face_.get()) == 0) return bad_font("this is not a TrueType or OpenType font");
    font_.reset(hb_font_create(face_.get()));
    const std::uint32_t instance = request_.font.index >> 16U;
    constexpr std::uint32_t kMostInstances = 0x7FFF;
    if (instance != 0 && instance <= kMostInstances) hb_font_set_var_named_instance(font_.get(), instance - 1);
    return {};
  }

  void draw_line(std::string_view line, Vec2 origin, hb_draw_funcs_t& funcs) {
    const Buffer buffer(hb_buffer_create());
    hb_buffer_add_utf8(buffer.get(), line.data(), static_cast<int>(line.size()), 0, static_cast<int>(line.size()));
    hb_buffer_guess_segment_properties(buffer.get());
    const hb_feature_t no_kerning{HB_TAG('k', 'e', 'r', 'n'), 0, HB_FEATURE_GLOBAL_START, HB_FEATURE_GLOBAL_END};
    hb_shape(font_.get(), buffer.get(), &no_kerning, request_.has_kerning ? 0 : 1);
    unsigned count = 0;
    std::size_t first_missing_at = line.size();  // glyphs may be from right to left
    const hb_glyph_info_t* const infos = hb_buffer_get_glyph_infos(buffer.get(), &count);
    const hb_glyph_position_t* const positions = hb_buffer_get_glyph_positions(buffer.get(), &count);
    for (unsigned i = 0; i < count; ++i) {
      if (job_ != nullptr) job_->checkpoint();
      const hb_glyph_position_t& place = positions[i];
      if (infos[i].codepoint == 0) {
        missing_.insert(character_at(line, infos[i].cluster));
        first_missing_at = std::min<std::size_t>(first_missing_at, infos[i].cluster);
      } else {
        pen_.origin = origin + Vec2{static_cast<double>(place.x_offset), static_cast<double>(place.y_offset)};
        hb_font_get_glyph_shape(font_.get(), infos[i].codepoint, &funcs, &pen_);
        pen_.close();
      }
      origin = origin + Vec2{static_cast<double>(place.x_advance), static_cast<double>(place.y_advance)};
    }
    if (first_missing_.empty() && first_missing_at < line.size())
      first_missing_ = character_at(line, first_missing_at);
  }

  std::string missing_in_words() const {
    if (missing_.size() <= 1) return fmt::format("{} has no glyph for {}", request_.font.name, first_missing_);
    return fmt::format("{} has no glyphs for {} characters, the first of them {}", request_.font.name,
                       missing_.size(), first_missing_);
  }

  Expected<TextOutlines> finish() {
    if (pen_.contours.empty()) {
      if (!missing_.empty()) return std::unexpected(Error{ErrorCode::bad_input, missing_in_words()});
      return std::unexpected(Error{ErrorCode::bad_input, "nothing of this text is drawn"});
    }
    TextOutlines out;
    const double em = hb_face_get_upem(face_.get());
    // About a thousandth of the size of most letters.
    constexpr double kTolerance = 1.0 / 20'000.0;
    out.curves.curves = united_contours(std::move(pen_.contours), kTolerance * em, job_);
    const double scale = request_.size / em;
    for (PlaneCurve& curve : out.curves.curves) curve.transform(Affine::scaling(scale, scale));
    if (!missing_.empty()) out.remarks.push_back(missing_in_words() + "; left out");
    return out;
  }

  const TextRequest& request_;
  JobControl* job_;
  Blob blob_;
  Face face_;
  Font font_;
  Pen pen_;
  std::set<std::string> missing_;
  std::string first_missing_;
};

}  // namespace

Expected<TextOutlines> outlines_of_text(const TextRequest& request, JobControl* job) {
  return TextReader(request, job).read();
}

}  // namespace mes
