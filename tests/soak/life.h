// SPDX-License-Identifier: GPL-3.0-or-later
// A document's life: random edits of all kinds, with the picture kept up to date by patches.
#pragma once

#include <string>
#include <vector>

#include "app/editing/editor.h"
#include "core/base/rng.h"
#include "core/io/session/session.h"
#include "tests/soak/picture_check.h"

namespace mes::test {

/// Guarantees: the same seed gives the same life. `session` is its timeline so far; what it cannot tell are
/// the runs that were stopped.
///
/// Smallest use:
///     Life life(seed);
///     for (int i = 0; i < 300; ++i) life.step();
///     const std::string trouble = life.check();
class Life {
 public:
  explicit Life(std::uint64_t seed);

  /// Something happens, and the picture follows. Throws where a patch breaks a promise.
  void step();
  /// Empty, or how the picture differs from a fresh computation.
  std::string check();
  Session session() const;

 private:
  enum class Source : std::uint8_t { curve, noise, square, grid, circle, balls };
  Vec2 place();
  Disk disk();
  void edit();
  void drag();
  void change_balls();
  void evolve();
  void choose_settings();
  void choose_layers();
  void show(std::vector<LayerIndex> layers);
  SampleId some_sample();

  Rng rng_;
  Source source_;
  bool is_exact_;     // number types and layers that compute in rationals, on a small document
  std::size_t most_;  // samples
  Editor editor_;
  ComputationSettings settings_;
  LayerConfiguration configuration_;
  std::vector<LayerIndex> shown_;
  Consumer consumer_;
};

}  // namespace mes::test
