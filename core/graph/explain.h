// SPDX-License-Identifier: GPL-3.0-or-later
// Structures describe their rows here: a row itself, its origins and its products.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/base/geometry/disk.h"
#include "core/base/geometry/parabola_arc.h"
#include "core/base/jobs/job_control.h"
#include "core/draw/provenance.h"
#include "core/graph/element.h"
#include "core/graph/structure.h"

namespace mes {

/// A point of a shape, and what it follows.
struct ShapePlace {
  Vec2 at{};
  Followed follows{};
  ShapePlace(Vec2 p) : at(p) {}  // NOLINT(google-explicit-constructor): a place that follows nothing
  ShapePlace(Vec2 p, const Followed& followed) : at(p), follows(followed) {}
};

/// Shapes of one line; shapes with coordinates that are not finite are dropped.
class ProvenanceShapes {
 public:
  void point(const ShapePlace& p) { add(PrimitiveKind::point, {p.at.x, p.at.y}, {p.follows}); }
  /// `follows` is for the centre.
  void circle(const Disk& disk, const Followed& follows = {}) {
    add(PrimitiveKind::circle, {disk.center.x, disk.center.y, disk.radius}, {follows});
  }
  void segment(const ShapePlace& a, const ShapePlace& b) {
    add(PrimitiveKind::segment, {a.at.x, a.at.y, b.at.x, b.at.y}, {a.follows, b.follows});
  }
  void ray(Vec2 from, Vec2 towards) { add(PrimitiveKind::ray, {from.x, from.y, towards.x, towards.y}, {}); }
  /// A ray from a point on the bisector of `a` and `b`, to the left of the vector from `a` to `b`.
  void ray_along_bisector(const ShapePlace& from, const ShapePlace& a, const ShapePlace& b) {
    const Vec2 towards = perpendicular(b.at - a.at);
    add(PrimitiveKind::ray, {from.at.x, from.at.y, towards.x, towards.y}, {from.follows, a.follows, b.follows});
  }
  void line(Vec2 through, Vec2 along) { add(PrimitiveKind::line, {through.x, through.y, along.x, along.y}, {}); }
  void bisector(const ShapePlace& a, const ShapePlace& b) {
    const Vec2 through = 0.5 * (a.at + b.at);
    const Vec2 along = perpendicular(b.at - a.at);
    add(PrimitiveKind::line, {through.x, through.y, along.x, along.y}, {a.follows, b.follows});
  }
  /// `follows` is for the centre.
  void arc(const Disk& disk, const ShapePlace& from, const ShapePlace& to, const Followed& follows = {}) {
    add(PrimitiveKind::arc, {disk.center.x, disk.center.y, disk.radius, from.at.x, from.at.y, to.at.x, to.at.y},
        {follows, from.follows, to.follows});
  }
  void parabola(const ParabolaArc& arc) {
    add(PrimitiveKind::parabola, {arc.from.x, arc.from.y, arc.control.x, arc.control.y, arc.to.x, arc.to.y}, {});
  }
  void triangle(const ShapePlace& a, const ShapePlace& b, const ShapePlace& c) {
    add(PrimitiveKind::triangle, {a.at.x, a.at.y, b.at.x, b.at.y, c.at.x, c.at.y}, {a.follows, b.follows, c.follows});
  }
  std::size_t size() const { return shapes_.size(); }
  std::vector<ProvenanceShape> take() { return std::move(shapes_); }

 private:
  void add(PrimitiveKind kind, const std::array<double, 7>& values, const std::array<Followed, 3>& follows);
  std::vector<ProvenanceShape> shapes_;
};

/// A number as in the lines: six digits.
std::string number_text(double x);
std::string place_text(Vec2 p);

/// The lines about one element. Structures add theirs in `Structure::explain`, inputs before consumers. Each describes
/// only the contents of its own tables, so several may describe one row.
class Explanation {
 public:
  Explanation(const StructureSet& set, const std::function<bool(const Structure&)>& is_current, JobControl& job)
      : set_(set), is_current_(is_current), job_(job) {}

  /// Call this for each row of a full scan. Throws `Cancelled`.
  void look() {
    constexpr std::size_t kRowsBetween = 1024;
    if (++looks_ % kRowsBetween == 0) job_.checkpoint();
  }

  /// Asks the owner of the row to add its lines. Without an owner, asks every structure that is up to date, inputs
  /// first.
  void about(const Element& element);
  template <class Tag>
  void about(ElementKind kind, Slot<Tag> row) {
    about(Element{{kind, nullptr}, row.index()});
  }

  /// Null if it is not up to date.
  template <class T>
  const T* current() const {
    const T& structure = set_.get<T>();
    return is_current_(structure) ? &structure : nullptr;
  }

  void say(ProvenanceRole role, std::string text, ProvenanceShapes& shapes, bool is_heavy = false) {
    lines_.push_back({{role, std::move(text), shapes.take(), is_heavy}, {}});
  }
  /// Describes the element, by its name and the rest of the line. A structure with more information may `rename` it.
  void say_itself(std::string name, std::string rest, ProvenanceShapes& shapes);
  /// Replaces the last name given to `say_itself`; does nothing before the first.
  void rename(std::string name);
  /// Adds shapes of one sort, one for each counted thing: to the existing line of this sort, or as a new line. Does
  /// nothing without shapes.
  void say_any(ProvenanceRole role, const std::string& one, const std::string& many, ProvenanceShapes& shapes);
  /// Lines by role: itself, origins, products. Within a role they keep the order of insertion.
  std::vector<ProvenanceLine> take();

 private:
  /// A line with its key: the sort of things it counts, or the text after the name.
  struct Draft {
    ProvenanceLine line;
    std::string key;
  };

  const StructureSet& set_;
  const std::function<bool(const Structure&)>& is_current_;
  JobControl& job_;
  std::size_t looks_ = 0;
  std::vector<Draft> lines_;
  std::optional<std::size_t> named_;  ///< index of the line of the last `say_itself`
};

/// Asks only structures for which `is_current` holds, and skips the others silently. Empty if the row is dead. Throws
/// `Cancelled`. O(size of the neighbourhood), or O(n) if rows are found by a full scan.
std::vector<ProvenanceLine> explain(const StructureSet& set, const std::function<bool(const Structure&)>& is_current,
                                    const Element& element, JobControl& job);

/// The rows of an element in structures for which `is_current` holds: only in its owner, if it has one.
/// O(columns of all tables).
std::vector<ProvenanceRow> rows_of(const StructureSet& set, const std::function<bool(const Structure&)>& is_current,
                                   const Element& element);

/// The changes that a further sample would cause, as far as the structures are current: its Voronoi cell (itself),
/// elements that disappear (origin) and that appear (product); edges of the curve are heavy. Empty below dimension 2,
/// at an existing sample, and at positions outside the coordinate range. Throws `Cancelled`. O(location + changes).
std::vector<ProvenanceLine> explain_insertion(const StructureSet& set,
                                              const std::function<bool(const Structure&)>& is_current, Vec2 at,
                                              JobControl& job);

}  // namespace mes
