#include "attachment_places.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "boxbeam/project/attachment_welds.hpp"

namespace boxbeam::report {
namespace {

bool are_alike(const BeamDetail& a, const BeamDetail& b) {
  return a.detail.name == b.detail.name && a.assumed == b.assumed &&
         a.detail.curve.name == b.detail.curve.name && (a.from == a.to) == (b.from == b.to);
}

/// Stretches one behind the other are one; several flats of a plate run side by side.
std::string places_of(std::vector<const BeamDetail*> alike) {
  std::stable_sort(alike.begin(), alike.end(),
                   [](const BeamDetail* a, const BeamDetail* b) { return a->from < b->from; });
  struct Stretch {
    Length from, to;
  };
  std::vector<Stretch> stretches;
  for (const BeamDetail* const of : alike) {
    if (!stretches.empty() && of->from <= stretches.back().to)
      stretches.back().to = std::max(stretches.back().to, of->to);
    else
      stretches.push_back({of->from, of->to});
  }
  std::vector<std::string> texts;
  for (const Stretch& of : stretches) {
    texts.push_back(of.to > of.from
                        ? fmt::format("{:.6g} to {:.6g}", of.from.value(), of.to.value())
                        : fmt::format("{:.6g}", of.from.value()));
  }
  return fmt::format("s = {} m", fmt::join(texts, ", "));
}

}  // namespace

std::vector<AlikeWelds> alike_welds_of(const FatigueInput& fatigue) {
  std::vector<std::vector<const BeamDetail*>> groups;
  for (const AttachmentWeld& weld : fatigue.attachments) {
    if (!weld.detail.assumed.empty() && !may_govern(fatigue, weld)) continue;
    const auto group = std::find_if(groups.begin(), groups.end(), [&](const auto& of) {
      return are_alike(*of.front(), weld.detail);
    });
    if (group == groups.end())
      groups.push_back({&weld.detail});
    else
      group->push_back(&weld.detail);
  }
  std::vector<AlikeWelds> alike;
  for (const auto& group : groups) alike.push_back({group.front(), places_of(group)});
  return alike;
}

}  // namespace boxbeam::report
