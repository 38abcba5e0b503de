#include "neighbour_steps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "boxbeam/report/format.hpp"
#include "boxbeam/section/section_properties.hpp"
#include "boxbeam/strength/section_class.hpp"

namespace boxbeam::report {
namespace {

template <class Inputs>
const auto& named(const Inputs& inputs, const std::string& name) {
  return *std::find_if(inputs.begin(), inputs.end(),
                       [&](const auto& input) { return input.name == name; });
}

std::string at_time(const Check& check, const std::string& what) {
  return fmt::format("at t = {}{}, {}", text::seconds(check.time.value()),
                     check.situation.empty() ? "" : ", " + check.situation, what);
}

}  // namespace

Steps pin_steps(const Project& project, const NeighbourResult& result) {
  const Check& check = result.check;
  const PinInput& pin = named(project.pins, check.point);
  const PinJoint& joint = pin.geometry;
  const PinStrength& strength = pin.strength;
  const std::string F = text::kN(check.acting.value());
  const std::string d = text::mm(joint.diameter.value()), b = text::mm(joint.inner_plate.value()),
                    a = text::mm(joint.outer_plate.value()), c = text::mm(joint.gap.value());
  const std::string gamma_M0 = number(strength.gamma_M0), gamma_M2 = number(strength.gamma_M2);
  const double A = pin_shear_resistance(joint, strength) * strength.gamma_M2 /
                   (0.6 * strength.pin_tensile) / (metre * metre);
  Steps steps{{"F", {F}, {at_time(check, "the largest force of the joint")}},
              {"d", {d}, {"pin"}},
              {"a", {a}, {"each outer plate"}},
              {"b", {b}, {"inner plate"}},
              {"c", {c}, {"gap between them"}}};
  steps.push_back({"A", {"pi d^2/4", fmt::format("pi x ({})^2/4", d), mm2(A)}, {}});
  const double F_v = pin_shear_resistance(joint, strength).value();
  steps.push_back(
      {"F_v,Rd",
       {"0.6 A f_up/gamma_M2",
        fmt::format("0.6 x {} x {}/{}", mm2(A), text::MPa(strength.pin_tensile.value()), gamma_M2),
        text::kN(F_v)},
       {"shear, one plane"}});
  const auto use = [&](const char* symbol, const char* formula, const std::string& values,
                       double value) {
    steps.push_back({symbol, {formula, values, text::significant(value)}, {}});
  };
  use("u_v", "F/(2 F_v,Rd)", fmt::format("{}/(2 x {})", F, text::kN(F_v)), result.pin.shear);
  const auto bearing = [&](const char* resistance, const char* formula, const std::string& plate,
                           Length thickness, Stress yield, const char* what) {
    const double f_y = std::min(yield, strength.pin_yield).value();
    const double F_b = pin_bearing_resistance(thickness, yield, joint, strength).value();
    steps.push_back(
        {resistance,
         {formula, fmt::format("1.5 x {} x {} x {}/{}", plate, d, text::MPa(f_y), gamma_M0),
          text::kN(F_b)},
         {what}});
    return text::kN(F_b);
  };
  const std::string inner =
      bearing("F_b,Rd", "1.5 b d f_y/gamma_M0", b, joint.inner_plate, strength.inner_yield,
              "bearing of the inner plate; f_y the lower of plate and pin");
  use("u_b", "F/F_b,Rd", fmt::format("{}/{}", F, inner), result.pin.bearing_inner);
  const std::string outer = bearing("F_a,Rd", "1.5 a d f_y/gamma_M0", a, joint.outer_plate,
                                    strength.outer_yield, "bearing of each outer plate");
  use("u_a", "F/(2 F_a,Rd)", fmt::format("{}/(2 x {})", F, outer), result.pin.bearing_outer);
  const double M_Ed = pin_moment(si<Force>(check.acting.value()), joint).value();
  const double M_Rd = pin_bending_resistance(joint, strength).value();
  const double W = M_Rd * strength.gamma_M0 / (1.5 * strength.pin_yield.value());
  steps.push_back({"M_Ed",
                   {"F (b + 4 c + 2 a)/8", fmt::format("{} x ({} + 4 x {} + 2 x {})/8", F, b, c, a),
                    text::kNm(M_Ed)},
                   {}});
  steps.push_back({"W_el", {"pi d^3/32", fmt::format("pi x ({})^3/32", d), mm3(W)}, {}});
  steps.push_back(
      {"M_Rd",
       {"1.5 W_el f_yp/gamma_M0",
        fmt::format("1.5 x {} x {}/{}", mm3(W), text::MPa(strength.pin_yield.value()), gamma_M0),
        text::kNm(M_Rd)},
       {}});
  use("u_m", "M_Ed/M_Rd", fmt::format("{}/{}", text::kNm(M_Ed), text::kNm(M_Rd)),
      result.pin.bending);
  use("u_c", "u_m^2 + u_v^2",
      fmt::format("{}^2 + {}^2", text::significant(result.pin.bending),
                  text::significant(result.pin.shear)),
      result.pin.combined);
  steps.push_back(
      {"factor",
       {"1/max(u_v, u_b, u_a, u_m, sqrt(u_c))",
        fmt::format("1/max({}, {}, {}, {}, sqrt({}))", text::significant(result.pin.shear),
                    text::significant(result.pin.bearing_inner),
                    text::significant(result.pin.bearing_outer),
                    text::significant(result.pin.bending), text::significant(result.pin.combined)),
        text::significant(check.safety_factor, 4)},
       {"on the force, with which u_c grows by its square"}});
  return steps;
}

Steps pulled_rod_steps(const Project& project, const NeighbourResult& result) {
  const Check& check = result.check;
  const RodInput& rod = named(project.rods, check.point);
  const Area whole = properties_of(rod.section).area;
  const std::string A = mm2(whole.value()), A_net = mm2(rod.net_area.value_or(whole).value()),
                    f_y = text::MPa(rod.yield_strength.value()),
                    f_u = text::MPa(rod.tensile_strength.value()),
                    plastic = text::kN(result.plastic.value()), net = text::kN(result.net.value());
  return {{"N", {text::kN(check.acting.value())}, {at_time(check, "the largest tension")}},
          {"A", {A}, {}},
          {"A_net",
           {A_net},
           {rod.net_area ? "given by the case" : "the case names no holes for fasteners"}},
          {"N_pl,Rd",
           {"A f_y/gamma_M0", fmt::format("{} x {}/{}", A, f_y, number(rod.gamma_M0)), plastic},
           {}},
          {"N_u,Rd",
           {"0.9 A_net f_u/gamma_M2",
            fmt::format("0.9 x {} x {}/{}", A_net, f_u, number(rod.gamma_M2)), net},
           {}},
          {"N_t,Rd",
           {fmt::format("min({}, {})", plastic, net), text::kN(check.resisting.value())},
           {"limit"}},
          {"factor",
           {"N_t,Rd/N",
            fmt::format("{}/{}", text::kN(check.resisting.value()), text::kN(check.acting.value())),
            text::significant(check.safety_factor, 4)},
           {}}};
}

namespace {

/// What an internal plate in class 4 leaves effective of itself.
Steps effective_plate_steps(const CompressedPlate& plate, const std::string& epsilon) {
  const std::string c = text::mm((plate.ratio * plate.thickness).value()),
                    t = text::mm(plate.thickness.value()),
                    lambda = text::significant(plate.lambda_p), rho = text::significant(plate.rho);
  return {{"c", {c}, {plate.name}},
          {"t", {t}, {}},
          {"lambda_p",
           {"c/(t 28.4 epsilon sqrt(4))",
            fmt::format("{}/({} x 28.4 x {} x sqrt(4))", c, t, epsilon), lambda},
           {"k_sigma = 4: even compression (EN 1993-1-5, 4.4)"}},
          {"rho",
           {"(lambda_p - 0.22)/lambda_p^2", fmt::format("({0} - 0.22)/{0}^2", lambda), rho},
           {"psi = 1"}},
          {"A_c",
           {"2 (1 - rho) c t", fmt::format("2 x (1 - {}) x {} x {}", rho, c, t),
            mm2(plate.idle.value())},
           {fmt::format("not effective of both plates, {}", plate.name)}}};
}

/// The class of the rod's section by its own plates, and its effective area in class 4.
Steps class_steps(const RodInput& rod, const CompressedSection& section) {
  if (section.plates.empty()) return {};
  const CompressedPlate& worst = *std::max_element(
      section.plates.begin(), section.plates.end(),
      [](const auto& a, const auto& b) { return a.ratio / a.limit < b.ratio / b.limit; });
  const bool round = std::holds_alternative<RoundTube>(rod.section.outer);
  const double eps = epsilon_of(rod.yield_strength);
  const std::string epsilon = text::significant(eps);
  Steps steps{
      {"epsilon",
       {"sqrt(235 MPa/f_y)",
        fmt::format("sqrt(235 MPa/({}))", text::MPa(rod.yield_strength.value())), epsilon},
       {}},
      {round ? "d/t" : "c/t",
       {text::significant(worst.ratio)},
       {fmt::format("{}, of class 3 or better up to {} (EN 1993-1-1, table 5.2){}", worst.name,
                    text::significant(worst.limit), section.class_4 ? ": class 4" : "")}}};
  if (!section.class_4) return steps;
  std::string sum = mm2(section.area.value());
  for (const CompressedPlate& plate : section.plates) {
    if (plate.rho == 1.0) continue;
    append(steps, effective_plate_steps(plate, epsilon));
    sum += " - " + mm2(plate.idle.value());
  }
  steps.push_back({"A_eff", {sum, mm2(section.effective.value())}, {"A less what is idle"}});
  return steps;
}

}  // namespace

Steps pressed_rod_steps(const Project& project, const NeighbourResult& result) {
  const Check& check = result.check;
  const RodInput& rod = named(project.rods, check.point);
  const SectionProperties properties = properties_of(rod.section);
  const std::string A = mm2(properties.area.value()), I = mm4(properties.I_2.value()),
                    L = text::mm(rod.buckling_length.value()),
                    f_y = text::MPa(rod.yield_strength.value());
  const double lambda = result.slenderness;
  const double chi = result.reduction;
  const double alpha = imperfection_factor(rod.curve);
  const std::string area = result.section.class_4 ? "A_eff" : "A";
  const std::string A_eff = mm2(result.section.effective.value());
  const double N_cr = (result.section.effective * rod.yield_strength).value() / (lambda * lambda);
  const double phi = 0.5 * (1.0 + alpha * (lambda - 0.2) + lambda * lambda);
  const std::string l = text::significant(lambda), p = text::significant(phi);
  Steps steps{{"N", {text::kN(check.acting.value())}, {at_time(check, "the largest compression")}},
              {"A", {A}, {}}};
  append(steps, class_steps(rod, result.section));
  append(
      steps,
      {{"I", {I}, {fmt::format("about the {} axis, the weaker one", result.weak_axis ? "z" : "y")}},
       {"L_cr", {L}, {"buckling length"}},
       {"N_cr",
        {"pi^2 E I/L_cr^2", fmt::format("pi^2 x 210000 MPa x {}/({})^2", I, L), text::kN(N_cr)},
        {}},
       {"lambda",
        {fmt::format("sqrt({} f_y/N_cr)", area),
         fmt::format("sqrt({} x {}/{})", A_eff, f_y, text::kN(N_cr)), l},
        {}}});
  const char* const curve =
      std::array{"a0", "a", "b", "c", "d"}[static_cast<std::size_t>(rod.curve)];
  if (lambda <= 0.2) {
    steps.push_back({"chi", {number(chi)}, {"lambda is not above 0.2: no reduction"}});
  } else {
    steps.push_back({"phi",
                     {"0.5 (1 + alpha (lambda - 0.2) + lambda^2)",
                      fmt::format("0.5 x (1 + {} x ({} - 0.2) + {}^2)", number(alpha), l, l), p},
                     {fmt::format("buckling curve {}", curve)}});
    steps.push_back({"chi",
                     {"1/(phi + sqrt(phi^2 - lambda^2))",
                      fmt::format("1/({0} + sqrt({0}^2 - {1}^2))", p, l), text::significant(chi)},
                     {}});
  }
  const std::string chi_text = lambda <= 0.2 ? number(chi) : text::significant(chi);
  steps.push_back({"N_b,Rd",
                   {fmt::format("chi {} f_y/gamma_M1", area),
                    fmt::format("{} x {} x {}/{}", chi_text, A_eff, f_y, number(rod.gamma_M1)),
                    text::kN(check.resisting.value())},
                   {"limit"}});
  steps.push_back(
      {"factor",
       {"N_b,Rd/N",
        fmt::format("{}/{}", text::kN(check.resisting.value()), text::kN(check.acting.value())),
        text::significant(check.safety_factor, 4)},
       {}});
  return steps;
}

}  // namespace boxbeam::report
