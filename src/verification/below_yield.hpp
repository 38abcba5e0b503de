#pragma once

#include <memory>
#include <optional>

#include "boxbeam/section/cut_forces.hpp"
#include "boxbeam/strength/effective_width.hpp"

namespace boxbeam {

/// An effective section below yield, where the case asks for that, it settles and is used less,
/// which 4.4(4) leaves free.
template <class Section>
std::optional<Section> lower_section(const Section& section, const CutForces& cut, WidthRule rule,
                                     double at_yield) {
  if (rule == WidthRule::at_yield) return std::nullopt;
  auto below = section.below_yield(cut, rule == WidthRule::annex_E);
  if (below && below->use(cut) > at_yield) below.reset();
  return below;
}

/// The one by which a section is judged; `section` lives as long as `of`.
template <class Section, class Owner>
std::shared_ptr<const Section> section_under(const std::shared_ptr<const Owner>& of,
                                             const Section& section, const CutForces& cut,
                                             WidthRule rule) {
  if (auto below = lower_section(section, cut, rule, section.use(cut)))
    return std::make_shared<Section>(std::move(*below));
  return {of, &section};
}

/// The clause by which its plates are reduced.
inline const char* clause_of(bool below, WidthRule rule) {
  if (!below) return "4.4";
  return rule == WidthRule::annex_E ? "annex E" : "4.4(4)";
}

}  // namespace boxbeam
