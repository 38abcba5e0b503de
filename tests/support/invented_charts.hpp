#pragma once

#include <string>
#include <vector>

#include "charts/chart.hpp"

/// Charts and maps of nothing, to be drawn: plain ones, and all that can make a figure illegible.
namespace test {

/// The trapezoid and Simpson's rule, errors n^-2 and n^-4 at n = 2 to 256; the fifth setting of the
/// second is the default.
boxbeam::charts::Chart invented_chart(std::string name);

/// Ten methods over 21 decades, with zeros, failures and a default among them.
boxbeam::charts::Chart crowded_chart();

/// These, and charts of hostile texts, of failures alone, of one setting, without times, without
/// counts, with numbers that no axis holds.
std::vector<boxbeam::charts::Chart> all_charts();

/// 12 x 10 trials of each method: those at the lowest x are refused; of all but the first method
/// those above the diagonal are wrong.
boxbeam::charts::Map invented_map(std::string name, std::size_t panels);

/// Such maps, of hostile texts too, and with zero on an axis that says it is logarithmic.
std::vector<boxbeam::charts::Map> all_maps();

}  // namespace test
