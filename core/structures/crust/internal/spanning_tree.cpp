// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/crust/internal/spanning_tree.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "core/base/disjoint_sets.h"
#include "core/base/geometry/box2.h"
#include "core/base/jobs/parallel.h"
#include "core/base/jobs/prefetch.h"

namespace mes {

namespace {

using Rank = CertaintyOrder::Rank;
using Block = std::uint32_t;

class SpanningTree {
 public:
  SpanningTree(const Delaunay& delaunay, const CertaintyOrder& order)
      : delaunay_(delaunay),
        order_(order),
        is_in_tree_(delaunay.edge_rows(), 0),
        kept_(delaunay.site_rows()),
        joined_(delaunay.site_rows()),
        reaches_out_(delaunay.site_rows(), 0) {}

  Table<EdgeSlot, std::uint8_t> run(std::size_t sites_per_block, JobControl& job) {
    const std::size_t blocks = cut_into_blocks(sites_per_block);
    distribute_edges(blocks);
    job.checkpoint();
    run_tasks(blocks, [&](std::size_t block) {
      job.checkpoint();
      decide_within(block, job);
    });
    job.checkpoint();
    decide_the_rest(job);
    return std::move(is_in_tree_);
  }

 private:
  Box2 extent() const {
    std::vector<Box2> boxes(chunk_count(delaunay_.site_rows()));
    parallel_for(delaunay_.site_rows(), [&](std::size_t begin, std::size_t end, std::size_t chunk) {
      Box2 own;
      for (const SiteSlot site : slots_between<SiteSlot>(begin, end))
        if (delaunay_.is_site(site)) own.add(delaunay_.site_position(site));
      boxes[chunk] = own;
    });
    Box2 all;
    for (const Box2& box : boxes) {
      if (box.is_empty()) continue;
      all.add(box.low);
      all.add(box.high);
    }
    return all;
  }

  // Blocks are runs of cells of a grid, so that uniform sites fill them equally.
  std::size_t cut_into_blocks(std::size_t sites_per_block) {
    const double cells = static_cast<double>(delaunay_.site_count()) / static_cast<double>(sites_per_block);
    const auto side = static_cast<std::uint32_t>(std::clamp(std::sqrt(cells), 1.0, 256.0));
    block_of_.assign(delaunay_.site_rows(), 0);
    if (side == 1) return 1;
    const Box2 box = extent();
    // Halved before subtracting, so that boxes as wide as the doubles do not overflow.
    const auto cell_of = [side](double value, double low, double high) {
      const double t = (0.5 * value - 0.5 * low) / (0.5 * high - 0.5 * low) * side;
      return t > 0.0 ? std::min(static_cast<std::uint32_t>(std::min(t, 1e6)), side - 1) : 0U;
    };
    parallel_for(delaunay_.site_rows(), [&](std::size_t begin, std::size_t end, std::size_t) {
      for (const SiteSlot site : slots_between<SiteSlot>(begin, end)) {
        if (!delaunay_.is_site(site)) continue;
        const Vec2 at = delaunay_.site_position(site);
        block_of_[site] = side * cell_of(at.y, box.low.y, box.high.y) + cell_of(at.x, box.low.x, box.high.x);
      }
    });
    return std::size_t{side} * side;
  }

  // Brings the edges with an end in a block together; those between two blocks are in both groups, and once more in a
  // last one.
  void distribute_edges(std::size_t blocks) {
    const std::size_t rows = delaunay_.edge_rows();
    const std::size_t parts = worker_count();
    const auto rows_of = [&](std::size_t part) {
      return slots_between<EdgeSlot>(rows * part / parts, rows * (part + 1) / parts);
    };
    const auto for_each_group = [&](const EdgeRow& row, auto visit) {
      const Block a = block_of_[row.v[0]];
      const Block b = block_of_[row.v[1]];
      visit(a);
      if (a == b) return;
      visit(b);
      visit(blocks);
    };
    std::vector<std::vector<std::size_t>> place(parts);  // first the counts, then the next positions
    run_tasks(parts, [&](std::size_t part) {
      std::vector<std::size_t> counts(blocks + 1, 0);
      for (const EdgeSlot edge : rows_of(part)) {
        if (delaunay_.edge(edge).is_alive())
          for_each_group(delaunay_.edge(edge), [&](std::size_t group) { ++counts[group]; });
      }
      place[part] = std::move(counts);
    });
    std::size_t total = 0;
    for (std::size_t group = 0; group <= blocks; ++group) {
      begin_.push_back(total);
      for (std::size_t part = 0; part < parts; ++part) total += std::exchange(place[part][group], total);
    }
    begin_.push_back(total);
    edges_ = std::make_unique_for_overwrite<RowNumber[]>(total);  // zeros would be one more pass on one thread
    run_tasks(parts, [&](std::size_t part) {
      std::vector<std::size_t>& next = place[part];
      for (const EdgeSlot edge : rows_of(part)) {
        if (!delaunay_.edge(edge).is_alive()) continue;
        for_each_group(delaunay_.edge(edge), [&](std::size_t group) { edges_[next[group]++] = edge.index(); });
      }
    });
    open_.resize(blocks);
  }

