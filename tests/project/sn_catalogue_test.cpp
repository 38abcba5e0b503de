#include "boxbeam/project/sn_catalogue.hpp"

#include <algorithm>
#include <cmath>

#include "catch.hpp"

namespace sn_catalogue_test {

using namespace boxbeam;

namespace {

constexpr StressKind kinds[] = {StressKind::direct, StressKind::shear};

/// Every curve of the catalogue, with its family.
template <class Function>
void for_every_curve(Function&& function) {
  for (const std::string& family : families()) {
    for (const StressKind kind : kinds) {
      for (const std::string& name : names_of(family, kind)) {
        CAPTURE(family, name, kind == StressKind::shear);
        function(family, find_curve(family, name, kind).value());
      }
    }
  }
}

}  // namespace

TEST_CASE("every curve says its code, source and name, and has a sound shape", "[sn_catalogue]") {
  int curves = 0;
  for_every_curve([&](const std::string&, const SnCurve& curve) {
    ++curves;
    CHECK_FALSE(curve.code.empty());
    CHECK_FALSE(curve.source.empty());
    CHECK_FALSE(curve.name.empty());
    CHECK(curve.reference_cycles == 2e6);
    REQUIRE_FALSE(curve.branches.empty());
    CHECK(curve.reference_cycles <= curve.branches.front().until);
    for (std::size_t i = 1; i < curve.branches.size(); ++i) {
      CHECK(curve.branches[i].until > curve.branches[i - 1].until);
      CHECK(curve.branches[i].slope > curve.branches[i - 1].slope);
    }
    const double end = curve.branches.back().until;
    CHECK(curve.cut_off.has_value() == std::isfinite(end));
    if (curve.cut_off) CHECK(*curve.cut_off == end);
  });
  CHECK(curves > 50);
}

TEST_CASE("every curve is continuous at its knees and falls with life", "[sn_catalogue]") {
  for_every_curve([](const std::string&, const SnCurve& curve) {
    for (const SnBranch& branch : curve.branches) {
      if (std::isinf(branch.until)) continue;
      const Stress before = strength_at(curve, branch.until * (1 - 1e-9), Loading::spectrum);
      const Stress behind = strength_at(curve, branch.until * (1 + 1e-9), Loading::spectrum);
      CHECK(before / behind == Approx(1.0).epsilon(1e-8));
    }
    for (double cycles = 1e3; cycles < 1e10; cycles *= 1.9) {
      CHECK(strength_at(curve, 1.9 * cycles, Loading::spectrum) <=
            strength_at(curve, cycles, Loading::spectrum));
    }
  });
}

TEST_CASE("a curve of a category is named by its strength at 2e6 cycles", "[sn_catalogue]") {
  for (const char* family : {"EN 1993-1-9", "EN 1993-1-9 hot spot"}) {
    for (const StressKind kind : kinds) {
      for (const std::string& name : names_of(family, kind)) {
        if (name.ends_with("*")) continue;
        CHECK(find_curve(family, name, kind)->reference.value() * 1e-6 == std::stod(name));
      }
    }
  }
  for (const StressKind kind : kinds) {
    for (const std::string& name : names_of("IIW", kind)) {
      const SnCurve curve = find_curve("IIW", name, kind).value();
      CHECK(curve.reference.value() * 1e-6 == std::stod(name.substr(4)));
      CHECK(curve.unconfirmed);
    }
  }
}

TEST_CASE("names are unique in their family and kind", "[sn_catalogue]") {
  for (const std::string& family : families()) {
    for (const StressKind kind : kinds) {
      std::vector<std::string> names = names_of(family, kind);
      std::sort(names.begin(), names.end());
      CHECK(std::adjacent_find(names.begin(), names.end()) == names.end());
    }
  }
}

TEST_CASE("the curve of the same strength is never more than 0.5 % stronger and the best such",
          "[sn_catalogue]") {
  for (const std::string& family : families()) {
    for (const StressKind kind : kinds) {
      for (double strength = 20e6; strength < 200e6; strength *= 1.01) {
        const auto found = curve_of_same_strength(family, kind, si<Stress>(strength));
        if (found) CHECK(found->reference.value() <= 1.005 * strength);
        for (const std::string& name : names_of(family, kind)) {
          const Stress other = find_curve(family, name, kind)->reference;
          if (other.value() > 1.005 * strength) continue;
          REQUIRE(found);
          CHECK(other <= found->reference);
        }
      }
    }
  }
}

TEST_CASE("what is not in the catalogue is not found", "[sn_catalogue]") {
  CHECK_FALSE(find_curve("EN 1993-1-9", "95"));
  CHECK_FALSE(find_curve("EN 1993-1-9", "90", StressKind::shear));
  CHECK_FALSE(find_curve("EN 1993-1-8", "100"));
  CHECK(names_of("EN 1993-1-8").empty());
  CHECK_FALSE(curve_of_same_strength("EN 1993-1-9", StressKind::direct, si<Stress>(35e6)));
  CHECK_FALSE(curve_of_same_strength("EN 1993-1-9 hot spot", StressKind::shear, si<Stress>(1e9)));
}

}  // namespace sn_catalogue_test
