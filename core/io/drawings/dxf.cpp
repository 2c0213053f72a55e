// SPDX-License-Identifier: GPL-3.0-or-later
// DXF as text (AutoCAD's reference of group codes, R12 to 2018): LINE, LWPOLYLINE and POLYLINE with bulges as arcs,
// CIRCLE, ARC, ELLIPSE, SPLINE, POINT, and the content of blocks wherever INSERT puts it. Lines and arcs that meet end
// to end form one curve. Left out are paper space, invisible entities, those on layers that are off or frozen, and all
// other kinds of entities.
#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include "core/base/geometry/box2.h"
#include "core/curves/interpolation/b_spline.h"
#include "core/curves/interpolation/cubic_interpolation.h"
#include "core/curves/joined_ends.h"
#include "core/io/curve_samples.h"
#include "core/io/drawings/dxf_pairs.h"
#include "core/io/format_spec.h"
#include "core/io/text/ascii_text.h"
#include "core/io/text/counted_remarks.h"
#include "core/io/text/text_numbers.h"
#include "core/io/text/written_decimals.h"

namespace mes {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr double kDegree = std::numbers::pi / 180.0;
constexpr std::size_t kDeepestBlock = 32;
constexpr std::size_t kMostEntities = 1'000'000;  // entities of a block count at each insertion
constexpr std::size_t kMostDxfPieces = 1'000'000;
constexpr std::size_t kMostPairs = 50'000'000;  // lines of entities; those of a block count at each insertion
constexpr std::string_view kBinary = "AutoCAD Binary DXF";

struct Block {
  Vec2 base{};
  std::vector<DxfEntity> entities{};
  bool is_open = false;  ///< it is being drawn
};

class DxfReader {
 public:
  DxfReader(std::string_view bytes, const std::string& name, ReadJob& job) : bytes_(bytes), name_(name), job_(job) {}

  Expected<LoadedFile> read() {
    if (bytes_.starts_with(kBinary)) return bad_input("only DXF as text can be read", name_, 1, 1);
    auto pairs = read_dxf_pairs(bytes_, name_, &job_);
    if (!pairs) return std::unexpected(pairs.error());
    pairs_ = *std::move(pairs);
    if (auto done = read_sections(); !done) return std::unexpected(done.error());
    if (auto done = draw_all(entities_, {}, 0); !done) return std::unexpected(done.error());
    join_curves();
    if (set_.curves.empty() && set_.points.empty()) return nothing();
    const SamplingRequest request = default_sampling(set_);
    auto file = load_samples(std::move(set_), request, name_, job_);
    if (!file) return file;
    if (!unit_.empty()) file->data.map = MapPlane{.unit = std::string(unit_)};
    remarks_.for_each([&](const std::string& text, std::size_t line) {
      file->warnings.push_back(Error{ErrorCode::bad_input, text, name_, line, 1}.message());
    });
    return file;
  }

 private:
  std::unexpected<Error> refuse(const DxfPair& pair, std::string text) const {
    return bad_input(std::move(text), name_, pair.line, 1);
  }
  std::unexpected<Error> nothing() const {
    std::string text = "nothing is drawn in it";
    remarks_.for_each([&](const std::string& remark, std::size_t) { text += "; " + remark; });
    return bad_input(std::move(text), name_, 1, 1);
  }
  void leave_out(DxfEntity entity, std::string_view one, std::string_view many) {
    remarks_.add(fmt::format("{} is left out", one), fmt::format("{} are left out", many), entity.front().line);
  }

  /// The entity that begins at index `begin`, a pair with code 0.
  DxfEntity entity_at(std::size_t begin) const {
    std::size_t end = begin + 1;
    while (end < pairs_.size() && pairs_[end].code != 0) ++end;
    return std::span(pairs_).subspan(begin, end - begin);
  }

