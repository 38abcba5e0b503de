// Mechanisms in space that cannot be, as a case writes them: what is said, and what to write.

#include <string>

#include "project/small_chain.hpp"

namespace broken_chain_test {

using namespace boxbeam;
using namespace small_chain;

TEST_CASE("what is wrong in a case in space is said with what to write", "[bad_input]") {
  struct Wrong {
    std::string lines, said, hint;
  };
  const std::string all = hinge + weld + swing, meshed = two_wheels + swing + teeth;
  const Wrong wrongs[] = {
      {hinge + swing, "no joint carries body \"load\"", "connect"},
      {all + "[joints.again]\nkind = \"fixed\"\nconnect = [\"ground\", "
             "\"load.D\"]\n",
       "carried twice, by \"weld\" and by \"again\"", "closes = true"},
      {"[joints.hinge]\nkind = \"fixed\"\nconnect = [\"load.C\", \"arm.A\"]\n" + weld,
       "is carried by what it carries itself", "the tree begins at the ground"},
      {hinge + weld, "nothing drives joint \"hinge\"", "kind = \"hold\""},
      {hinge + "friction = { coefficient = 0.1 }\n" + weld + swing,
       "friction in a revolute joint is not computed", "what slides along an axis"},
      {all + "[joints.loose]\nkind = \"revolute\"\nconnect = [\"ground\", \"arm.B\"]\n"
             "axis = \"x\"\ncloses = true\nclearance = \"0.2 mm\"\n",
       "clearance of a revolute joint is not computed", "a ball in a wider socket"},
      {all + "[joints.loose]\nkind = \"spherical\"\nconnect = [\"ground\", \"arm.B\"]\n"
             "closes = true\nclearance = \"0.2 mm\"\nrestitution = 0.8\n",
       "wants the stiffness of its contact", "Johnson"},
      {all + "[joints.slot]\nkind = \"slot\"\nconnect = [\"ground\", \"arm.B\"]\naxis = \"x\"\n"
             "friction = { coefficient = 0.1, guide_length = \"0.1 m\" }\n",
       "a slot carries no couple", "leave out guide_length"},
      {heel("prismatic") +
           "axis = \"y\"\n"
           "friction = { coefficient = 3.0 }\n[drivers.a]\njoint = \"hinge\"\nkind = "
           "\"hold\"\nvalue "
           "= "
           "\"0 m\"\n" +
           weld,
       "a coefficient of friction, from 0 to 2", "coefficient = 0.1"},
      {hinge + "moved_by = \"forces\"\n" + weld + swing, "forces move joint \"hinge\"",
       "or the driver"},
      {hinge + "moved_by = \"forces\"\n" + weld, "how long is not known", "duration"},
      {hinge + "start_rate = \"1 rad/s\"\n" + weld + swing, "rates at the start",
       "moved_by = \"forces\""},
      {hinge + weld + "[drivers.swing]\njoint = \"hing\"\nkind = \"hold\"\nvalue = \"0 deg\"\n",
       "there is no joint \"hing\"", "did you mean \"hinge\"?"},
      {all + "[drivers.twice]\njoint = \"hinge\"\nkind = \"hold\"\nvalue = \"0 deg\"\n",
       "has a driver already", "one driver"},
      {all + "[drivers.weld]\njoint = \"weld\"\nkind = \"hold\"\nvalue = \"0 deg\"\n",
       "is fixed and cannot move", "one driver"},
      {all + "[forces.bar]\nkind = \"torsion spring\"\njoint = \"weld\"\nstiffness = \"1 N "
             "m/rad\"\n",
       "there is no revolute joint \"weld\"", "hinge"},
      {all + "[forces.bar]\nkind = \"torsion spring\"\njoint = \"hinge\"\nstiffness = \"0 N "
             "m/rad\"\n",
       "neither stiffness nor damping", "kN m/rad"},
      {all + "[joints.rod]\nkind = \"distance\"\nconnect = [\"ground\", \"load.D\"]\n",
       "the length of \"rod\" is not known", "length ="},
      {all + "[joints.rod]\nkind = \"distance\"\nconnect = [\"ground\", \"load.D\"]\n"
             "length = \"1 m\"\n[drivers.rod]\njoint = \"rod\"\nkind = \"hold\"\n"
             "value = \"1 m\"\n",
       "the length of \"rod\" is said twice", "a cylinder a driver"},
      {all + "[joints.ball]\nkind = \"spherical\"\nconnect = [\"ground\", \"load.D\"]\n"
             "closes = true\n[drivers.ball]\njoint = \"ball\"\nkind = \"hold\"\n"
             "value = \"1 m\"\n",
       "closes a loop and follows it", "the length of a distance"},
      {all + "[joints.hook]\nkind = \"universal\"\nconnect = [\"ground\", \"load.D\"]\n"
             "closes = true\naxis = \"x\"\nsecond_axis = [1, 1, 0]\n",
       "stand square", "second_axis = \"z\""},
      {heel("screw") +
           "axis = \"x\"\n"
           "lead = \"0 mm\"\n" +
           weld,
       "\"lead\"", "0.25 m"},
      {meshed + "joints = [\"hinge\", \"whel\"]\nratio = -0.5\n",
       "there is no joint \"whel\" that carries a body", "did you mean \"wheel\"?"},
      {meshed + "joints = [\"hinge\"]\nratio = -0.5\n", "has two wheels", "joints = ["},
      {meshed + "joints = [\"hinge\", \"hinge\"]\nratio = -0.5\n", "cannot mesh with itself",
       "the two wheels"},
      {meshed + "joints = [\"hinge\", \"weld\"]\nratio = -0.5\n", "\"weld\" is of kind \"fixed\"",
       "revolute joints"},
      {two_wheels + sledge + swing + teeth + "joints = [\"hinge\", \"sledge\"]\nratio = -0.5\n",
       "\"sledge\" is of kind \"prismatic\"", "kind = \"rack\""},
      {meshed + "joints = [\"hinge\", \"wheel\"]\nratio = 0\n", "must not be zero", "-0.5"},
      {meshed + "joints = [\"hinge\", \"wheel\"]\nratio = 1\n", "both wheels turn alike",
       "negative"},
      {meshed + "joints = [\"hinge\", \"wheel\"]\nratio = -0.5\npressure_angle = \"80 deg\"\n",
       "from 0 to 45 deg", "20 deg"},
      {meshed + "joints = [\"hinge\", \"wheel\"]\nratio = -0.5\nmesh = \"load.D\"\n",
       "does not stand still beside both axes", "the ground"},
      {meshed + "joints = [\"hinge\", \"wheel\"]\nratio = -0.5\nmesh = \"ground\"\n"
                "at = [\"0.2 m\", \"0 m\", \"0 m\"]\n",
       "0.1 m beside the line", "goes through (0.1, 0, 0) m along (0, 1, 0) of the ground"},
      {meshed + "joints = [\"hinge\", \"wheel\"]\nratio = -0.5\n"
                "[drivers.teeth]\njoint = \"teeth\"\nkind = \"hold\"\n"
                "value = \"0 deg\"\n",
       "closes a loop and follows it", "one driver"},
      {heel("revolute") + "axis = \"w\"\n" + weld, "\"axis\" cannot be \"w\"", "three numbers"},
      {heel("revolute") +
           "axis = [0, 0, "
           "0]\n" +
           weld,
       "is no direction", "three numbers"},
      {heel("fixed") +
           "turn = [\"10 "
           "deg\"]\n" +
           weld,
       "wants turns about axes", "[[\"x\", \"10 deg\"]"},
      {heel("pin") + "" + weld, "\"kind\" cannot be \"pin\"", "revolute"},
      {"[joints.hinge]\nkind = \"fixed\"\nconnect = [\"arm.A\", \"ground\"]\n" + weld,
       "carries the second one's body", "the carrying body first"},
      {all + "[forces.f]\nkind = \"force\"\npoint = \"arm.B\"\ndirection = \"z\"\n",
       "wants either \"size\" or \"law\"", "size ="},
      {all + "[forces.f]\nkind = \"force\"\npoint = \"arm.X\"\ndirection = \"z\"\nsize = \"1 N\"\n",
       "has no point \"X\"", "did you mean"},
      {all + "[forces.f]\nkind = \"force\"\npoint = \"arm.B\"\naxes = \"lod\"\ndirection = "
             "\"z\"\nsize = \"1 N\"\n",
       "there is no body \"lod\"", "did you mean \"load\"?"},
      {all + "[forces.f]\nkind = \"line force\"\nfrom = \"arm.A\"\nto = \"arm.side\"\n"
             "direction = \"z\"\nsize = \"1 N/m\"\n",
       "reaches to s = 0.5 m of the beam", "split the segment"},
      {all + "[forces.f]\nkind = \"line force\"\nfrom = \"arm.A\"\nto = \"load.C\"\n"
             "direction = \"z\"\nsize = \"1 N/m\"\n",
       "between two points of one body", "leg.foot"},
      {all + "[bodies.world]\npoints = { A = [\"0 m\", \"0 m\", \"0 m\"] }\n[joints.w]\nkind = "
             "\"fixed\"\nconnect = [\"ground\", "
             "\"world.A\"]\n",
       "is the world and no body", "another name"},
      {all + "[bodies.rod]\nmass = \"1 kg\"\nuniform_rod = [\"P\", \"P\"]\n"
             "points = { P = [\"0 m\", \"0 m\", \"0 m\"] }\n"
             "[joints.r]\nkind = \"fixed\"\nconnect = [\"ground\", \"rod.P\"]\n",
       "the rod has no length", "two points apart"},
      {all + "[forces.f]\nkind = \"force\"\npoint = \"arm.far\"\ndirection = \"z\"\n"
             "size = \"1 N\"\n",
       "acts beyond the end of the beam, at s = 1.5 m", "fixed to the beam"},
      {all + "[hand_symbols]\n\"a b\" = 1\n", "cannot stand in a formula", "w_g"},
      {hinge + weld +
           "[drivers.swing]\njoint = \"hinge\"\nkind = \"polynomial\"\n"
           "coefficients = [\"0 rad\", \"1 rad/s\", \"1 rad/s^2\"]\n",
       "\"hinge\" neither repeats nor ends", "duration"},
      {all + "[deflection]\nlimit = \"1 mm\"\n", "does not say from which line its deflection",
       "against = \"tangent\""},
      {all + "[[hand_formulas]]\nname = \"v\"\nquantity = \"omega\"\nof = \"arm\"\n"
             "formula = [\"1/0\", \"0\", \"0\"]\n",
       "has no finite value", "division by zero"},
      {all + "[[hand_formulas]]\nname = \"v\"\nquantity = \"omega\"\nof = \"arm\"\n"
             "formula = [\"unknown*2\", \"0\", \"0\"]\n",
       "\"unknown*2\"", "hand_symbols"},
  };
  for (const Wrong& wrong : wrongs) {
    CAPTURE(wrong.lines);
    const Problem problem = problem_of(wrong.lines);
    CHECK_THAT(problem.message, Catch::Contains(wrong.said));
    CHECK_THAT(problem.hint, Catch::Contains(wrong.hint));
    CHECK(problem.line > 0);
  }
}

TEST_CASE("bodies that cannot be are refused", "[bad_input]") {
  const auto problem_with = [](const std::string& part, const std::string& with) {
    std::string text = bodies + hinge + weld + swing;
    text.replace(text.find(part), part.size(), with);
    return problem_in(text).message;
  };
  const std::string inertia = "[\"1 kg m^2\", \"2 kg m^2\", \"2.5 kg m^2\"]";
  CHECK_THAT(problem_with(inertia, "[\"1 kg m^2\", \"2 kg m^2\", \"3.5 kg m^2\"]"),
             Catch::Contains("no body has these principal moments"));
  CHECK_THAT(problem_with(inertia, "[\"-1 kg m^2\", \"2 kg m^2\", \"2 kg m^2\"]"),
             Catch::Contains("no body has these principal moments"));
  CHECK_THAT(problem_with(inertia,
                          "[[\"1 kg m^2\", \"0.1 kg m^2\", \"0 kg m^2\"], [\"0 kg m^2\", \"1 kg "
                          "m^2\", \"0 kg m^2\"], [\"0 kg m^2\", \"0 kg m^2\", \"1 kg m^2\"]]"),
             Catch::Contains("not symmetric"));
  CHECK_THAT(problem_with("mass = \"10 kg\"\n", ""), Catch::Contains("with inertia has a mass"));
  CHECK_THAT(problem_with("points = { A =", "mass = \"3 kg\"\npoints = { A ="),
             Catch::Contains("come from its sections"));
  CHECK_THAT(problem_with("axis = \"x\"\nz = \"z\"", "axis = \"x\"\nz = [1, 0, 1]"),
             Catch::Contains("square on the beam's axis"));
  CHECK_THAT(problem_with("C = [\"0 m\", \"0 m\", \"0 m\"]", "C = [\"0 m\", \"0 m\"]"),
             Catch::Contains("three values, x, y and z"));
}

}  // namespace broken_chain_test
