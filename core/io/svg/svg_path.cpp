// SPDX-License-Identifier: GPL-3.0-or-later
// Source: SVG 2, chapter 9.
#include "core/io/svg/svg_path.h"

#include <numbers>
#include <span>
#include <utility>

#include "core/base/lower_case.h"
#include "core/io/svg/svg_values.h"
#include "core/io/text/coordinate_pairs.h"

namespace mes {
namespace {

constexpr bool is_command(char c) {
  switch (lower_case(c)) {
    case 'm':
    case 'l':
    case 'h':
    case 'v':
    case 'c':
    case 's':
    case 'q':
    case 't':
    case 'a':
    case 'z': return true;
    default: return false;
  }
}

void look_at(const JobControl* job) {
  if (job != nullptr && job->stop_requested()) throw Cancelled{};
}

/// Reads runs of vertices at once while they have the usual form.
class VertexRuns {
 public:
  /// Takes pairs from the beginning of the text and hands them to `use(std::span<const Vec2>)`. Throws `Cancelled`.
  template <class Use>
  void take(SvgText& text, char letter, const JobControl* job, Use use) {
    if (unusual_ != 0) {
      --unusual_;
      return;
    }
    bool is_any = false;
    for (bool goes_on = true; goes_on; look_at(job)) {
      const PairRun run = read_coordinate_pairs(text.rest(), letter, pairs_, is_any);
      text.skip(run.size);
      if (run.count != 0) use(std::span<const Vec2>(pairs_.first(run.count)));
      goes_on = run.count == pairs_.size();
      is_any = is_any || run.count != 0;
    }
    if (!is_any) unusual_ = kPatience;
  }

 private:
  static constexpr std::size_t kPatience = 8;  // after one unusual vertex, more are likely
  static constexpr std::size_t kAtOnce = 1024;

  /// A buffer of this thread, because a new one would take as long as a short path. It fits a near cache, and most
  /// curves get memory for all their vertices at once.
  static std::span<Vec2> room() {
    thread_local std::vector<Vec2> pairs(kAtOnce);
    return pairs;
  }

  std::span<Vec2> pairs_ = room();
  std::size_t unusual_ = 0;
};

class PathReader {
 public:
  PathReader(std::string_view data, const JobControl* job) : text_(data), job_(job) {}

  SvgPath read() {
    text_.skip_blanks();
    while (!text_.is_at_end() && !out_.fault) {
      const std::size_t place = text_.place();
      const char command = text_.sign();
      const bool may_begin = has_begun_ || lower_case(command) == 'm';
      if (!is_command(command) || !may_begin) {
        out_.fault = place;
        break;
      }
      text_.take(command);
      if (++commands_ % kOften == 0) look();
      read_command(command);
      text_.skip_blanks();
    }
    finish_subpath();
    return std::move(out_);
  }

 private:
  /// Reads the command with all its argument sets. After the first set of M, further sets are those of L.
  void read_command(char command) {
    const char kind = lower_case(command);
    is_relative_ = command == kind;
    if (kind == 'z') return close();
    char now = kind;
    for (bool has_another = true; has_another; has_another = begins_a_number()) {
      if (now == 'l' && read_lines()) continue;
      if (!read_set(now)) {
        out_.fault = text_.place();
        return;
      }
      if (now == 'm') now = 'l';
      if (++commands_ % kOften == 0) look();
    }
  }

  void look() const { look_at(job_); }

  /// Reads as many sets of lines as possible together; false for none.
  bool read_lines() {
    bool is_any = false;
    SvgText after_comma = text_;
    after_comma.skip_comma();
    runs_.take(after_comma, is_relative_ ? 'l' : 'L', job_, [&](std::span<const Vec2> run) {
      if (is_relative_) {
        for (const Vec2 step : run) curve().line_to(at_ = at_ + step);
      } else {
        curve().lines_to(run);
        at_ = run.back();
      }
      is_any = true;
    });
    if (!is_any) return false;
    text_ = after_comma;
    forget_controls();
    return true;
  }

  bool begins_a_number() {
    text_.skip_blanks();
    const char c = text_.sign();
    return c == ',' || c == '.' || c == '-' || c == '+' || (c >= '0' && c <= '9');
  }

  bool read_set(char kind) {
    switch (kind) {
      case 'm': return read_move();
      case 'l': return read_line();
      case 'h': return read_along(&Vec2::x);
      case 'v': return read_along(&Vec2::y);
      case 'c': return read_cubic(false);
      case 's': return read_cubic(true);
      case 'q': return read_quadratic(false);
      case 't': return read_quadratic(true);
      default: return read_arc();
    }
  }