  Expected<void> read_sections() {
    std::string_view section;
    Block* block = nullptr;
    bool is_in_section = false;
    for (std::size_t i = 0; i < pairs_.size();) {
      if (pairs_[i].code != 0) {
        ++i;  // variables of the header
        continue;
      }
      const DxfEntity entity = entity_at(i);
      const std::string_view kind = entity.front().value;
      i += entity.size();
      if (kind == "EOF") return {};
      if (kind == "SECTION") {
        section = dxf_text(entity, 2).value_or("");
        is_in_section = true;
        if (section == "HEADER") note_unit(entity);
      } else if (kind == "ENDSEC") {
        section = {};
        is_in_section = false;
      } else if (kind == "LAYER" && section == "TABLES") {
        note_layer(entity);
      } else if (section == "BLOCKS" && kind == "BLOCK") {
        block = &blocks_[std::string(dxf_text(entity, 2).value_or(""))];
        const auto base = point(entity, 10);
        if (!base) return std::unexpected(base.error());
        block->base = *base;
      } else if (section == "BLOCKS" && kind == "ENDBLK") {
        block = nullptr;
      } else if (section == "BLOCKS" && block != nullptr) {
        block->entities.push_back(entity);
      } else if (section == "ENTITIES") {
        entities_.push_back(entity);
      }
    }
    if (is_in_section && !pairs_.empty()) return refuse(pairs_.back(), "the file ends within a section");
    return {};
  }

  void note_unit(DxfEntity header) {
    for (std::size_t i = 0; i + 1 < header.size(); ++i) {
      if (header[i].code != 9 || header[i].value != "$INSUNITS") continue;
      if (const auto unit = unit_of_dxf_number(trimmed(header[i + 1].value)); !unit.empty()) unit_ = unit;
    }
  }

  void note_layer(DxfEntity layer) {
    const std::string_view color = dxf_text(layer, 62).value_or("");
    const std::string_view flags = dxf_text(layer, 70).value_or("0");
    const auto value = parse_count(flags);
    const bool is_frozen = value && (*value & 1U) != 0;
    if (color.starts_with('-') || is_frozen) hidden_layers_.insert(dxf_text(layer, 2).value_or(""));
  }

  // Numbers of an entity -----------------------------------------------------------------------------------------

  Expected<double> number(const DxfPair& pair) const {
    if (const auto value = parse_number(pair.value)) return *value;
    return refuse(pair, fmt::format("expected a number for group {}, found {}", pair.code, in_quotes(pair.value)));
  }
  /// The first value of a code, or `otherwise`.
  Expected<double> number(DxfEntity entity, int code, double otherwise) const {
    const auto found = std::ranges::find(entity, code, &DxfPair::code);
    return found == entity.end() ? Expected<double>(otherwise) : number(*found);
  }
  /// A coordinate or another length.
  Expected<double> coordinate(DxfEntity entity, int code) {
    if (const auto text = dxf_text(entity, code)) decimals_.add(*text);
    return number(entity, code, 0.0);
  }
  Expected<Vec2> point(DxfEntity entity, int code) {
    const auto x = coordinate(entity, code);
    if (!x) return std::unexpected(x.error());
    const auto y = coordinate(entity, code + 10);
    if (!y) return std::unexpected(y.error());
    return Vec2{*x, *y};
  }
  /// All pairs of a code and the one ten above it.
  Expected<std::vector<Vec2>> points(DxfEntity entity, int code) const {
    const auto x = numbers(entity, code);
    if (!x) return std::unexpected(x.error());
    const auto y = numbers(entity, code + 10);
    if (!y) return std::unexpected(y.error());
    std::vector<Vec2> out(std::min(x->size(), y->size()));
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = {(*x)[i], (*y)[i]};
    return out;
  }
  /// The rounding error of an angle as it is written.
  static double rounding_of(DxfEntity entity, int code) {
    return half_last_digit(dxf_text(entity, code).value_or(""));
  }
  /// All values of a code.
  Expected<std::vector<double>> numbers(DxfEntity entity, int code) const {
    std::vector<double> out;
    for (const DxfPair& pair : entity) {
      if (pair.code != code) continue;
      const auto value = number(pair);
      if (!value) return std::unexpected(value.error());
      out.push_back(*value);
    }
    return out;
  }
  unsigned flags_of(DxfEntity entity) const {
    const auto value = parse_count(dxf_text(entity, 70).value_or("0"));
    return value ? static_cast<unsigned>(*value & 0xffffU) : 0U;
  }

