// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/balls/ball_union.h"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/disjoint_sets.h"
#include "core/base/jobs/isolated.h"
#include "core/structures/balls/internal/union_runs.h"
#include "core/structures/balls/local_balls.h"
#include "core/structures/balls/voronoi_balls.h"

namespace mes {
namespace {

template <class Tables, class Visit>
void for_each_table(Tables& t, Visit&& visit) {
  visit(t.balls);
  visit(t.dual_edges);
  visit(t.dual_faces);
  visit(t.v_points);
  visit(t.v_origins);
  visit(t.axis);
  visit(t.v_faces);
  visit(t.v_edges);
  visit(t.arcs);
  visit(t.counts);
  visit(t.measures);
}

constexpr IsolationLimits kNaive{10.0, std::uint64_t{1} << 32U, "naive arithmetic"};
constexpr IsolationLimits kRoots{0.0, std::uint64_t{1} << 34U, "arithmetic with roots"};

UnionTables isolated(UnionTables (*run)(const PipelineInput&, JobControl&), const PipelineInput& input,
                     const IsolationLimits& limits, JobControl& job) {
  const std::vector<std::byte> bytes = run_isolated(
      [&] {
        JobControl own;
        const UnionTables tables = run(input, own);
        TableWriter writer;
        for_each_table(tables, writer);
        return writer.take();
      },
      limits, job);
  UnionTables tables;
  TableReader reader(bytes);
  for_each_table(tables, reader);
  return tables;
}

class InnerVoronoiBalls final : public VoronoiBalls {
 public:
  InnerVoronoiBalls(const Delaunay& delaunay, const InnerBalls& balls)
      : VoronoiBalls(delaunay, balls.vertices()), balls_(balls) {}
  bool is_ball(FamilySlot row) const override { return balls_.is_ball(face_of(row)) && VoronoiBalls::is_ball(row); }
  bool are_inner() const override { return true; }
  bool has_changed() const override { return !balls_.changes().is_empty(); }

 private:
  const InnerBalls& balls_;
};

/// The balls of the document, row for row.
class OwnBalls final : public BallFamily {
 public:
  explicit OwnBalls(const UserBalls& balls) : balls_(balls) {}
  std::size_t rows() const override { return balls_.row_count(); }
  std::string_view rows_of() const override { return "balls/balls"; }
  bool is_ball(FamilySlot row) const override { return balls_.is_alive(same_row<BallSlot>(row)); }
  Disk plain_disk(FamilySlot row) const override { return balls_.disk(same_row<BallSlot>(row)); }
  bool is_from_samples() const override { return false; }
  BallSlot ball_of_document(FamilySlot row) const override { return same_row<BallSlot>(row); }
  std::array<Vec2, 3> corners(FamilySlot) const override { return {}; }
  void touched_samples(FamilySlot, std::vector<TouchedSample>&) const override {}
  bool has_changed() const override { return !balls_.changes().is_empty(); }

