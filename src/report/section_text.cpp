#include "boxbeam/report/section_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "boxbeam/report/format.hpp"
#include "document_fields.hpp"
#include "profile_text.hpp"
#include "text_layout.hpp"

namespace boxbeam {
namespace {

std::string in(double value, double scale, const char* unit) {
  return fmt::format("{:.6g} {}", value == 0.0 ? 0.0 : value * scale, unit);
}

std::string place(const SectionPlace& at) {
  const auto mm = [](Length x) { return x.value() * 1e3; };
  return fmt::format("y {:.6g} mm, z {:.6g} mm", mm(at.y), mm(at.z));
}

using report::Field;
using report::Fields;

void put_shear(Fields& to, const Field& field, const SectionUnderForces* under, bool webs) {
  std::vector<PlateUnderForces> plates;
  if (under != nullptr) {
    for (const PlateUnderForces& plate : under->plates) {
      if (plate.web == webs) plates.push_back(plate);
    }
  }
  to.list(field, "{plate}", plates, [](Fields& of, const PlateUnderForces& plate) {
    of.text("plate", plate.sheared.name);
    of.number({"V_b_Rd", "of a panel without diaphragms, without the flanges' part"}, "N",
              plate.sheared.resists.resistance.value());
    of.number({"chi", "chi_w"}, "1", plate.sheared.resists.chi_w);
    of.number("utilisation", "1", plate.shear_use);
  });
}

const PlateUnderForces* reduced_of(const SectionUnderForces& under) {
  return under.reduced ? &under.plates[*under.reduced] : nullptr;
}

/// What forces do to the plates; all of it is absent without them.
void put_under(Fields& to, const SectionUnderForces* under) {
  const auto value = [&](const auto& of) { return [&] { return of(*under); }; };
  to.optional().whole({"class", "1 to 4, by the stress that is there; absent without forces"},
                      value([](const SectionUnderForces& of) { return of.section_class; }));
  to.optional().object({"effective", "EN 1993-1-5, 4; absent without forces"}, [&](Fields& of) {
    of.number("A", "m^2", value([](const SectionUnderForces& u) { return u.area.value(); }));
    of.number({"e_z", "shift of the centroid under N alone"}, "m",
              value([](const SectionUnderForces& u) { return u.shift_z.value(); }));
    of.number("e_y", "m", value([](const SectionUnderForces& u) { return u.shift_y.value(); }));
    of.number({"W_y", "at the place that is used most, signed"}, "m^3",
              value([](const SectionUnderForces& u) { return u.use.W_y.value(); }));
    of.number("W_z", "m^3", value([](const SectionUnderForces& u) { return u.use.W_z.value(); }));
    of.number("utilisation", "1", value([](const SectionUnderForces& u) { return u.use.use; }));
  });
  to.optional().object({"shear", "EN 1993-1-5, 5; absent without forces"}, [&](Fields& of) {
    put_shear(of, "webs", under, true);
    put_shear(of, "flanges", under, false);
  });
  to.optional().object({"interaction", "7.1; absent without forces"}, [&](Fields& of) {
    of.number("utilisation", "1",
              value([](const SectionUnderForces& u) { return u.interaction_use; }));
  });
  if (under != nullptr && !under->reduced) return;
  to.optional().object(
      {"reduced_stress",
       "clause 10, the plate that is used most; absent without forces, of paths, and where "
       "stiffeners divide a plate"},
      [&](Fields& of) {
        of.text("plate",
                value([](const SectionUnderForces& u) { return reduced_of(u)->sheared.name; }));
        const auto finite = [&](double ReducedStress::*which) -> std::optional<double> {
          const auto* const reduced = under == nullptr ? nullptr : reduced_of(*under);
          if (reduced == nullptr) return std::nullopt;
          const double of_plate = reduced->reduced.*which;
          return std::isfinite(of_plate) ? std::optional(of_plate) : std::nullopt;
        };
        of.number_or_null({"alpha_ult", "null where nothing acts"}, "1",
                          finite(&ReducedStress::alpha_ult));
        of.number_or_null({"alpha_cr", "null where nothing can buckle"}, "1",
                          finite(&ReducedStress::alpha_cr));
        of.number("utilisation", "1",
                  value([](const SectionUnderForces& u) { return reduced_of(u)->reduced.use; }));
      });
}

std::string under_text(const SectionUnderForces& under) {
  const SectionUse& use = under.use;
  std::string out =
      "\n" + layout::entry("class", fmt::format("{} under these forces", under.section_class));
  out += layout::entry(
      "effective",
      fmt::format("A_eff {}, centroid shifted by e_z {}, e_y {} (N alone); W_y,eff {}, W_z,eff {}",
                  in(under.area.value(), 1e6, "mm^2"), in(under.shift_z.value(), 1e3, "mm"),
                  in(under.shift_y.value(), 1e3, "mm"), in(std::abs(use.W_y.value()), 1e9, "mm^3"),
                  in(std::abs(use.W_z.value()), 1e9, "mm^3")));
  layout::Table table({"check", "plate", "resistance", "use [%]", "EN 1993-1-5"});
  const auto percent = [](double of) { return text::significant(100.0 * of, 3); };
  table.row({"effective section", under.place, text::MPa(use.yield_strength.value()),
             percent(use.use), "4.6"});
  for (const PlateUnderForces& plate : under.plates) {
    table.row({"shear buckling", plate.sheared.name,
               text::amount(plate.sheared.resists.resistance.value(), "N"),
               percent(plate.shear_use), "5.2"});
  }
  table.row({"interaction", "", "", percent(under.interaction_use), "7.1"});
  const PlateUnderForces* const reduced = reduced_of(under);
  if (reduced != nullptr) {
    table.row({"reduced stress", reduced->sheared.name, "", percent(reduced->reduced.use), "10"});
  }
  return out + "\n" + table.text() +
         layout::paragraph(
             std::string("partial factors 1; panels without diaphragms, end posts not rigid. ") +
             (reduced != nullptr ? "Two routes: effective widths with interaction, or reduced "
                                   "stress, which lets nothing yield elsewhere"
                                 : "Reduced stresses (10) are not computed of plates that "
                                   "stiffeners divide, nor of thin-walled paths"));
}

}  // namespace

void report::put_section_summary(Fields& to, const SectionSummary& summary) {
  const SectionProperties& p = summary.properties;
  const auto place = [&](const Field& field, const SectionPlace& at) {
    const double yz[] = {at.y.value(), at.z.value()};
    to.numbers(field, "m", yz, {"y", "z"});
  };
  to.constant("schema", "boxbeam.section/1");
  to.text("name", summary.section.name);
  to.number("area", "m^2", p.area.value());
  to.number("I_y", "m^4", p.I_y.value());
  to.number("I_z", "m^4", p.I_z.value());
  if (to.is_describing() || summary.torsion.I_T) {
    to.optional().number({"I_T", "absent where it is not known"}, "m^4",
                         [&] { return summary.torsion.I_T->value(); });
  }
  to.number("W_y", "m^3", p.W_y.value());
  to.number("W_z", "m^3", p.W_z.value());
  to.number("I_yz", "m^4", p.I_yz.value());
  to.number("I_1", "m^4", p.I_1.value());
  to.number("I_2", "m^4", p.I_2.value());
  to.number("principal_angle", "rad", p.principal_angle);
  place("centroid", {p.centroid_y, p.centroid_z});
  if (to.is_describing() || summary.torsion.shear_centre) {
    to.optional();
    place({"shear_centre", "absent where it is not known"},
          summary.torsion.shear_centre.value_or(SectionPlace{}));
  }
  to.number({"A_m", "inside the mid-lines of the walls"}, "m^2", summary.torsion.enclosed.value());
  to.text("steel", summary.steel);
  to.list("plates", "{plate}", summary.plates, [](Fields& of, const SlenderPlate& plate) {
    of.text("plate", plate.plate);
    of.number({"ratio", "c/t"}, "1", plate.ratio);
    of.whole({"class", "1 to 4"}, class_of(plate.ratio, plate.limits));
    const double limits[] = {plate.limits.class_1, plate.limits.class_2, plate.limits.class_3};
    of.numbers("limits", "1", limits, {"class_1", "class_2", "class_3"});
  });
  if (to.is_describing() || summary.under) put_under(to, summary.under.get());
}

std::string section_text(const SectionSummary& summary) {
  const SectionProperties& p = summary.properties;
  const TorsionProperties& torsion = summary.torsion;
  const Section& section = summary.section.section;
  std::string out = layout::heading(summary.section.name);
  out += layout::entry("profile", profile_text(section.outer));
  if (section.inner) out += layout::entry("inside", profile_text(*section.inner));
  out += layout::entry("A", in(p.area.value(), 1e6, "mm^2"));
  out += layout::entry("I_y", in(p.I_y.value(), 1e12, "mm^4"));
  out += layout::entry("I_z", in(p.I_z.value(), 1e12, "mm^4"));
  if (p.I_yz.value() != 0.0) {
    out += layout::entry("I_yz", in(p.I_yz.value(), 1e12, "mm^4"));
    out += layout::entry(
        "principal", fmt::format("{} and {}, the first about an axis {:.4g} deg from +y",
                                 in(p.I_1.value(), 1e12, "mm^4"), in(p.I_2.value(), 1e12, "mm^4"),
                                 p.principal_angle * 180.0 / std::numbers::pi));
  }
  out += layout::entry("W_y", in(p.W_y.value(), 1e9, "mm^3"));
  out += layout::entry("W_z", in(p.W_z.value(), 1e9, "mm^3"));
  out +=
      layout::entry("I_T", torsion.I_T ? in(torsion.I_T->value(), 1e12, "mm^4") + " (free warping)"
                                       : "not known for this kind of section");
  if (torsion.enclosed.value() > 0.0) {
    out += layout::entry("A_m", in(torsion.enclosed.value(), 1e6, "mm^2") + " inside mid-lines");
  }
  out += layout::entry("centroid", place({p.centroid_y, p.centroid_z}));
  if (torsion.shear_centre) out += layout::entry("shear centre", place(*torsion.shear_centre));
  if (!summary.section.source.empty()) {
    out += layout::entry(
        "source", summary.section.source + (summary.section.unconfirmed ? " (not confirmed)" : ""));
  }
  const std::string under = summary.under ? under_text(*summary.under) : "";
  if (summary.plates.empty()) return out + under;
  layout::Table table({"plate", "c/t", "class", "class 1 up to", "2", "3"});
  for (const SlenderPlate& plate : summary.plates) {
    table.row({plate.plate, text::significant(plate.ratio, 4),
               fmt::format("{}", class_of(plate.ratio, plate.limits)),
               text::significant(plate.limits.class_1, 4),
               text::significant(plate.limits.class_2, 4),
               text::significant(plate.limits.class_3, 4)});
  }
  return out + "\n" + table.text() +
         fmt::format("  {}, EN 1993-1-1:2005, table 5.2: flanges compressed, webs bent\n",
                     summary.steel) +
         under;
}

std::string section_json(const std::vector<SectionSummary>& summaries) {
  Json list = Json::array();
  for (const SectionSummary& summary : summaries) {
    Fields fields(list.emplace_back(Json::object()));
    report::put_section_summary(fields, summary);
  }
  return (list.size() == 1 ? list.front() : list).dump(2) + "\n";
}

}  // namespace boxbeam