  // Drawing ------------------------------------------------------------------------------------------------------

  Expected<void> draw_all(std::span<const DxfEntity> entities, const Affine& map, std::size_t depth) {
    for (std::size_t i = 0; i < entities.size(); ++i) {
      job_.checkpoint();
      const DxfEntity entity = entities[i];
      if (++drawn_ > kMostEntities)
        return refuse(entity.front(), fmt::format("there are more than {} entities, those of blocks counted each "
                                                  "time that they are inserted",
                                                  kMostEntities));
      // The vertices of an old polyline are entities that follow it.
      std::size_t end = i + 1;
      if (entity.front().value == "POLYLINE") {
        while (end < entities.size() && entities[end].front().value == "VERTEX") ++end;
        if (end < entities.size() && entities[end].front().value == "SEQEND") ++end;
      }
      const std::span<const DxfEntity> vertices = entities.subspan(i + 1, end - i - 1);
      i = end - 1;
      looked_at_ += entity.size();
      for (const DxfEntity vertex : vertices) looked_at_ += vertex.size();
      if (looked_at_ > kMostPairs) return refuse(entity.front(), "blocks are inserted too often");
      if (is_hidden(entity)) continue;
      if (auto done = draw(entity, vertices, map, depth); !done) return done;
      if (pieces_ > kMostDxfPieces)
        return refuse(entity.front(), fmt::format("there are more than {} lines and arcs", kMostDxfPieces));
    }
    return {};
  }

  bool is_hidden(DxfEntity entity) {
    if (dxf_text(entity, 67).value_or("0") == "1") {
      remarks_.add("entity in paper space is left out", "entities in paper space are left out", entity.front().line);
      return true;
    }
    const bool is_invisible = dxf_text(entity, 60).value_or("0") == "1";
    const auto layer = dxf_text(entity, 8);
    if (!is_invisible && (!layer || !hidden_layers_.contains(*layer))) return false;
    remarks_.add("entity that is invisible or on a layer that is off is left out",
                 "entities that are invisible or on layers that are off are left out", entity.front().line);
    return true;
  }

  Expected<void> draw(DxfEntity entity, std::span<const DxfEntity> vertices, const Affine& map, std::size_t depth) {
    const std::string_view kind = entity.front().value;
    if (kind == "LINE") return draw_line(entity, map);
    if (kind == "POINT") return draw_point(entity, map);
    if (kind == "SPLINE") return draw_spline(entity, map);
    // Other entities have coordinates in a plane of their own, which may be seen from below.
    const auto nz = number(entity, 230, 1.0);
    if (!nz) return std::unexpected(nz.error());
    const auto normal = point(entity, 210);
    if (!normal) return std::unexpected(normal.error());
    constexpr double kUpright = 1e-6;
    const bool is_flat = std::abs(normal->x) <= kUpright && std::abs(normal->y) <= kUpright && *nz != 0.0;
    const bool is_known = kind == "CIRCLE" || kind == "ARC" || kind == "ELLIPSE" || kind == "LWPOLYLINE" ||
                          kind == "POLYLINE" || kind == "INSERT";
    if (is_known && !is_flat) {
      remarks_.add("entity that is not parallel to the plane is left out",
                   "entities that are not parallel to the plane are left out", entity.front().line);
      return {};
    }
    const bool is_from_below = *nz < 0.0;
    if (kind == "ELLIPSE") return draw_ellipse(entity, map, is_from_below);
    const Affine seen = is_from_below ? map * Affine::scaling(-1.0, 1.0) : map;
    if (kind == "CIRCLE" || kind == "ARC") return draw_arc(entity, seen, kind == "CIRCLE");
    if (kind == "LWPOLYLINE") return draw_polyline(entity, seen);
    if (kind == "POLYLINE") return draw_old_polyline(entity, vertices, seen);
    if (kind == "INSERT") return draw_block(entity, seen, depth);
    constexpr std::string_view kSilent[]{"SEQEND", "VIEWPORT", "ATTDEF", "ATTRIB"};
    if (std::ranges::find(kSilent, kind) == std::end(kSilent)) {
      const std::string name = printable(kind.substr(0, 32));
      leave_out(entity, "entity " + name, "entities " + name);
    }
    return {};
  }

