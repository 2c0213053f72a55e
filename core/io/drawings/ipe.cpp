// SPDX-License-Identifier: GPL-3.0-or-later
// Drawings of Ipe as XML (.ipe), as its manual describes them: paths and groups with their matrices, in points, y up.
// Marks become points. All pages lie over each other. Text, pictures, spiro and cardinal splines, and the splines of
// Ipe 6 are left out.
#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "core/curves/interpolation/b_spline.h"
#include "core/io/curve_samples.h"
#include "core/io/format_spec.h"
#include "core/io/text/text_numbers.h"
#include "core/io/xml/xml_source.h"

namespace mes {
namespace {

using pugi::xml_node;

constexpr std::size_t kDeepestGroup = 200;
constexpr std::size_t kMostIpePieces = 4'000'000;

/// Words between blanks, with their positions.
class PathWords {
 public:
  explicit PathWords(std::string_view text) : text_(text) {}
  bool next() {
    constexpr std::string_view kBlanks = " \t\r\n";
    const std::size_t begin = text_.find_first_not_of(kBlanks, at_);
    if (begin == std::string_view::npos) return false;
    at_ = std::min(text_.find_first_of(kBlanks, begin), text_.size());
    word_ = text_.substr(begin, at_ - begin);
    place_ = begin;
    return true;
  }
  std::string_view word() const { return word_; }
  std::size_t place() const { return place_; }

 private:
  std::string_view text_;
  std::size_t at_ = 0;
  std::string_view word_;
  std::size_t place_ = 0;
};

std::optional<std::vector<double>> numbers_in(std::string_view text) {
  std::vector<double> out;
  PathWords words(text);
  while (words.next()) {
    const auto value = parse_number(words.word());
    if (!value) return std::nullopt;
    out.push_back(*value);
  }
  return out;
}

Affine affine_of(const double* v) {
  return {v[0], v[1], v[2], v[3], v[4], v[5]};
}

/// The arc of an ellipse, the image of the unit circle, between two points, in the direction of its matrix. Nothing if
/// the matrix has no inverse.
std::optional<EllipticArc> arc_on(const Affine& map, Vec2 from, Vec2 to) {
  const double determinant = map.a * map.d - map.b * map.c;
  if (determinant == 0.0 || !std::isfinite(determinant)) return std::nullopt;
  const auto angle_of = [&](Vec2 p) {
    const Vec2 q = p - Vec2{map.e, map.f};
    return std::atan2((map.a * q.y - map.b * q.x) / determinant, (map.d * q.x - map.c * q.y) / determinant);
  };
  EllipticArc out{{map.e, map.f}, {map.a, map.b}, {map.c, map.d}, angle_of(from), 0.0};
  out.sweep = angle_of(to) - out.start;
  if (out.sweep <= 0.0) out.sweep += 2.0 * std::numbers::pi;
  if (!std::isfinite(out.start) || !std::isfinite(out.sweep)) return std::nullopt;
  return out;
}

class IpeReader {
 public:
  IpeReader(std::string_view bytes, const std::string& name, ReadJob& job)
      : source_(bytes, name), name_(name), job_(job) {}

  Expected<LoadedFile> read() {
    const auto root = source_.parse(job_);
    if (!root) return std::unexpected(root.error());
    if (local_name(root->name()) != "ipe" && local_name(root->name()) != "ipeselection")
      return source_.refuse(source_.place_of(*root), "the root element is not ipe");
    job_.begin(source_.bytes());
    const bool is_selection = local_name(root->name()) == "ipeselection";
    if (is_selection) {
      if (auto done = read_objects(*root, {}, 0); !done) return std::unexpected(done.error());
    }
    for (const xml_node page : root->children("page"))
      if (auto done = read_objects(page, {}, 0); !done) return std::unexpected(done.error());
    if (set_.curves.empty() && set_.points.empty()) return nothing();
    const SamplingRequest request = default_sampling(set_);
    auto file = load_samples(std::move(set_), request, name_, job_);
    if (!file) return file;
    file->warnings = source_.messages();
    file->data.map = MapPlane{.unit = "pt"};
    return file;
  }

 private:
  std::unexpected<Error> nothing() const {
    std::string text = "nothing is drawn in it";
    source_.remarks.for_each([&](const std::string& remark, std::size_t) { text += "; " + remark; });
    return bad_input(std::move(text), name_, 1, 1);
  }

  static bool is_object(std::string_view kind) {
    constexpr std::array<std::string_view, 5> kObjects{"path", "group", "use", "text", "image"};
    return std::ranges::find(kObjects, kind) != kObjects.end();
  }

