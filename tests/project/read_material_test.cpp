#include "project/small_case.hpp"

namespace read_material_test {

using namespace boxbeam;

namespace {

/// The small case with other words instead of `part`.
std::string with(const std::string& part, const std::string& words) {
  std::string text = small_case::bodies + small_case::pivot + small_case::for_a_second;
  return text.replace(text.find(part), part.size(), words);
}

Material material_with(const std::string& fy_source) {
  return parse_project("small.toml", with("steel = \"S355\"\n", "steel = \"S355\"\n" + fy_source))
      .material;
}

/// Yield strength of a plate of 40 mm in MPa: 345 by EN 10025-2, 355 by EN 1993-1-1.
double yield_at_40_mm(const Material& material) {
  return yield_strength_of(material, 0.04 * metre).value().value() * 1e-6;
}

}  // namespace

TEST_CASE("[material] fy_source: one source's strengths, without it the lower ones") {
  const Material lower = material_with("");
  CHECK(yield_at_40_mm(lower) == Approx(345).epsilon(1e-12));
  CHECK(lower.source == "the lower of EN 10025-2, table 7, and EN 1993-1-1:2005, table 3.1");
  CHECK(tensile_strength_of(lower, 0.04 * metre) == si<Stress>(470e6));

  const Material product = material_with("fy_source = \"EN 10025-2\"\n");
  CHECK(yield_at_40_mm(product) == Approx(345).epsilon(1e-12));
  CHECK(product.source == "EN 10025-2, table 7");

  const Material design = material_with("fy_source = \"EN 1993-1-1\"\n");
  CHECK(yield_at_40_mm(design) == Approx(355).epsilon(1e-12));
  CHECK(tensile_strength_of(design, 0.04 * metre) == si<Stress>(490e6));
  CHECK(design.source == "EN 1993-1-1:2005, table 3.1");
}

TEST_CASE("[material] a plate of 100 mm is beyond EN 1993-1-1, not beyond both sources") {
  const std::string thick =
      with("diameter = \"100 mm\"\nwall = \"5 mm\"", "diameter = \"300 mm\"\nwall = \"100 mm\"");
  CHECK_NOTHROW(parse_project("small.toml", thick));
  std::string design = thick;
  const std::string steel = "steel = \"S355\"\n";
  design.insert(design.find(steel) + steel.size(), "fy_source = \"EN 1993-1-1\"\n");
  try {
    parse_project("small.toml", design);
    FAIL("a plate without yield strength was read");
  } catch (const InputError& error) {
    REQUIRE(error.problems().size() == 1);
    CHECK(error.problems().front().message.find("no yield strength for the plate of 100 mm") !=
          std::string::npos);
    CHECK(error.problems().front().hint.find("its table ends at 80 mm") != std::string::npos);
  }
}

}  // namespace read_material_test
