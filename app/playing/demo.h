// SPDX-License-Identifier: GPL-3.0-or-later
// The video of the 2007 paper as a session: one-step axis, general pipeline, smoothing.
#pragma once

#include "core/document/sample_data.h"
#include "core/io/session/session.h"

namespace mes {

class Registry;

inline constexpr const char* kDemoTitle = "The demo of 2007";

/// Everything in it is computed during playback; it contains no finished pictures. Its scenes are the steps of a
/// lesson, at the timeline positions where they are complete. `shape` needs at least one closed contour. Layers that
/// the registry lacks are not shown. Error: the shape makes no document, or a step of an evolution fails, e.g.
/// because the registry lacks that evolution.
///
/// Source: B. Miklos, J. Giesen, M. Pauly, "Medial axis approximation from inner Voronoi balls: a demo of the
/// Mesecina tool", SoCG 2007 (multimedia session).
Expected<Session> demo_session(const Registry& registry, const SampleData& shape);

}  // namespace mes
