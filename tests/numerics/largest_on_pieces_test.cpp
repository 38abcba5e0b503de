#include "boxbeam/numerics/largest_on_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "catch.hpp"

namespace largest_on_pieces_test {

using namespace boxbeam;

namespace {

/// One function on pieces, as its own group.
PieceSearchResult search(const std::vector<std::vector<double>>& pieces,
                         const std::function<double(std::size_t, double)>& f) {
  PieceSearch of;
  of.pieces = pieces;
  of.at = [&](std::size_t piece, double x) { return FunctionValues{f(piece, x)}; };
  of.group_of = [](std::size_t) { return std::size_t{0}; };
  return largest_on_pieces(of);
}

}  // namespace

TEST_CASE("a smooth hump is found to the tolerance with few evaluations") {
  // 2 + sin: largest 3 at pi/2, between the places of any halving.
  const auto found = search({{0.0, 3.0}}, [](std::size_t, double x) { return 2.0 + std::sin(x); });
  CHECK(found.largest[0] == Approx(3.0).epsilon(1e-4));
  for (const double open : found.left_open) CHECK(open <= 1e-4);
  CHECK(found.evaluations < 40);
}

TEST_CASE("a roof of any slopes is found wherever its ridge stands") {
  // Two straight lines that meet at x_0 with the value 1: the ridge is the largest.
  std::mt19937 random(1717);
  std::uniform_real_distribution<double> place(0.01, 0.99), exponent(-2.0, 0.5);
  for (int i = 0; i < 500; ++i) {
    const double ridge = place(random);
    const double rise = std::pow(10.0, exponent(random)), fall = std::pow(10.0, exponent(random));
    const auto found = search({{0.0, 1.0}}, [&](std::size_t, double x) {
      return std::max(0.0, x < ridge ? 1.0 - rise * (ridge - x) : 1.0 - fall * (x - ridge));
    });
    CAPTURE(ridge, rise, fall);
    CHECK(found.largest[0] >= 1.0 - 1.1e-4);
    for (const double open : found.left_open) CHECK(open <= 1e-4);
  }
}

TEST_CASE("the larger of many functions is searched, and functions below it are left alone") {
  // Ten waves of one group; the largest has its top 5 at 0.3.
  PieceSearch of;
  of.pieces = {{0.0, 1.0}, {1.0, 2.0}};
  of.at = [](std::size_t, double x) {
    FunctionValues values{5.0 - 20.0 * (x - 0.3) * (x - 0.3)};
    for (int k = 1; k < 10; ++k) values.push_back(1.0 + 0.2 * std::sin(10.0 * k * x));
    return values;
  };
  of.group_of = [](std::size_t) { return std::size_t{0}; };
  const PieceSearchResult found = largest_on_pieces(of);
  CHECK(found.largest[0] == Approx(5.0).epsilon(1e-4));
  CHECK(found.evaluations < 40);
}

TEST_CASE("each group has its own largest, and what is known elsewhere saves evaluations") {
  PieceSearch of;
  of.pieces = {{0.0, 4.0}};
  of.at = [](std::size_t, double x) {
    return FunctionValues{2.0 + std::sin(x), 0.01 * (2.0 + std::cos(x - 1.0))};
  };
  of.group_of = [](std::size_t f) { return f; };
  const PieceSearchResult found = largest_on_pieces(of);
  CHECK(found.largest[0] == Approx(3.0).epsilon(1e-4));
  CHECK(found.largest[1] == Approx(0.03).epsilon(1e-4));
  of.known = {10.0, 10.0};
  CHECK(largest_on_pieces(of).evaluations == 5);
}

TEST_CASE("values at the ends of pieces are limits from inside") {
  // A step at 1: 1 before it, 7 behind, falling.
  const auto found = search({{0.0, 1.0}, {1.0, 2.0}}, [](std::size_t piece, double x) {
    return piece == 0 ? 1.0 : 7.0 - (x - 1.0);
  });
  CHECK(found.largest[0] == 7.0);
}

TEST_CASE("a jump that nobody told of is found to a millionth of the piece") {
  // Up to 0.437 it rises to 1.437, behind it falls from 1: largest before the jump.
  const auto found =
      search({{0.0, 1.0}}, [](std::size_t, double x) { return x < 0.437 ? 1.0 + x : 1.437 - x; });
  CHECK(found.largest[0] == Approx(1.437).epsilon(1e-4));
}

}  // namespace largest_on_pieces_test