  void add(PlaneCurve curve, const Affine& map) {
    if (curve.piece_count() == 0) return;
    pieces_ += curve.piece_count();
    if (pieces_ > kMostDxfPieces) return;
    curve.transform(map);
    set_.curves.push_back(std::move(curve));
  }

  Expected<void> draw_line(DxfEntity entity, const Affine& map) {
    const auto from = point(entity, 10);
    if (!from) return std::unexpected(from.error());
    const auto to = point(entity, 11);
    if (!to) return std::unexpected(to.error());
    if (*from == *to) return {};
    PlaneCurve curve(*from);
    curve.line_to(*to);
    add(std::move(curve), map);
    return {};
  }

  Expected<void> draw_point(DxfEntity entity, const Affine& map) {
    const auto at = point(entity, 10);
    if (!at) return std::unexpected(at.error());
    set_.points.push_back(map.of_point(*at));
    return {};
  }

  /// Adds an arc between two angles in radians, counter-clockwise. If these are equal, or a full turn apart, up to
  /// their last digits (`rounding` radians together), the arc is the whole ellipse.
  void add_arc(const EllipticArc& ellipse, double from, double to, double rounding, const Affine& map) {
    constexpr double kLeastRounding = 1e-9;
    const double turns = std::round((to - from) / kTurn);
    const double rest = std::abs((to - from) - turns * kTurn);
    double sweep = std::fmod(to - from, kTurn);
    if (sweep < 0.0) sweep += kTurn;
    if (rest <= kLeastRounding || (turns != 0.0 && rest < 0.999 * rounding)) sweep = kTurn;
    if (std::abs(from) > kTurn) from = std::fmod(from, kTurn);
    EllipticArc arc = ellipse;
    arc.start = from;
    arc.sweep = sweep;
    const auto at = [&](double angle) { return arc.center + std::cos(angle) * arc.u + std::sin(angle) * arc.v; };
    PlaneCurve curve(at(from));
    curve.arc_to(arc, sweep == kTurn ? curve.start() : at(from + sweep));
    if (sweep == kTurn) curve.close();
    const double reach =
        std::max(length(arc.u), length(arc.v)) * std::max(std::hypot(map.a, map.b), std::hypot(map.c, map.d));
    end_rounding_ = std::max(end_rounding_, reach * rounding);
    add(std::move(curve), map);
  }

  Expected<void> draw_arc(DxfEntity entity, const Affine& map, bool is_circle) {
    const auto center = point(entity, 10);
    if (!center) return std::unexpected(center.error());
    const auto radius = coordinate(entity, 40);
    if (!radius) return std::unexpected(radius.error());
    const auto from = number(entity, 50, 0.0);
    if (!from) return std::unexpected(from.error());
    const auto to = number(entity, 51, 0.0);
    if (!to) return std::unexpected(to.error());
    if (!(*radius > 0.0)) {
      leave_out(entity, "circle without a radius", "circles without a radius");
      return {};
    }
    const EllipticArc circle{*center, {*radius, 0.0}, {0.0, *radius}, 0.0, kTurn};
    if (is_circle)
      add_arc(circle, 0.0, kTurn, 0.0, map);
    else
      add_arc(circle, kDegree * *from, kDegree * *to, kDegree * (rounding_of(entity, 50) + rounding_of(entity, 51)),
              map);
    return {};
  }

