// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the layers of layer_list.inc, and for each family of balls those of union/union_layer_list.inc.
#include <vector>

#include "core/graph/layer.h"
#include "core/layers/parts/family.h"
#include "core/structures/poles/polar_union.h"

namespace mes {

#define LAYER(name) Layer make_##name##_layer(const StructureSet& set);
#define LAYERS(name) std::vector<Layer> make_##name##_layers(const StructureSet& set);
#include "core/layers/layer_list.inc"
#undef LAYER
#undef LAYERS

#define UNION_LAYER(name) Layer make_union_##name##_layer(const UnionFamily& family);
#define UNION_SAMPLE_LAYER(name) UNION_LAYER(name)
#include "core/layers/union/union_layer_list.inc"
#undef UNION_LAYER
#undef UNION_SAMPLE_LAYER

namespace {

using AddLayers = void (*)(const StructureSet& set, std::vector<Layer>& out);

template <Layer (*make)(const StructureSet&)>
void add_one(const StructureSet& set, std::vector<Layer>& out) {
  out.push_back(make(set));
}
template <std::vector<Layer> (*make)(const StructureSet&)>
void add_all(const StructureSet& set, std::vector<Layer>& out) {
  for (Layer& layer : make(set)) out.push_back(std::move(layer));
}

constexpr AddLayers kLayers[] = {
#define LAYER(name) add_one<make_##name##_layer>,
#define LAYERS(name) add_all<make_##name##_layers>,
#include "core/layers/layer_list.inc"
#undef LAYER
#undef LAYERS
};

struct UnionLayer {
  Layer (*make)(const UnionFamily& family);
  bool needs_samples;
};
constexpr UnionLayer kUnionLayers[] = {
#define UNION_LAYER(name) {make_union_##name##_layer, false},
#define UNION_SAMPLE_LAYER(name) {make_union_##name##_layer, true},
#include "core/layers/union/union_layer_list.inc"
#undef UNION_LAYER
#undef UNION_SAMPLE_LAYER
};

void add_union_layers(const UnionFamily& family, std::vector<Layer>& out) {
  for (const UnionLayer& layer : kUnionLayers)
    if (!layer.needs_samples || family.balls.family().is_from_samples()) out.push_back(layer.make(family));
}

}  // namespace

std::vector<Layer> make_layers(const StructureSet& structures) {
  std::vector<Layer> out;
  for (const AddLayers add : kLayers) add(structures, out);
  add_union_layers({'A', structures.get<AUnion>(), structures.get<APowerDiagram>(), structures.get<AVDiagram>(),
                    structures.get<ABallSampling>(), structures.get<AGrownComplex>(), structures.get<AScaleUnion>(),
                    structures.get<AScaleSampling>(), structures.get<ASkeletonUnion>(), LayerGroup::union_a, true},
                   out);
  add_union_layers({'P', structures.get<PUnion>(), structures.get<PPowerDiagram>(), structures.get<PVDiagram>(),
                    structures.get<PBallSampling>(), structures.get<PGrownComplex>(), structures.get<PScaleUnion>(),
                    structures.get<PScaleSampling>(), structures.get<PSkeletonUnion>(), LayerGroup::union_p, true},
                   out);
  add_union_layers({'B', structures.get<BUnion>(), structures.get<BPowerDiagram>(), structures.get<BVDiagram>(),
                    structures.get<BBallSampling>(), structures.get<BGrownComplex>(), structures.get<BScaleUnion>(),
                    structures.get<BScaleSampling>(), structures.get<BSkeletonUnion>(), LayerGroup::union_b, false},
                   out);
  return out;
}

}  // namespace mes
