// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/inputs/center_line_ends.h"

#include <utility>

namespace mes {

void CenterLineEnds::rebuild(JobControl&) {
  if (pending_ == nullptr) return;
  const std::shared_ptr<const Annotations> annotations = std::exchange(pending_, nullptr);
  std::vector<std::array<CenterLineEnd, 2>> ends;
  for (const Annotation& annotation : *annotations) {
    if (annotation.kind != AnnotationKind::center_line) continue;
    std::array<CenterLineEnd, 2>& line = ends.emplace_back();
    for (std::size_t i = 0; i < line.size(); ++i) {
      line[i].at = annotation.anchors[i].at;
      for (const std::uint32_t number : annotation.anchors[i].samples)
        line[i].follows.push_back(SampleId{first_.value + number});
    }
  }
  if (ends == current_) return;
  current_ = std::move(ends);
  touched_ = 1;
}

}  // namespace mes
