#include "boxbeam/study/chart.hpp"

#include <algorithm>

namespace boxbeam::study {

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

}  // namespace boxbeam::study
