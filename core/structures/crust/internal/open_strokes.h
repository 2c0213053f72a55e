// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the stretches of the crust that are open strokes, which enclose nothing.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/jobs/job_control.h"
#include "core/structures/crust/internal/certainty_growth.h"

namespace mes {

/// Nothing closes a wave or a spiral: between its two ends the spanning tree of the labels runs along and across the
/// stroke itself, and inside would spill over wherever it does. A curve that encloses nothing has no inside, so labels
/// do not change across an open stroke at all.
///
/// The rule, on the samples alone:
///  1. Small defects are repaired. Odd sites are matched with each other along *repairing* edges: those that mend
///     (`CertaintyOrder`), and crust edges between two odd sites one of which has no other. The matching is the stable
///     one: most doubtful edges first. The *curve* is the crust without the matched edges that are crust, and with
///     the other matched edges.
///  2. A *chain* is a stretch of the curve from one site with one curve edge to another, through sites with two.
///  3. Its ends look for partners among the sites with an odd number of curve edges, as Kruskal's algorithm pairs them:
///     by `CertaintyGrowth`, in components of at most `kReach` sites and a `kStrokeSites`-th of the chain's. The chain
///     is an open stroke if neither end finds a partner. It is also one if the ends find each other, more than two
///     edges of the tree apart and in a component with more than a `kStrokeSites`-th of the chain's sites: a component
///     that is small against the chain is a gap in a closed curve, perhaps with dirt in it, and the ends of an arc have
///     an edge in common. But it is none if its ends are at most `kGap` times its longest edge apart: that is a gap,
///     whatever noise there is around it.
///
/// Cost: O(odd sites, the chains, and what their ends grow). An update repeats a decision if it met a site that has
/// changed, on the walk along the chain or in the two growths. Threads: a rebuild for labels alone borrows other cores.
class OpenStrokes {
 public:
  OpenStrokes(const Delaunay& delaunay, const OneStepCrust& crust, const CertaintyOrder& order)
      : delaunay_(delaunay), crust_(crust), order_(order), walk_{CertaintyGrowth(delaunay, order)} {}

  bool has_edge(EdgeSlot edge) const { return on_stroke_.has(edge) && on_stroke_[edge] != 0; }
  /// True if the site is one of the two ends of an open stroke.
  bool ends_at(SiteSlot site) const { return is_end_.has(site) && is_end_[site] != 0; }
  std::size_t count() const { return count_; }

  void rebuild(JobControl& job);
  /// The same strokes, faster where many sites are odd, but without the data that only `update` needs. The keys of the
  /// order and the spanning tree (spanning_tree.h) must be known.
  void rebuild_for_labels_alone(const Table<EdgeSlot, std::uint8_t>& tree, JobControl& job);
  bool is_ready_to_update() const { return is_ready_to_update_; }
  /// `touched` are all sites at which an edge was added or removed, or changed its crust bit or its opposite corners,
  /// and the neighbours of sites whose degree changed.
  void update(const std::vector<SiteSlot>& touched, JobControl& job);
  /// Edges that the last update may have changed; some may be dead, and some unchanged.
  const std::vector<EdgeSlot>& changed_edges() const { return changed_edges_; }
  const std::vector<SiteSlot>& changed_ends() const { return changed_ends_; }

 private:
  static constexpr std::size_t kReach = 128;
  /// Changes no result, only how many sites are looked at.
  static constexpr std::size_t kNearby = 64;
  /// Number of edges after which a walk along the curve asks how long a stroke from its beginning can be.
  static constexpr std::size_t kLong = 64;
  /// 8 to 32 do about as well. With fewer, spirals pass for closed curves with a gap; with more, such curves pass for
  /// strokes.
  static constexpr std::size_t kStrokeSites = 16;
  /// 4 to 8 do about as well. Below, noisy closed curves are lost as a whole; above, short strokes are closed.
  static constexpr double kGap = 4.0;

  using ChainSlot = Slot<struct ChainTag>;
  using WatchSlot = Slot<struct WatchTag>;
  /// The chain that begins at a site, or the sites that keep it from being one.
  struct Chain {
    SiteSlot begin;
    SiteSlot end;                    ///< kNoSlot if no chain begins here, or it is recorded at its other end
    std::vector<EdgeSlot> edges;     ///< edges of the chain if it is an open stroke; else empty
    std::vector<WatchSlot> watched;  ///< sites on which the outcome depends
  };
  /// A chain depends on a site. The watches of one site are linked both ways.
  struct Watch {
    ChainSlot chain;
    SiteSlot site;
    WatchSlot next, previous;
  };
  struct Match {
    EdgeSlot edge;
    SiteSlot partner;
    friend bool operator==(const Match&, const Match&) = default;
  };

