// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editing/curves/contour_commands.h"

#include <algorithm>
#include <array>

#include "core/base/counted.h"

namespace mes {
namespace {

struct ContourWords {
  const char* step;
  const char* done;
};
constexpr std::array<ContourWords, kContourChanges> kContourWords{{{"Join contours", "Joined"},
                                                                   {"Cut contours", "Cut"},
                                                                   {"Close contours", "Closed"},
                                                                   {"Open contours", "Opened"},
                                                                   {"Reverse contours", "Reversed"},
                                                                   {"Forget contours", "Forgotten"}}};

}  // namespace

std::vector<SampleId> ContourCommands::selected() const {
  std::vector<SampleId> out;
  for (const SampleSlot slot : editor_.selection().slots()) out.push_back(editor_.document().id(slot));
  return out;
}

Expected<void> ContourCommands::put(const CurveOrder& contours, const std::string& name) {
  editor_.note_layers();
  if (auto done = editor_.set_contours(contours, name); !done) return done;
  if (const LayerIndex layer = layers_.find("contours"); layer != kNoLayer) layers_.set_visible(layer, true);
  editor_.join_layers();
  return {};
}

Expected<std::string> ContourCommands::change(ContourChange change) {
  const std::size_t before = editor_.document().curve_order()->contours.size();
  const auto contours = changed_contours(editor_.document(), change, selected());
  if (!contours) return std::unexpected(contours.error());
  const ContourWords& words = kContourWords[static_cast<std::size_t>(change)];
  if (auto done = put(*contours, words.step); !done) return std::unexpected(done.error());
  const std::size_t after = contours->contours.size();
  return std::string(words.done) + ": the document has " + counted(after, "contour") +
         (before == after ? "" : " instead of " + std::to_string(before));
}

void ContourCommands::begin_along_crust() {
  is_wanted_ = true;
  if (crust_.now() == nullptr) crust_.find();
}

Expected<std::string> ContourCommands::along(const CrustChains::Curve& curve) {
  const Document& document = editor_.document();
  const Selection& selection = editor_.selection();
  const bool takes_all = selection.sample_count() == 0;
  std::vector<CurveOrder::Contour> chains;
  for (const CrustChains::Curve::Chain& chain : curve.chains) {
    if (!takes_all && std::ranges::none_of(chain.samples, [&](SampleSlot slot) { return selection.contains(slot); }))
      continue;
    CurveOrder::Contour& contour = chains.emplace_back(CurveOrder::Contour{chain.closed, {}});
    for (const SampleSlot slot : chain.samples) contour.samples.push_back(document.id(slot));
  }
  if (chains.empty())
    return std::unexpected(Error{ErrorCode::bad_input, takes_all ? "the crust has no chains"
                                                                 : "no selected sample is on a chain of the crust"});
  const std::size_t count = chains.size();
  const CurveOrder contours = with_contours(document, std::move(chains));
  if (contours == *document.curve_order()) return std::string("The contours are the chains of the crust already");
  if (auto done = put(contours, "Contours along the crust"); !done) return std::unexpected(done.error());
  return counted(count, "contour") + " along the crust";
}

Expected<std::optional<std::string>> ContourCommands::follow() {
  if (editor_.in_gesture()) return std::nullopt;
  const Expected<bool> is_found = crust_.follow();
  if (!is_found) {
    is_wanted_ = false;
    return std::unexpected(is_found.error());
  }
  if (!is_wanted_) return std::nullopt;
  const auto* const curve = crust_.now();
  if (curve == nullptr) {
    // The document has changed since the search of the chains began.
    if (*is_found) is_wanted_ = false;
    return std::nullopt;
  }
  is_wanted_ = false;
  auto done = along(*curve);
  if (!done) return std::unexpected(done.error());
  return std::optional(*std::move(done));
}

}  // namespace mes
