// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/crust/labels.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <utility>

#include "core/base/jobs/parallel.h"
#include "core/base/jobs/prefetch.h"
#include "core/structures/crust/internal/label_spread.h"
#include "core/structures/crust/internal/spanning_tree.h"

namespace mes {

namespace {

// Sorts rows roughly in the order of the table, in which neighbours mostly lie near each other: readers of the change
// sets then find one row beside the other. `room` is work space. O(rows).
template <class Row>
void bring_near(std::vector<Row>& rows, std::size_t table_rows, std::vector<Row>& room) {
  constexpr std::size_t kFew = 256;
  constexpr int kBits = 11;
  if (rows.size() < kFew) return;
  const int shift = std::max(static_cast<int>(std::bit_width(table_rows)) - kBits, 0);
  std::array<std::uint32_t, (std::size_t{1} << kBits) + 1> begin{};
  for (const Row row : rows) ++begin[(row.index() >> shift) + 1];
  for (std::size_t i = 1; i < begin.size(); ++i) begin[i] += begin[i - 1];
  room.resize(rows.size());
  for (const Row row : rows) room[begin[row.index() >> shift]++] = row;
  rows.swap(room);
}

}  // namespace

Labels::Labels(Delaunay& delaunay, OneStepCrust& crust)
    : Structure("labels", {&delaunay, &crust}),
      delaunay_(delaunay),
      crust_(crust),
      order_(delaunay, crust),
      strokes_(delaunay, crust, order_),
      join_(delaunay, crust, order_, strokes_) {}

void Labels::clear_changes() {
  face_changes_.clear();
  edge_changes_.clear();
}

void Labels::set_conflict(EdgeSlot edge, bool is_conflict) {
  if (this->is_conflict(edge) == is_conflict) return;
  conflict_[edge] ^= kIsConflict;
  if (is_conflict) {
    ++conflict_count_;
  } else {
    --conflict_count_;
  }
  conflict_edges_.push_back(edge);
}

bool Labels::is_in_conflict(EdgeSlot edge) const {
  const EdgeRow& row = delaunay_.edge(edge);
  if (!row.is_alive()) return false;
  if (tree_) return ((inside_[row.f[0]] ^ inside_[row.f[1]]) & 1U) != (crust_.is_wall(edge) ? 1U : 0U);
  return join_.has_edge(edge) != strokes_.has_edge(edge);
}

void Labels::read_conflict(EdgeSlot edge) {
  set_conflict(edge, is_in_conflict(edge));
}

void Labels::read_all_conflicts() {
  std::vector<std::size_t> counts(chunk_count(delaunay_.edge_rows()), 0);
  parallel_for(delaunay_.edge_rows(), [&](std::size_t begin, std::size_t end, std::size_t chunk) {
    std::size_t count = 0;
    for (const EdgeSlot edge : slots_between<EdgeSlot>(begin, end)) {
      const bool is_one = is_in_conflict(edge);
      conflict_[edge] = is_one ? 1 : 0;
      count += is_one ? 1U : 0U;
    }
    counts[chunk] = count;
  });
  conflict_count_ = 0;
  for (const std::size_t count : counts) conflict_count_ += count;
}

// Chooses clusters if they are small, otherwise the tree, which may be known. Open strokes must be known.
void Labels::choose_way(Table<EdgeSlot, std::uint8_t> is_in_tree, JobControl& job) {
  tree_.reset();
  if (join_.rebuild(job)) return;
  join_.clear();
  if (is_in_tree.empty()) {
    order_.find_keys();
    is_in_tree = spanning_tree(delaunay_, order_, job);
  }
  tree_ = std::make_unique<CertaintyTree>(delaunay_, crust_, order_);
  tree_->rebuild(is_in_tree, order_.take_keys());
  odd_when_tree_grew_ = crust_.odd_count();
}

void Labels::label_all(JobControl& job) {
  LabelSpread spread(
      delaunay_, [this](FaceSlot face, int i) { return is_passage(face, i); },
      [this](FaceSlot face, int i) { return is_border(face, i); });
  spread.run(inside_, spread.usual_parts(delaunay_.face_rows()), job);
}

void Labels::rebuild(JobControl& job) {
  clear_changes();
  conflict_.clear();
  conflict_count_ = 0;
  tree_.reset();
  join_.clear();
  is_idle_ = crust_.odd_count() == 0 || delaunay_.dimension() < 2;
  order_.clear();
  // If this many sites are odd and clusters are not small, the ends of strokes are found sooner along the tree.
  Table<EdgeSlot, std::uint8_t> is_in_tree;
  if (!is_idle_ && crust_.odd_count() > std::max(kManyOddSites, delaunay_.site_count() / kFewSites) &&
      !join_.promises_to_be_small(job)) {
    order_.find_keys();
    is_in_tree = spanning_tree(delaunay_, order_, job);
    strokes_.rebuild_for_labels_alone(is_in_tree, job);
  } else {
    strokes_.rebuild(job);
  }
  if (delaunay_.dimension() < 2) {
    inside_.assign(delaunay_.face_rows(), 0);
    return;
  }
  if (is_idle_) {
    label_all(job);
    return;
  }
  choose_way(std::move(is_in_tree), job);
  order_.forget_keys();
  conflict_.resize(delaunay_.edge_rows(), 0);
  if (tree_) label_all(job);
  read_all_conflicts();
  if (!tree_) label_all(job);
}

// Finds the sites at which an edge changed, or has another crust bit or other corners; the neighbours of those whose
// degree changed; and the ends of edges that are now long or not any more. Whether an edge mends, and whether it is
// long, depends on both of its ends.
void Labels::find_touched_sites() {
  touched_.clear();
  touched_marks_.begin(delaunay_.site_rows());
  const auto touch = [this](SiteSlot site) {
    if (touched_marks_.insert(site)) touched_.push_back(site);
  };
  for (const SiteSlot site : crust_.site_changes().removed) touch(site);
  for (const SiteSlot site : crust_.site_changes().touched) touch(site);
  for (const EdgeSlot edge : delaunay_.edge_changes().touched)
    for (const SiteSlot site : delaunay_.edge(edge).v) touch(site);
  order_.update(touched_);
  for (const SiteSlot site : crust_.degree_changes())
    delaunay_.for_each_edge_at(site, [&](EdgeSlot, SiteSlot other, FaceSlot) { touch(other); });
  for (const EdgeSlot edge : order_.changed_edges())
    for (const SiteSlot site : delaunay_.edge(edge).v) touch(site);
}

// True if all labels were recomputed on the way.
bool Labels::follow_conflicts(JobControl& job) {
  is_idle_ = is_idle_ && crust_.odd_count() == 0;
  if (is_idle_ && !order_.keeps_lengths()) return false;
  find_touched_sites();
  if (is_idle_) return false;
  conflict_.resize(delaunay_.edge_rows(), 0);
  if (!strokes_.is_ready_to_update()) {
    strokes_.rebuild(job);
    label_all_anew(job);
    return true;
  }
  strokes_.update(touched_, job);
  const bool is_large = delaunay_.edge_changes().size() > 64 + delaunay_.edge_rows() / kFewEdges;
  if (tree_ ? is_large || !tree_->has_forests() || crust_.odd_count() < odd_when_tree_grew_ / 2
            : !join_.update(touched_, job)) {
    label_all_anew(job);
    return true;
  }
  if (tree_) {
    tree_->update(job);
    return false;
  }
  for (const EdgeSlot edge : strokes_.changed_edges()) read_conflict(edge);
  for (const EdgeSlot edge : join_.changed_edges()) read_conflict(edge);
  is_idle_ = crust_.odd_count() == 0;
  return false;
}

void Labels::get_ready_to_update(JobControl& job) {
  if (!strokes_.is_ready_to_update()) strokes_.rebuild(job);
  if (tree_ && !tree_->has_forests()) tree_->make_forests(job);
}

void Labels::label_all_anew(JobControl& job) {
  choose_way({}, job);
  get_ready_to_update(job);
  const Table<FaceSlot, std::uint8_t> before = inside_;
  if (!tree_)
    for (const EdgeSlot edge : delaunay_.edge_slots()) read_conflict(edge);
  label_all(job);
  if (tree_)
    for (const EdgeSlot edge : delaunay_.edge_slots()) read_conflict(edge);
  for (const FaceSlot face : delaunay_.face_slots())
    if (delaunay_.face(face).is_alive() && inside_[face] != before[face]) turned_.push_back(face);
}

void Labels::label_new_faces() {
  face_marks_.begin(delaunay_.face_rows());
  for (const FaceSlot face : delaunay_.face_changes().touched) face_marks_.insert(face);
  queue_.clear();
  const auto settle = [this](FaceSlot face, bool inside) {
    inside_[face] = inside ? 1 : 0;
    face_marks_.erase(face);
    queue_.push_back(face);
  };
  for (const FaceSlot seed : delaunay_.face_changes().touched) {
    if (!face_marks_.contains(seed)) continue;
    if (delaunay_.face(seed).is_infinite()) {
      settle(seed, false);
    } else {
      for (int i = 0; i < 3; ++i) {
        const FaceSlot other = delaunay_.face(seed).n[i];
        if (face_marks_.contains(other)) continue;
        settle(seed, is_inside(other) != is_border(seed, i));
        break;
      }
    }
    while (!queue_.empty()) {
      const FaceSlot face = queue_.back();
      queue_.pop_back();
      for (int i = 0; i < 3; ++i) {
        const FaceSlot other = delaunay_.face(face).n[i];
        if (!face_marks_.contains(other)) continue;
        settle(other, !delaunay_.face(other).is_infinite() && is_inside(face) != is_border(face, i));
      }
    }
  }
}

// Collects the edges that labels contradict, and turns over the labels that must change.
bool Labels::repair(JobControl& job) {
  violations_.clear();
  const auto check = [this](EdgeSlot edge) {
    const EdgeRow& row = delaunay_.edge(edge);
    if (row.is_alive() && is_violated(row.f[0], delaunay_.face(row.f[0]).index_of_edge(edge)))
      violations_.emplace_back(row.f[0], row.f[1]);
  };
  for (const FaceSlot face : delaunay_.face_changes().touched)
    for (int i = 0; i < 3; ++i)
      if (is_violated(face, i)) violations_.emplace_back(face, delaunay_.face(face).n[i]);
  if (tree_) {
    for (const EdgeSlot edge : tree_->new_between_faces()) check(edge);
    for (const EdgeSlot edge : strokes_.changed_edges()) check(edge);
  } else {
    for (const EdgeSlot edge : conflict_edges_) check(edge);
  }
  if (violations_.empty()) return true;
  if (tree_) return turn_along_tree(job);
  return side_search_.run(
      violations_,
      [this](FaceSlot face, auto visit) {
        for (int i = 0; i < 3; ++i)
          if (is_passage(face, i) && !is_violated(face, i)) visit(delaunay_.face(face).n[i]);
      },
      [this](FaceSlot face) { return delaunay_.face(face).is_infinite(); },
      [this](FaceSlot face) {
        inside_[face] ^= 1U;
        turned_.push_back(face);
      },
      delaunay_.face_rows(), job);
}

// The tree of faces tells which side of a violated edge is cut off from infinity by an odd number of violated edges.
// This side is turned over, and nothing else is looked at. It can have thousands of faces, so each is visited once,
// while the rows ahead are fetched. The conflict bit of an edge changes if one of its faces is turned, and changes back
// if both are.
bool Labels::turn_along_tree(JobControl& job) {
  constexpr std::size_t kAhead = 8;
  tree_->find_odd_sides(violations_, queue_);
  for (const auto& [face, other] : violations_)
    walls_.push_back(delaunay_.face(face).e[delaunay_.face(face).index_of_neighbour(other)]);
  tree_->raise(walls_);
  for (const FaceSlot face : delaunay_.face_changes().touched) inside_[face] |= kIsListed;
  for (const EdgeSlot edge : delaunay_.edge_changes().touched) conflict_[edge] |= kIsListed;
  const auto list = [this](EdgeSlot edge) {
    if ((conflict_[edge] & kIsListed) != 0) return;
    conflict_[edge] |= kIsListed;
    turned_edges_.push_back(edge);
  };
  std::size_t next = 0;
  front_.clear();
  for (std::size_t i = 0; i < walls_.size(); ++i) {
    if (tree_->is_met(walls_[i])) continue;
    front_.push_back({queue_[i], kNoSlot});
    for (; next < front_.size(); ++next) {
      if ((next & 0xfffU) == 0xfffU) job.checkpoint();
      if (next + kAhead < front_.size()) {
        const FaceSlot ahead = front_[next + kAhead].face;
        prefetch(inside_.address(ahead));
        for (const EdgeSlot edge : delaunay_.face(ahead).e) {
          if (edge == kNoSlot) continue;
          tree_->expect(edge);
          prefetch(conflict_.address(edge));
        }
      }
      const auto [face, by] = front_[next];
      const FaceRow& row = delaunay_.face(face);
      if (row.is_infinite()) return false;
      inside_[face] ^= 1U;
      for (int k = 0; k < 3; ++k) {
        const EdgeSlot edge = row.e[k];
        if (edge == by) continue;
        list(edge);
        if (!tree_->is_between_faces(edge)) {
          conflict_[edge] ^= kIsConflict;
          if (is_conflict(edge)) {
            ++conflict_count_;
          } else {
            --conflict_count_;
          }
        } else if (tree_->is_wall(edge)) {
          tree_->meet(edge);
        } else {
          prefetch(delaunay_.faces().address(row.n[k]));
          front_.push_back({row.n[k], edge});
        }
      }
    }
  }
  tree_->lower(walls_);
  for (const auto& [face, by] : front_) turned_.push_back(face);
  return true;
}

// Makes the change sets after `turn_along_tree`.
void Labels::list_turned() {
  for (const EdgeSlot edge : conflict_edges_) {
    if (!delaunay_.edge(edge).is_alive() || (conflict_[edge] & kIsListed) != 0) continue;
    conflict_[edge] |= kIsListed;
    turned_edges_.push_back(edge);
  }
  bring_near(turned_, delaunay_.face_rows(), queue_);
  bring_near(turned_edges_, delaunay_.edge_rows(), edge_room_);
  face_changes_ = delaunay_.face_changes();
  for (const FaceSlot face : turned_)
    if ((inside_[face] & kIsListed) == 0) face_changes_.touched.push_back(face);
  edge_changes_ = delaunay_.edge_changes();
  edge_changes_.touched.insert(edge_changes_.touched.end(), turned_edges_.begin(), turned_edges_.end());
  for (const FaceSlot face : delaunay_.face_changes().touched) inside_[face] ^= kIsListed;
  for (const EdgeSlot edge : edge_changes_.touched) conflict_[edge] ^= kIsListed;
}

void Labels::list_changes() {
  face_recorder_.begin(delaunay_.face_rows());
  edge_recorder_.begin(delaunay_.edge_rows());
  for (const FaceSlot face : delaunay_.face_changes().removed) face_recorder_.note(face, true);
  for (const FaceSlot face : delaunay_.face_changes().touched) face_recorder_.note(face, true);
  for (const EdgeSlot edge : delaunay_.edge_changes().removed) edge_recorder_.note(edge, true);
  for (const EdgeSlot edge : delaunay_.edge_changes().touched) edge_recorder_.note(edge, true);
  for (const EdgeSlot edge : conflict_edges_)
    if (delaunay_.edge(edge).is_alive()) edge_recorder_.note(edge, true);
  for (const FaceSlot face : turned_) {
    face_recorder_.note(face, true);
    for (const EdgeSlot edge : delaunay_.face(face).e)
      if (edge != kNoSlot) edge_recorder_.note(edge, true);
  }
  face_recorder_.finish(face_changes_, [this](FaceSlot face) { return delaunay_.face(face).is_alive(); });
  edge_recorder_.finish(edge_changes_, [this](EdgeSlot edge) { return delaunay_.edge(edge).is_alive(); });
}

bool Labels::update(JobControl& job) {
  inside_.resize(delaunay_.face_rows(), 0);
  turned_.clear();
  turned_edges_.clear();
  conflict_edges_.clear();
  walls_.clear();
  if (!follow_conflicts(job)) {
    label_new_faces();
    if (!repair(job)) return false;
    if (tree_) {
      for (const EdgeSlot edge : delaunay_.edge_changes().removed) read_conflict(edge);
      for (const EdgeSlot edge : delaunay_.edge_changes().touched) read_conflict(edge);
      for (const EdgeSlot edge : strokes_.changed_edges()) read_conflict(edge);
      for (const EdgeSlot edge : walls_) read_conflict(edge);
    }
  }
  if (turned_.empty() && conflict_edges_.empty()) {
    // The usual case: labels differ only where the triangulation does.
    face_changes_ = delaunay_.face_changes();
    edge_changes_ = delaunay_.edge_changes();
  } else if (walls_.empty()) {
    list_changes();
  } else {
    list_turned();
  }
  return true;
}

StatList Labels::statistics() const {
  std::int64_t inside = 0;
  std::int64_t outside = 0;
  for (const FaceSlot face : delaunay_.face_slots())
    if (delaunay_.is_finite_face(face)) (is_inside(face) ? inside : outside) += 1;
  return {{"inside", inside},
          {"outside", outside},
          {"conflicts", static_cast<std::int64_t>(conflict_count())},
          {"open_strokes", static_cast<std::int64_t>(strokes_.count())}};
}

void Labels::find(std::vector<Finding>& out) const {
  if (conflict_count() == 0) return;
  Finding& finding = out.emplace_back();
  finding.text = "edges at which inside and outside contradict the crust";
  finding.count = static_cast<std::int64_t>(conflict_count());
  for (const EdgeSlot edge : delaunay_.edge_slots()) {
    if (finding.places.size() == kMostPlaces) break;
    const EdgeRow& row = delaunay_.edge(edge);
    if (row.is_alive() && is_conflict(edge))
      finding.places.push_back(0.5 * (delaunay_.site_position(row.v[0]) + delaunay_.site_position(row.v[1])));
  }
}

}  // namespace mes
