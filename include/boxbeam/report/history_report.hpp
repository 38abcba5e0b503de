#pragma once

#include <string>

#include "boxbeam/report/marked_text.hpp"
#include "boxbeam/verification/history_fatigue.hpp"

namespace boxbeam {

/// The verdict on a stress history, its spectrum with the damage of each row, and what follows.
report::MarkedText history_text(const HistoryDemand& demand, const HistoryFatigue& fatigue);

/// The same as boxbeam.fatigue/1, SI.
std::string history_json(const HistoryDemand& demand, const HistoryFatigue& fatigue);

/// "ASTM E1049, half cycles", "four points, residue as half cycles", "periodic (no residue)".
std::string to_text(const CountingRule& rule);

}  // namespace boxbeam
