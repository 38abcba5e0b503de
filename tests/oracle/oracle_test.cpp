#include "oracle.hpp"

#include <filesystem>

#include "catch.hpp"
#include "comparison.hpp"

namespace oracle_test {

namespace {

namespace fs = std::filesystem;

/// A folder that is gone afterwards.
struct Scratch {
  fs::path path = fs::temp_directory_path() / "boxbeam-oracle-test";
  ~Scratch() { fs::remove_all(path); }
};

}  // namespace

TEST_CASE("a random case is the same for the same number and another for another", "[oracle]") {
  CHECK(oracle::random_case(7).text == oracle::random_case(7).text);
  CHECK(oracle::random_case(7).text != oracle::random_case(8).text);
}

TEST_CASE("the oracle would notice a side dropped, a detail's end ignored and a grid of 24",
          "[oracle][unsanitized]") {
  const Scratch scratch;
  constexpr int cases = 40;
  std::array<int, oracle::faults.size()> shown{};
  int compared = 0;
  for (int i = 1; i <= cases; ++i) {
    const oracle::Outcome outcome = oracle::examine(
        oracle::random_case(static_cast<std::uint64_t>(i)), scratch.path.string(), {80, 24, 80});
    INFO("case " << i << ": " << outcome.why);
    CHECK(outcome.kind != oracle::Outcome::Kind::refused);
    if (outcome.kind == oracle::Outcome::Kind::compared) ++compared;
    for (std::size_t k = 0; k < shown.size(); ++k) shown[k] += outcome.shown[k] ? 1 : 0;
  }
  CHECK(compared >= 36);
  CHECK(shown[0] >= cases / 4);
  CHECK(shown[1] >= cases / 20);
  CHECK(shown[2] >= cases / 4);
}

}  // namespace oracle_test
