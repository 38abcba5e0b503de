#include "boxbeam/report/section_text.hpp"

#include <fmt/format.h>

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

}  // namespace

using report::Fields;

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
  if (summary.plates.empty()) return out;
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
                     summary.steel);
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
