#include "boxbeam/numerics/exact_memo.hpp"

#include <cmath>
#include <limits>

#include "catch.hpp"

namespace exact_memo_test {

using namespace boxbeam;

TEST_CASE("a value is found once for the same bits of its arguments") {
  ExactMemo<2, double> memo;
  int found = 0;
  const auto of = [&](double x, double y) {
    return memo.of({x, y}, [&] {
      ++found;
      return std::copysign(1.0, x) / (1.0 + y);
    });
  };
  CHECK(of(0.0, 1.0) == 0.5);
  CHECK(of(0.0, 1.0) == 0.5);
  CHECK(found == 1);
  // Equal, yet not the same.
  CHECK(of(-0.0, 1.0) == -0.5);
  CHECK(found == 2);
  CHECK(of(0.0, std::nextafter(1.0, 2.0)) == 1.0 / (1.0 + std::nextafter(1.0, 2.0)));
  CHECK(of(1.0, 0.0) == 1.0);
  CHECK(found == 4);
  // Not equal to itself, yet the same.
  const double none = std::numeric_limits<double>::quiet_NaN();
  of(none, 0.0);
  of(none, 0.0);
  CHECK(found == 5);
}

TEST_CASE("what is forgotten is found again") {
  ExactMemo<1, double> memo;
  int found = 0;
  const auto square_of = [&](double x) {
    return memo.of({x}, [&] {
      ++found;
      return x * x;
    });
  };
  bool all = true;
  for (int round = 0; round < 2; ++round)
    for (int i = 0; i < 10'000; ++i) {
      const double x = i;
      all = all && square_of(x) == x * x;
    }
  CHECK(all);
  CHECK(found > 10'000);
}

}  // namespace exact_memo_test