 private:
  const UserBalls& balls_;
};

/// Vertices and pieces beyond the range of doubles: crossings so nearly in line that their circle reaches beyond it.
struct BeyondDoubles {
  std::int64_t count = 0;
  std::vector<Vec2> places;
};
BeyondDoubles beyond_doubles(const UnionTables& t) {
  BeyondDoubles out;
  for (const VFace& face : t.v_faces) {
    if (is_finite(Disk{face.center, face.radius})) continue;
    ++out.count;
    // The centre cannot be shown, but the v-points on its circle can.
    const Vec2 place = t.v_points[face.v[0]].position;
    if (out.places.size() < kMostPlaces && is_finite(place)) out.places.push_back(place);
  }
  for (const VPoint& v : t.v_points)
    if (v.is_alive() && !is_finite(v.position)) ++out.count;
  return out;
}

struct AxisCounts {
  std::int64_t nodes = 0, edges = 0, components = 0, leaves = 0, branch_points = 0;
};
AxisCounts count_axis(const UnionTables& t) {
  AxisCounts out;
  const std::size_t nodes = t.node_count();
  DisjointSets<AxisNodeSlot> joined(nodes);
  Table<AxisNodeSlot, std::uint32_t> degree(nodes, 0);
  // Ends of pieces of length zero are one node.
  for (const AxisPiece& piece : t.axis)
    if (piece.is_alive() && piece.is_zero != 0) joined.join(joined.root(piece.node[1]), joined.root(piece.node[0]));
  Table<AxisNodeSlot, AxisNodeSlot> merged(nodes);
  for (const AxisNodeSlot node : merged.rows()) merged[node] = joined.root(node);
  Table<AxisNodeSlot, bool> is_node(nodes, false);
  for (const FamilySlot ball : t.balls.rows())
    if (t.balls[ball] == BallState::isolated) is_node[node_of(ball)] = true;
  for (const AxisPiece& piece : t.axis) {
    if (!piece.is_alive()) continue;
    for (const AxisNodeSlot node : piece.node) is_node[merged[node]] = true;
    if (piece.is_zero != 0) continue;
    ++out.edges;
    for (const AxisNodeSlot node : piece.node) ++degree[merged[node]];
  }
  joined.reset(nodes);
  for (const AxisNodeSlot node : merged.rows()) {
    if (!is_node[node] || merged[node] != node) continue;
    ++out.nodes;
    out.leaves += degree[node] == 1 ? 1 : 0;
    out.branch_points += degree[node] >= 3 ? 1 : 0;
  }
  out.components = out.nodes;
  for (const AxisPiece& piece : t.axis) {
    if (!piece.is_alive() || piece.is_zero != 0) continue;
    const AxisNodeSlot a = joined.root(merged[piece.node[0]]);
    const AxisNodeSlot b = joined.root(merged[piece.node[1]]);
    if (a == b) continue;
    joined.join(b, a);
    --out.components;
  }
  return out;
}

/// This many balls are decided exactly within some hundredths of a second.
constexpr std::size_t kFewBalls = 1000;

/// True if rounding makes dual complex and axis contradict each other, or if crossings lie so near to each other that
/// it may have made two of one or changed their order on a circle, as where balls nearly coincide.
bool is_in_doubt(const UnionTables& t) {
  const UnionCounts& c = t.counts;
  if (c.lost_crossings + c.contradictions + c.negative_radicands + c.near_duplicates != 0) return true;
  std::int64_t chi = 0;
  for (const BallState state : t.balls) chi += state == BallState::visible || state == BallState::isolated ? 1 : 0;
  for (const DualEdge& edge : t.dual_edges) chi -= edge.is_alive() ? 1 : 0;
  for (const DualFace& face : t.dual_faces) chi += face.is_alive() ? 1 : 0;
  const AxisCounts axis = count_axis(t);
  return chi != axis.nodes - axis.edges;
}

}  // namespace

std::string_view name_of(UnionRung rung) {
  switch (rung) {
    case UnionRung::shortcut: return "shortcut";
    case UnionRung::naive: return "naive";
    case UnionRung::doubles: return "doubles";
    case UnionRung::rational: return "rational";
    case UnionRung::mixed: return "mixed";
    case UnionRung::roots: return "roots";
  }
  return "";
}

BallUnion::BallUnion(std::string_view id, std::vector<Structure*> inputs, const SettingsSource& settings,
                     const Parameter& scale, std::unique_ptr<BallFamily> family, const AxisCertificate* certificate,
                     std::unique_ptr<SampleUnion> shortcut)
    : Structure(id, std::move(inputs)),
      settings_(settings),
      scale_(scale),
      family_(std::move(family)),
      certificate_(certificate),
      shortcut_(std::move(shortcut)) {}

BallUnion::Choice BallUnion::choice() const {
  const ComputationSettings& settings = settings_.current();
  return {settings.precision, settings.is_on(Parameter::union_shortcut), settings[scale_]};
}

bool BallUnion::is_shortcut_valid() const {
  const Choice now = choice();
  const bool may = now.precision == Precision::fast || now.precision == Precision::exact;
  return may && now.use_shortcut && now.scale == 1.0 && shortcut_ && certificate_->is_certified();
}

void BallUnion::rebuild(JobControl& job) {
  changes_.clear();
  taken_from_ = nullptr;
  made_with_ = choice();
  family_->set_scale(made_with_.scale);
  if (is_shortcut_valid()) {
    rung_ = UnionRung::shortcut;
    why_ = "certified";
    shortcut_->rebuild(tables_, job);
    return;
  }
  if (made_with_.scale != 1.0) {
    why_ = "scaled balls";
  } else if (!shortcut_) {
    why_ = family_->is_from_samples() ? "no certificate for these balls" : "no samples to follow";
  } else if (!made_with_.use_shortcut || made_with_.precision == Precision::naive ||
             made_with_.precision == Precision::exact_roots) {
    why_ = "as asked for";
  } else {
    why_ = fmt::format("not certified: {} arcs met by other balls, {} samples not on one border",
                       certificate_->bad_edge_count(), certificate_->bad_site_count());
  }
  run_pipeline(made_with_.precision, job);
  refine(tables_);
}

void BallUnion::take_over(const BallUnion& other) {
  changes_.clear();
  made_with_ = choice();
  family_->set_scale(made_with_.scale);
  rung_ = other.rung_;
  why_ = other.why_;
  ignored_ = other.ignored_;
  tables_ = other.tables_;
  taken_from_ = &other;
}

// Only the shortcut changes parts of tables; it has no faces and edges of the v-points, and counts nothing.
bool BallUnion::follow(const BallUnion& other) {
  changes_.clear();
  const bool is_same_rung = rung_ == other.rung_ && why_ == other.why_;
  if (taken_from_ != &other || made_with_ != choice() || !is_same_rung) return false;
  if (other.changes_.size() == 0) return true;
  if (rung_ != UnionRung::shortcut) return false;
  changes_ = other.changes_;
  const auto copy = []<class Row, class Value, class ChangedRow>(Table<Row, Value>& to, const Table<Row, Value>& from,
                                                                 const ChangeSet<ChangedRow>& changes) {
    to.resize(from.size());
    for (const auto* rows : {&changes.touched, &changes.removed})
      for (const ChangedRow row : *rows)
        if (const Row at = same_row<Row>(row); from.has(at)) to[at] = from[at];
  };
  const UnionTables& from = other.tables_;
  copy(tables_.balls, from.balls, changes_.balls);
  copy(tables_.dual_edges, from.dual_edges, changes_.dual_edges);
  copy(tables_.axis, from.axis, changes_.dual_edges);
  copy(tables_.dual_faces, from.dual_faces, changes_.dual_faces);
  copy(tables_.v_points, from.v_points, changes_.v_points);
  copy(tables_.v_origins, from.v_origins, changes_.v_points);
  copy(tables_.arcs, from.arcs, changes_.arcs);
  return true;
}

UnionMeasures BallUnion::measures() const {
  if (taken_from_ != nullptr) return taken_from_->measures();
  return shortcut_ && rung_ == UnionRung::shortcut ? shortcut_->measures() : tables_.measures;
}

void BallUnion::run_pipeline(Precision precision, JobControl& job) {
  const LocalBalls balls = local_balls(*family_, job);
  ignored_ = balls.ignored;
  const bool may_be_exact = precision == Precision::fast && made_with_.use_shortcut;
  // Rounding changes the union of balls that touch samples: around each sample, signs are a matter of chance.
  const bool costs_little = balls.balls.size() <= kFewBalls;
  const bool is_exact = may_be_exact && (family_->is_from_samples() || costs_little);
  tables_ = run_pipeline(is_exact ? Precision::exact : precision, balls.input(), job);
  if (rung_ != UnionRung::doubles || !may_be_exact || !is_in_doubt(tables_)) return;
  why_ += "; rounded numbers are in doubt";
  tables_ = run_pipeline(Precision::exact, balls.input(), job);
}

UnionTables BallUnion::run_pipeline(Precision precision, const PipelineInput& input, JobControl& job) {
  switch (precision) {
    case Precision::naive: rung_ = UnionRung::naive; return isolated(run_union_naive, input, kNaive, job);
    case Precision::fast: rung_ = UnionRung::doubles; return run_union_doubles(input, job);
    case Precision::exact: {
      UnionTables out = run_union_exact(input, job);
      rung_ = out.counts.roots == 0 && family_->touch_samples() ? UnionRung::rational : UnionRung::mixed;
      if (rung_ == UnionRung::mixed && family_->touch_samples()) why_ += "; some circles cross where no sample is";
      return out;
    }
    case Precision::exact_roots: rung_ = UnionRung::roots; return isolated(run_union_roots, input, kRoots, job);
  }
  return {};
}

UnionTables BallUnion::exact_dual_complex(JobControl& job) const {
  if (is_exact()) return tables_;
  if (shortcut_ && made_with_.scale == 1.0 && certificate_->is_certified()) {
    SampleUnion fresh = *shortcut_;
    UnionTables tables;
    fresh.rebuild(tables, job);
    return tables;
  }
  const LocalBalls balls = local_balls(*family_, job);
  return run_dual_complex_exact(balls.input(), job);
}

bool BallUnion::update(JobControl&) {
  changes_.clear();
  const bool same_balls = !family_->has_changed() && (!certificate_ || certificate_->touched() == 0);
  if (made_with_ == choice() && same_balls && rung_ != UnionRung::shortcut) return true;
  if (made_with_ != choice() || rung_ != UnionRung::shortcut || !is_shortcut_valid()) return false;
  shortcut_->update(tables_, changes_);
  return true;
}

StatList BallUnion::statistics() const {
  const UnionTables& t = tables_;
  std::vector<std::int64_t> edges(3, 0);
  std::int64_t faces = 0;
  std::int64_t zero_faces = 0;
  std::int64_t visible = 0;
  std::int64_t isolated_balls = 0;
  std::int64_t hidden = 0;
  std::int64_t duplicates = 0;
  for (const BallState state : t.balls) {
    visible += state == BallState::visible || state == BallState::isolated ? 1 : 0;
    isolated_balls += state == BallState::isolated ? 1 : 0;
    hidden += state == BallState::hidden ? 1 : 0;
    duplicates += state == BallState::duplicate ? 1 : 0;
  }
  for (const DualEdge& edge : t.dual_edges)
    if (edge.is_alive()) ++edges[static_cast<std::size_t>(edge.kind)];
  for (const DualFace& face : t.dual_faces) {
    faces += face.is_alive() ? 1 : 0;
    zero_faces += face.is_alive() && face.is_exactly_zero != 0 ? 1 : 0;
  }
  std::int64_t v_points = 0;
  std::int64_t foreign = 0;
  for (const VPoint& v : t.v_points) {
    v_points += v.is_alive() ? 1 : 0;
    foreign += v.is_alive() && v.site == kNoSlot ? 1 : 0;
  }
  const AxisCounts axis = count_axis(t);
  const UnionMeasures measures = this->measures();
  StatList out{{"rung", std::string(name_of(rung_))},
               {"why", why_},
               {"balls", visible + hidden + duplicates},
               {"visible", visible},
               {"hidden", hidden},
               {"duplicates", duplicates},
               {"ignored", static_cast<std::int64_t>(ignored_)},
               {"dual_edges", edges[0] + edges[1] + edges[2]},
               {"dual_singular", edges[0]},
               {"dual_regular", edges[1]},
               {"dual_interior", edges[2]},
               {"dual_faces", faces},
               {"zero_faces", zero_faces},
               {"chi_dual", visible - edges[0] - edges[1] - edges[2] + faces},
               {"isolated", isolated_balls},
               {"v_points", v_points},
               {"nodes", axis.nodes},
               {"edges", axis.edges},
               {"components", axis.components},
               {"cycles", axis.edges - axis.nodes + axis.components},
               {"chi", axis.nodes - axis.edges},
               {"leaves", axis.leaves},
               {"branch_points", axis.branch_points},
               {"length", measures.axis_length},
               {"area", measures.area},
               {"perimeter", measures.perimeter}};
  if (family_->touch_samples()) out.push_back({"foreign_v_points", foreign});
  if (rung_ == UnionRung::shortcut) return out;
  const UnionCounts& c = t.counts;
  out.insert(out.end(), {{"raw_v_points", c.raw_v_points},
                         {"edges_without_sample", c.edges_without_sample},
                         {"sign_flips", c.sign_flips},
                         {"negative_faces", c.negative_faces},
                         {"negative_radicands", c.negative_radicands},
                         {"near_duplicates", c.near_duplicates},
                         {"lost_crossings", c.lost_crossings},
                         {"contradictions", c.contradictions},
                         {"not_finite", t.measures.left_out + beyond_doubles(t).count}});
  return out;
}

std::string_view BallUnion::kernel() const {
  switch (rung_) {
    case UnionRung::shortcut: return "none needed: certified";
    case UnionRung::naive: return "double";
    case UnionRung::doubles: return "EPICK on rounded points";
    case UnionRung::rational: return "EPECK";
    case UnionRung::mixed: return "EPECK, then intervals and fields with roots";
    case UnionRung::roots: return "CORE::Expr";
  }
  return {};
}

void BallUnion::find(std::vector<Finding>& out) const {
  if (rung_ == UnionRung::shortcut) return;
  const UnionTables& t = tables_;
  const auto say = [&](FindingLevel level, std::int64_t count, const char* text) -> std::vector<Vec2>& {
    return out.emplace_back(Finding{level, std::string(id()) + ": " + text, count, {}, {}}).places;
  };
  const bool rounded = !is_exact();
  if (t.counts.sign_flips != 0) {
    auto& places =
        say(FindingLevel::wrong, t.counts.sign_flips,
            "triangles misjudged by rounding: their balls have a common sample, so their orthogonal radius is zero");
    // Misjudged triangles that were left out cannot be shown, but the edges beside them that lost a neighbour can.
    for (const DualEdge& edge : t.dual_edges) {
      if (places.size() >= kMostPlaces) break;
      if (edge.is_alive() && edge.kind == DualClass::singular)
        places.push_back(0.5 * (family_->disk(edge.ball[0]).center + family_->disk(edge.ball[1]).center));
    }
  }
  std::int64_t foreign = 0;
  std::vector<Vec2> foreign_places;
  for (const VPoint& v : t.v_points) {
    if (!v.is_alive() || v.site != kNoSlot) continue;
    ++foreign;
    if (foreign_places.size() < kMostPlaces) foreign_places.push_back(v.position);
  }
  // The theorem is about the inner balls: crossings of other balls that are no samples say nothing about it.
  const FindingLevel exact_level = family_->are_inner() ? FindingLevel::doubt : FindingLevel::note;
  if (family_->touch_samples() && foreign != 0)
    say(rounded ? FindingLevel::wrong : exact_level, foreign,
        rounded ? "v-points that are not samples, by rounding or in truth" : "v-points that are not samples") =
        std::move(foreign_places);
  if (t.counts.lost_crossings + t.counts.contradictions + t.counts.negative_radicands != 0)
    say(FindingLevel::wrong, t.counts.lost_crossings + t.counts.contradictions + t.counts.negative_radicands,
        "contradictions between dual complex and Voronoi diagram of the v-points");
  if (BeyondDoubles beyond = beyond_doubles(t); beyond.count != 0)
    say(FindingLevel::wrong, beyond.count, "points that are not finite, left out of sums and drawing") =
        std::move(beyond.places);
  const StatList stats = statistics();
  const auto value = [&stats](std::string_view key) {
    for (const Stat& stat : stats)
      if (stat.key == key) return std::get<std::int64_t>(stat.value);
    return std::int64_t{0};
  };
  if (value("chi_dual") != value("chi"))
    say(FindingLevel::wrong, 1, "differences of the axis from the dual complex in Euler characteristic");
}

std::unique_ptr<BallFamily> inner_voronoi_balls(const Delaunay& delaunay, const InnerBalls& balls) {
  return std::make_unique<InnerVoronoiBalls>(delaunay, balls);
}

AUnion::AUnion(SettingsSource& settings, Delaunay& delaunay, OneStepCrust& crust, Labels& labels, InnerBalls& balls,
               MedialAxis& axis, AxisCertificate& certificate)
    : BallUnion("a-union", {&settings, &delaunay, &crust, &labels, &balls, &axis, &certificate}, settings,
                Parameter::a_scale, inner_voronoi_balls(delaunay, balls), &certificate,
                std::make_unique<SampleUnion>(delaunay, crust, labels, balls, axis, certificate)) {}

std::unique_ptr<BallFamily> user_ball_family(const UserBalls& balls) {
  return std::make_unique<OwnBalls>(balls);
}

BUnion::BUnion(SettingsSource& settings, UserBalls& balls)
    : BallUnion("b-union", {&settings, &balls}, settings, Parameter::b_scale, user_ball_family(balls)) {}

}  // namespace mes
