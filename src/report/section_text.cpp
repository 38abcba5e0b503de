#include "boxbeam/report/section_text.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <numbers>

#include "boxbeam/report/format.hpp"
#include "profile_text.hpp"
#include "text_layout.hpp"

namespace boxbeam {
namespace {

using Json = nlohmann::ordered_json;

std::string in(double value, double scale, const char* unit) {
  return fmt::format("{:.6g} {}", value == 0.0 ? 0.0 : value * scale, unit);
}

std::string place(const SectionPlace& at) {
  const auto mm = [](Length x) { return x.value() * 1e3; };
  return fmt::format("y {:.6g} mm, z {:.6g} mm", mm(at.y), mm(at.z));
}

Json json_of(const SectionSummary& summary) {
  const SectionProperties& p = summary.properties;
  Json json{{"schema", "boxbeam.section/1"},
            {"name", summary.section.name},
            {"area", p.area.value()},
            {"I_y", p.I_y.value()},
            {"I_z", p.I_z.value()}};
  if (summary.torsion.I_T) json["I_T"] = summary.torsion.I_T->value();
  json["W_y"] = p.W_y.value();
  json["W_z"] = p.W_z.value();
  json["I_yz"] = p.I_yz.value();
  json["I_1"] = p.I_1.value();
  json["I_2"] = p.I_2.value();
  json["principal_angle"] = p.principal_angle;
  json["centroid"] = Json::array({p.centroid_y.value(), p.centroid_z.value()});
  if (summary.torsion.shear_centre) {
    json["shear_centre"] = Json::array(
        {summary.torsion.shear_centre->y.value(), summary.torsion.shear_centre->z.value()});
  }
  json["A_m"] = summary.torsion.enclosed.value();
  json["steel"] = summary.steel;
  json["plates"] = Json::array();
  for (const SlenderPlate& plate : summary.plates) {
    json["plates"].push_back({{"plate", plate.plate},
                              {"ratio", plate.ratio},
                              {"class", class_of(plate.ratio, plate.limits)},
                              {"limits", Json::array({plate.limits.class_1, plate.limits.class_2,
                                                      plate.limits.class_3})}});
  }
  return json;
}

}  // namespace

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
  if (summaries.size() == 1) return json_of(summaries.front()).dump(2) + "\n";
  Json list = Json::array();
  for (const SectionSummary& summary : summaries) list.push_back(json_of(summary));
  return list.dump(2) + "\n";
}

}  // namespace boxbeam
