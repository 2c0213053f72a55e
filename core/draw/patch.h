// SPDX-License-Identifier: GPL-3.0-or-later
// The output of the geometry engine: for each layer the instances that changed.
//
// A patch is relative to the patches before it. Within one layer and kind, instances are numbered
//  0 .. count-1 without gaps; this number is the instance's index in the drawing buffer.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/geometry/box2.h"
#include "core/base/geometry/finding.h"
#include "core/base/ids.h"
#include "core/base/stat.h"
#include "core/draw/primitives.h"
#include "core/draw/variant.h"

namespace mes {

/// Changed instances of one kind of one layer.
struct KindPatch {
  bool reset = false;       ///< `data` holds all instances 0 .. count-1 and `index` is empty
  std::uint32_t count = 0;  ///< number of instances after this patch (shrinks need no data)
  /// Instances to overwrite. The later of two equal indices counts; one at or past `count` was dropped again.
  std::vector<std::uint32_t> index;
  std::vector<double> data;  ///< `stride_of(kind)` doubles each, in the order of `index`

  bool is_empty() const { return !reset && !count_changed && index.empty(); }
  bool count_changed = false;
  void clear() {
    reset = false;
    count_changed = false;
    index.clear();
    data.clear();
  }
};

struct LayerPatch {
  VariantLayer layer{};
  bool has_scalars = false;        ///< the last double of an instance has a meaning; otherwise it is always 0
  bool scalars_are_names = false;  ///< scalars only tell elements apart, and depend on history
  std::array<KindPatch, kPrimitiveKinds> kinds;
  KindPatch& operator[](PrimitiveKind kind) { return kinds[static_cast<std::size_t>(kind)]; }
  const KindPatch& operator[](PrimitiveKind kind) const { return kinds[static_cast<std::size_t>(kind)]; }
  bool is_empty() const {
    for (const KindPatch& patch : kinds)
      if (!patch.is_empty()) return false;
    return true;
  }
  /// Clears the patch: it then has no instances, and says so.
  void clear() {
    for (KindPatch& patch : kinds) {
      patch.clear();
      patch.count = 0;
    }
  }
};

/// Some instances of one kind of one layer, passed to a consumer that does not store them.
struct InstancePiece {
  VariantLayer layer{};
  PrimitiveKind kind = PrimitiveKind::point;
  bool scalars_are_names = false;
  std::span<const double> values;  ///< `stride_of(kind)` doubles each
};

/// Drawing space is `(p - origin) * scale` with a power of two as `scale`, so that the document fills about [-1, 1] and
/// pairs of floats keep the precision of the doubles.
struct DrawingFrame {
  Vec2 origin{};
  double scale = 1.0;
  friend bool operator==(const DrawingFrame&, const DrawingFrame&) = default;
};

enum class NodeState : std::uint8_t {
  up_to_date,
  computing,
  failed,    ///< `reason` explains it; the last good picture stays
  blocked,   ///< an input failed
  inactive,  ///< not demanded
};

struct NodeReport {
  std::string structure;                ///< public id, kebab case
  VariantIndex variant = kMainVariant;  ///< variant of the structure
  NodeState state = NodeState::inactive;
  std::string reason;               ///< one line, when failed or blocked
  std::vector<SampleId> witnesses;  ///< culprits of a failure
  bool is_refused = false;          ///< failed because it would be too large
  std::uint64_t computed = 0;       ///< run in which it or one of its inputs was last computed; 0 = never
  double update_ms = 0.0;           ///< its own time for the last rebuild or update, without inputs
  std::uint64_t touched = 0;        ///< rows touched by the last update
  bool rebuilt = false;             ///< the last computation was a rebuild
  StatList stats;                   ///< filled if statistics were requested
  std::string_view kernel;          ///< number type of its decisions; empty if it makes none
  bool is_judging = false;          ///< if it reports nothing, the one-step axis is proved right
  std::vector<Finding> findings;    ///< filled if findings were requested
};

/// State of a layer as the panel shows it; follows from the structures that it reads.
struct LayerReport {
  VariantLayer layer{};
  NodeState state = NodeState::inactive;
  double emit_ms = 0.0;    ///< time of the last complete emission of the layer
  std::uint64_t lost = 0;  ///< primitives dropped because their coordinates are not finite
  std::string reason;
};

/// Reports of one run on structures and layers. A graph rewrites only those that are needed if it finds its own marks, so
/// the marks are moved or swapped together with the lists.
struct RunReport {
  std::uint64_t origin = 0;          ///< identifies the set of structures in `nodes`
  std::uint64_t demand = 0;          ///< identifies the demand for which the lists were last written
  std::vector<NodeReport> nodes;     ///< main computation first, then the variants
  std::vector<LayerReport> reports;  ///< main computation first, then the variants
};

/// The output of one run of the graph.
struct FramePatch : RunReport {
  std::uint64_t document_revision = 0;  ///< revision of the document in this picture
  DrawingFrame frame;                   ///< if it differs from the previous patch, every layer is reset
  std::vector<LayerPatch> layers;       ///< only demanded layers with changes; entries past `layer_count` are spare
  std::size_t layer_count = 0;
  bool complete = true;  ///< false: the run was stopped; the patch has no layers, and the picture stays
};

}  // namespace mes
