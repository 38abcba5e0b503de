#include "section_steps.hpp"

#include <fmt/format.h>

#include <cctype>
#include <cmath>
#include <optional>

#include "boxbeam/report/format.hpp"

namespace boxbeam::report {
namespace {

std::string kind_of(const StressPoint& point) {
  if (point.lag || point.web_lag) return "eff";
  return point.net.area == point.gross.area ? "" : "net";
}

/// A box of equal flanges and equal webs without anything inside. In metres: B, H outside, b, h
/// inside.
struct PlainBox {
  double B, H, b, h, flange, web;
};

std::optional<PlainBox> plain_box_of(const Section& section) {
  const auto* box = std::get_if<Box>(&section.outer);
  if (box == nullptr || section.inner || !box->stiffeners.empty()) return std::nullopt;
  if (box->top_flange != box->bottom_flange || box->left_web != box->right_web) return std::nullopt;
  const double flange = box->top_flange.value(), web = box->left_web.value();
  const double B = box->width.value(), H = box->height.value();
  return PlainBox{B, H, B - 2.0 * web, H - 2.0 * flange, flange, web};
}

Steps plain_box_steps(const PlainBox& box, const SectionProperties& gross, bool space) {
  const std::string B = text::mm(box.B), H = text::mm(box.H), b = text::mm(box.b),
                    h = text::mm(box.h);
  const auto inertia = [](const std::string& wide, const std::string& high,
                          const std::string& wide_inside, const std::string& high_inside) {
    return fmt::format("({} x ({})^3 - {} x ({})^3)/12", wide, high, wide_inside, high_inside);
  };
  Steps steps{{"A",
               {"B H - b h", fmt::format("{} x {} - {} x {}", B, H, b, h), mm2(gross.area.value())},
               {"box, outside B x H, inside b x h"}},
              {"I_y", {"(B H^3 - b h^3)/12", inertia(B, H, b, h), mm4(gross.I_y.value())}, {}}};
  if (space) {
    steps.push_back(
        {"I_z", {"(H B^3 - h b^3)/12", inertia(H, B, h, b), mm4(gross.I_z.value())}, {}});
  }
  return steps;
}

/// The factor of EN 1993-1-5 table 3.1 that a stretch of the beam has.
struct TableFactor {
  const char* formula;
  const char* where;
};

TableFactor table_factor_of(const ShearLag& lag) {
  const bool wide = lag.kappa > 0.7;
  if (lag.region == BendingRegion::sagging) {
    return {wide ? "1/(5.9 kappa)" : "1/(1 + 6.4 kappa^2)",
            "beta_1 of table 3.1, sagging: no force makes a peak of the moment in this stretch"};
  }
  return {wide ? "1/(8.6 kappa)" : "1/(1 + 6 (kappa - 1/(2500 kappa)) + 1.6 kappa^2)",
          lag.region == BendingRegion::cantilever
              ? "beta_2 of table 3.1, cantilever: the moment is largest at the clamped end"
              : "beta_2 of table 3.1, hogging: a force makes a peak of the moment in this stretch"};
}

/// A formula with a value in the place of a symbol.
std::string with(std::string formula, const std::string& symbol, const std::string& value) {
  const bool number = std::isdigit(static_cast<unsigned char>(value.front())) != 0;
  for (std::size_t at = formula.find(symbol); at != std::string::npos;
       at = formula.find(symbol, at + value.size())) {
    // A product of two numbers needs its sign.
    const bool behind_number = number && at > 1 && formula[at - 1] == ' ' &&
                               std::isdigit(static_cast<unsigned char>(formula[at - 2])) != 0;
    formula.replace(at, symbol.size(), (behind_number ? "x " : "") + value);
  }
  return formula;
}

/// With more digits than others, for what counts is what is missing to one.
std::string beta_text(const ShearLag& lag) { return text::significant(lag.beta, 6); }

/// Of the flanges, or of the webs, whose symbols have an index.
Steps shear_lag_steps(const ShearLag& lag, const std::string& of, const std::string& index) {
  Steps steps;
  const std::string b_0 = text::mm(lag.b_0.value());
  const std::string L_e = text::mm(lag.effective_length.value());
  const double alpha = lag.kappa * (lag.effective_length / lag.b_0);
  constexpr double round_off = 1e-9;
  Step kappa{"kappa" + index, {"b_0/L_e", fmt::format("{}/{}", b_0, L_e)}, {}};
  if (std::abs(alpha - 1.0) > round_off) {
    steps.push_back({"alpha_0",
                     {"sqrt(1 + A_sl/(b_0 t))", text::significant(alpha)},
                     {"stiffeners of the " + of}});
    kappa.formulas = {"alpha_0 b_0/L_e",
                      fmt::format("{} x {}/{}", text::significant(alpha), b_0, L_e)};
  }
  kappa.formulas.push_back(text::significant(lag.kappa, 5));
  kappa.notes.push_back(
      fmt::format("shear lag of the {}: half their width over the length between "
                  "zero moments; EN 1993-1-5, 3.2.1",
                  of));
  steps.push_back(kappa);
  const std::string value = beta_text(lag);
  if (lag.beta == 1.0) {
    steps.push_back({"beta" + index, {value}, {"no reduction for so small a kappa"}});
    return steps;
  }
  const auto [formula, where] = table_factor_of(lag);
  steps.push_back({"beta" + index,
                   {with(formula, "kappa", "kappa" + index),
                    with(formula, "kappa", text::significant(lag.kappa, 5)), value},
                   {where}});
  return steps;
}

/// Width of what is idle in the middle of each plate [m].
double idle_of(const std::optional<ShearLag>& lag) {
  return lag ? 2.0 * (1.0 - lag->beta) * lag->b_0.value() : 0.0;
}

/// What is idle in flanges (b_i) and webs (h_i) of a plain box.
struct IdleStrips {
  double b_i = 0.0, h_i = 0.0;
};

double cube(double x) { return x * x * x; }

/// The strips, where they alone make the difference between gross and effective section.
std::optional<IdleStrips> strips_of(const PlainBox& box, const StressPoint& point) {
  const IdleStrips idle{idle_of(point.lag), idle_of(point.web_lag)};
  const auto near = [](double a, double b) {
    constexpr double round_off = 1e-9;
    return std::abs(a - b) <= round_off * std::abs(b);
  };
  const SectionProperties &gross = point.gross, &net = point.net;
  const bool by_strips =
      near(gross.area.value() - 2.0 * idle.b_i * box.flange - 2.0 * idle.h_i * box.web,
           net.area.value()) &&
      near(gross.I_y.value() - idle.b_i * (cube(box.H) - cube(box.h)) / 12.0 -
               box.web * cube(idle.h_i) / 6.0,
           net.I_y.value()) &&
      near(gross.I_z.value() - idle.h_i * (cube(box.B) - cube(box.b)) / 12.0 -
               box.flange * cube(idle.b_i) / 6.0,
           net.I_z.value());
  return by_strips ? std::optional(idle) : std::nullopt;
}

Step idle_step(const char* symbol, const ShearLag& lag, const std::string& index, double idle,
               const char* what) {
  return {symbol,
          {"2 (1 - beta" + index + ") b_0",
           fmt::format("2 x (1 - {}) x {}", text::significant(lag.beta), text::mm(lag.b_0.value())),
           text::mm(idle)},
          {what}};
}

/// Plates whose idle strips lie across the axis of a moment of inertia, and those along it.
struct Strips {
  std::string depths;  ///< "(H^3 - h^3)", between which the strips across lie
  double outside = 0.0, inside = 0.0;
  std::string across_symbol;  ///< "b_i"
  double across = 0.0;
  std::string along_symbol;  ///< "t_w h_i^3"
  double along = 0.0, thickness = 0.0;
};

Step effective_inertia_step(const std::string& of, double whole, double effective,
                            const Strips& strips) {
  std::string formula = of, values = mm4(whole);
  if (strips.across > 0.0) {
    formula += fmt::format(" - {} {}/12", strips.across_symbol, strips.depths);
    values += fmt::format(" - {} x (({})^3 - ({})^3)/12", text::mm(strips.across),
                          text::mm(strips.outside), text::mm(strips.inside));
  }
  if (strips.along > 0.0) {
    formula += fmt::format(" - {}/6", strips.along_symbol);
    values += fmt::format(" - {} x ({})^3/6", text::mm(strips.thickness), text::mm(strips.along));
  }
  return {of + ",eff", {formula, values, mm4(effective)}, {}};
}

Steps effective_box_steps(const PlainBox& box, const IdleStrips& idle, const StressPoint& point,
                          bool space) {
  Steps steps;
  std::string formula = "A", values = mm2(point.gross.area.value());
  if (point.lag) {
    steps.push_back(idle_step("b_i", *point.lag, "", idle.b_i, "idle width of each flange"));
    formula += " - 2 b_i t_f";
    values += fmt::format(" - 2 x {} x {}", text::mm(idle.b_i), text::mm(box.flange));
  }
  if (point.web_lag) {
    steps.push_back(idle_step("h_i", *point.web_lag, "_web", idle.h_i, "idle width of each web"));
    formula += " - 2 h_i t_w";
    values += fmt::format(" - 2 x {} x {}", text::mm(idle.h_i), text::mm(box.web));
  }
  steps.push_back({"A_eff", {formula, values, mm2(point.net.area.value())}, {}});
  steps.push_back(effective_inertia_step(
      "I_y", point.gross.I_y.value(), point.net.I_y.value(),
      {"(H^3 - h^3)", box.H, box.h, "b_i", idle.b_i, "t_w h_i^3", idle.h_i, box.web}));
  if (space) {
    steps.push_back(effective_inertia_step(
        "I_z", point.gross.I_z.value(), point.net.I_z.value(),
        {"(B^3 - b^3)", box.B, box.b, "h_i", idle.h_i, "t_f b_i^3", idle.b_i, box.flange}));
  }
  return steps;
}

/// Where no formula of a few letters gives the section.
Steps value_steps(const StressPoint& point, bool space) {
  const std::string kind = kind_of(point);
  const char* note = "along the border of the section";
  if (kind == "eff") note = "less what shear lag leaves idle, and holes";
  if (kind == "net") note = "less holes";
  Steps steps{{area_symbol(point), {mm2(point.net.area.value())}, {note}},
              {inertia_symbol("I_y", point), {mm4(point.net.I_y.value())}, {}}};
  const bool skew = point.net.I_yz.value() != 0.0;
  if (space || skew)
    steps.push_back({inertia_symbol("I_z", point), {mm4(point.net.I_z.value())}, {}});
  if (skew) steps.push_back({inertia_symbol("I_yz", point), {mm4(point.net.I_yz.value())}, {}});
  return steps;
}

}  // namespace

std::string area_symbol(const StressPoint& point) {
  const std::string kind = kind_of(point);
  return kind.empty() ? "A" : "A_" + kind;
}

std::string inertia_symbol(const std::string& of, const StressPoint& point) {
  const std::string kind = kind_of(point);
  return kind.empty() ? of : of + "," + kind;
}

Steps section_steps(const Project& project, const StressPoint& point) {
  const bool space = project.in_space;
  const std::optional<PlainBox> box = plain_box_of(point.section);
  Steps steps;
  if (box) append(steps, plain_box_steps(*box, point.gross, space));
  if (point.lag) append(steps, shear_lag_steps(*point.lag, "flanges", ""));
  if (point.web_lag) append(steps, shear_lag_steps(*point.web_lag, "webs", "_web"));
  if (box && kind_of(point).empty()) return steps;
  const auto idle = box && kind_of(point) == "eff" ? strips_of(*box, point) : std::nullopt;
  append(steps, idle ? effective_box_steps(*box, *idle, point, space) : value_steps(point, space));
  return steps;
}

}  // namespace boxbeam::report
