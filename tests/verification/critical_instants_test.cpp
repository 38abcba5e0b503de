#include "boxbeam/verification/critical_instants.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "catch.hpp"
#include "support/shipped_cases.hpp"

namespace critical_instants_test {

using namespace boxbeam;

namespace {

bool is_moment(const CriticalInstant& instant) {
  return instant.quantity().starts_with("M") || instant.quantity() == "T";
}

std::vector<ShownInstant> shown_in(const test::ShippedCase& of) {
  return instants_to_show(of.project, of.verification.critical_instants, of.verification.motions);
}

}  // namespace

TEST_CASE("what is nothing beside the largest force is no extreme") {
  for (const test::ShippedCase& of : test::shipped_cases()) {
    CAPTURE(of.path);
    const double length = of.project.beam.length().value();
    double force = 0.0;
    for (const CriticalInstant& instant : of.verification.critical_instants) {
      if (instant.quantity() == "stress") continue;
      force = std::max(force, std::abs(instant.value) / (is_moment(instant) ? length : 1.0));
    }
    for (const CriticalInstant& instant : of.verification.critical_instants) {
      CAPTURE(instant.quantity(), instant.value);
      if (instant.quantity() == "stress") continue;
      CHECK(std::abs(instant.value) > 1e-6 * force * (is_moment(instant) ? length : 1.0));
    }
  }
}

TEST_CASE("a quantity has each of its extremes once") {
  for (const test::ShippedCase& of : test::shipped_cases()) {
    CAPTURE(of.path);
    std::set<std::pair<std::string, End>> known;
    for (const CriticalInstant& instant : of.verification.critical_instants) {
      CAPTURE(instant.quantity());
      CHECK(known.insert({instant.quantity(), instant.end}).second);
      for (const CriticalInstant& other : of.verification.critical_instants) {
        if (other.quantity() != instant.quantity() || other.end == instant.end) continue;
        const bool larger = instant.end == End::largest;
        CHECK((larger ? instant.value >= other.value : instant.value <= other.value));
      }
    }
  }
}

TEST_CASE("an instant is named by a quantity once, and its stress by the place it belongs to") {
  for (const test::ShippedCase& of : test::shipped_cases()) {
    CAPTURE(of.path);
    for (const ShownInstant& shown : shown_in(of)) {
      CAPTURE(shown.why);
      std::set<std::string> quantities;
      std::size_t from = 0;
      while (from < shown.why.size()) {
        const std::size_t end = std::min(shown.why.find(", ", from), shown.why.size());
        const std::string reason = shown.why.substr(from, end - from);
        from = end + 2;
        if (reason.find("stress") != std::string::npos) {
          CHECK(reason.find("stress at the governing place") != std::string::npos);
          CHECK(quantities.insert("stress").second);
          continue;
        }
        CHECK(quantities.insert(reason.substr(reason.rfind(' ') + 1)).second);
      }
    }
  }
}

TEST_CASE("where a quantity has both extremes at one instant, the larger one names it") {
  // The leg of the gear at t = 0.5 s: M_y is -0.19 kN m at its foot and -0.90 kN m at its hinge.
  const auto gear =
      std::find_if(test::shipped_cases().begin(), test::shipped_cases().end(),
                   [](const test::ShippedCase& of) { return of.path.ends_with("gear.toml"); });
  const std::vector<ShownInstant> shown = shown_in(*gear);
  CHECK(std::any_of(shown.begin(), shown.end(), [](const ShownInstant& of) {
    return of.why.find("most negative M_y") != std::string::npos;
  }));
  for (const ShownInstant& of : shown) {
    CHECK(of.why.find("least negative M_y") == std::string::npos);
  }
}

}  // namespace critical_instants_test
