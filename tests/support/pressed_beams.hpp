#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "boxbeam/verification/verify.hpp"

/// Box beams under forces that come into their webs.
namespace pressed_beams {

using namespace boxbeam;

struct Sizes {
  double width = 600.0, height = 600.0, flange = 20.0, web = 12.0, throat = 0.0;
};

struct Piece {
  double length = 1.0;  // [m]
  Sizes from, to;
};

struct Load {
  std::string name = "f";
  double at = 0.0, down = 0.0, y = 0.0, z = 0.0;  // [m], [kN], [m]
  double moment = 0.0, torque = 0.0;              // about y, about x [kN m]
  double across = 0.0;                            // along y, in space [kN]
};

/// A weightless beam; in space on forks.
struct Beam {
  std::vector<Piece> pieces;
  std::vector<double> diaphragms;
  double thickness = 16.0, weld = 0.0;  // of them and of the throats of their welds [mm]
  std::vector<std::pair<double, double>> supports;  // s [m], z of its pin [m]
  std::vector<Load> forces;
  std::string more = {};
  bool space = false;
  double required = 1.0;

  double length() const {
    double sum = 0.0;
    for (const Piece& of : pieces) sum += of.length;
    return sum;
  }

  Beam mirrored() const {
    Beam other = *this;
    const double L = length();
    std::reverse(other.pieces.begin(), other.pieces.end());
    for (Piece& of : other.pieces) std::swap(of.from, of.to);
    for (double& s : other.diaphragms) s = L - s;
    for (auto& [s, z] : other.supports) s = L - s;
    for (Load& of : other.forces) {
      of.at = L - of.at;
      of.moment = -of.moment;
    }
    return other;
  }

  std::string text() const {
    std::string out = "[case]\nname = \"pressed\"\nkind = \"static\"\n[frame]\n";
    out += space ? "space = true\ngravity = [\"0 m/s^2\", \"0 m/s^2\", \"0 m/s^2\"]\n"
                 : "gravity = [\"0 m/s^2\", \"0 m/s^2\"]\n";
    std::string segments;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const Piece& of = pieces[i];
      int end = 0;
      for (const Sizes& at : {of.from, of.to}) {
        out += fmt::format(
            "[sections.s{}{}]\nkind = \"box\"\nwidth = \"{:.10g} mm\"\nheight = \"{:.10g} "
            "mm\"\nflange = \"{:.10g} mm\"\nweb = \"{:.10g} mm\"\n{}",
            i, end++, at.width, at.height, at.flange, at.web,
            at.throat > 0.0 ? fmt::format("seam_throat = \"{:.10g} mm\"\n", at.throat) : "");
      }
      segments +=
          fmt::format("[[beam.segments]]\nlength = \"{:.12g} m\"\nfrom = \"s{}0\"\nto = \"s{}1\"\n",
                      of.length, i, i);
    }
    out += "[beam]\ndensity = \"7850 kg/m^3\"\n" + segments;
    for (const double s : diaphragms)
      out +=
          fmt::format("[[beam.diaphragms]]\nstation = \"{:.12g} m\"\nthickness = \"{} mm\"\n{}", s,
                      thickness, weld > 0.0 ? fmt::format("throat = \"{:.10g} mm\"\n", weld) : "");
    for (std::size_t i = 0; i < supports.size(); ++i) {
      const auto [s, z] = supports[i];
      const std::string at = space ? fmt::format("[\"{:.12g} m\", \"0 m\", \"{} m\"]", s, z)
                                   : fmt::format("\"{:.12g} m\"", s);
      if (i == 0) {
        out += fmt::format("[supports.a]\nkind = \"pinned\"\nat = {}\n{}", at,
                           space ? "fork = true\n" : "");
      } else if (space) {
        out += fmt::format(
            "[supports.z{}]\nkind = \"roller\"\nat = {}\ndirection = \"z\"\nfork = "
            "true\n[supports.y{}]\nkind = \"roller\"\nat = {}\ndirection = \"y\"\n",
            i, at, i, at);
      } else {
        out += fmt::format("[supports.z{}]\nkind = \"roller\"\nat = {}\n", i, at);
      }
    }
    for (const Load& of : forces) {
      if (space) {
        out += fmt::format(
            "[loads.{}]\nkind = \"force\"\nat = [\"{:.12g} m\", \"{:.12g} m\", \"{:.12g} "
            "m\"]\nforce = [\"0 kN\", \"{:.12g} kN\", \"{:.12g} kN\"]\nmoment = [\"{:.12g} kN m\", "
            "\"{:.12g} kN m\", \"0 kN m\"]\n",
            of.name, of.at, of.y, of.z, of.across, -of.down, of.torque, of.moment);
      } else {
        out += fmt::format(
            "[loads.{}]\nkind = \"force\"\nat = \"{:.12g} m\"\nforce = [\"0 kN\", \"{:.12g} "
            "kN\"]\nmoment = \"{:.12g} kN m\"\n",
            of.name, of.at, -of.down, of.moment);
      }
    }
    return out + more + "[material]\nsteel = \"S355\"\nfy_source = \"EN 1993-1-1\"\n[strength]\n" +
           fmt::format("required = {:.10g}\n", required);
  }

  Verification verified() const { return verify(parse_project("pressed.toml", text())); }
};

inline bool stops(const Verification& of, const std::string& part) {
  return std::any_of(of.gates.begin(), of.gates.end(), [&](const Gate& gate) {
    return gate.blocks && (gate.plate + " " + gate.finding).find(part) != std::string::npos;
  });
}

inline bool says(const Verification& of, const std::string& part) {
  return stops(of, part) ||
         std::any_of(of.not_judged.begin(), of.not_judged.end(), [&](const NotJudged& note) {
           return (note.what + " " + note.reason).find(part) != std::string::npos;
         });
}

/// The largest use of a criterion.
inline double use_of(const Verification& of, Criterion criterion) {
  double most = 0.0;
  for (const CheckResult& result : of.checks) {
    if (result.check.criterion == criterion) most = std::max(most, result.check.utilisation());
  }
  return most;
}

/// The same of checks whose place holds a text.
inline double use_at(const Verification& of, Criterion criterion, const std::string& text) {
  double most = 0.0;
  for (const CheckResult& result : of.checks) {
    if (result.check.criterion == criterion && result.check.point.find(text) != std::string::npos)
      most = std::max(most, result.check.utilisation());
  }
  return most;
}

inline std::string cycles(double count, const std::string& loads, const std::string& other = "") {
  return fmt::format(
      "[[situations]]\nname = \"off\"\nloads = {{ {} }}\n[[situations]]\nname = \"on\"\nloads = {{ "
      "{} }}\n[[situations]]\nname = \"change\"\nbetween = [\"off\", \"on\"]\ncycles = "
      "{:.3g}\n[fatigue]\nloading = \"spectrum\"\ncategory = 160\ngamma_Ff = 1.0\ngamma_Mf = "
      "1.35\nrequired = 1.0\n",
      other, loads, count);
}

inline std::string introduced(double from, double to, double stiff_length) {
  return fmt::format(
      "[[beam.load_introductions]]\nfrom = \"{} m\"\nto = \"{} m\"\nstiff_length = \"{} mm\"\n",
      from, to, stiff_length);
}

}  // namespace pressed_beams
