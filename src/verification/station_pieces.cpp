// The polynomials that describe what a station feels between instants.
#include <algorithm>
#include <cmath>
#include <utility>

#include "boxbeam/verification/load_history.hpp"
#include "bracket_nodes.hpp"
#include "passed_borders.hpp"

namespace boxbeam {
namespace {

/// Halvings of a bracket that one polynomial does not describe: a millionth is left of it.
constexpr int most_halvings = 20;

}  // namespace

StationHistory::Piece StationHistory::piece_between(double from, double to, bool keep) const {
  Piece piece{from, to, {}, false};
  if (keep) {
    const LoadHistory::Bracket& bracket = loads_->bracket({si<Time>(from), si<Time>(to)});
    for (std::size_t k = 0; k <= last_node; ++k) piece.at[k] = bracket[k].at(station_);
    return piece;
  }
  for (std::size_t k = 0; k <= last_node; ++k) {
    piece.at[k] = loads_->diagram_at(si<Time>(BracketPoints::between(from, to, k))).at(station_);
  }
  return piece;
}

void StationHistory::add_smooth(const Piece& piece, int halvings, bool keep,
                                std::vector<Piece>& pieces) const {
  const double defect = defect_of(piece.at, force_floor_, moment_floor_);
  if (defect <= 1.0) {
    pieces.push_back(piece);
    return;
  }
  if (halvings == 0) {
    pieces.push_back(piece);
    pieces.back().jump = true;
    return;
  }
  const double middle = 0.5 * (piece.from + piece.to);
  const Piece left = piece_between(piece.from, middle, keep);
  const Piece right = piece_between(middle, piece.to, keep);
  // A bend or a jump is in one of the halves, and a bend is half as large there; where both halves
  // are as rough as the whole, halving on would not end. What is small is the rounding of loads
  // that were solved for: the polynomial passes through its middle. Else only the nodes are known.
  constexpr double better = 1.5;
  constexpr double small = 100.0;
  const double least = std::min(defect_of(left.at, force_floor_, moment_floor_),
                                defect_of(right.at, force_floor_, moment_floor_));
  if (least > defect / better) {
    pieces.push_back(piece);
    pieces.back().jump = defect > small;
    return;
  }
  add_smooth(left, halvings - 1, keep, pieces);
  add_smooth(right, halvings - 1, keep, pieces);
}

void StationHistory::divide_at_passages(const LoadHistory::Reach& reach,
                                        std::vector<Piece>& pieces) const {
  const LoadHistory::Bracket& bracket = loads_->bracket(reach);
  const double begin = reach.from.value();
  const double end = reach.to.value();
  double from = begin;
  const auto add = [&](double to) {
    if (to > from) add_smooth(piece_between(from, to, false), most_halvings / 2, false, pieces);
  };
  for (std::size_t k = 1; k <= last_node; ++k) {
    const std::size_t before = borders_before(bracket[k - 1], station_);
    const std::size_t behind = borders_before(bracket[k], station_);
    if (behind == before) continue;
    double low = BracketPoints::between(begin, end, k - 1);
    double high = BracketPoints::between(begin, end, k);
    const std::size_t border = std::min(before, behind);
    double left = (border_of(bracket[k - 1], border) - station_.s).value();
    double beyond = (station_.s - border_of(bracket[k], border)).value();
    const auto look_at = [&](double time) {
      if (!(time > low && time < high)) return;
      const CutForceDiagram at = loads_->diagram_at(si<Time>(time));
      const double to_go = (border_of(at, border) - station_.s).value();
      const bool lies_before = borders_before(at, station_) == before;
      (lies_before ? low : high) = time;
      (lies_before ? left : beyond) = lies_before ? to_go : -to_go;
    };
    // At even speed it passes here, but for rounding; else as far again on from where this leads.
    constexpr int most = 12;
    for (int i = 0; i < most && left * beyond > 0.0; ++i) {
      const double speed = (left + beyond) / (high - low), passed = low + left / speed;
      const double aside = 1e-14 * std::max(std::abs(low), std::abs(high));
      look_at(passed - aside);
      look_at(passed + aside);
      if (high - low <= 4.0 * aside) break;
      if (high <= passed + aside)
        look_at(high - 2.0 * beyond / speed);
      else if (low >= passed - aside)
        look_at(low + 2.0 * left / speed);
    }
    // To the last time before and the first behind: the same from whichever instants it is found,
    // so that an extremum on one side of it is looked up there.
    for (double half = 0.5 * (low + high); half > low && half < high; half = 0.5 * (low + high))
      look_at(half);
    add(low);
    from = high;
  }
  add(end);
}

const std::vector<StationHistory::Piece>& StationHistory::pieces_of(std::size_t instant) const {
  const auto found = pieces_.find(instant);
  if (found != pieces_.end()) return found->second;
  std::vector<Piece> pieces;
  const LoadHistory::Reach reach = loads_->reach_of(instant);
  const LoadHistory::Bracket& bracket = loads_->bracket(reach);
  const bool passage =
      std::any_of(bracket.begin(), bracket.end(), [&](const CutForceDiagram& diagram) {
        return borders_before(diagram, station_) != borders_before(bracket[0], station_);
      });
  if (passage) {
    divide_at_passages(reach, pieces);
  } else if (reach.to > reach.from) {
    add_smooth(piece_between(reach.from.value(), reach.to.value(), true), most_halvings, true,
               pieces);
  }
  return pieces_.emplace(instant, std::move(pieces)).first->second;
}

}  // namespace boxbeam