  Expected<void> draw_ellipse(DxfEntity entity, const Affine& map, bool is_from_below) {
    const auto center = point(entity, 10);
    if (!center) return std::unexpected(center.error());
    const auto major = point(entity, 11);
    if (!major) return std::unexpected(major.error());
    const auto ratio = number(entity, 40, 1.0);
    if (!ratio) return std::unexpected(ratio.error());
    const auto from = number(entity, 41, 0.0);
    if (!from) return std::unexpected(from.error());
    const auto to = number(entity, 42, kTurn);
    if (!to) return std::unexpected(to.error());
    if (*major == Vec2{}) {
      leave_out(entity, "ellipse without a major axis", "ellipses without a major axis");
      return {};
    }
    const Vec2 minor = (is_from_below ? -*ratio : *ratio) * perpendicular(*major);
    add_arc({*center, *major, minor, 0.0, kTurn}, *from, *to, rounding_of(entity, 41) + rounding_of(entity, 42), map);
    return {};
  }

  struct Corner {
    Vec2 at{};
    double bulge = 0.0;
  };

  /// A bulge is the tangent of a quarter of the arc's angle to the next corner; positive if the arc lies to the right
  /// of the segment.
  static void add_side(PlaneCurve& curve, double bulge, Vec2 to) {
    const Vec2 from = curve.end();
    if (from == to) return;
    // For a flatter arc the centre is so far away that rounding moves it by more than the arc's height.
    constexpr double kFlat = 1e-8;
    if (std::abs(bulge) <= kFlat) return curve.line_to(to);
    const double shift = (1.0 - bulge * bulge) / (4.0 * bulge);
    const Vec2 center = 0.5 * (from + to) + shift * perpendicular(to - from);
    if (!is_finite(center)) return curve.line_to(to);
    const Vec2 u = from - center;
    curve.arc_to({center, u, perpendicular(u), 0.0, 4.0 * std::atan(bulge)}, to);
  }

  void add_corners(const std::vector<Corner>& corners, bool is_closed, const Affine& map) {
    if (corners.size() < 2) return;
    PlaneCurve curve(corners.front().at);
    for (std::size_t i = 1; i < corners.size(); ++i) add_side(curve, corners[i - 1].bulge, corners[i].at);
    if (is_closed) {
      add_side(curve, corners.back().bulge, corners.front().at);
      curve.close();
    }
    add(std::move(curve), map);
  }

  Expected<void> draw_polyline(DxfEntity entity, const Affine& map) {
    std::vector<Corner> corners;
    for (const DxfPair& pair : entity) {
      constexpr int kX = 10;
      constexpr int kY = 20;
      constexpr int kBulge = 42;
      if (pair.code != kX && pair.code != kY && pair.code != kBulge) continue;
      const auto value = number(pair);
      if (!value) return std::unexpected(value.error());
      if (pair.code != kBulge) decimals_.add(pair.value);
      if (pair.code == kX) {
        corners.push_back({{*value, 0.0}, 0.0});
      } else if (!corners.empty()) {
        (pair.code == kY ? corners.back().at.y : corners.back().bulge) = *value;
      }
    }
    add_corners(corners, (flags_of(entity) & 1U) != 0, map);
    return {};
  }

  Expected<void> draw_old_polyline(DxfEntity entity, std::span<const DxfEntity> vertices, const Affine& map) {
    constexpr unsigned kMesh = 16U | 64U;
    constexpr unsigned kControl = 16U;
    if ((flags_of(entity) & kMesh) != 0) {
      leave_out(entity, "mesh", "meshes");
      return {};
    }
    std::vector<Corner> corners;
    for (const DxfEntity vertex : vertices) {
      if (vertex.front().value != "VERTEX" || (flags_of(vertex) & kControl) != 0) continue;
      const auto at = point(vertex, 10);
      if (!at) return std::unexpected(at.error());
      const auto bulge = number(vertex, 42, 0.0);
      if (!bulge) return std::unexpected(bulge.error());
      corners.push_back({*at, *bulge});
    }
    add_corners(corners, (flags_of(entity) & 1U) != 0, map);
    return {};
  }