  bool repairs(EdgeSlot edge) const;
  bool would_take(SiteSlot site, const CertaintyOrder::Rank& rank) const {
    return match_[site].partner == kNoSlot || order_.is_surer(order_.rank_of(match_[site].edge), rank);
  }
  /// A walk from a site with one curve edge, and everything that it meets; one per thread.
  struct Walk {
    CertaintyGrowth growth;
    std::vector<EdgeSlot> edges{};
    SiteSlot end{};               ///< the other end of the chain, if the walk reached it
    std::vector<SiteSlot> met{};  ///< sites on which the outcome depends, some of them several times
  };
  struct Stroke {
    SiteSlot begin, end;
    std::vector<EdgeSlot> edges;
  };

  struct Proposal {
    CertaintyOrder::Rank rank;
    SiteSlot site;
    SiteSlot partner;  ///< kNoSlot: there is none
  };
  Proposal best_proposal(SiteSlot site) const;
  void set_match(SiteSlot site, const Match& match);
  void part(SiteSlot site);
  void match(const Proposal& proposal);
  void match_first_choices(JobControl& job);
  void match_all(JobControl& job);
  void match_in_order(JobControl& job);
  bool is_on_curve(EdgeSlot edge) const;
  int curve_degree(SiteSlot site) const { return crust_.wall_degree(site) + degree_change_[site]; }

  void watch(ChainSlot chain, SiteSlot site);
  void forget(ChainSlot chain);
  void forget_those_at(SiteSlot site);
  void find_chain(SiteSlot begin, JobControl& job);
  void find_strokes(const std::vector<SiteSlot>& begins, const Table<EdgeSlot, std::uint8_t>& tree, JobControl& job);
  void note_stroke(ChainSlot slot, SiteSlot end, const std::vector<EdgeSlot>& edges);
  ChainSlot new_chain(SiteSlot begin);
  EdgeSlot next_on_curve(SiteSlot site, EdgeSlot last) const;
  /// Follows the curve from one end of a chain. Returns the other end if the chain is an open stroke and recorded here.
  SiteSlot end_of_stroke(SiteSlot begin, Walk& walk, JobControl& job) const;
  bool grow(SiteSlot site, std::size_t reach, Walk& walk, JobControl& job) const;
  bool finds_other_nearby(SiteSlot a, SiteSlot b, Walk& walk, JobControl& job) const;
  bool finds_partner(SiteSlot site, std::size_t reach, Walk& walk, JobControl& job) const;
  bool are_near(SiteSlot a, SiteSlot b, const std::vector<EdgeSlot>& edges) const;
  bool is_open(SiteSlot a, SiteSlot b, Walk& walk, JobControl& job) const;
  void toggle(const Chain& chain);
  void make_room();
  void clear();

  const Delaunay& delaunay_;
  const OneStepCrust& crust_;
  const CertaintyOrder& order_;
  bool is_ready_to_update_ = true;

  // Empty until there is an odd site.
  Table<SiteSlot, Match> match_;
  Table<SiteSlot, std::int8_t> degree_change_;  ///< caused by the matched edge
  Table<SiteSlot, std::uint8_t> is_end_;
  Table<SiteSlot, WatchSlot> first_watch_;
  Table<EdgeSlot, std::uint8_t> on_stroke_;
  Table<ChainSlot, Chain> chains_;
  std::vector<ChainSlot> free_chains_;
  Table<WatchSlot, Watch> watches_;
  std::vector<WatchSlot> free_watches_;
  std::size_t count_ = 0;

  // Work space.
  std::vector<SiteSlot> proposers_;  ///< sites that may find a partner, or a better one
  std::vector<Proposal> proposals_;  ///< a heap
  Table<SiteSlot, EdgeSlot> first_choice_;
  struct Before {
    SiteSlot site;
    Match match;
  };
  SlotMarks<SiteSlot> noted_;
  std::vector<Before> matches_before_;
  std::vector<SiteSlot> begins_;
  Walk walk_;
  std::vector<EdgeSlot> changed_edges_;
  std::vector<SiteSlot> changed_ends_;
};

}  // namespace mes
