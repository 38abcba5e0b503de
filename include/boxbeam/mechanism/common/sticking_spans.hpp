#pragma once

#include <optional>
#include <string>
#include <vector>

#include "boxbeam/mechanism/common/sticking.hpp"

namespace boxbeam {

/// A contact that can stick, and what it does at first.
struct FirstSlip {
  std::string joint;
  Slip slip = Slip::none;
};

/// From when until when a contact sticks [s].
struct StickingSpan {
  double from = 0.0;
  std::optional<double> until;  ///< nothing where it does at the end of the time looked at
};

/// How often and when a contact sticks.
struct StickingContact {
  std::string joint;
  std::vector<StickingSpan> spans;
};

/// The contacts that can stick, by what they do at the time `begin` and what changes then.
std::vector<StickingContact> sticking_contacts(const std::vector<FirstSlip>& first, double begin,
                                               const std::vector<SlipChange>& changes);

/// Those of laws that can stick, by name.
std::vector<FirstSlip> first_slips_of(const std::vector<Friction>& laws,
                                      const std::vector<std::string>& names,
                                      const std::vector<Slip>& slips);

/// "rail sticks 2 times: 0.21 s to 0.35 s, from 0.9 s on".
std::string to_text(const StickingContact& contact);

}  // namespace boxbeam
