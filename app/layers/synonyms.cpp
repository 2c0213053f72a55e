// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/layers/synonyms.h"

#include <algorithm>
#include <array>

namespace mes {
namespace {

constexpr std::string_view kPruning = "prune pruning hair hairs twig twigs spur spurs spurious simplify skeleton";

constexpr auto kSynonyms = std::to_array<Synonyms>({
    {"new", "clear reset empty blank start over"},
    {"open", "load import read"},
    {"save", "store write export"},
    {"save-as", "export store csv geojson wkt poff coordinates"},
    {"keep-degrees", "longitude latitude gps coordinates projection"},
    {"trace-picture", "background photo image scan template underlay"},
    {"trace-into-samples", "vectorize vectorise image photo scan silhouette outline bitmap raster png jpeg import"},
    {"make-shape", "generate circle ellipse polygon star spiral gear formula random example primitive"},
    {"write-text", "font letters glyph type string word"},
    {"snapshot", "screenshot image png export photo capture"},
    {"copy-picture", "screenshot clipboard image"},
    {"record", "film movie capture frames screencast animation"},
    {"make-video", "film movie mp4 animation gif ffmpeg screencast"},
    {"export-figure", "print pdf svg eps postscript tikz latex ipe paper publication vector image save"},
    {"export-center-lines", "centerline midline skeleton gis width river road tool path save"},
    {"quit", "exit close"},
    {"delete", "remove erase clear"},
    {"deselect", "escape cancel unselect none"},
    {"repair-sampling", "refine fix densify insert missing gaps"},
    {"decimate-sampling", "thin reduce simplify fewer coarsen"},
    {"duplicate", "clone copy"},
    {"mirror-x", "flip reflect horizontal"},
    {"mirror-y", "flip reflect vertical"},
    {"put-on-line", "collinear straight degenerate"},
    {"put-on-circle", "cocircular concyclic degenerate"},
    {"add-circle", "circumcircle"},
    {"join-contours", "connect link merge polyline"},
    {"cut-contours", "split break divide"},
    {"forget-contours", "remove polyline connectivity"},
    {"contours-along-crust", "connect polyline polygon reconstruct"},
    {"tool-select", "arrow pointer move drag pick"},
    {"tool-insert", "add point draw"},
    {"tool-spray", "draw pen pencil freehand stroke scribble"},
    {"tool-brush", "eraser rubber"},
    {"tool-ball", "draw disk circle"},
    {"tool-measure", "distance length angle ruler radius dimension"},
    {"tool-annotate", "label text arrow note caption write"},
    {"keep-measurement", "dimension pin"},
    {"keep-highlight", "pin mark"},
    {"toggle-snap", "grid magnet align"},
    {"toggle-handles", "scale rotate resize transform frame"},
    {"fit", "reset view zoom all whole home"},
    {"toggle-panels", "hide interface clean sidebar full screen"},
    {"toggle-statistics", "counts numbers timing performance info"},
    {"toggle-parameters", "settings options"},
    {"toggle-log", "messages errors warnings history"},
    {"toggle-selection", "coordinates numbers edit position properties"},
    {"toggle-curves", "resample spacing density spline bezier"},
    {"curves-of-samples", "spline interpolate fit smooth"},
    {"toggle-branches", "histogram table length width skeleton"},
    {"toggle-persistence", "barcode homology topology betti"},
    {"toggle-sampling", "quality epsilon density proof theorem certificate problems"},
    {"toggle-experiments", "plugin extension script c++ python own algorithm"},
    {"add-experiment", "plugin extension script c++ python own algorithm"},
    {"toggle-legend", "colour color bar scale heat map"},
    {"toggle-key", "legend names of layers"},
    {"toggle-scale-bar", "ruler length unit"},
    {"toggle-axes", "ticks rulers coordinates frame"},
    {"toggle-grid", "graph paper lines"},
    {"add-pane", "compare split side by side view window"},
    {"toggle-evolution", "animate animation steps flow play timeline"},
    {"toggle-theme", "light mode night colours colors"},
    {"projector-mode", "lecture bigger text font size large beamer contrast"},
    {"presenter-mode", "slides slideshow full screen lecture talk presentation"},
    {"save-bundle", "preset style view slide"},
    {"import-bundles", "presets styles load"},
    {"export-bundles", "presets styles save"},
    {"cancel", "stop abort interrupt"},
    {"hold-update", "freeze pause lock"},
    {"precision-naive", "float floating point number type"},
    {"precision-fast", "filtered number type"},
    {"precision-exact", "rational cgal number type"},
    {"precision-exact-roots", "algebraic core number type"},
    {"toggle-lesson", "slides tutorial steps export pdf html video"},
    {"mark-step", "slide add lesson"},
    {"present-lesson", "slides slideshow lecture talk presentation"},
    {"demo", "tour video introduction example"},
    {"classic-keys", "shortcuts 2007 old"},
    {"write-keys", "shortcuts customize bindings keyboard"},
    {"help", "shortcuts keyboard cheat sheet"},
    {"manual", "documentation reference handbook guide help command line"},

    {"points", "samples dots vertices sites"},
    {"indices", "numbers labels ids"},
    {"image", "background photo picture"},
    {"delaunay", "triangulation mesh"},
    {"voronoi", "diagram cells thiessen dirichlet"},
    {"voronoi-circles", "circumcircles empty"},
    {"curve", "crust reconstruction outline boundary"},
    {"voronoi-crust", "reconstruction amenta bern eppstein"},
    {"power-crust", "reconstruction amenta choi kolluri"},
    {"medial-axis", "skeleton centre line center centerline midline"},
    {"all-medial-axis", "skeleton exterior symmetry"},
    {"lambda-medial-axis", kPruning},
    {"angle-medial-axis", kPruning},
    {"cover-medial-axis", kPruning},
    {"scale-axis", kPruning},
    {"a-scale-axis", kPruning},
    {"a-scale-skeleton", kPruning},
    {"interior-voronoi-disks", "inner balls maximal inscribed"},
    {"interior-polar-disks", "inner polar balls"},
    {"feature-size", "lfs local thickness distance"},
    {"sampling-epsilon", "density quality"},
    {"theorem-check", "proof certificate"},
    {"curve-defects", "errors holes gaps"},
    {"alpha-edges", "shape alpha complex"},
    {"alpha-boundary", "shape outline concave hull"},
    {"a-union-boundary", "offset outline"},
    {"a-v-points", "vertices union boundary"},
    {"contours", "polylines order connectivity"},

    {"lambda-limit", kPruning},
    {"angle-limit", kPruning},
    {"scale-axis-factor", kPruning},
    {"alpha-radius", "offset grow shape"},
    {"smooth", "curvature flow fair laplacian taubin denoise"},
    {"subdivide", "refine chaikin four point"},
    {"noise", "jitter random perturb shake disturb"},
});

}  // namespace

std::span<const Synonyms> all_synonyms() {
  return kSynonyms;
}

std::string_view synonyms_of(std::string_view id) {
  const auto* const found = std::ranges::find(kSynonyms, id, &Synonyms::id);
  return found == kSynonyms.end() ? std::string_view() : found->words;
}

}  // namespace mes