  std::vector<Rank> ranks_of_group(std::size_t group) const {
    std::vector<Rank> ranks;
    ranks.reserve(begin_[group + 1] - begin_[group]);
    for (std::size_t i = begin_[group]; i < begin_[group + 1]; ++i)
      ranks.push_back(order_.rank_of(EdgeSlot(edges_[i])));
    return ranks;
  }

  // Runs Kruskal's algorithm twice at once. `joined_` has the components that edges of this block make. `kept_` has
  // those of the edges that are certainly in the tree; there, everything outside the block is one component, together
  // with all that `reaches_out_`.
  void decide_within(std::size_t block, JobControl& job) {
    std::vector<Rank> ranks = ranks_of_group(block);
    order_.sort(ranks, job);
    constexpr std::size_t kAhead = 12;
    for (std::size_t i = 0; i < ranks.size(); ++i) {
      if (i + kAhead < ranks.size()) prefetch(delaunay_.edges().address(ranks[i + kAhead].edge));
      const Rank& rank = ranks[i];
      const EdgeRow& row = delaunay_.edge(rank.edge);
      const bool is_own[2] = {block_of_[row.v[0]] == block, block_of_[row.v[1]] == block};
      if (!is_own[0] || !is_own[1]) {
        reaches_out_[kept_.root(row.v[is_own[0] ? 0 : 1])] = 1;
        continue;
      }
      const SiteSlot a = kept_.root(row.v[0]);
      const SiteSlot b = kept_.root(row.v[1]);
      if (a == b) continue;
      const bool both_reach_out = reaches_out_[a] != 0 && reaches_out_[b] != 0;
      const SiteSlot joined_a = joined_.root(a);
      const SiteSlot joined_b = joined_.root(b);
      if (joined_a == joined_b) continue;
      joined_.join(joined_a, joined_b);
      if (both_reach_out) {
        open_[block].push_back(rank);
        continue;
      }
      is_in_tree_[rank.edge] = 1;
      const std::uint8_t reaches_out = reaches_out_[a] | reaches_out_[b];
      reaches_out_[kept_.join(a, b)] = reaches_out;
    }
  }

  void decide_the_rest(JobControl& job) {
    std::vector<Rank> ranks = ranks_of_group(open_.size());
    for (const std::vector<Rank>& open : open_) ranks.insert(ranks.end(), open.begin(), open.end());
    order_.sort(ranks, job);
    for (const Rank& rank : ranks) {
      const EdgeRow& row = delaunay_.edge(rank.edge);
      const SiteSlot a = kept_.root(row.v[0]);
      const SiteSlot b = kept_.root(row.v[1]);
      if (a == b) continue;
      is_in_tree_[rank.edge] = 1;
      kept_.join(a, b);
    }
  }

  const Delaunay& delaunay_;
  const CertaintyOrder& order_;
  Table<EdgeSlot, std::uint8_t> is_in_tree_;
  Table<SiteSlot, Block> block_of_;
  std::unique_ptr<RowNumber[]> edges_;   // grouped by block
  std::vector<std::size_t> begin_;       // start of each block in `edges_`, of the edges between blocks, and the end
  std::vector<std::vector<Rank>> open_;  // by block: edges that are not decided within it
  // Rows of one block belong to one thread.
  DisjointSets<SiteSlot> kept_;
  DisjointSets<SiteSlot> joined_;
  Table<SiteSlot, std::uint8_t> reaches_out_;  // by root of `kept_`
};

}  // namespace

Table<EdgeSlot, std::uint8_t> spanning_tree(const Delaunay& delaunay, const CertaintyOrder& order, JobControl& job,
                                            std::size_t sites_per_block) {
  return SpanningTree(delaunay, order).run(sites_per_block, job);
}

}  // namespace mes
