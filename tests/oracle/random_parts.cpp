#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "random_text.hpp"

namespace oracle {
namespace {

void put_behind(std::string& text, const std::string& words, const std::string& more) {
  const std::size_t at = text.find(words);
  if (at != std::string::npos) text.insert(at + words.size(), more);
}

std::string factors(Draw& draw) {
  std::string text;
  if (draw.chance(0.6)) text += fmt::format("gamma_M0 = {:.3g}\n", draw.real(1.0, 1.2));
  if (draw.chance(0.6)) text += fmt::format("gamma_M1 = {:.3g}\n", draw.real(1.0, 1.3));
  if (draw.chance(0.6)) text += fmt::format("gamma_M2 = {:.3g}\n", draw.real(1.1, 1.8));
  if (draw.chance(0.3))
    text += fmt::format("C_my = {:.2g}\nC_mz = {:.2g}\n", draw.real(0.6, 1.0), draw.real(0.6, 1.0));
  return text;
}

/// A plate that the sections of a beam have.
std::string plate_of(Draw& draw, const BeamWriter& beam) {
  switch (beam.family()) {
    case Family::box:
      if (beam.has_stiffeners() && draw.chance(0.3)) return "stiffeners";
      return draw.one_of({"top flange", "bottom flange", "left web", "right web"});
    case Family::nested:
      return draw.one_of({"top flange", "bottom flange", "left web", "right web", "inner profile"});
    case Family::tube:
    case Family::round:
    case Family::plate: break;
  }
  return "walls";
}

std::string part_materials(Draw& draw, const BeamWriter& beam) {
  std::string text;
  const int count = draw.whole(1, 2);
  for (int i = 0; i < count; ++i) {
    text += fmt::format("\n[[part_materials]]\nsteel = \"{}\"\nplates = [\"{}\", \"{}\"]\n",
                        draw.one_of({"S235", "S275", "S355", "S420N"}), plate_of(draw, beam),
                        plate_of(draw, beam));
    const int segments = static_cast<int>(beam.borders().size()) - 1;
    if (draw.chance(0.5))
      text += fmt::format("segments = [\"part {}\"]\n", draw.whole(1, segments));
  }
  return text;
}

std::string diaphragms(Draw& draw, const BeamWriter& beam) {
  std::set<double> stations{0.0, beam.length()};
  const int count = draw.whole(1, 3);
  for (int i = 0; i < count; ++i) stations.insert(round_mm(beam.length() * draw.real(0.1, 0.9)));
  std::string text;
  for (const double s : stations) {
    text += fmt::format("\n[[beam.diaphragms]]\nstation = {}\nthickness = {}\n", m(s),
                        mm(draw.real(0.006, 0.025)));
    if (draw.chance(0.5)) text += fmt::format("throat = {}\n", mm(draw.real(0.003, 0.008)));
  }
  return text;
}

std::string restraints(Draw& draw, const BeamWriter& beam) {
  const bool pins = draw.chance(0.5);
  std::string text;
  for (const double s : {0.0, beam.length()}) {
    if (!pins && s > 0.0) continue;
    text += fmt::format(
        "\n[[beam.restraints]]\nstation = {}\nholds = [\"along y\", \"along z\", \"turning "
        "over\"]\nclamped = {}\n",
        m(s), !pins);
  }
  return text;
}

/// Plates of a pin of 20 to 70 mm.
std::string lugs(Draw& draw) {
  std::string both;
  for (const char* const plate : {"inner", "outer"}) {
    if (both.empty() ? draw.chance(0.2) : draw.chance(0.4)) continue;
    std::string one = fmt::format("{{ plate = \"{}\", width = {}", plate, mm(draw.real(0.15, 0.4)));
    if (draw.chance(0.6)) one += fmt::format(", end = {}", mm(draw.real(0.06, 0.15)));
    if (draw.chance(0.4)) one += fmt::format(", stress_factor = {:.3g}", draw.real(1.5, 5.0));
    if (draw.chance(0.5))
      one += fmt::format(", category = {}", draw.one_of({125, 100, 80, 63, 50, 36}));
    both += (both.empty() ? "" : ", ") + one + " }";
  }
  return both.empty() ? "" : "lugs = [" + both + "]\n";
}

}  // namespace

void add_parts(Draw& draw, const BeamWriter& beam, RandomCase& of) {
  std::string& text = of.text;
  if (draw.chance(0.4)) put_behind(text, "\n[strength]\n", factors(draw));
  const std::string gamma_Ff = "gamma_Ff = 1.0";
  const std::size_t at = text.find(gamma_Ff);
  if (draw.chance(0.3) && at != std::string::npos)
    text.replace(at, gamma_Ff.size(), fmt::format("gamma_Ff = {:.3g}", draw.real(1.0, 1.3)));
  const bool box = beam.family() == Family::box;
  if (draw.chance(0.3)) {
    text += part_materials(draw, beam);
    // Which of them these are of is to be said then.
    put_behind(text, "\n[[rods]]\n", "steel = \"S275\"\n");
    put_behind(text, "\n[[pins]]\n", "steel = \"S420N\"\nplate_steel = \"S235\"\n");
  }
  if (box && draw.chance(0.3)) text += diaphragms(draw, beam);
  if (beam.has_webs() && draw.chance(0.3)) {
    text += fmt::format("\n[[beam.load_introductions]]\nfrom = \"0 m\"\nto = {}\n{}\n",
                        m(beam.length()),
                        draw.chance(0.5) ? "into = \"webs\"" : "stiff_length = \"60 mm\"");
  }
  if (draw.chance(0.25)) text += restraints(draw, beam);
  if (draw.chance(0.6)) put_behind(text, "\n[[pins]]\n", lugs(draw));
}

BeamWriter write_given_loads(Draw& draw, RandomCase& of) {
  const double length = round_mm(draw.real(1.5, 5.0));
  const bool space = draw.chance(0.5);
  BeamWriter beam(draw, length, draw.real(0.12, 0.35), space);
  const double size = beam.modulus() * draw.real(4e7, 2e8) / length;
  const double middle = round_mm(length * draw.real(0.2, 0.9));
  const int rows = draw.whole(6, 20);
  const std::string file = of.name + "-record.csv";
  std::string& text = of.text;
  text += fmt::format("[case]\nname = \"{}\"\nkind = \"loads\"\n", of.name) + beam.sections +
          "\n[beam]\ndensity = \"7850 kg/m^3\"\n" + beam.segments + beam.holes();
  text += fmt::format(
      "\n[files.record]\npath = \"{}\"\n\n[loads.tip]\nstation = {}\ncolumns = {{ F_x = \"X\", F_z "
      "= \"Z\"{} }}\n",
      file, m(length), space ? ", F_y = \"Y\"" : "");
  if (space) text += fmt::format("y = {}\nz = {}\n", m(round_mm(draw.real(-0.1, 0.1))), m(0.0));
  text += fmt::format(
      "\n[loads.middle]\nstation = {}\nforce = [{}, \"0 kN\", {}]\ntimes = \"P\"\nper = 100.0\n",
      m(middle), kN(size * draw.real(-0.5, 0.5)), kN(size * draw.real(-1.0, 1.0)));
  text += fmt::format("\n[balance]\nstation = \"0 m\"\nheld = [\"0 m\", {}]\n", m(middle));
  if (draw.chance(0.5)) text += "gravity = [\"0 m/s^2\", \"0 m/s^2\", \"-9.81 m/s^2\"]\n";
  const auto record = [&](const std::string& name, double times) {
    std::string table = "time [s], X [kN], Y [kN], Z [N], P [bar]\n";
    for (int i = 0; i <= rows; ++i) {
      table += fmt::format("{:.6g}, {:.6g}, {:.6g}, {:.6g}, {:.6g}\n", 0.1 * i,
                           1e-3 * times * size * draw.real(-0.6, 0.6),
                           1e-3 * times * size * draw.real(-0.2, 0.2),
                           times * size * draw.real(-1.0, 1.0), draw.real(-50.0, 100.0));
    }
    of.tables.emplace_back(name, table);
  };
  record(file, 1.0);
  const bool several = draw.chance(0.5);
  text += demands(draw, beam, length, several);
  if (several) {
    const std::string other = of.name + "-other.csv";
    record(other, draw.real(0.5, 1.3));
    text += situations(draw, "files.record.path", {"", "\"" + other + "\""});
  }
  return beam;
}

BeamWriter write_frame(Draw& draw, RandomCase& of) {
  const double length = round_mm(draw.real(2.0, 5.0));
  BeamWriter beam(draw, length, draw.real(0.12, 0.35), false);
  const double support = round_mm(length * draw.real(0.6, 1.0));
  const double size = beam.modulus() * draw.real(4e7, 2e8) / length;
  std::string& text = of.text;
  text += fmt::format("[case]\nname = \"{}\"\nkind = \"static\"\n", of.name) + beam.sections +
          "\n[beam]\ndensity = \"7850 kg/m^3\"\n" + beam.segments + beam.holes();
  text += fmt::format(
      "\n[supports.heel]\nkind = \"pinned\"\nat = \"0 m\"\n\n[supports.prop]\nkind = \"roller\"\n"
      "at = {}\n",
      m(support));
  Combining& by = of.combining;
  by.cases.push_back({"weight", true, 0.0});
  for (int i = 1; i <= 3; ++i) {
    const std::string name = fmt::format("load{}", i);
    by.cases.push_back({name, draw.chance(0.3), std::round(100.0 * draw.real(0.0, 1.0)) / 100.0});
    text +=
        fmt::format("\n[loads.{}]\nkind = \"force\"\nat = {}\nforce = [{}, {}]\ncase = \"{}\"\n",
                    name, m(round_mm(length * draw.real(0.1, 1.0))),
                    kN(size * draw.real(-0.5, 0.5)), kN(size * draw.real(-1.5, 1.0)), name);
    text += by.cases.back().permanent
                ? fmt::format("\n[load_cases.{}]\nkind = \"permanent\"\n", name)
                : fmt::format("\n[load_cases.{}]\nkind = \"variable\"\npsi_0 = {}\n", name,
                              by.cases.back().psi_0);
  }
  by.by_ab = draw.chance(0.5);
  text += fmt::format("\n[combinations]\nrule = \"{}\"\n", by.by_ab ? "6.10a/b" : "6.10");
  if (draw.chance(0.5)) {
    by.gamma_G = 0.01 * draw.whole(110, 140);
    by.gamma_G_inf = 0.01 * draw.whole(80, 100);
    by.gamma_Q = 0.01 * draw.whole(120, 160);
    text += fmt::format("gamma_G = {}\ngamma_G_inf = {}\ngamma_Q = {}\n", by.gamma_G,
                        by.gamma_G_inf, by.gamma_Q);
    if (by.by_ab) {
      by.xi = 0.01 * draw.whole(80, 95);
      text += fmt::format("xi = {}\n", by.xi);
    }
  }
  for (const Combining::LoadCase& each : by.cases) {
    text += fmt::format("\n[[situations]]\nname = \"unit {0}\"\nloads = {{ \"{0}\" = 1.0 }}\n",
                        each.name);
  }
  text += fmt::format(
      "\n[[situations]]\nname = \"change\"\nbetween = [\"unit load1\", \"unit load{}\"]\ncycles = "
      "{:.3g}\n",
      draw.whole(2, 3), draw.logarithmic(1e3, 1e6));
  text += demands(draw, beam, length, true);
  return beam;
}

void write_strut(Draw& draw, RandomCase& of) {
  const double length = round_mm(draw.real(2.0, 6.0));
  const bool welded = draw.chance(0.6);
  const double width = round_mm(draw.real(0.08, 0.16)), height = round_mm(draw.real(0.08, 0.25));
  const double wall = round_mm(draw.real(0.005, 0.012));
  const bool pins = draw.chance(0.5);
  const double A = 2.0 * wall * (width + height);
  const double I = wall * width * width * (width / 6.0 + 0.5 * height);
  const double L_cr = (pins ? 1.0 : 2.0) * length;
  const double critical = std::numbers::pi * std::numbers::pi * 210e9 * I / (L_cr * L_cr);
  const double N = std::min(draw.real(0.03, 0.4) * critical, 0.8 * 235e6 * A);
  const double M = A * height / 4.0 * 235e6 * draw.real(0.05, 0.5);
  std::string& text = of.text;
  text += fmt::format("[case]\nname = \"{}\"\nkind = \"loads\"\n\n[sections.strut]\n", of.name);
  text += welded ? fmt::format("kind = \"box\"\nflange = {0}\nweb = {0}\n", mm(wall))
                 : fmt::format("kind = \"rectangular tube\"\nwall = {}\n", mm(wall));
  text += fmt::format(
      "width = {}\nheight = {}\n\n[beam]\ndensity = \"7850 kg/m^3\"\n\n[[beam.segments]]\n"
      "length = {}\nsection = \"strut\"\n",
      mm(width), mm(height), m(length));
  for (const double s : {0.0, length}) {
    if (!pins && s > 0.0) continue;
    text += fmt::format(
        "\n[[beam.restraints]]\nstation = {}\nholds = [\"along y\", \"along z\", \"turning "
        "over\"]\nclamped = {}\n",
        m(s), !pins);
  }
  text += fmt::format(
      "\n[loads.tip]\nstation = {}\nforce = [{}, {}, {}]\nmoment = [\"0 kN m\", \"{:.4g} kN m\", "
      "\"0 kN m\"]\n\n[balance]\nstation = \"0 m\"\n",
      m(length), kN(-N), draw.chance(0.5) ? kN(0.3 * M / length) : kN(0.0),
      kN(M / length * draw.real(-1.0, 1.0)), 1e-3 * M * draw.real(-1.0, 1.0));
  text += fmt::format("\n[material]\nsteel = \"{}\"\n\n[strength]\nrequired = {:.3g}\n{}",
                      draw.one_of({"S235", "S355", "S460N"}), draw.real(1.0, 1.4), factors(draw));
}

}  // namespace oracle
