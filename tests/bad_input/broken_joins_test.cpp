// What joins the beam and stands beside it, and how loads combine, with one mistake each.

#include "bad_input/broken_case.hpp"

namespace broken_joins_test {

using namespace bad_input;

namespace {

/// Where the mistake is, in each of the texts below.
const std::string here = "#here";

const std::string tube =
    "\n[sections.stay]\nkind = \"round tube\"\ndiameter = \"114.3 mm\"\nwall = \"10 mm\"\n";
const std::string pin =
    "\n[[pins]] #pins\nname = \"hub\"\njoint = \"O\"\ndiameter = \"80 mm\"\nhole = \"81 mm\"\n"
    "inner_plate = \"60 mm\"\nouter_plate = \"31 mm\"\n";
const std::string lug = pin + "[[pins.lugs]]\nplate = \"inner\"\nwidth = \"200 mm\"\n";
const std::string rod = tube +
                        "[[rods]] #rods\nname = \"upper\"\nfrom = \"upper_rod.B\"\n"
                        "to = \"upper_rod.A\"\nsection = \"stay\"\ncurve = \"a\"\n";
const std::string weld = tube +
                         "[[welds]] #welds\nname = \"w\"\nstation = \"0.511 m\"\n"
                         "around = \"stay\"\nthroat = \"5 mm\"\n";

std::string changed(std::string text, const std::string& part, const std::string& other) {
  INFO("replaced: " << part);
  REQUIRE(count_of(part, text) == 1);
  return text.replace(text.find(part), part.size(), other + " " + here);
}

/// The rig with lines behind it, one of them another one.
BrokenCase with(const std::string& lines, const std::string& part, const std::string& other,
                std::vector<std::string> said, const std::string& at = here) {
  return appended(other, changed(lines, part, other), at, std::move(said));
}

/// The rig with lines behind it, the last one wrong.
BrokenCase ending(const std::string& lines, const std::string& wrong,
                  std::vector<std::string> said) {
  return appended(wrong, lines + wrong + " " + here + "\n", here, std::move(said));
}

/// The jib of the template, one of its lines another one.
BrokenCase jib_with(const std::string& part, const std::string& other,
                    std::vector<std::string> said, const std::string& at = here) {
  const std::string text =
      changed(test::read_file(test::project_file("sections/templates/static.toml")), part, other);
  return {other, text, line_of(at, text), std::move(said)};
}

}  // namespace

TEST_CASE("pins and lugs that cannot be are refused", "[bad_input]") {
  check_refused({
      with(pin, "diameter = \"80 mm\"", "diameter = 80", {"is a length, not a bare number"}),
      with(pin, "hole = \"81 mm\"", "hole = \"79 mm\"", {"does not fit its hole"}),
      with(pin, "joint = \"O\"", "joint = \"OO\"", {"there is no joint \"OO\"", "did you mean"}),
      // What bears a moment as well, or turns by a couple, is no pin.
      with(pin, "joint = \"O\"", "joint = \"rail\"", {"\"rail\" does not turn about a pin"}),
      with(pin, "joint = \"O\"", "joint = \"exciter\"", {"\"exciter\" does not turn about a pin"}),
      with(pin, "hole = \"81 mm\"", "bore = \"81 mm\"", {"unknown key \"bore\""}),
      ending(pin, "required = 0", {"must be above zero"}),
      ending(pin, "steel = \"S355J2\"", {"no steel \"S355J2\"", "did you mean \"S355\"?"}),
      with(lug, "width = \"200 mm\"", "width = \"100 mm\"", {"bears nothing", "table 3.9"}),
      with(lug, "plate = \"inner\"", "plate = \"both\"", {"one of \"inner\", \"outer\""}),
      ending(lug + "[[pins.lugs]]\nwidth = \"210 mm\"\n", "plate = \"inner\"",
             {"is there already", "once each"}),
      ending(lug + "category = 80\n", "kind = \"shear\"", {"for direct stress"}),
      ending(pin + "[[pins]]\njoint = \"O\"\ndiameter = \"70 mm\"\ninner_plate = \"61 mm\"\n"
                   "outer_plate = \"32 mm\"\n",
             "name = \"hub\"", {"is there already"}),
  });
}

TEST_CASE("rods that cannot be are refused", "[bad_input]") {
  check_refused({
      with(rod, "section = \"stay\"", "section = \"stave\"",
           {"there is no section \"stave\"", "known: "}),
      with(rod, "curve = \"a\"", "curve = \"e\"", {"\"a0\", \"a\", \"b\", \"c\", \"d\""}),
      with(rod, "from = \"upper_rod.B\"", "", {"has no \"from\""}, "#rods"),
      with(rod, "to = \"upper_rod.A\"", "to = \"blade.A\"", {"of the same body"}),
      with(rod, "from = \"upper_rod.B\"\nto = \"upper_rod.A\"", "link = \"stai\"",
           {"no joint of kind \"distance\", driven length or spring is \"stai\""}),
      ending(rod, "buckling_length = 6", {"is a length, not a bare number"}),
      ending(rod, "buckling_length = \"6 kN\"", {"is a length, but \"6 kN\" is a force"}),
      ending(rod, "net_area = \"1 m^2\"", {"larger than the whole section"}),
  });
}

TEST_CASE("welds that cannot be are refused", "[bad_input]") {
  check_refused({
      with(weld, "throat = \"5 mm\"", "throat = 5", {"is a length, not a bare number"}),
      with(weld, "throat = \"5 mm\"", "", {"the weld has no throat"}, "#welds"),
      with(weld, "station = \"0.511 m\"", "station = \"9 m\"", {"behind the end of the beam"}),
      with(weld, "around = \"stay\"", "around = \"stave\"",
           {"there is no section \"stave\"", "known: "}),
      ending(weld, "penetration = \"10 mm\"", {"penetrates through the wall"}),
      ending(weld, "penetration = \"partial\"", {"does not begin with a number"}),
  });
}

TEST_CASE("combinations that cannot be are refused", "[bad_input]") {
  const std::string rule = "rule = \"6.10\"                   # or: 6.10a/b; none";
  const auto set = [&](const std::string& factors) {
    return "rule = \"none\"\n[[combinations.sets]]\nname = \"storm\"\nfactors = { lift = " +
           factors + " }";
  };
  check_refused({
      jib_with(rule, "rule = \"6.10c\"", {"did you mean \"6.10\"?"}),
      jib_with(rule, "rule = \"6.10\"\ngamma_Q = 0", {"must be above zero"}),
      jib_with(rule, "rule = \"6.10\"\nxi = 0.9", {"unknown key \"xi\""}),
      // A text in a list of numbers is no number that may be passed over.
      jib_with(rule, set("[0.0, \"1.5\"]"), {"one factor, or the least and the largest"}),
      jib_with(rule, set("[[0.0, 1.5]]"), {"one factor, or the least and the largest"}),
      jib_with(rule, set("\"1.5\""), {"one factor, or the least and the largest"}),
      jib_with(rule, set("[0.0, 1.0, 1.5]"), {"one factor, or the least and the largest"}),
      jib_with(rule, set("1.5, wind = 1.0"), {"there is no load case \"wind\""}),
      jib_with("psi_0 = 1.0", "", {"has no \"psi_0\""}, "[load_cases.lift]"),
      jib_with("psi_0 = 1.0", "psi_0 = 1.2", {"psi_0 is from 0 to 1"}),
      jib_with("[load_cases.lift]", "[load_cases.lifts]", {"no load is in a case \"lifts\""}),
      jib_with("between = [\"empty\", \"lifting\"]", "between = [\"empty\", \"empty\"]",
               {"\"empty\" stands there already", "each once"}),
  });
}

}  // namespace broken_joins_test
