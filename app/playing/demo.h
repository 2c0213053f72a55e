// SPDX-License-Identifier: GPL-3.0-or-later
// The video of the 2007 paper as a session: one-step axis, general pipeline, smoothing.
#pragma once

#include "core/document/commands.h"
#include "core/io/session/session.h"

namespace mes {

class Registry;

inline constexpr const char* kDemoTitle = "The demo of 2007";

/// Everything it shows is computed when it is played; nothing of it is a picture made beforehand. Its scenes are the steps
/// of a lesson, at the places of the timeline where they are complete. `shape` needs one closed contour at least. Layers
/// that the registry lacks are not shown. Error: the shape makes no document, or a step of an evolution fails, as it does
/// where the registry lacks that evolution.
///
/// Source: B. Miklos, J. Giesen, M. Pauly, "Medial axis approximation from inner Voronoi balls: a demo of the
/// Mesecina tool", SoCG 2007 (multimedia session).
Expected<Session> demo_session(const Registry& registry, const SampleData& shape);

}  // namespace mes