  bool number(double& value) {
    text_.skip_comma();
    return text_.number(value);
  }
  bool vector(Vec2& value) { return number(value.x) && number(value.y); }
  bool point(Vec2& value) {
    if (!vector(value)) return false;
    if (is_relative_) value = at_ + value;
    return true;
  }

  bool read_move() {
    Vec2 to;
    if (!point(to)) return false;
    finish_subpath();
    has_begun_ = true;
    at_ = start_ = to;
    forget_controls();
    return true;
  }

  bool read_line() {
    Vec2 to;
    if (!point(to)) return false;
    go_to(to);
    return true;
  }

  bool read_along(double Vec2::*axis) {
    double value = 0.0;
    if (!number(value)) return false;
    Vec2 to = at_;
    to.*axis = is_relative_ ? at_.*axis + value : value;
    go_to(to);
    return true;
  }

  bool read_cubic(bool is_smooth) {
    Vec2 first = mirrored(cubic_control_);
    Vec2 second;
    Vec2 to;
    if ((!is_smooth && !point(first)) || !point(second) || !point(to)) return false;
    curve().cubic_to(first, second, to);
    at_ = to;
    forget_controls();
    cubic_control_ = second;
    return true;
  }

  bool read_quadratic(bool is_smooth) {
    Vec2 control = mirrored(quadratic_control_);
    Vec2 to;
    if ((!is_smooth && !point(control)) || !point(to)) return false;
    curve().quadratic_to(control, to);
    at_ = to;
    forget_controls();
    quadratic_control_ = control;
    return true;
  }

  bool read_arc() {
    Vec2 radii;
    double rotation = 0.0;
    if (!vector(radii) || !number(rotation)) return false;
    text_.skip_comma();
    const auto is_large = text_.flag();
    if (!is_large) return false;
    text_.skip_comma();
    const auto sweeps = text_.flag();
    Vec2 to;
    if (!sweeps || !point(to)) return false;
    const auto arc = arc_between(at_, to, radii, rotation * std::numbers::pi / 180.0, *is_large, *sweeps);
    if (!arc) {
      go_to(to);
      return true;
    }
    curve().arc_to(*arc, to);
    at_ = to;
    forget_controls();
    return true;
  }

  void go_to(Vec2 to) {
    curve().line_to(to);
    at_ = to;
    forget_controls();
  }

  void close() {
    if (curve_) curve_->close();
    finish_subpath();
    at_ = start_;
    forget_controls();
  }

  /// The curve of this subpath. After a closed subpath the next one begins at the same point.
  PlaneCurve& curve() {
    if (!curve_) curve_.emplace(at_);
    return *curve_;
  }
  void finish_subpath() {
    if (curve_) out_.curves.push_back(*std::exchange(curve_, std::nullopt));
  }

  Vec2 mirrored(const std::optional<Vec2>& control) const { return control ? at_ + (at_ - *control) : at_; }
  void forget_controls() {
    cubic_control_.reset();
    quadratic_control_.reset();
  }

  static constexpr std::size_t kOften = 1U << 14U;

  SvgText text_;
  const JobControl* job_;
  std::size_t commands_ = 0;
  VertexRuns runs_;
  SvgPath out_;
  std::optional<PlaneCurve> curve_;
  Vec2 at_{};
  Vec2 start_{};
  std::optional<Vec2> cubic_control_;      // the last control point, if the last command was a cubic
  std::optional<Vec2> quadratic_control_;  // the same for a quadratic
  bool is_relative_ = false;
  bool has_begun_ = false;
};

}  // namespace

SvgPath read_svg_path(std::string_view data, const JobControl* job) {
  return PathReader(data, job).read();
}

SvgPath read_svg_points(std::string_view points, bool is_closed, const JobControl* job) {
  SvgPath out;
  std::optional<PlaneCurve> curve;
  VertexRuns runs;
  SvgText rest(points);
  const auto add = [&](std::span<const Vec2> run) {
    if (!curve) {
      curve.emplace(run.front());
      run = run.subspan(1);
    }
    curve->lines_to(run);
  };
  for (rest.skip_blanks(); !rest.is_at_end(); rest.skip_comma()) {
    const std::size_t begin = rest.place();
    runs.take(rest, '\0', job, add);
    if (rest.place() != begin) continue;
    Vec2 point;
    bool is_pair = rest.number(point.x);
    if (is_pair) rest.skip_comma();
    is_pair = is_pair && rest.number(point.y);
    if (!is_pair) {
      out.fault = rest.place();
      break;
    }
    add({&point, 1});
  }
  if (!curve || curve->piece_count() == 0) return out;
  if (is_closed) curve->close();
  out.curves.push_back(*std::move(curve));
  return out;
}

}  // namespace mes
