// SPDX-License-Identifier: GPL-3.0-or-later
// A structure without inputs: the entry of outside data into the graph.
#pragma once

#include <memory>

#include "core/base/geometry/box2.h"
#include "core/document/delta.h"
#include "core/graph/structure.h"

namespace mes {

/// `post` (or a method of the subclass) queues changes, and the next `update` or `rebuild` takes them all at once.
/// Sources are brought up to date in every run, demanded or not, so that their queues do not grow.
class SourceStructure : public Structure {
 public:
  explicit SourceStructure(std::string_view id) : Structure(id, {}) {}

  /// Queues a change of the document; sources that do not care ignore it.
  virtual void post(std::shared_ptr<const DocumentDelta> /*delta*/) {}
  virtual bool has_pending() const = 0;
  /// Whether variants without a document of their own share it.
  virtual bool is_of_document() const { return true; }
  /// Covers everything alive since the last rebuild; the drawing frame follows this box.
  virtual Box2 extent() const { return {}; }
};

}  // namespace mes
