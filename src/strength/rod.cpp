#include "boxbeam/strength/rod.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "boxbeam/section/section_properties.hpp"
#include "boxbeam/section/torsion.hpp"
#include "boxbeam/section/warping.hpp"
#include "boxbeam/strength/effective_path.hpp"
#include "boxbeam/strength/twisting_buckling.hpp"
#include "column_formulas.hpp"

namespace boxbeam {
namespace {

/// A, and A_eff in class 4.
Area area_of(const NoDerivation&, const PressedRod& rod) { return rod.section.effective; }

Traced area_of(Derivation& steps, const PressedRod& rod) {
  return derive_effective_area(steps, rod.section, rod.yield_strength);
}

/// m = A (e_z/W_y + e_y/W_z).
template <class Record, class A>
auto bent_by(Record& record, const A& area, const EccentricForce& of) {
  const auto e_z = record.given("e_z", of.e_z, "from the line of the rod to the centroid");
  const auto W_y = record.given("W_y", of.W_y, "the least of all places");
  const auto e_y = record.given("e_y", of.e_y, "from the line of the rod to the centroid");
  const auto W_z = record.given("W_z", of.W_z, "the least of all places");
  return record.define("m", area * (e_z / W_y + e_y / W_z));
}

/// Resistances as quantities or as expressions.
template <class Value>
struct Tension {
  Value plastic, net, least;
};
template <class Value>
Tension(Value, Value, Value) -> Tension<Value>;

template <class Record>
auto resist_tension(Record& record, const PulledRod& rod) {
  const auto A = record.given("A", rod.area);
  const auto A_net =
      record.given("A_net", rod.net_area.value_or(rod.area),
                   rod.net_area ? "given by the case" : "the case names no holes for fasteners");
  const auto f_y = record.known("f_y", rod.yield_strength);
  const auto f_u = record.known("f_u", rod.tensile_strength);
  const auto gamma_M0 = record.known("gamma_M0", rod.gamma_M0, {ValueKind::factor});
  const auto gamma_M2 = record.known("gamma_M2", rod.gamma_M2, {ValueKind::factor});
  const auto plastic = record.define("N_pl,Rd", A * f_y / gamma_M0);
  const auto net = record.define("N_u,Rd", 0.9 * A_net * f_u / gamma_M2);
  const auto least = record.define("N_t,Rd", least_of({plastic, net}), "limit");
  if (!rod.beside) return Tension{plastic, net, least};
  const auto m = bent_by(record, A, *rod.beside);
  return Tension{
      plastic, net,
      record.define("N_t,m", least / (1.0 + m), "with what N beside the centroid bends")};
}

/// N_cr of the rod, by bending about its weaker axis or by all ways at once.
template <class Record, class E, class I, class L>
auto critical_force(Record& record, const PressedRod& rod, const E& youngs_modulus,
                    const I& inertia, const L& length) {
  auto bending = column::euler_force(record, youngs_modulus, inertia, length);
  using Value = std::decay_t<decltype(bending)>;
  if (!rod.twisting) return bending;
  const TwistingRod& of = *rod.twisting;
  record.given("N_cr,y", of.about_y, "about y");
  record.given("N_cr,z", of.about_z, "about z");
  record.given("N_cr,T", of.by_twisting, "by twisting alone, (G I_T + pi^2 E I_w/L_T^2)/i_0^2");
  record.given("L_T", of.length, "between its ends, held against turning");
  record.given("y_0/i_0", of.y_0, {ValueKind::number}, "from centroid to shear centre");
  record.given("z_0/i_0", of.z_0, {ValueKind::number}, "likewise");
  return Value(record.given("N_cr,TF", of.critical(),
                            "by bending both ways and twisting at once (6.3.1.4), the least root "
                            "of (N - N_cr,y)(N - N_cr,z)(N - N_cr,T) i_0^2 = N^2 [z_0^2 (N - "
                            "N_cr,y) + y_0^2 (N - N_cr,z)]; less where y and z are no principal "
                            "axes"));
}

template <class Value, class Number>
struct Compression {
  Number slenderness, reduction;
  Value section, buckling, least;
};
template <class Value, class Number>
Compression(Number, Number, Value, Value, Value) -> Compression<Value, Number>;

template <class Record>
auto resist_compression(Record& record, const PressedRod& rod) {
  const auto A = area_of(record, rod);
  const auto I = record.given("I", rod.inertia);
  record.note([&] {
    return std::string("about the ") + (rod.weak_axis ? "z" : "y") + " axis, the weaker one";
  });
  const auto L_cr = record.given("L_cr", rod.buckling_length, "buckling length");
  const auto E = record.known("E", rod.youngs_modulus);
  const auto f_y = record.known("f_y", rod.yield_strength);
  const auto N_cr = critical_force(record, rod, E, I, L_cr);
  const auto lambda = column::slenderness(record, A, f_y, N_cr);
  const auto chi = column::reduction(record, lambda, rod.curve);
  const auto whole = column::resistance(record, chi, A, f_y, rod.gamma_M1);
  const auto gamma_M0 = record.known("gamma_M0", rod.gamma_M0, {ValueKind::factor});
  using Value = std::decay_t<decltype(whole)>;
  Value buckling = whole, of_section = A * f_y / gamma_M0;
  if (rod.beside) {
    const auto m = bent_by(record, A, *rod.beside);
    buckling = record.define("N_b,m", whole / (1.0 + 1.6 * chi * m),
                             "with what N beside the centroid bends, k = 1.6 at most (6.3.3)");
    of_section = A * f_y / (gamma_M0 * (1.0 + m));
  }
  if (of_section < buckling) {
    const Value section = record.define("N_c,Rd", of_section, "limit: the section itself (6.2.4)");
    return Compression{lambda, chi, section, buckling, section};
  }
  record.note([] { return "limit"; });
  return Compression{lambda, chi, of_section, buckling, buckling};
}

}  // namespace

Force TwistingRod::critical() const {
  const Force one = 1.0 * newton;
  return one / twisting_part({one / about_y, one / about_z, one / by_twisting, y_0, z_0, coupling});
}

namespace {

/// A thin-walled path by itself; nothing of other sections.
const ThinWalled* path_alone_in(const Section& section) {
  return section.inner ? nullptr : std::get_if<ThinWalled>(&section.outer);
}

/// The least of a whole section, on the safe side by the corners of the rectangle around it.
SectionModulus least_modulus_of(const SectionProperties& p, bool about_y) {
  const AreaSums sums = sums_of(p);
  double most = 0.0;
  for (const bool negative : {false, true})
    for (const Length& y : {p.y_left, p.y_right})
      for (const Length& z : {p.z_top, p.z_bottom})
        most = std::max(most, std::abs(most_per_moment(sums, moment_alone(about_y, negative),
                                                       y.value(), z.value())));
  return si<SectionModulus>(1.0 / most);
}

}  // namespace

std::string bent_plates_obstacle_of(const Section& section, Stress yield_strength) {
  if (path_alone_in(section) != nullptr) return "";
  const CompressedSection of = compressed_section_of(section, yield_strength);
  if (!of.obstacle.empty()) return of.obstacle;
  return of.class_4
             ? "its force acts beside its centroid (y = z = 0 of its section), and its plates "
               "of class 4 may buckle under what that bends, which is not computed (EN "
               "1993-1-5, 4.4)"
             : "";
}

std::optional<EccentricForce> eccentric_force_of(const Section& section, Stress yield_strength,
                                                 Length shift_y, Length shift_z) {
  const SectionProperties p = properties_of(section);
  const double nothing = 1e-9 * std::sqrt(p.area.value());
  const auto farther = [&](Length centroid, Length shift) {
    const Length most = std::max(abs(centroid), abs(Length(centroid + shift)), std::less<>());
    return most.value() > nothing ? most : Length{};
  };
  EccentricForce of{farther(p.centroid_y, shift_y), farther(p.centroid_z, shift_z), {}, {}};
  if (of.e_y == Length{} && of.e_z == Length{}) return std::nullopt;
  if (const ThinWalled* const path = path_alone_in(section)) {
    const EffectivePath works(*path_section_of(*path, steel_of(yield_strength)));
    of.W_y = works.least_modulus(true);
    of.W_z = works.least_modulus(false);
  } else {
    of.W_y = least_modulus_of(p, true);
    of.W_z = least_modulus_of(p, false);
  }
  return of;
}

std::string turning_obstacle_of(const Section& section, Length shift_y, Length shift_z) {
  if (enclosed_area_of(section.outer).value() > 0.0) return "";
  const SectionProperties p = properties_of(section);
  constexpr double alike = 1.0 + 1e-6, along_axis = 1e-6;
  if (!(p.I_1 > alike * p.I_2)) return "";
  const double nothing = 1e-9 * std::sqrt(p.area.value());
  const double c = std::cos(p.principal_angle), s = std::sin(p.principal_angle);
  for (const double part : {0.0, 1.0}) {
    const double y = (p.centroid_y + part * shift_y).value();
    const double z = (p.centroid_z + part * shift_z).value();
    // Across the axis that I_1 is about.
    if (!(std::abs(c * z - s * y) > std::max(along_axis * std::hypot(y, z), nothing))) continue;
    return fmt::format(
        "its force acts {:.3g} mm beside its centroid along z and {:.3g} mm along y (y = z = 0 of "
        "its section, which buckling walls may move), and may turn the open section over, which "
        "is not computed (EN 1993-1-1, 6.3.3)",
        1e3 * std::abs(z), 1e3 * std::abs(y));
  }
  return "";
}

std::optional<TwistingRod> twisting_rod_of(const Section& section, Stress youngs_modulus,
                                           Length buckling_length, Length between) {
  const auto is_path = [](const Profile& of) { return std::holds_alternative<ThinWalled>(of); };
  if (!is_path(section.outer) && !(section.inner && is_path(*section.inner))) return std::nullopt;
  const TorsionProperties torsion = torsion_properties_of(section);
  if (!torsion.I_T || !torsion.shear_centre) return std::nullopt;
  // EN 1993-1-1, 3.2.6.
  constexpr double poisson = 0.3;
  const double E = youngs_modulus.value(), G = E / (2.0 * (1.0 + poisson));
  const SectionProperties p = properties_of(section);
  const double y = (torsion.shear_centre->y - p.centroid_y).value();
  const double z = (torsion.shear_centre->z - p.centroid_z).value();
  const double radius_squared = (p.I_y + p.I_z).value() / p.area.value() + y * y + z * z;
  const double EI_w = section.inner ? 0.0 : E * warping_constant_of(section.outer).value_or(0.0);
  TwistingRod of;
  of.length = std::max(buckling_length, between, std::less<>());
  of.about_y = euler_force(youngs_modulus, p.I_y, buckling_length);
  of.about_z = euler_force(youngs_modulus, p.I_z, buckling_length);
  of.by_twisting = si<Force>(
      1.0 / twisting_per_force(G * torsion.I_T->value(), EI_w, of.length.value(), radius_squared));
  of.y_0 = std::abs(y) / std::sqrt(radius_squared);
  of.z_0 = std::abs(z) / std::sqrt(radius_squared);
  of.coupling = std::abs(p.I_yz.value()) / std::sqrt(p.I_y.value() * p.I_z.value());
  return of;
}

TensionResistance tension_resistance_of(const PulledRod& rod) {
  const auto of = resist_tension(plainly, rod);
  return {of.plastic, of.net, of.least};
}

void derive_tension_factor(Derivation& steps, const Traced& tension, const PulledRod& rod) {
  const Traced resistance = resist_tension(steps, rod).least;
  steps.define("factor", resistance / tension);
}

CompressionResistance compression_resistance_of(const PressedRod& rod) {
  const auto of = resist_compression(plainly, rod);
  return {of.slenderness, of.reduction, of.section, of.buckling, of.least};
}

void derive_compression_factor(Derivation& steps, const Traced& compression,
                               const PressedRod& rod) {
  const Traced resistance = resist_compression(steps, rod).least;
  steps.define("factor", resistance / compression);
}

}  // namespace boxbeam
