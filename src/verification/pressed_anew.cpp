#include "pressed_anew.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bent_flanges.hpp"

namespace boxbeam {

void PressedAnew::Pressed::take(double stress, std::size_t instant) {
  if (at_ != instant) {
    *this = whole();
    at_ = instant;
    now_ = stress;
    ++seen;
  } else if (std::abs(stress) > std::abs(now_)) {
    now_ = stress;
  }
}

PressedAnew::Pressed PressedAnew::Pressed::whole() const {
  Pressed of = *this;
  if (seen == 0) return of;
  of.least = std::min(of.least, now_);
  of.most = std::max(of.most, now_);
  return of;
}

void PressedAnew::take(const Patch& patch, const std::vector<Borne>& ways, bool all) {
  if (!project_->fatigue.asked) return;
  // A torque stands for either of its two senses once.
  if (patch.is_torque() && !(patch.force > Force{})) return;
  double in_web = 0.0, in_weld = 0.0;
  for (const Borne& way : ways) {
    const double force = (way.basis.share * way.basis.force).value();
    const bool counted =
        counted_ && way.basis.box && PressingForces::counts(patch) && !patch.led_there;
    const auto* const weld = std::get_if<StiffenerWeld>(&way.basis.bears);
    if (weld != nullptr && !(counted && way.part == Borne::Part::weld)) {
      // Where nothing is said of them as thick together as the diaphragm.
      const Length throat = way.part == Borne::Part::unsaid_weld
                                ? Length(0.5 * patch.diaphragm->thickness)
                                : weld->throat;
      in_weld = std::max(
          in_weld, force / (static_cast<double>(weld->welds) * throat * weld->length).value());
    }
    const PatchedWeb* const web = web_in(way);
    if (web == nullptr) continue;
    if (counted) continue;
    in_web = std::max(in_web, force / (web->thickness * loaded_length_of(*web)).value());
  }
  // From above or from below: what pushes and what pulls.
  const double of_what = patch.is_torque() ? patch.torque.value() : patch.force.value();
  const double sense = of_what > 0.0 ? 1.0 : -1.0, s = patch.s.value();
  const auto add = [&](double stress, Pressed& of) {
    of.unsaid = of.unsaid || !patch.given;
    if (all)
      of.take(stress, instants_);
    else if (stress > 0.0)
      of.most = std::max(of.most, stress);
    else
      of.least = std::min(of.least, stress);
    of.from = std::min(of.from, s);
    of.to = std::max(of.to, s);
  };
  if (patch.diaphragm == nullptr) add(sense * in_web, webs_[{patch.name, patch.along_z}]);
  // A wheel leads its force to a diaphragm that it passes and is gone.
  if (in_weld > 0.0) add(sense * in_weld, welds_[{patch.name, patch.along_z}]);
}

PressedAnew::Changing PressedAnew::changing_in(const PressedByName& all) const {
  Changing found;
  for (const auto& [key, known] : all) {
    const Pressed of = known.whole();
    // What moves on is gone from a place.
    const bool moves = of.to - of.from > 1e-6 * project_->beam.length().value();
    const bool comes_and_goes = moves || of.seen < instants_;
    const double range = std::max(of.most, comes_and_goes ? 0.0 : of.least) -
                         std::min(of.least, comes_and_goes ? 0.0 : of.most);
    if (!(range > hardly_changes.value())) continue;
    found.most = std::max(found.most, range);
    found.unsaid = found.unsaid || of.unsaid;
    if (found.names.empty() || found.names.back() != key.first) found.names.push_back(key.first);
  }
  return found;
}

void PressedAnew::add_to(std::vector<NotJudged>& found) const {
  if (const Changing of = changing_in(webs_); !of.names.empty())
    found.push_back(
        {Criterion::patch_loading, fmt::format("webs under {}", fmt::join(of.names, ", ")),
         fmt::format("pressed anew by up to {:.3g} MPa at every cycle, not counted in fatigue (EN "
                     "1993-1-9, table 8.10){}",
                     1e-6 * of.most,
                     of.unsaid ? ": [[beam.load_introductions]] say how it comes in" : "")});
  if (const Changing of = changing_in(welds_); !of.names.empty())
    found.push_back({Criterion::weld,
                     fmt::format("welds of diaphragms under {}", fmt::join(of.names, ", ")),
                     fmt::format("stressed anew by up to {:.3g} MPa at every cycle, not counted in "
                                 "fatigue (EN 1993-1-9, table 8.5, row 3)",
                                 1e-6 * of.most)});
}

}  // namespace boxbeam
