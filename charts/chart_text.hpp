#pragma once

#include <string>
#include <vector>

#include "charts/chart.hpp"

/// Words about the points of charts, for figures, pages and the terminal.
namespace boxbeam {

/// A setting without a result, or with one that is no number.
bool has_failed(const charts::Point& point);

/// Settings of a method that failed for one reason.
struct FailedSettings {
  std::string method;
  std::vector<std::string> settings;
  std::string reason;
};

std::vector<FailedSettings> failures_of(const charts::Chart& chart);

/// "8 parts", "8 parts, 16 parts", "8 parts to 1024 parts (7 settings)".
std::string settings_text(const std::vector<std::string>& settings);

/// What the program does by itself where a chart's question arises.
struct DefaultSetting {
  const charts::Series* series;
  const charts::Point* point;
};

/// None where the question has no default.
std::vector<DefaultSetting> defaults_of(const charts::Chart& chart);

/// How an error stands to what a strength check needs: "better", "within", "coarser"; "failed".
std::string standing_of(const charts::Chart& chart, const charts::Point& point);

/// Which settings are better than the default of a chart, and why it is not one of them; "" where
/// it lies on the front, or cost is not weighed.
std::string front_text(const charts::Chart& chart);

/// "exact polynomials, closed form".
std::string setting_text(const DefaultSetting& setting);

/// "2.3e-16", "0", "failed".
std::string error_text(const charts::Point& point);

/// "1e-4 to 1e-3".
std::string needed_text(const charts::Chart& chart);

/// A measured time with three digits: "412 ns", "1.30 ms".
std::string duration_text(double seconds);

}  // namespace boxbeam
