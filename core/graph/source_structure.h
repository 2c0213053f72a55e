// SPDX-License-Identifier: GPL-3.0-or-later
// A structure without inputs: what enters the graph from outside.
#pragma once

#include <memory>

#include "core/base/box2.h"
#include "core/document/delta.h"
#include "core/graph/structure.h"

namespace mes {

/// Something is queued by `post` (or by a method of the subclass) and taken by the next `update` or `rebuild`, all at
/// once. Sources are brought up to date in every run, demanded or not: their queue must not grow.
class SourceStructure : public Structure {
 public:
  explicit SourceStructure(std::string_view id) : Structure(id, {}) {}

  /// Queues a change of the document; sources that do not care ignore it.
  virtual void post(std::shared_ptr<const DocumentDelta> /*delta*/) {}
  virtual bool has_pending() const = 0;
  /// A variant that has no document of its own shares it.
  virtual bool is_of_document() const { return true; }
  /// Covers all that lived since the last rebuild; the pictures are drawn in a frame that follows it.
  virtual Box2 extent() const { return {}; }
};

}  // namespace mes
