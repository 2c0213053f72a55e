// SPDX-License-Identifier: GPL-3.0-or-later
// How structures say what a row of theirs is, what it comes from and what it made.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/base/disk.h"
#include "core/base/job_control.h"
#include "core/draw/provenance.h"
#include "core/graph/element.h"
#include "core/graph/structure.h"

namespace mes {

/// A place of a shape, and what it follows.
struct ShapePlace {
  Vec2 at{};
  Followed follows{};
  ShapePlace(Vec2 p) : at(p) {}  // NOLINT(google-explicit-constructor): a place that follows nothing
  ShapePlace(Vec2 p, const Followed& followed) : at(p), follows(followed) {}
};

/// Shapes of one line; those with coordinates that are not finite are left out.
class ProvenanceShapes {
 public:
  void point(const ShapePlace& p) { add(PrimitiveKind::point, {p.at.x, p.at.y}, {p.follows}); }
  /// `follows`: of its centre.
  void circle(const Disk& disk, const Followed& follows = {}) {
    add(PrimitiveKind::circle, {disk.center.x, disk.center.y, disk.radius}, {follows});
  }
  void segment(const ShapePlace& a, const ShapePlace& b) {
    add(PrimitiveKind::segment, {a.at.x, a.at.y, b.at.x, b.at.y}, {a.follows, b.follows});
  }
  void ray(Vec2 from, Vec2 towards) { add(PrimitiveKind::ray, {from.x, from.y, towards.x, towards.y}, {}); }
  /// From a place on the bisector of `a` and `b`, to the left of the way from `a` to `b`.
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
  /// `follows`: of its centre.
  void arc(const Disk& disk, const ShapePlace& from, const ShapePlace& to, const Followed& follows = {}) {
    add(PrimitiveKind::arc, {disk.center.x, disk.center.y, disk.radius, from.at.x, from.at.y, to.at.x, to.at.y},
        {follows, from.follows, to.follows});
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

/// Numbers as the lines write them: six digits.
std::string number_text(double x);
std::string place_text(Vec2 p);
/// "1 edge", "2 edges".
std::string count_text(std::size_t count, const std::string& one, const std::string& many);

/// The lines about one element. Structures add theirs in `Structure::explain`, inputs before consumers; each says what
/// its own tables know, so several may speak of one row.
class Explanation {
 public:
  Explanation(const StructureSet& set, const std::function<bool(const Structure&)>& is_current, JobControl& job)
      : set_(set), is_current_(is_current), job_(job) {}

  /// To be called for each row where rows are found by looking at all. Throws `Cancelled`.
  void look() {
    constexpr std::size_t kRowsBetween = 1024;
    if (++looks_ % kRowsBetween == 0) job_.checkpoint();
  }

  /// Lets the owner of the row speak; where there is none, every structure that is up to date, inputs first: each
  /// adds what it knows of the row.
  void about(const Element& element);
  template <class Tag>
  void about(ElementKind kind, Slot<Tag> row) {
    about(Element{{kind, nullptr}, row.index()});
  }

  /// Null when it is not up to date.
  template <class T>
  const T* current() const {
    const T& structure = set_.get<T>();
    return is_current_(structure) ? &structure : nullptr;
  }

  void say(ProvenanceRole role, std::string text, ProvenanceShapes& shapes, bool is_heavy = false) {
    lines_.push_back({{role, std::move(text), shapes.take(), is_heavy}, {}});
  }
  /// What the element is, as its name and the rest of the line. A structure that knows more calls it by another name.
  void say_itself(std::string name, std::string rest, ProvenanceShapes& shapes);
  /// Replaces the name that `say_itself` gave last; does nothing before it.
  void rename(std::string name);
  /// Adds shapes of one sort, one for each thing counted: to the line that has them already, or as a new line. Nothing
  /// when there are none.
  void say_any(ProvenanceRole role, const std::string& one, const std::string& many, ProvenanceShapes& shapes);
  /// By role: itself, origins, products. Within a role in the order in which they were said.
  std::vector<ProvenanceLine> take();

 private:
  /// A line, and what is counted in it or what follows the name in it.
  struct Draft {
    ProvenanceLine line;
    std::string key;
  };

  const StructureSet& set_;
  const std::function<bool(const Structure&)>& is_current_;
  JobControl& job_;
  std::size_t looks_ = 0;
  std::vector<Draft> lines_;
  std::optional<std::size_t> named_;  ///< the line of the last `say_itself`
};

/// Reads only structures for which `is_current` holds; the others are passed over in silence. Empty when the row is
/// dead. Throws `Cancelled`. O(size of the neighbourhood), O(n) where rows are found by looking at all.
std::vector<ProvenanceLine> explain(const StructureSet& set, const std::function<bool(const Structure&)>& is_current,
                                    const Element& element, JobControl& job);

/// The rows that structures for which `is_current` holds have of an element: its owner, or all of them where it has none.
/// O(columns of all tables).
std::vector<ProvenanceRow> rows_of(const StructureSet& set, const std::function<bool(const Structure&)>& is_current,
                                   const Element& element);

/// What a further sample at a place would change, as far as the structures are current: its Voronoi cell (itself), what
/// goes (origin) and what comes (product); edges of the curve are heavy. Empty below dimension 2, where a sample is
/// already, and where no number may be. Throws `Cancelled`. O(location + changes).
std::vector<ProvenanceLine> explain_insertion(const StructureSet& set,
                                              const std::function<bool(const Structure&)>& is_current, Vec2 at,
                                              JobControl& job);

}  // namespace mes
