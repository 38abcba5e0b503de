#include "boxbeam/numerics/largest_on_pieces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>

namespace boxbeam {
namespace {

using Five = std::array<double, 5>;

/// The top of the parabola through three places at distance 1, between the outer two.
double top_of(double before, double at, double behind) {
  const double largest = std::max({before, at, behind});
  const double slope = 0.5 * (behind - before);
  const double bend = behind - 2.0 * at + before;
  if (bend >= 0.0 || std::abs(slope) > -bend) return largest;
  return std::max(largest, at - 0.5 * slope * slope / bend);
}

/// What a function with these values may have between them.
double bound_of(const Five& v) {
  const double second = 0.375 * v[0] + 0.75 * v[2] - 0.125 * v[4];
  const double fourth = 0.375 * v[4] + 0.75 * v[2] - 0.125 * v[0];
  const double error = std::max(std::abs(v[1] - second), std::abs(v[3] - fourth));
  const double top =
      std::max({top_of(v[0], v[1], v[2]), top_of(v[1], v[2], v[3]), top_of(v[2], v[3], v[4])});
  return top + 3.0 * error;
}

/// A part of a piece; its places by their indices.
struct Part {
  std::size_t piece = 0;
  std::array<std::size_t, 5> places{};
  double excess = 0.0;  ///< of its bound over the largest found when it was last looked at

  friend bool operator<(const Part& a, const Part& b) { return a.excess < b.excess; }
};

class Search {
 public:
  explicit Search(const PieceSearch& of) : of_(&of), largest_(of.known) {
    for (std::size_t piece = 0; piece < of.pieces.size(); ++piece) {
      const std::vector<double>& borders = of.pieces[piece];
      std::size_t first = evaluate(piece, borders.front());
      for (std::size_t k = 0; k + 1 < borders.size(); ++k) {
        Part part{piece, {}, 0.0};
        part.places.front() = first;
        for (std::size_t j = 1; j < 5; ++j) {
          const double fraction = 0.25 * static_cast<double>(j);
          const double at =
              j == 4 ? borders[k + 1] : borders[k] + fraction * (borders[k + 1] - borders[k]);
          part.places[j] = evaluate(piece, at);
        }
        first = part.places.back();
        parts_.push_back(part);
      }
    }
  }

  PieceSearchResult run() {
    std::priority_queue<Part> queue;
    for (Part& part : parts_) {
      part.excess = excess_of(part);
      queue.push(part);
    }
    PieceSearchResult result;
    while (!queue.empty()) {
      Part worst = queue.top();
      if (worst.excess <= of_->tolerance) break;
      queue.pop();
      // The largest may have grown meanwhile.
      const double excess = excess_of(worst);
      if (excess < worst.excess) {
        worst.excess = excess;
        queue.push(worst);
        continue;
      }
      if (sites_.size() >= of_->most_evaluations || !can_halve(worst)) {
        leave_open(worst, result.left_open);
        continue;
      }
      for (Part& half : halves_of(worst)) {
        half.excess = excess_of(half);
        queue.push(half);
      }
    }
    for (; !queue.empty(); queue.pop()) leave_open(queue.top(), result.left_open);
    result.evaluations = sites_.size();
    result.largest = largest_;
    result.pieces.resize(of_->pieces.size());
    for (Site& site : sites_) result.pieces[site.piece].push_back(std::move(site.place));
    for (std::vector<SearchedPlace>& places : result.pieces) {
      std::sort(places.begin(), places.end(),
                [](const SearchedPlace& a, const SearchedPlace& b) { return a.at < b.at; });
    }
    return result;
  }

 private:
  struct Site {
    std::size_t piece;
    SearchedPlace place;
  };

  std::size_t evaluate(std::size_t piece, double at) {
    sites_.push_back({piece, {at, of_->at(piece, at)}});
    const FunctionValues& values = sites_.back().place.values;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const std::size_t group = of_->group_of(i);
      if (group >= largest_.size()) largest_.resize(group + 1, 0.0);
      largest_[group] = std::max(largest_[group], values[i]);
    }
    return sites_.size() - 1;
  }

  double excess_of(const Part& part) const {
    const std::vector<double> excesses = excesses_of(part);
    return *std::max_element(excesses.begin(), excesses.end());
  }

  void leave_open(const Part& part, std::vector<double>& left_open) const {
    const std::vector<double> excesses = excesses_of(part);
    left_open.resize(excesses.size(), 0.0);
    for (std::size_t g = 0; g < excesses.size(); ++g)
      left_open[g] = std::max(left_open[g], excesses[g]);
  }

  /// By group; 0 where no bound exceeds the largest found.
  std::vector<double> excesses_of(const Part& part) const {
    std::size_t functions = 0;
    for (const std::size_t i : part.places)
      functions = std::max(functions, sites_[i].place.values.size());
    std::vector<double> excesses(std::max<std::size_t>(1, largest_.size()), 0.0);
    for (std::size_t f = 0; f < functions; ++f) {
      const std::size_t group = of_->group_of(f);
      const double largest = largest_[group];
      if (largest <= 0.0) continue;
      Five v{};
      for (std::size_t j = 0; j < v.size(); ++j) {
        const FunctionValues& values = sites_[part.places[j]].place.values;
        if (f < values.size()) v[j] = values[f];
      }
      excesses[group] = std::max(excesses[group], bound_of(v) / largest - 1.0);
    }
    return excesses;
  }

  double place(const Part& part, std::size_t j) const { return sites_[part.places[j]].place.at; }

  /// Places are told apart to a millionth of their piece: there even a steep ridge is level.
  bool can_halve(const Part& part) const {
    const std::vector<double>& borders = of_->pieces[part.piece];
    constexpr double least = 1e-6;
    return place(part, 4) - place(part, 0) > least * (borders.back() - borders.front());
  }

  std::array<Part, 2> halves_of(const Part& part) {
    std::array<Part, 2> halves;
    for (std::size_t h = 0; h < 2; ++h) {
      Part& half = halves[h];
      half.piece = part.piece;
      for (std::size_t j = 0; j < 5; ++j) {
        const std::size_t known = 2 * h + j / 2;
        half.places[j] =
            j % 2 == 0 ? part.places[known]
                       : evaluate(part.piece, 0.5 * (place(part, known) + place(part, known + 1)));
      }
    }
    return halves;
  }

  const PieceSearch* of_;
  std::vector<double> largest_;
  std::vector<Site> sites_;
  std::vector<Part> parts_;
};

}  // namespace

PieceSearchResult largest_on_pieces(const PieceSearch& search) { return Search(search).run(); }

}  // namespace boxbeam
