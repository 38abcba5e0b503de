#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>

#include "random_text.hpp"

namespace oracle {

namespace {

/// What holds a boom: a body, a cylinder that moves, or a rod.
struct BoomHold {
  bool by_body = false, moves = false;
  double reach = 0.0, tilt = 0.0, frequency = 0.0;
};

std::string hold(Draw& draw, const BoomHold& of) {
  if (of.by_body) {
    return fmt::format(
        "\n[bodies.strut]\nmass = \"{:.3g} kg\"\nuniform_rod = [\"a\", \"b\"]\npoints = {{ a = "
        "[\"0 m\", \"0 m\", \"0 m\"], b = [\"{:.9g} m\", \"0 m\", \"0 m\"] "
        "}}\n\n[joints.foot]\nkind = \"universal\"\nconnect = [\"column.ram\", "
        "\"strut.a\"]\naxis = \"y\"\nsecond_axis = \"z\"\nstart = [\"{:.6g} rad\", \"0 "
        "rad\"]\n\n[joints.hold]\nkind = \"spherical\"\nconnect = [\"strut.b\", "
        "\"boom.lug\"]\ncloses = true\n",
        draw.real(10, 60), of.reach, of.tilt);
  }
  std::string text =
      "\n[joints.hold]\nkind = \"distance\"\nconnect = [\"column.ram\", \"boom.lug\"]\n";
  text += of.moves ? fmt::format(
                         "\n[drivers.hold]\njoint = \"hold\"\nkind = \"harmonic\"\nmean = \"{:.6g} "
                         "m\"\namplitude = \"{:.3g} m\"\nfrequency = \"{:.4g} Hz\"\nphase = \"90 "
                         "deg\"\n",
                         of.reach, 0.1 * draw.real(0.2, 1.0), of.frequency)
                   : fmt::format("length = \"{:.9g} m\"\n", of.reach);
  return text;
}

}  // namespace

/// A boom on a column that slews, held by a rod without mass or a cylinder beside its plane or in
/// it, or by a body between a universal joint and a ball; with a pin and, without mass, a rod
/// there.
BeamWriter write_luffing(Draw& draw, RandomCase& of) {
  const double length = round_mm(draw.real(3.0, 7.0));
  BeamWriter beam(draw, length, draw.real(0.12, 0.35), true);
  const double frequency = draw.one_of({0.02, 0.025, 0.04, 0.05});
  const double period = 1.0 / frequency;
  const double mass = beam.modulus() * draw.real(1e7, 6e7) / 9.81 / length;
  const double lug = round_mm(length * draw.real(0.25, 0.6)), below = round_mm(draw.real(0.8, 1.6));
  const double aside = draw.chance(0.4) ? round_mm(draw.real(-0.6, 0.6)) : 0.0;
  const double middle = round_mm(length * draw.real(0.1, 0.9));
  const double raised = draw.real(0.0, 40.0) * std::numbers::pi / 180.0;
  // From the foot to the lug where the boom is raised so far.
  const double reach = std::hypot(lug * std::cos(raised), aside, lug * std::sin(raised) + below);
  const bool by_body = draw.chance(0.35), moves = !by_body && draw.chance(0.5);
  std::string& text = of.text;
  text += fmt::format(
      "[case]\nname = \"{}\"\nkind = \"spatial\"\n\n[mechanism]\ngravity = [\"0 m/s^2\", \"0 "
      "m/s^2\", \"-9.81 m/s^2\"]\n\n[bodies.column]\nmass = \"500 kg\"\npoints = {{ O = [\"0 m\", "
      "\"0 m\", \"0 m\"], heel = [\"0 m\", \"0 m\", \"2 m\"], ram = [\"0 m\", {}, {}] "
      "}}\n\n[bodies.boom]\npoints = {{ heel = [\"0 m\", \"0 m\", \"0 m\"], lug = [{}, \"0 m\", "
      "\"0 "
      "m\"], tip = [{}, \"0 m\", \"0 m\"], mid = [{}, \"0 m\", \"0 m\"] }}\n\n[bodies.load]\nmass "
      "= "
      "\"{:.4g} kg\"\npoints = {{ D = [\"0 m\", \"0 m\", \"0 m\"] }}\n",
      of.name, m(aside), m(2.0 - below), m(lug), m(length), m(middle), mass);
  text += fmt::format(
      "\n[joints.slew]\nkind = \"revolute\"\nconnect = [\"ground\", \"column.O\"]\naxis = "
      "\"z\"\n\n[joints.luff]\nkind = \"revolute\"\nconnect = [\"column.heel\", "
      "\"boom.heel\"]\naxis = \"-y\"\nstart = \"{:.6g} rad\"\n\n[joints.hook]\nkind = "
      "\"fixed\"\nconnect = [\"boom.tip\", \"load.D\"]\n\n[drivers.slewing]\njoint = "
      "\"slew\"\nkind = \"harmonic\"\nmean = \"0 deg\"\namplitude = \"{:.0f} deg\"\nfrequency = "
      "\"{:.4g} Hz\"\n",
      raised, draw.real(10, 120), frequency);
  // Up from the foot.
  const double tilt = -std::atan2(lug * std::sin(raised) + below, lug * std::cos(raised));
  text += hold(draw, {by_body, moves, reach, tilt, frequency});
  if (draw.chance(0.7)) {
    text += fmt::format(
        "\n[forces.F]\nkind = \"force\"\npoint = \"boom.mid\"\ndirection = [{:.3f}, {:.3f}, "
        "{:.3f}]\n",
        draw.real(-1, 1), draw.real(-1, 1), draw.real(-1, 1));
    if (draw.chance(0.5)) text += "axes = \"boom\"\n";
    text += law(draw, of, 8.0 * mass, period, false);
  }
  text += beam.sections;
  if (!by_body)
    text += "\n[sections.bar]\nkind = \"round tube\"\ndiameter = \"101.6 mm\"\nwall = \"8 mm\"\n";
  text +=
      "\n[model]\ndemand = \"rigid\"\n\n[beam]\nbody = \"boom\"\nstart = \"heel\"\naxis = "
      "\"x\"\nz = \"z\"\ndensity = \"7850 kg/m^3\"\n" +
      beam.segments + beam.holes();
  const bool several = draw.chance(0.35);
  text += demands(draw, beam, length, several);
  if (several) {
    text += situations(draw, "drivers.slewing.amplitude",
                       {"", fmt::format("\"{:.0f} deg\"", draw.real(10, 150))});
  }
  if (!by_body) {
    text += fmt::format(
        "\n[[rods]]\nname = \"hold\"\nlink = \"hold\"\nsection = \"bar\"\nbuckling_length = {}\n"
        "curve = \"{}\"\n",
        m(reach + 0.1), draw.one_of({"a", "b", "c"}));
  }
  text += fmt::format(
      "\n[[pins]]\nname = \"eye\"\njoint = \"{}\"\ndiameter = {}\ninner_plate = \"40 "
      "mm\"\nouter_plate = \"20 mm\"\ngap = \"3 mm\"\n",
      draw.chance(0.75) ? "hold" : "luff", mm(draw.real(0.03, 0.07)));
  return beam;
}

}  // namespace oracle