  Expected<void> draw_spline(DxfEntity entity, const Affine& map) {
    const auto degree = number(entity, 71, 3.0);
    if (!degree) return std::unexpected(degree.error());
    auto knots = numbers(entity, 40);
    if (!knots) return std::unexpected(knots.error());
    auto weights = numbers(entity, 41);
    if (!weights) return std::unexpected(weights.error());
    auto controls = points(entity, 10);
    if (!controls) return std::unexpected(controls.error());
    if (controls->empty()) return draw_fit_points(entity, map);
    constexpr double kMostDegree = 15.0;
    BSpline spline{.degree = *degree >= 1.0 && *degree <= kMostDegree ? static_cast<std::size_t>(*degree) : 0,
                   .knots = *std::move(knots),
                   .controls = *std::move(controls),
                   .weights = *std::move(weights)};
    // A span of high degree can become this many pieces.
    constexpr std::size_t kPiecesOfASpan = 32;
    if (spline.controls.size() * kPiecesOfASpan > kMostDxfPieces)
      return refuse(entity.front(),
                    fmt::format("a spline has more than {} control points", kMostDxfPieces / kPiecesOfASpan));
    std::vector<PlaneCurve> curves = curves_of_spline(std::move(spline));
    if (curves.empty()) leave_out(entity, "spline whose knots do not fit", "splines whose knots do not fit");
    for (PlaneCurve& curve : curves) {
      if (curve.piece_count() > 1 && curve.start() == curve.end()) curve.close();
      add(std::move(curve), map);
    }
    return {};
  }

  /// A spline given by fit points alone is a cubic spline through them.
  Expected<void> draw_fit_points(DxfEntity entity, const Affine& map) {
    const auto fit = points(entity, 11);
    if (!fit) return std::unexpected(fit.error());
    if (fit->size() < 2) {
      leave_out(entity, "spline without control points", "splines without control points");
      return {};
    }
    EndTangents tangents;
    for (const auto& [code, tangent] : {std::pair(12, &tangents.at_start), std::pair(13, &tangents.at_end)}) {
      const auto direction = points(entity, code);
      if (!direction) return std::unexpected(direction.error());
      if (!direction->empty() && direction->front() != Vec2{}) *tangent = direction->front();
    }
    const bool is_closed = (flags_of(entity) & 1U) != 0;
    if (auto curve = cubic_through(*fit, is_closed, tangents)) add(*std::move(curve), map);
    return {};
  }

  Expected<void> draw_block(DxfEntity entity, const Affine& map, std::size_t depth) {
    const auto name = dxf_text(entity, 2);
    const auto found = blocks_.find(std::string(name.value_or("")));
    if (found == blocks_.end()) {
      leave_out(entity, "block that is not there", "blocks that are not there");
      return {};
    }
    Block& block = found->second;
    if (block.is_open) {
      leave_out(entity, "block inside itself", "blocks inside themselves");
      return {};
    }
    if (depth >= kDeepestBlock) return refuse(entity.front(), "blocks are nested too deeply");
    const auto at = point(entity, 10);
    if (!at) return std::unexpected(at.error());
    constexpr int kCodes[]{41, 42, 50, 44, 45, 70, 71};
    double values[]{1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0};
    for (std::size_t i = 0; i < std::size(kCodes); ++i) {
      const auto value = number(entity, kCodes[i], values[i]);
      if (!value) return std::unexpected(value.error());
      values[i] = *value;
    }
    const auto [x_scale, y_scale, angle, column_step, row_step, columns, rows] = values;
    constexpr double kMostRows = 10'000.0;
    if (!(columns <= kMostRows && rows <= kMostRows))
      return refuse(entity.front(), fmt::format("a block is inserted in more than {} rows or columns", kMostRows));
    const Affine turned = map * Affine::translation(at->x, at->y) * Affine::rotation(kDegree * angle);
    block.is_open = true;
    for (int row = 0; row < std::max(rows, 1.0); ++row)
      for (int column = 0; column < std::max(columns, 1.0); ++column) {
        const Affine placed = turned * Affine::translation(column * column_step, row * row_step) *
                              Affine::scaling(x_scale, y_scale) * Affine::translation(-block.base.x, -block.base.y);
        if (auto done = draw_all(block.entities, placed, depth + 1); !done) return done;
        if (++drawn_ > kMostEntities) return refuse(entity.front(), "blocks are inserted too often");
      }
    block.is_open = false;
    return {};
  }

