// SPDX-License-Identifier: GPL-3.0-or-later
// What leaves the geometry engine: for each layer the instances that changed.
//
// A patch is relative to the patches before it. Within one layer and kind, instances are numbered
// 0 .. count-1 without gaps; that number is the instance's place in the drawing buffer.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/box2.h"
#include "core/base/finding.h"
#include "core/base/slot.h"
#include "core/base/stat.h"
#include "core/draw/primitives.h"
#include "core/draw/provenance.h"
#include "core/draw/variant.h"

namespace mes {

/// Changed instances of one kind of one layer.
struct KindPatch {
  bool reset = false;       ///< `data` holds all instances 0 .. count-1 and `index` is empty
  std::uint32_t count = 0;  ///< number of instances after this patch (shrinks need no data)
  /// Instances to overwrite. May name one twice, then the later wins; one at or past `count` was dropped again.
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
  bool has_scalars = false;        ///< the last double of an instance means something; else it is 0 in all
  bool scalars_are_names = false;  ///< it only tells elements apart, and depends on history
  std::array<KindPatch, kPrimitiveKinds> kinds;
  KindPatch& operator[](PrimitiveKind kind) { return kinds[static_cast<std::size_t>(kind)]; }
  const KindPatch& operator[](PrimitiveKind kind) const { return kinds[static_cast<std::size_t>(kind)]; }
  bool is_empty() const {
    for (const KindPatch& patch : kinds)
      if (!patch.is_empty()) return false;
    return true;
  }
  /// Without instances, and saying so.
  void clear() {
    for (KindPatch& patch : kinds) {
      patch.clear();
      patch.count = 0;
    }
  }
};

/// Some instances of one kind of one layer, on their way to a consumer that does not keep them.
struct InstancePiece {
  VariantLayer layer{};
  PrimitiveKind kind = PrimitiveKind::point;
  bool scalars_are_names = false;
  std::span<const double> values;  ///< `stride_of(kind)` doubles each
};

/// Coordinates are turned into drawing space by `(p - origin) * scale`, `scale` a power of two, so that the
/// document fits about [-1, 1] and single precision pairs keep what the doubles say.
struct DrawingFrame {
  Vec2 origin{};
  double scale = 1.0;
  friend bool operator==(const DrawingFrame&, const DrawingFrame&) = default;
};

enum class NodeState : std::uint8_t {
  up_to_date,
  computing,
  failed,    ///< `reason` says why; the last good picture stays
  blocked,   ///< an input failed
  inactive,  ///< not demanded
};

struct NodeReport {
  std::string structure;                ///< public id, kebab case
  VariantIndex variant = kMainVariant;  ///< whose structure it is
  NodeState state = NodeState::inactive;
  std::string reason;               ///< one line, when failed or blocked
  std::vector<SampleId> witnesses;  ///< culprits of a failure
  bool is_refused = false;          ///< it failed because it would be too large
  std::uint64_t computed = 0;       ///< run in which it, or what it is computed from, was last computed; 0 = never
  double update_ms = 0.0;           ///< own time of the last rebuild or update, inputs not counted
  std::uint64_t touched = 0;        ///< rows touched by the last update
  bool rebuilt = false;             ///< the last one was a rebuild
  StatList stats;                   ///< filled when statistics were asked for
  std::string_view kernel;          ///< number type at work; empty where none decides
  bool is_judging = false;          ///< its silence is a proof that the one-step axis is right
  std::vector<Finding> findings;    ///< filled when findings were asked for
};

/// State of a layer as the panel shows it; follows from the structures it reads.
struct LayerReport {
  VariantLayer layer{};
  NodeState state = NodeState::inactive;
  double emit_ms = 0.0;    ///< of the last time the layer was sent whole
  std::uint64_t lost = 0;  ///< primitives left out because their coordinates are not finite
  std::string reason;
};

/// Everything one run of the graph has to say.
struct FramePatch {
  std::uint64_t document_revision = 0;  ///< the document state this picture shows
  DrawingFrame frame;                   ///< when it differs from the patch before, every layer is reset
  std::vector<LayerPatch> layers;       ///< only demanded layers with changes; entries past `layer_count` are spare
  std::size_t layer_count = 0;
  std::uint64_t origin = 0;          ///< a number for the structures that `nodes` are about
  std::uint64_t demand = 0;          ///< a number for the demand that they were last written for
  std::vector<NodeReport> nodes;     ///< of the main computation first, then of the variants
  std::vector<LayerReport> reports;  ///< of the main computation first, then of the variants
  bool complete = true;  ///< false: the run was stopped; no layer is in the patch, and the picture is as before
};

}  // namespace mes
