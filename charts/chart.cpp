#include "charts/chart.hpp"

#include <algorithm>

namespace boxbeam::charts {

const Point* default_point(const Chart& chart) {
  for (const Series& series : chart.series) {
    for (const Point& point : series.points) {
      if (point.is_default) return &point;
    }
  }
  return nullptr;
}

const char* to_text(Outcome outcome) {
  switch (outcome) {
    case Outcome::solved: return "solved";
    case Outcome::wrong: return "silently wrong";
    case Outcome::refused: return "refused";
  }
  return "";
}

std::size_t MapPanel::count(Outcome outcome) const {
  return static_cast<std::size_t>(std::count_if(
      cells.begin(), cells.end(), [&](const Cell& cell) { return cell.outcome == outcome; }));
}

}  // namespace boxbeam::charts
