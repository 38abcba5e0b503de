#include "bad_input/broken_case.hpp"
#include "catch.hpp"

namespace broken_mechanism_test {

using namespace bad_input;

namespace {

/// The rig with a joint, driver or force behind it that has a mistake in the line of `at`.
BrokenCase with(const std::string& name, const std::string& lines, const std::string& at,
                std::vector<std::string> said) {
  return appended(name, "\n" + lines, at, std::move(said));
}

}  // namespace

TEST_CASE("joints that cannot be are refused", "[bad_input]") {
  const auto joint = [](const std::string& name, const std::string& lines, const std::string& at,
                        std::vector<std::string> said) {
    return with(name, "[joints.new]\n" + lines, at, std::move(said));
  };
  const std::string slider = "kind = \"slider\"\ndirection = \"0 deg\"\n";
  const std::string gear = "kind = \"gear\"\nconnect = [\"beam.O\", \"upper_rod.A\"]\n";
  const std::string rack =
      "kind = \"rack\"\npinion = \"beam.O\"\ndirection = \"0 deg\"\nat = [\"0 m\", \"0 m\"]\n";
  check_refused({
      joint("slider without line", slider + "point = \"sledge.E\"\n", "[joints.new]",
            {"a slider wants either \"through\" or \"guide\"", "through = [x, y]"}),
      joint("slider on two lines",
            slider + "point = \"sledge.E\"\nguide = \"beam.C\"\nthrough = [\"0 m\", \"0 m\"]\n",
            "[joints.new]", {"a slider wants either \"through\" or \"guide\"", "on a body"}),
      joint("guide of the ground", slider + "point = \"sledge.E\"\nguide = \"ground\"\n",
            "guide = \"ground\"",
            {"a line on the ground is given by a point", "write through = [x, y] instead"}),
      joint("slider on its own body", slider + "point = \"beam.B\"\nguide = \"beam.C\"\n",
            "point = \"beam.B\"", {"a slider connects two different bodies", "guide = "}),
      joint("slider of the ground on the ground",
            slider + "point = \"ground\"\nat = [\"0 m\", \"0 m\"]\nthrough = [\"0 m\", \"0 m\"]\n",
            "point = \"ground\"", {"a slider connects two different bodies", "guide = "}),
      replaced("friction beyond any", "point = \"sledge.E\"",
               "point = \"sledge.E\"\nfriction = { coefficient = 3 }",
               {"a coefficient of friction, from 0 to 2", "coefficient = 0.1"}, "coefficient = 3"),
      replaced("friction below zero", "point = \"sledge.E\"",
               "point = \"sledge.E\"\nfriction = { viscous = \"-1 N s/m\" }",
               {"\"viscous\" must not be below zero", "500 N s/m"}, "viscous = "),
      replaced("friction in another unit", "point = \"sledge.E\"",
               "point = \"sledge.E\"\nfriction = { viscous = \"1 N\" }",
               {"a force per velocity, but \"1 N\" is a force", "500 N s/m"}, "viscous = "),
      joint("pin of three", "kind = \"pin\"\nconnect = [\"beam.B\", \"sledge.E\", \"blade.A\"]\n",
            "\"sledge.E\", \"blade.A\"]", {"a pin connects two points", "write connect = "}),
      joint("rigid joint of the ground",
            "kind = \"rigid\"\nconnect = [\"ground\", \"ground\"]\nat = [\"0 m\", \"0 m\"]\n",
            "connect = [\"ground\", \"ground\"]",
            {"a rigid joint connects two different bodies", "write connect = "}),
      joint("distance of nothing",
            "kind = \"distance\"\nconnect = [\"beam.B\", \"sledge.E\"]\nlength = \"0 m\"\n",
            "length = \"0 m\"", {"\"length\" must be above zero", "0.25 m"}),
      joint("coupling of ratio zero",
            "kind = \"angle coupling\"\npoints = [\"beam.O\", \"sledge.E\"]\nratio = 0\n",
            "ratio = 0", {"\"ratio\" must not be zero", "ratio = -0.5"}),
      joint("gear of one wheel", gear + "radii = [\"0.1 m\"]\n",
            "radii = ", {"a gear has two radii", "an annulus below zero"}),
      joint("gear of no radius", gear + "radii = [\"0.1 m\", \"0 m\"]\n",
            "radii = ", {"a wheel's radius must not be zero", "write radii = "}),
      joint("gear in itself", gear + "radii = [\"0.1 m\", \"-100 mm\"]\n",
            "radii = ", {"wheel and annulus of one size", "the distance of the centres"}),
      joint("rack of no radius", rack + "rack = \"ground\"\nradius = \"0 m\"\n", "radius = \"0 m\"",
            {"\"radius\" must not be zero", "0.25 m"}),
      with("rack on its own wheel",
           "[joints.new]\nkind = \"rack\"\npinion = \"beam.O\"\nrack = \"beam.B\"\n"
           "direction = \"0 deg\"\nradius = \"0.1 m\"\n",
           "rack = \"beam.B\"", {"a rack connects two different bodies", "write pinion = "}),
  });
}

TEST_CASE("drivers that cannot be are refused", "[bad_input]") {
  const auto driver = [](const std::string& name, const std::string& lines, const std::string& at,
                         std::vector<std::string> said) {
    return with(name, "[drivers.new]\n" + lines, at, std::move(said));
  };
  const std::string y = "point = \"beam.B\"\ncoordinate = \"y\"\n";
  const std::string rate = "kind = \"constant rate\"\nstart = \"0 deg\"\nrate = \"6 rpm\"\n";
  const std::string step = "kind = \"smooth step\"\nfrom = \"0 m\"\nbegin = \"1 s\"\n" + y;
  check_refused({
      driver("unknown kind", "kind = \"harmonix\"\n" + y, "harmonix",
             {"\"kind\" cannot be \"harmonix\"", "did you mean \"harmonic\"?", "\"smooth step\""}),
      driver("unknown coordinate", "kind = \"table\"\npoint = \"beam.B\"\ncoordinate = \"z\"\n",
             "coordinate = \"z\"", {"\"coordinate\" cannot be \"z\"", "\"relative angle\""}),
      driver("relative to the ground",
             rate + "coordinate = \"relative angle\"\npoints = [\"beam.O\", \"ground\"]\n",
             "points = [\"beam.O\", \"ground\"]",
             {"an angle against the ground is no relative angle", "coordinate = \"angle\""}),
      driver("length of one body",
             "kind = \"constant rate\"\nstart = \"1 m\"\nrate = \"1 m/s\"\ncoordinate = "
             "\"length\"\npoints = [\"beam.O\", \"beam.B\"]\n",
             "points = [\"beam.O\", \"beam.B\"]",
             {"a driven length connects two different bodies", "write points = "}),
      driver("harmonics without amplitude",
             "kind = \"harmonic\"\nmean = \"0 m\"\namplitude = \"0 mm\"\nfrequency = \"1 Hz\"\n"
             "further = [{ amplitude = \"0 m\", frequency = \"2 Hz\" }]\n" +
                 y,
             "amplitude = \"0 mm\"", {"the driver does not move", "an amplitude other than zero"}),
      driver("no rate", "kind = \"constant rate\"\nstart = \"0 m\"\nrate = \"0 m/s\"\n" + y,
             "rate = \"0 m/s\"", {"\"rate\" must not be zero", "1 m/s"}),
      driver("rate of another dimension",
             "kind = \"constant rate\"\nstart = \"0 m\"\nrate = \"6 rpm\"\n" + y,
             "rate = \"6 rpm\"",
             {"\"rate\" is a length per s, but \"6 rpm\" is an angular frequency", "1 m/s"}),
      driver("turn in Hz",
             "kind = \"constant rate\"\nstart = \"0 deg\"\nrate = \"2 Hz\"\n"
             "point = \"beam.O\"\ncoordinate = \"angle\"\n",
             "rate = \"2 Hz\"", {"an angle per s, but \"2 Hz\" is a frequency", "6 rpm"}),
      driver("coefficient of another power",
             "kind = \"polynomial\"\ncoefficients = [\"0 m\", \"1 m/s\", \"1 m/s\"]\n" + y,
             "coefficients", {"value 3, is a length per s^2, but \"1 m/s\" is", "1 m/s^2"}),
      driver("constant polynomial", "kind = \"polynomial\"\ncoefficients = [\"1 m\"]\n" + y,
             "coefficients", {"the driver does not move", "\"1 m/s\""}),
      driver("nine coefficients",
             "kind = \"polynomial\"\ncoefficients = [\"\", \"\", \"\", \"\", \"\", \"\", \"\", "
             "\"\", \"\"]\n" +
                 y,
             "coefficients", {"\"coefficients\" takes at most 8 values", "take away 1"}),
      driver("step backwards in time", step + "to = \"1 m\"\nend = \"0.5 s\"\n", "end = \"0.5 s\"",
             {"the step must end after it begins", "a time behind 1 s"}),
      driver("step to where it is", step + "to = \"0 m\"\nend = \"2 s\"\n", "to = \"0 m\"\nend",
             {"the driver does not move", "another value than \"from\""}),
      driver("table without file", "kind = \"table\"\n" + y, "[drivers.new]",
             {"[drivers.new] has no \"file\"", "write file = "}),
      driver("table that is not there", "kind = \"table\"\nfile = \"none.csv\"\n" + y,
             "file = \"none.csv\"",
             {"none.csv: there is no such file", "from the folder of the case file"}),
      driver("table that is a folder", "kind = \"table\"\nfile = \"/\"\n" + y, "file = \"/\"",
             {"/: this is a folder", "give the path of a table"}),
  });
}

TEST_CASE("a broken table is named by its file and line", "[bad_input]") {
  const test::TemporaryFolder folder;
  const std::string file = folder.write("stroke.csv", "time [s], y [mm]\n0, 1\n1, 2 mm\n2, 1\n");
  const std::string driver =
      "[drivers.new]\nkind = \"table\"\nfile = \"stroke.csv\"\npoint = \"beam.B\"\n"
      "coordinate = \"y\"\n";
  const std::string err = refused(folder.write("case.toml", rig() + driver),
                                  {file + ":3:4: error: \"2 mm\" is not a number",
                                   "    1, 2 mm\n       ^\n", "hint: write numbers without unit"});
  CHECK(count_of(": error: ", err) == 1);
}

TEST_CASE("forces that cannot be are refused", "[bad_input]") {
  const auto force = [](const std::string& name, const std::string& lines, const std::string& at,
                        std::vector<std::string> said) {
    return with(name, "[forces.new]\n" + lines, at, std::move(said));
  };
  const std::string push = "kind = \"force\"\npoint = \"beam.B\"\ndirection = \"0 deg\"\n";
  check_refused({
      force("unknown kind", "kind = \"sprnig\"\n", "sprnig",
            {"\"kind\" cannot be \"sprnig\"", "did you mean \"spring\"?"}),
      force("spring of nothing",
            "kind = \"spring\"\nconnect = [\"beam.B\", \"sledge.E\"]\nstiffness = \"0 N/m\"\n",
            "stiffness = \"0 N/m\"", {"neither stiffness nor damping", "200 kN/m"}),
      force("spring of one body",
            "kind = \"spring\"\nconnect = [\"beam.B\", \"beam.O\"]\nstiffness = \"1 N/m\"\n",
            "connect = [\"beam.B\", \"beam.O\"]",
            {"a spring connects two different bodies", "write connect = "}),
      force("spring below zero",
            "kind = \"spring\"\nconnect = [\"beam.B\", \"sledge.E\"]\nstiffness = \"-1 N/m\"\n",
            "stiffness = \"-1 N/m\"", {"\"stiffness\" must not be below zero", "200 kN/m"}),
      force("torsion spring in N/m",
            "kind = \"torsion spring\"\npoints = [\"beam.O\", \"ground\"]\nstiffness = \"1 N/m\"\n",
            "stiffness = \"1 N/m\"",
            {"a moment per angle, but \"1 N/m\" is a force per length", "5 kN m/rad"}),
      force("force of no size", push, "[forces.new]",
            {"[forces.new] wants either \"size\" or \"law\"", "size = \"10 kN\" for a constant"}),
      force("force of two sizes", push + "size = \"1 N\"\nlaw = {}\n", "[forces.new]",
            {"[forces.new] wants either \"size\" or \"law\""}),
      force("force without kind of law", push + "law = {}\n", "law = {}",
            {"[forces.new.law] has no \"kind\"", "write kind = \"harmonic\""}),
      force(
          "law that stands still",
          push + "law = { kind = \"smooth step\", from = \"1 N\", to = \"1 N\", end = \"1 s\" }\n",
          "law = ", {"the force does not change", "another value than \"from\""}),
      force("force on the ground",
            "kind = \"force\"\npoint = \"ground\"\ndirection = \"0 deg\"\nsize = \"1 N\"\n",
            "point = \"ground\"", {"\"ground\" is not a point of a body", "write \"body.point\""}),
      force("couple on three",
            "kind = \"couple\"\nsize = \"1 N m\"\npoints = [\"beam.B\", \"sledge.E\", "
            "\"blade.A\"]\n",
            "points = [\"beam.B\", \"sledge.E\"", {"a couple connects two points", "write points"}),
      force("couple in N", "kind = \"couple\"\npoints = [\"beam.B\"]\nsize = \"5 N\"\n",
            "size = \"5 N\"", {"\"size\" is a moment, but \"5 N\" is a force", "12 kN m"}),
      with("name of a driver",
           "[forces.exciter]\nkind = \"couple\"\npoints = [\"beam.B\"]\nsize = \"1 N m\"\n",
           "[forces.exciter]",
           {"\"exciter\" is already the name of a driver", "give the force another name"}),
      with("driver with the name of a joint",
           "[drivers.rail]\nkind = \"constant rate\"\nstart = \"0 m\"\nrate = \"1 m/s\"\n"
           "point = \"beam.B\"\ncoordinate = \"y\"\n",
           "[drivers.rail]",
           {"\"rail\" is already the name of a joint", "give the driver another name"}),
  });
}

TEST_CASE("a velocity at the start is one", "[bad_input]") {
  const std::string sketch = "sketch = { at = [\"0.5 m\", \"3 m\"], angle = \"0 deg\" }";
  check_refused({
      replaced("velocity in m", sketch,
               "sketch = { at = [\"0.5 m\", \"3 m\"], velocity = [\"1 m\", \"0 m/s\"] }",
               {"\"velocity\" x is a velocity, but \"1 m\" is a length", "10 mm/s"}),
      replaced("turning in Hz", sketch,
               "sketch = { at = [\"0.5 m\", \"3 m\"], angular_velocity = \"1 Hz\" }",
               {"an angular velocity, but \"1 Hz\" is a frequency", "6 rpm"}),
  });
}

TEST_CASE("a motion of unknown length is refused with both remedies", "[bad_input]") {
  const std::string beam_angle = "point = \"beam.O\"\ncoordinate = \"angle\"\n";
  check_refused({
      with("no common period",
           "[drivers.second]\nkind = \"harmonic\"\nmean = \"0 deg\"\namplitude = \"1 deg\"\n"
           "frequency = \"0.71234 Hz\"\n" +
               beam_angle,
           "[drivers.exciter]",
           {"the drivers and forces have no common period",
            "a whole number of cycles takes the same time", "[motion] with duration = \"10 s\""}),
      with("force that goes on growing",
           "[forces.push]\nkind = \"force\"\npoint = \"beam.B\"\ndirection = \"0 deg\"\n"
           "law = { kind = \"constant rate\", start = \"0 N\", rate = \"1 N/s\" }\n",
           "[forces.push]",
           {"\"push\" neither repeats nor ends", "harmonic, smooth step, table",
            "[motion] with duration"}),
      with("motion without duration", "[motion]\nsettle = \"1 s\"\n", "[motion]",
           {"[motion] has no \"duration\"", "write duration = "}),
      with("no time", "[motion]\nduration = \"0 s\"\n", "duration = \"0 s\"",
           {"\"duration\" must be above zero"}),
      with("time before", "[motion]\nduration = \"1 s\"\nsettle = \"-1 s\"\n", "settle = \"-1 s\"",
           {"\"settle\" must not be below zero"}),
  });
}

}  // namespace broken_mechanism_test