  Expected<void> read_objects(xml_node parent, const Affine& outer, std::size_t depth) {
    if (depth > kDeepestGroup) return source_.refuse(source_.place_of(parent), "groups are nested too deeply");
    for (const xml_node node : parent.children()) {
      const std::string_view kind = node.name();
      if (node.type() != pugi::node_element || !is_object(kind)) continue;
      job_.passed(source_.bytes().data() + source_.place_of(node));
      const auto map = map_of(node, outer);
      if (!map) return std::unexpected(map.error());
      auto done = kind == "path"    ? read_path(node, *map)
                  : kind == "group" ? read_objects(node, *map, depth + 1)
                  : kind == "use"   ? read_mark(node, *map)
                                    : leave_out(node, kind);
      if (!done) return done;
    }
    return {};
  }

  Expected<void> leave_out(xml_node node, std::string_view kind) {
    source_.remarks.add(fmt::format("{} object is left out", kind), fmt::format("{} objects are left out", kind),
                        source_.place_of(node));
    return {};
  }

  Expected<Affine> map_of(xml_node node, const Affine& outer) const {
    const std::string_view text = node.attribute("matrix").value();
    if (text.empty()) return outer;
    const auto numbers = numbers_in(text);
    constexpr std::size_t kSix = 6;
    if (numbers && numbers->size() == kSix) return outer * affine_of(numbers->data());
    return source_.refuse(source_.place_of(node, text, 0), fmt::format("{} is not a matrix", in_quotes(text)));
  }

  Expected<void> read_mark(xml_node node, const Affine& map) {
    const std::string_view name = node.attribute("name").value();
    if (!name.starts_with("mark/")) return leave_out(node, "symbol");
    const std::string_view text = node.attribute("pos").value();
    const auto numbers = numbers_in(text.empty() ? "0 0" : text);
    if (!numbers || numbers->size() != 2)
      return source_.refuse(source_.place_of(node, text, 0), fmt::format("{} is not a position", in_quotes(text)));
    set_.points.push_back(map.of_point({(*numbers)[0], (*numbers)[1]}));
    return {};
  }

  /// The current path.
  struct Path {
    xml_node node;
    std::string_view text;
    Affine map{};
    std::optional<PlaneCurve> curve{};
    std::vector<double> arguments{};
    std::size_t place = 0;  // position of the current word
  };

  std::unexpected<Error> refuse(const Path& path, std::string text) const {
    return source_.refuse(source_.place_of(path.node, path.text, path.place), std::move(text));
  }

  /// A curve that misses its start only by the rounding of coordinates is closed.
  static void close_what_looks_closed(PlaneCurve& curve) {
    if (curve.is_closed() || curve.piece_count() < 2) return;
    double around = 0.0;
    curve.for_each_piece([&](const Piece& piece) { around += distance(piece.from(), piece.to()); });
    constexpr double kRounding = 1e-5;
    if (distance(curve.start(), curve.end()) <= kRounding * around) curve.close();
  }

  void finish(Path& path) {
    if (path.curve && path.curve->piece_count() != 0) {
      close_what_looks_closed(*path.curve);
      path.curve->transform(path.map);
      set_.curves.push_back(*std::move(path.curve));
    }
    path.curve.reset();
  }

  Expected<void> read_path(xml_node node, const Affine& map) {
    Path path{.node = node, .text = node.child_value(), .map = map};
    PathWords words(path.text);
    while (words.next()) {
      path.place = words.place();
      job_.passed(source_.bytes().data() + source_.place_of(node, path.text, path.place));
      if (++pieces_ > kMostIpePieces)
        return refuse(path, fmt::format("paths have more than {} words", kMostIpePieces));
      const std::string_view word = words.word();
      const bool is_number = word.find_first_of("0123456789") != std::string_view::npos;
      if (!is_number) {
        if (auto done = apply(path, word); !done) return done;
        path.arguments.clear();
        continue;
      }
      const auto value = parse_number(word);
      if (!value) return refuse(path, describe(value.error(), word));
      path.arguments.push_back(*value);
    }
    if (!path.arguments.empty()) return refuse(path, "the path ends with numbers and without what they are for");
    finish(path);
    return {};
  }

