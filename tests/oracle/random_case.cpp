#include "random_case.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>

#include "random_text.hpp"

namespace oracle {
namespace {

/// Of a chord, or as the supports say.
std::string deflection(Draw& draw, double from, double to, bool chord) {
  if (!draw.chance(0.3)) return "";
  std::string text =
      fmt::format("\n[deflection]\nlimit = {}\n", mm((to - from) / draw.real(100, 600) + 0.001));
  if (chord) text += fmt::format("against = \"chord\"\nfrom = {}\nto = {}\n", m(from), m(to));
  if (draw.chance(0.3)) text += "load_factor = true\n";
  return text;
}

/// A lever that a crank swings, as in the template.
BeamWriter write_lever(Draw& draw, RandomCase& of) {
  const double length = round_mm(draw.real(2.0, 3.0));
  const double pin = round_mm(draw.real(1.35, 1.6));
  BeamWriter beam(draw, length, draw.real(0.12, 0.3), false);
  // Whole parts of the motion's frequency are written alike for drivers and forces.
  const double rate = draw.one_of({15.0, 24.0, 30.0, 37.5, 48.0, 60.0});
  const double period = 60.0 / rate;
  const double mass = beam.modulus() * draw.real(2e7, 1.5e8) / 9.81 / length;
  std::string& text = of.text;
  text += fmt::format(
      "[case]\nname = \"{}\"\nkind = \"planar\"\n\n[mechanism]\ngravity = [\"0 m/s^2\", \"-9.81 "
      "m/s^2\"]\n\n[bodies.crank]\nmass = \"40 kg\"\nuniform_rod = \"0.3 m\"\npoints = {{ O = "
      "[\"-0.15 m\", \"0 m\"], A = [\"0.15 m\", \"0 m\"] }}\nsketch = {{ at = [\"0 m\", \"0.15 "
      "m\"], angle = \"90 deg\" }}\n\n[bodies.rod]\nmass = \"60 kg\"\nuniform_rod = \"2 m\"\n"
      "points = {{ A = [\"-1 m\", \"0 m\"], B = [\"1 m\", \"0 m\"] }}\nsketch = {{ at = [\"1 m\", "
      "\"0.3 m\"], angle = \"0 deg\" }}\n\n[bodies.lever]\npoints = {{ C = [\"0 m\", \"0 m\"], B = "
      "[{}, \"0 m\"], D = [{}, \"0 m\"] }}\nsketch = {{ at = [\"2 m\", \"-1.2 m\"], angle = \"90 "
      "deg\" }}\n\n[bodies.load]\nmass = \"{:.4g} kg\"\ninertia = \"{:.4g} kg m^2\"\npoints = {{ D "
      "= [\"0 m\", \"0 m\"] }}\nsketch = {{ at = [\"2 m\", \"{:.4g} m\"], angle = \"90 deg\" }}\n",
      of.name, m(pin), m(length), mass, 0.03 * mass, length - 1.2);
  text +=
      "\n[joints.O]\nkind = \"pin\"\nconnect = [\"crank.O\", \"ground\"]\nat = [\"0 m\", \"0 m\"]\n"
      "\n[joints.A]\nkind = \"pin\"\nconnect = [\"crank.A\", \"rod.A\"]\n"
      "\n[joints.B]\nkind = \"pin\"\nconnect = [\"rod.B\", \"lever.B\"]\n"
      "\n[joints.C]\nkind = \"pin\"\nconnect = [\"lever.C\", \"ground\"]\nat = [\"2 m\", \"-1.2 "
      "m\"]\n\n[joints.D]\nkind = \"rigid\"\nconnect = [\"lever.D\", \"load.D\"]\n"
      "\n[loops.rod]\nturn = [\"rod.A\", \"rod.B\", \"lever.C\"]\nsign = \"-\"\n";
  text += fmt::format(
      "\n[drivers.motor]\npoint = \"crank.O\"\ncoordinate = \"angle\"\nkind = \"constant "
      "rate\"\nstart = \"90 deg\"\nrate = \"{:.4g} rpm\"\n",
      rate);
  if (draw.chance(0.5)) {
    text += fmt::format(
        "\n[forces.pull]\nkind = \"force\"\npoint = \"lever.{}\"\ndirection = "
        "\"{:.0f} deg\"\n",
        draw.chance(0.5) ? "D" : "B", draw.real(-180, 180));
    text += law(draw, of, 5.0 * mass, period, false);
  }
  text += beam.sections;
  const bool several =
      draw.chance(0.4) && of.tables.empty() && text.find("frequency") == std::string::npos;
  if (draw.chance(0.4))
    text += "\n[sections.bar]\nkind = \"round tube\"\ndiameter = \"80 mm\"\nwall = \"8 mm\"\n";
  const bool rod = text.find("[sections.bar]") != std::string::npos;
  text += "\n[model]\ndemand = \"rigid\"\n";
  text += "\n[beam]\nbody = \"lever\"\ndensity = \"7850 kg/m^3\"\n" + beam.segments + beam.holes();
  text += demands(draw, beam, length, several);
  if (several) {
    text += situations(draw, "drivers.motor.rate",
                       {"", fmt::format("\"{:.4g} rpm\"", rate * draw.real(0.3, 1.4))});
  }
  if (rod) {
    text +=
        "\n[[rods]]\nname = \"rod\"\nfrom = \"rod.A\"\nto = \"rod.B\"\nsection = \"bar\"\n"
        "curve = \"c\"\n";
  }
  if (draw.chance(0.4)) {
    text += fmt::format(
        "\n[[pins]]\nname = \"hub\"\njoint = \"{}\"\ndiameter = {}\ninner_plate = \"40 mm\"\n"
        "outer_plate = \"20 mm\"\ngap = \"3 mm\"\n",
        draw.one_of({"A", "B", "C"}), mm(draw.real(0.02, 0.07)));
  }
  text += deflection(draw, 0.0, draw.chance(0.5) ? pin : length, true);
  return beam;
}

/// A lever that a crank swings by a pin in its slot: the load slides along the beam.
BeamWriter write_quick_return(Draw& draw, RandomCase& of) {
  const double length = round_mm(draw.real(1.9, 2.6));
  BeamWriter beam(draw, length, draw.real(0.12, 0.3), false);
  const double radius = round_mm(draw.real(0.2, 0.5));
  const double mass = beam.modulus() * draw.real(2e7, 1.5e8) / 9.81 / length;
  std::string& text = of.text;
  text += fmt::format(
      "[case]\nname = \"{}\"\nkind = \"planar\"\n\n[mechanism]\ngravity = [\"0 m/s^2\", \"-9.81 "
      "m/s^2\"]\n\n[bodies.crank]\nmass = \"40 kg\"\ninertia = \"1 kg m^2\"\npoints = {{ O = "
      "[\"0 m\", \"0 m\"], A = [{}, \"0 m\"] }}\nsketch = {{ at = [\"0 m\", \"0 m\"], angle = \"90 "
      "deg\" }}\n\n[bodies.lever]\npoints = {{ C = [\"0 m\", \"0 m\"], D = [{}, \"0 m\"] "
      "}}\nsketch = {{ at = [\"0 m\", \"-1.2 m\"], angle = \"90 deg\" }}\n\n[bodies.load]\nmass = "
      "\"{:.4g} kg\"\ninertia = \"{:.4g} kg m^2\"\npoints = {{ D = [\"0 m\", \"0 m\"] }}\nsketch = "
      "{{ at = [\"0 m\", \"{:.4g} m\"], angle = \"90 deg\" }}\n",
      of.name, m(radius), m(length), mass, 0.03 * mass, length - 1.2);
  text += fmt::format(
      "\n[joints.O]\nkind = \"pin\"\nconnect = [\"crank.O\", \"ground\"]\nat = [\"0 m\", \"0 m\"]\n"
      "\n[joints.A]\nkind = \"pin in slot\"\npoint = \"crank.A\"\nguide = \"lever.C\"\ndirection "
      "= \"0 deg\"\n\n[joints.C]\nkind = \"pin\"\nconnect = [\"lever.C\", \"ground\"]\nat = [\"0 "
      "m\", \"-1.2 m\"]\n\n[joints.D]\nkind = \"rigid\"\nconnect = [\"lever.D\", \"load.D\"]\n"
      "\n[drivers.motor]\npoint = \"crank.O\"\ncoordinate = \"angle\"\nkind = \"constant "
      "rate\"\nstart = \"90 deg\"\nrate = \"{:.4g} rpm\"\n",
      draw.one_of({15.0, 24.0, 30.0, 37.5, 48.0}));
  text += beam.sections;
  text += "\n[model]\ndemand = \"rigid\"\n";
  text += "\n[beam]\nbody = \"lever\"\ndensity = \"7850 kg/m^3\"\n" + beam.segments + beam.holes();
  const bool several = draw.chance(0.3);
  text += demands(draw, beam, length, several);
  if (several) {
    text += situations(draw, "drivers.motor.rate",
                       {"", fmt::format("\"{:.4g} rpm\"", draw.real(10, 50))});
  }
  return beam;
}

/// A beam that stands still under forces that change: clamped, or on two supports.
BeamWriter write_standing(Draw& draw, RandomCase& of) {
  const double length = round_mm(draw.real(1.5, 5.0));
  BeamWriter beam(draw, length, draw.real(0.12, 0.4), false);
  const bool clamped = draw.chance(0.5);
  const double support = round_mm(length * draw.real(0.6, 1.0));
  const double middle = round_mm(length * draw.real(0.15, 0.9));
  const double aside = draw.chance(0.3) ? round_mm(draw.real(-0.3, 0.3)) : 0.0;
  const double period = draw.one_of({0.5, 1.0, 2.0});
  const double size = beam.modulus() * draw.real(3e7, 2e8) / length * (clamped ? 1.0 : 3.0);
  std::string& text = of.text;
  text += fmt::format(
      "[case]\nname = \"{}\"\nkind = \"planar\"\n\n[mechanism]\ngravity = [\"0 m/s^2\", \"-9.81 "
      "m/s^2\"]\n\n[bodies.beam]\npoints = {{ A = [\"0 m\", \"0 m\"], B = [{}, \"0 m\"], E = [{}, "
      "{}], F = [{}, \"0 m\"] }}\nsketch = {{ at = [\"0 m\", \"0 m\"], angle = \"0 deg\" }}\n",
      of.name, m(support), m(middle), m(aside), m(length));
  if (clamped) {
    text +=
        "\n[joints.A]\nkind = \"rigid\"\nconnect = [\"beam.A\", \"ground\"]\nat = [\"0 m\", \"0 "
        "m\"]\nangle = \"0 deg\"\n";
  } else {
    text += fmt::format(
        "\n[joints.A]\nkind = \"pin\"\nconnect = [\"beam.A\", \"ground\"]\nat = [\"0 m\", \"0 "
        "m\"]\n"
        "\n[joints.B]\nkind = \"pin in slot\"\npoint = \"beam.B\"\nthrough = [{}, "
        "\"0 m\"]\ndirection = \"0 deg\"\n",
        m(support));
  }
  text += "\n[forces.end]\nkind = \"force\"\npoint = \"beam.F\"\ndirection = \"" +
          fmt::format("{:.0f}", draw.chance(0.7) ? -90.0 : draw.real(-180, 180)) + " deg\"\n";
  text += law(draw, of, size, period, true);
  if (draw.chance(0.6)) {
    text += fmt::format(
        "\n[forces.middle]\nkind = \"force\"\npoint = \"beam.E\"\ndirection = "
        "\"{:.0f} deg\"\n",
        draw.real(-180, 180));
    text += law(draw, of, size, period, false);
  }
  text += beam.sections;
  text += "\n[model]\ndemand = \"rigid\"\n";
  text += "\n[beam]\nbody = \"beam\"\ndensity = \"7850 kg/m^3\"\n" + beam.segments + beam.holes();
  const bool several = draw.chance(0.3);
  text += demands(draw, beam, length, several);
  if (several) text += situations(draw, "mechanism.gravity", {"", "[\"0 m/s^2\", \"0 m/s^2\"]"});
  text += deflection(draw, 0.0, clamped ? length : support, !clamped && draw.chance(0.5));
  return beam;
}

/// The jib of a slewing crane.
BeamWriter write_jib(Draw& draw, RandomCase& of) {
  const double length = round_mm(draw.real(2.0, 6.0));
  BeamWriter beam(draw, length, draw.real(0.12, 0.35), true);
  const double frequency = draw.one_of({0.04, 0.05, 0.08, 0.1, 0.125, 0.2});
  const double period = 1.0 / frequency;
  const double mass = beam.modulus() * draw.real(1e7, 8e7) / 9.81 / length;
  const double middle = round_mm(length * draw.real(0.1, 0.9));
  const bool off_axis = draw.chance(0.5);
  const double y = off_axis ? round_mm(draw.real(-0.1, 0.1)) : 0.0;
  const double z = off_axis ? round_mm(draw.real(-0.2, 0.2)) : 0.0;
  const double raised = std::round(draw.real(-20, 30));
  std::string& text = of.text;
  text += fmt::format(
      "[case]\nname = \"{0}\"\nkind = \"spatial\"\n\n[mechanism]\ngravity = [\"0 m/s^2\", \"0 "
      "m/s^2\", \"-9.81 m/s^2\"]\n\n[bodies.column]\nmass = \"500 kg\"\ncentre = [\"0 m\", \"0 "
      "m\", \"1.5 m\"]\ninertia = [\"380 kg m^2\", \"380 kg m^2\", \"12 kg m^2\"]\npoints = {{ A = "
      "[\"0 m\", \"0 m\", \"0 m\"], B = [\"0 m\", \"0 m\", \"3 m\"] }}\n\n[bodies.jib]\npoints = "
      "{{ B = [\"0 m\", \"0 m\", \"0 m\"], D = [{1}, \"0 m\", \"0 m\"], lug = [{2}, {3}, {4}] "
      "}}\n\n[bodies.load]\nmass = \"{5:.4g} kg\"\ncentre = [\"{6:.2f} m\", \"0 m\", \"{7:.2f} "
      "m\"]\ninertia = [\"15 kg m^2\", \"15 kg m^2\", \"10 kg m^2\"]\npoints = {{ D = [\"0 m\", "
      "\"0 m\", \"0 m\"] }}\n",
      of.name, m(length), m(middle), m(y), m(z), mass, draw.real(0, 0.6), draw.real(-0.8, 0.2));
  text += fmt::format(
      "\n[joints.slew]\nkind = \"revolute\"\nconnect = [\"ground\", \"column.A\"]\nat = [\"0 m\", "
      "\"0 m\", \"0 m\"]\naxis = \"z\"\n\n[joints.root]\nkind = \"fixed\"\nconnect = "
      "[\"column.B\", \"jib.B\"]\nturn = [\"y\", \"{:.0f} deg\"]\n\n[joints.end]\nkind = "
      "\"fixed\"\n"
      "connect = [\"jib.D\", \"load.D\"]\nturn = [\"y\", \"{:.0f} deg\"]\n\n[drivers.slewing]\n"
      "joint = \"slew\"\nkind = \"harmonic\"\nmean = \"0 deg\"\namplitude = \"{:.0f} "
      "deg\"\nfrequency = \"{:.4g} Hz\"\n",
      -raised, raised, draw.real(20, 150), frequency);
  const int forces = draw.whole(1, 2);
  for (int i = 0; i < forces; ++i) {
    text += fmt::format("\n[forces.F{}]\nkind = \"force\"\npoint = \"{}\"\n", i + 1,
                        i == 0 ? "jib.lug" : "load.D");
    text += fmt::format("direction = [{:.3f}, {:.3f}, {:.3f}]\n", draw.real(-1, 1),
                        draw.real(-1, 1), draw.real(-1, 1));
    if (draw.chance(0.6)) text += "axes = \"jib\"\n";
    text += law(draw, of, 12.0 * mass, period, false);
  }
  text += beam.sections;
  text +=
      "\n[beam]\nbody = \"jib\"\nstart = \"B\"\naxis = \"x\"\nz = \"z\"\ndensity = \"7850 "
      "kg/m^3\"\n" +
      beam.segments + beam.holes();
  const bool several = draw.chance(0.35);
  text += demands(draw, beam, length, several);
  if (several) {
    text += situations(draw, "drivers.slewing.amplitude",
                       {"", fmt::format("\"{:.0f} deg\"", draw.real(10, 170))});
  }
  return beam;
}

/// A boom of elastic links on a jack.
BeamWriter write_boom(Draw& draw, RandomCase& of) {
  const double length = 3.5;
  BeamWriter beam(draw, length, draw.real(0.14, 0.3), false);
  const double frequency = std::round(draw.real(3, 30));
  const double force = beam.modulus() * draw.real(3e6, 4e7) / length;
  std::string& text = of.text;
  text += fmt::format(
      "[case]\nname = \"{}\"\nkind = \"flexible\"\n\n[mechanism]\ngravity = [\"0 m/s^2\", \"-9.81 "
      "m/s^2\"]\n\n[motion]\nfrequency = \"{:.0f} Hz\"\n\n[model]\nyoungs_modulus = \"210 "
      "GPa\"\nshear_modulus = \"81 GPa\"\ndamping = {{ ratio = 0.03, at = \"25 Hz\" "
      "}}\n\n[links.boom]\nkind = \"bending\"\norigin = [\"0 m\", \"0 m\"]\nangle = \"20 "
      "deg\"\nparts = 8\npoints = {{ jack = [\"1.2 m\", \"-0.15 m\"] }}\n\n[links.jack]\nkind = "
      "\"axial\"\nfrom = [\"0.9 m\", \"-0.9 m\"]\nto = \"boom.jack\"\nparts = 3\nEA = \"90 "
      "MN\"\nmass_per_length = \"30 kg/m\"\n\n[links.tool]\nkind = \"rigid\"\norigin = "
      "\"boom.end\"\nangle = \"20 deg\"\npoints = {{ flange = [\"0 m\", \"0 m\"] }}\nmass = "
      "\"{:.0f} kg\"\ninertia = \"6 kg m^2\"\ncentre = [\"0.2 m\", \"0 m\"]\n",
      of.name, frequency, draw.real(50, 300));
  text +=
      "\n[joints.foot]\nkind = \"revolute\"\nconnect = [\"boom.start\", \"ground\"]\nstiffness = "
      "\"200 MN/m\"\n\n[joints.base]\nkind = \"revolute\"\nconnect = [\"jack.start\", "
      "\"ground\"]\nstiffness = \"200 MN/m\"\n\n[joints.jack]\nkind = \"revolute\"\nconnect = "
      "[\"jack.end\", \"boom.jack\"]\nstiffness = \"200 MN/m\"\n\n[joints.flange]\nkind = "
      "\"revolute\"\nconnect = [\"boom.end\", \"tool.flange\"]\nstiffness = "
      "\"rigid\"\nturning_stiffness = \"rigid\"\n";
  text += fmt::format("\n[loads.shaking]\non = \"tool.flange\"\namplitude_force = [{}, {}]\n",
                      kN(force * draw.real(-1, 1)), kN(force * draw.real(0.2, 1)));
  text += beam.sections;
  text += "\n[beam]\nlink = \"boom\"\ndensity = \"7850 kg/m^3\"\n" + beam.segments + beam.holes();
  const bool several = draw.chance(0.3);
  text += demands(draw, beam, length, several);
  if (several) {
    text += situations(draw, "motion.frequency",
                       {"", fmt::format("\"{:.0f} Hz\"", std::round(draw.real(3, 30)))});
  }
  return beam;
}

}  // namespace

RandomCase random_case(std::uint64_t number) {
  Draw draw(number);
  RandomCase of;
  of.name = fmt::format("random-{}", number);
  // Numbers of their own, so that the beams stay what they are when a part is added.
  Draw of_parts(number + 0x5bd1e995ULL);
  if (of_parts.chance(0.05)) {
    write_strut(draw, of);
    return of;
  }
  Draw of_kind(number + 0x27d4eb2fULL);
  if (of_kind.chance(0.12)) {
    const BeamWriter beam = write_luffing(of_kind, of);
    add_parts(of_parts, beam, of);
    return of;
  }
  if (of_parts.chance(0.15)) {
    const BeamWriter beam =
        of_parts.chance(0.6) ? write_given_loads(draw, of) : write_frame(draw, of);
    add_parts(of_parts, beam, of);
    return of;
  }
  const double which = draw.real(0, 1);
  const BeamWriter beam = which < 0.28   ? write_standing(draw, of)
                          : which < 0.5  ? write_lever(draw, of)
                          : which < 0.6  ? write_quick_return(draw, of)
                          : which < 0.92 ? write_jib(draw, of)
                                         : write_boom(draw, of);
  add_parts(of_parts, beam, of);
  return of;
}

std::string RandomCase::write(const std::string& folder) const {
  namespace fs = std::filesystem;
  fs::create_directories(folder);
  for (const auto& [file, content] : tables) std::ofstream(fs::path(folder) / file) << content;
  const std::string path = (fs::path(folder) / (name + ".toml")).string();
  std::ofstream(path) << text;
  return path;
}

}  // namespace oracle
