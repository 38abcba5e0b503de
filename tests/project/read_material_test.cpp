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

namespace {

/// What is said of the small case with other words instead of `part`, "" where it is read.
std::string refusal(const std::string& part, const std::string& words) {
  try {
    parse_project("small.toml", with(part, words));
  } catch (const InputError& error) {
    CHECK(error.problems().size() == 1);
    return error.problems().front().message + "; " + error.problems().front().hint;
  }
  return "";
}

}  // namespace

TEST_CASE(
    "[material] the modulus of a material of one's own is said where the density is no steel's") {
  const std::string own =
      "name = \"EN AW-6082\"\nfy = \"250 MPa\"\nfu = \"290 MPa\"\nup_to = \"50 mm\"\n"
      "source = \"EN 1999-1-1\"\n";
  const std::string beam = "density = \"7850 kg/m^3\"\n";
  const auto said = [&](const std::string& density, const std::string& more) {
    std::string text = with("steel = \"S355\"\n", own + more);
    text.replace(text.find(beam), beam.size(), "density = \"" + density + "\"\n");
    try {
      const Project project = parse_project("small.toml", text);
      return std::string();
    } catch (const InputError& error) {
      return error.problems().front().message + "; " + error.problems().front().hint;
    }
  };
  CHECK(said("7850 kg/m^3", "").empty());
  CHECK(said("8000 kg/m^3", "").empty());  // stainless
  CHECK(said("2700 kg/m^3", "")
            .find("2700 kg/m^3, is not that of steel, and Young's modulus of "
                  "EN AW-6082 is not said; write youngs_modulus") != std::string::npos);
  CHECK_FALSE(said("8900 kg/m^3", "").empty());
  CHECK(said("2700 kg/m^3", "youngs_modulus = \"70 GPa\"\n").empty());
  CHECK(said("1e-3 kg/m^3", "[model]\nyoungs_modulus = \"210 GPa\"\n").empty());
}

TEST_CASE("[[part_materials]] that name no plate or no segment are refused") {
  const std::string end = "[strength]\n";
  const std::string part = "[[part_materials]]\nsteel = \"S235\"\n";
  CHECK(refusal(end, part + "plates = [\"walls\"]\n" + end).empty());
  CHECK(refusal(end, part + "plates = []\n" + end).find("no plate is of this material") == 0);
  CHECK(refusal(end, part + "segments = []\n" + end).find("no segment is of this material") == 0);
}

}  // namespace read_material_test