  Expected<void> apply(Path& path, std::string_view word) {
    constexpr std::string_view kOperators = "mlcqasuheCL";
    const std::size_t count = path.arguments.size();
    const auto at = [&](std::size_t i) { return Vec2{path.arguments[i], path.arguments[i + 1]}; };
    const auto expect = [&](std::size_t wanted) -> Expected<void> {
      if (count == wanted) return {};
      return refuse(path, fmt::format("{} has {} numbers before it, not {}", in_quotes(word), wanted, count));
    };
    if (word.size() != 1 || !kOperators.contains(word[0]))
      return refuse(path, fmt::format("there is no path operator {}", in_quotes(word)));
    const char kind = word[0];
    if (kind == 'm') {
      if (auto done = expect(2); !done) return done;
      finish(path);
      path.curve.emplace(at(0));
      return {};
    }
    if (kind == 'e') return apply_ellipse(path, expect(6));
    if (kind == 'u') return apply_closed_spline(path);
    if (!path.curve) return refuse(path, fmt::format("{} has no point to start from", in_quotes(word)));
    switch (kind) {
      case 'l':
        if (auto done = expect(2); !done) return done;
        path.curve->line_to(at(0));
        return {};
      case 'q':
        if (auto done = expect(4); !done) return done;
        path.curve->quadratic_to(at(0), at(2));
        return {};
      case 'a': return apply_arc(path, expect(8));
      case 'c': return apply_spline(path);
      case 'h':
        if (auto done = expect(0); !done) return done;
        path.curve->close();
        finish(path);
        return {};
      default: break;
    }
    // Undocumented splines: the path continues at their last point.
    const std::size_t ends = kind == 'C' && count % 2 == 1 ? count - 1 : count;
    if (ends < 2) return refuse(path, fmt::format("{} has no points before it", in_quotes(word)));
    source_.remarks.add("spline of a kind that is not read is left out, with what it belongs to",
                        "splines of kinds that are not read are left out, with what they belong to",
                        source_.place_of(path.node, path.text, path.place));
    path.curve.emplace(at(ends - 2));
    return {};
  }

  Expected<void> apply_ellipse(Path& path, Expected<void> good) {
    if (!good) return good;
    finish(path);
    const Affine map = affine_of(path.arguments.data());
    const EllipticArc all{{map.e, map.f}, {map.a, map.b}, {map.c, map.d}, 0.0, 2.0 * std::numbers::pi};
    const Vec2 start = all.center + all.u;
    path.curve.emplace(start);
    path.curve->arc_to(all, start);
    path.curve->close();
    finish(path);
    return {};
  }

  Expected<void> apply_arc(Path& path, Expected<void> good) {
    if (!good) return good;
    const Affine map = affine_of(path.arguments.data());
    const Vec2 to{path.arguments[6], path.arguments[7]};
    if (const auto arc = arc_on(map, path.curve->end(), to)) {
      path.curve->arc_to(*arc, to);
    } else {
      path.curve->line_to(to);
    }
    return {};
  }

  static std::vector<Vec2> points_of(const std::vector<double>& numbers) {
    std::vector<Vec2> out;
    for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) out.push_back({numbers[i], numbers[i + 1]});
    return out;
  }

  /// A line, a parabola, or a cubic spline, depending on the number of points.
  Expected<void> apply_spline(Path& path) {
    if (path.arguments.empty() || path.arguments.size() % 2 != 0)
      return refuse(path, "\"c\" has pairs of numbers before it");
    std::vector<Vec2> controls{path.curve->end()};
    std::ranges::copy(points_of(path.arguments), std::back_inserter(controls));
    constexpr std::size_t kCubic = 3;
    const std::size_t degree = std::min(controls.size() - 1, kCubic);
    append(path, BSpline::clamped(degree, controls));
    return {};
  }

  Expected<void> apply_closed_spline(Path& path) {
    constexpr std::size_t kLeast = 6;
    if (path.arguments.size() < kLeast || path.arguments.size() % 2 != 0)
      return refuse(path, "\"u\" has three pairs of numbers before it at least");
    finish(path);
    constexpr std::size_t kCubic = 3;
    append(path, BSpline::closed(kCubic, points_of(path.arguments)));
    if (path.curve) path.curve->close();
    finish(path);
    return {};
  }

  static void append(Path& path, const BSpline& spline) {
    const auto curve = curve_of_spline(spline);
    if (!curve) return;
    if (!path.curve) path.curve.emplace(curve->start());
    curve->for_each_piece([&](const Piece& piece) {
      if (piece.kind == PieceKind::line) {
        path.curve->line_to(piece.to());
      } else {
        path.curve->cubic_to(piece.points[1], piece.points[2], piece.to());
      }
    });
  }

  XmlSource source_;
  const std::string& name_;
  ReadJob& job_;
  std::size_t pieces_ = 0;
  CurveSet set_;
};

Match match_ipe(std::string_view bytes) {
  const std::string_view root = xml_root_name(bytes);
  return root == "ipe" || root == "ipeselection" ? Match::surely : Match::no;
}

Expected<LoadedFile> read_ipe(std::string_view bytes, const std::string& name, ReadJob& job) {
  return IpeReader(without_bom(bytes), name, job).read();
}

}  // namespace

Format ipe_format() {
  return {.descriptor = {.id = "ipe", .name = "Ipe drawing", .extensions = {".ipe"}, .can_read = true},
          .match = match_ipe,
          .read = read_ipe,
          .may_look_foreign = true};
}

}  // namespace mes