  /// Joins ends that differ by at most a rounding error: that of a drawing of a hundred units written with four
  /// decimals, or of the decimals in this file.
  void join_curves() {
    Box2 box;
    for (const PlaneCurve& curve : set_.curves) {
      for (const Vec2 p : curve.points()) box.add(p);
      for (const EllipticArc& arc : curve.arcs())
        for (const double side : {-1.0, 1.0}) box.add(arc.center + side * (arc.u + arc.v));
    }
    if (set_.curves.empty()) return;
    constexpr double kShare = 1e-6;
    constexpr double kMostShare = 1e-3;
    const double size = std::max(box.width(), box.height());
    const double far =
        std::max({std::abs(box.low.x), std::abs(box.low.y), std::abs(box.high.x), std::abs(box.high.y)});
    const double rounding = 2.0 * (2.0 * decimals_.error_of(far) + end_rounding_);
    const double tolerance = std::clamp(rounding, kShare * size, kMostShare * size);
    if (std::isfinite(size)) set_.curves = joined_ends(std::move(set_.curves), tolerance);
  }

  std::string_view bytes_;
  const std::string& name_;
  ReadJob& job_;
  std::vector<DxfPair> pairs_;
  std::map<std::string, Block> blocks_;
  std::set<std::string_view> hidden_layers_;
  std::vector<DxfEntity> entities_;
  std::size_t drawn_ = 0;
  std::size_t pieces_ = 0;
  std::size_t looked_at_ = 0;  // number of pairs of code and value
  WrittenDecimals decimals_;   // decimals of lengths
  double end_rounding_ = 0.0;  // rounding error of arc ends, from that of their angles
  CountedRemarks remarks_;
  CurveSet set_;
  std::string_view unit_;  // symbol; empty: the file names none
};

/// Recognises "0", "SECTION", perhaps after comments.
Match match_dxf(std::string_view bytes) {
  if (bytes.starts_with(kBinary)) return Match::surely;
  static const std::string kNoName;
  constexpr std::size_t kLookedAt = std::size_t{1} << 12U;
  const std::string_view begin = bytes.substr(0, kLookedAt);
  // Reads to the end of the first value of code 2: "SECTION", then its name.
  const std::size_t word = begin.find("SECTION");
  if (word == std::string_view::npos) return Match::no;
  const std::size_t end = begin.find_first_of("\r\n", word);
  const auto pairs = read_dxf_pairs(begin.substr(0, end), kNoName);
  const bool is_dxf = pairs && !pairs->empty() && pairs->front().code == 0 && pairs->front().value == "SECTION";
  return is_dxf ? Match::surely : Match::no;
}

Expected<LoadedFile> read_dxf(std::string_view bytes, const std::string& name, ReadJob& job) {
  return DxfReader(without_bom(bytes), name, job).read();
}

}  // namespace

Format dxf_format() {
  return {.descriptor = {.id = "dxf", .name = "DXF drawing", .extensions = {".dxf"}, .can_read = true},
          .match = match_dxf,
          .read = read_dxf,
          .may_look_foreign = true};
}

}  // namespace mes
