// What works of a stiffened plate under direct stress.
#include <algorithm>
#include <cmath>
#include <limits>

#include "boxbeam/strength/stiffened_plate.hpp"
#include "out_of_plate.hpp"
#include "stiffened_formulas.hpp"

namespace boxbeam {
namespace {

/// Where no buckling factor is given any more, that of this stress ratio is taken.
constexpr double least_psi = -3.0;

double ratio_of(double smaller, double larger) { return std::max(least_psi, smaller / larger); }

/// A piece of plate between stiffeners or edges, in the frame of a plate whose first edge is
/// compressed most: `from` is compressed more than `to`.
struct PanelPart {
  double from = 0.0, to = 0.0;
  bool pressed = false;
  double compressed = 0.0;         ///< gross width, counted from `from`
  double first = 0.0, last = 0.0;  ///< of it the gross parts that go with both its borders
  double rho = 1.0;
  double psi = 1.0;
  EffectiveWidth effective;

  double width() const { return to - from; }
};

/// The plate, and its stress, from the edge that is compressed most. SI.
class Oriented {
 public:
  Oriented(const StiffenedPlate& plate, double at_low, double at_high, bool from_high)
      : plate_(&plate), from_high_(from_high), b_((plate.high - plate.low).value()) {
    first_ = from_high ? at_high : at_low;
    psi_ = (from_high ? at_low : at_high) / first_;
    for (std::size_t k = 0; k < plate.stiffeners.size(); ++k)
      order_.push_back(from_high ? plate.stiffeners.size() - 1 - k : k);
  }

  double width() const { return b_; }
  double psi() const { return psi_; }
  std::size_t count() const { return order_.size(); }
  std::size_t index(std::size_t k) const { return order_[k]; }
  const FlatStiffener& stiffener(std::size_t k) const { return plate_->stiffeners[order_[k]]; }
  double place(std::size_t k) const { return along(stiffener(k).place); }
  double along(Length place) const {
    return (from_high_ ? plate_->high - place : place - plate_->low).value();
  }
  /// Over that of the first edge.
  double stress(double x) const { return 1.0 - (1.0 - psi_) * x / b_; }

  WorkingStrip strip(double from, double to, double works) const {
    const auto at = [&](double x) {
      return from_high_ ? plate_->high - si<Length>(x) : plate_->low + si<Length>(x);
    };
    return from_high_ ? WorkingStrip{at(to), at(from), works}
                      : WorkingStrip{at(from), at(to), works};
  }
  bool from_high() const { return from_high_; }

 private:
  const StiffenedPlate* plate_;
  bool from_high_;
  double b_, first_ = 0.0, psi_ = 1.0;
  std::vector<std::size_t> order_;
};

PanelPart subpanel_of(const StiffenedPlate& plate, const Oriented& in, double from, double to) {
  PanelPart of;
  of.from = from;
  of.to = to;
  const double most = in.stress(from);
  of.pressed = most > 0.0 && to > from;
  if (!of.pressed) return of;
  const double psi = ratio_of(std::min(most, in.stress(to)), most);
  const auto width = panel_effective_width(si<Length>(of.width()), plate.thickness, psi,
                                           plate.yield_strength, plate.length);
  of.rho = width->rho;
  of.psi = psi;
  of.effective = *width;
  of.compressed = of.width() / std::max(1.0, 1.0 - psi);
  of.first = width->b_e1.value() / width->rho;
  of.last = of.compressed - of.first;
  return of;
}

/// The stiffener with what of both subpanels beside it goes with it.
StiffenerColumn column_of(const StiffenedPlate& plate, const Oriented& in, std::size_t k,
                          const PanelPart& before, const PanelPart& behind) {
  const FlatStiffener& flat = in.stiffener(k);
  const double t = plate.thickness.value(), under = flat.thickness.value();
  OutOfPlate of;
  of.add_plate(before.last + under + behind.first, t);
  of.add(flat, t);
  StiffenerColumn column;
  column.place = flat.place;
  column.area = si<Area>(of.area);
  column.inertia = si<SecondMoment>(of.inertia());
  column.effective = si<Area>(
      of.area - t * ((1.0 - before.rho) * before.last + (1.0 - behind.rho) * behind.first));
  const double at = 0.5 * (plate.thickness + flat.depth).value();
  column.e = si<Length>(std::max(of.centroid(), at - of.centroid()));
  column.stress = in.stress(in.place(k));
  return column;
}

/// Alike stiffeners at equal distances, as far as smearing them asks for.
bool is_even(const StiffenedPlate& plate) {
  constexpr double alike = 1.1;
  double narrowest = std::numeric_limits<double>::infinity(), widest = 0.0;
  Length from = plate.low;
  const auto look = [&](Length to) {
    narrowest = std::min(narrowest, (to - from).value());
    widest = std::max(widest, (to - from).value());
    from = to;
  };
  for (const FlatStiffener& of : plate.stiffeners) look(of.place);
  look(plate.high);
  const FlatStiffener& first = plate.stiffeners.front();
  return widest <= alike * narrowest &&
         std::all_of(plate.stiffeners.begin(), plate.stiffeners.end(), [&](const auto& of) {
           return of.depth == first.depth && of.thickness == first.thickness;
         });
}

/// sigma_cr,p by A.2 of a column between supports of the plate.
void take_held(StiffenerBuckling& of, const StiffenedPlate& plate, const StiffenerColumn& column,
               double b_1, double b_2) {
  const Stress at_edge = held_column_stress(column.area, column.inertia, si<Length>(b_1),
                                            si<Length>(b_2), plate.thickness, plate.length) /
                         column.stress;
  if (of.sigma_cr_p > Stress{} && at_edge >= of.sigma_cr_p) return;
  of.sigma_cr_p = at_edge;
  of.held = column;
  of.b_1 = si<Length>(b_1);
  of.b_2 = si<Length>(b_2);
}

/// Both stiffeners as one, where the resultant of their forces is.
StiffenerColumn together(const StiffenedPlate& plate, const Oriented& in, const StiffenerColumn& a,
                         const StiffenerColumn& b) {
  StiffenerColumn of;
  of.area = a.area + b.area;
  of.inertia = a.inertia + b.inertia;
  const auto in_a = a.stress * a.area, in_b = b.stress * b.area;
  of.place =
      plate.low + (in_a * (a.place - plate.low) + in_b * (b.place - plate.low)) / (in_a + in_b);
  of.stress = in.stress(in.along(of.place));
  return of;
}

void find_plate_stress(StiffenerBuckling& of, const StiffenedPlate& plate, const Oriented& in,
                       const std::vector<StiffenerColumn>& columns) {
  const double b = in.width();
  const auto x = [&](const StiffenerColumn& column) { return in.along(column.place); };
  if (columns.size() == 1) {
    take_held(of, plate, columns[0], x(columns[0]), b - x(columns[0]));
  } else if (columns.size() == 2) {
    const double x_1 = x(columns[0]), x_2 = x(columns[1]);
    take_held(of, plate, columns[0], x_1, x_2 - x_1);
    take_held(of, plate, columns[1], x_2 - x_1, b - x_2);
    const StiffenerColumn both = together(plate, in, columns[0], columns[1]);
    take_held(of, plate, both, x(both), b - x(both));
  } else if (is_even(plate)) {
    const double t = plate.thickness.value();
    OutOfPlate all;
    all.add_plate(b, t);
    for (const FlatStiffener& flat : plate.stiffeners) all.add(flat, t);
    of.model = PlateModel::orthotropic;
    of.gamma = all.inertia() / (b * t * t * t / (12.0 * stiffened::one_less_nu_squared));
    of.delta = all.area / (b * t) - 1.0;
    std::optional<double> alpha;
    if (plate.length) alpha = plate.length->value() / b;
    of.k_sigma_p = orthotropic_buckling_factor(alpha, in.psi(), of.gamma, of.delta);
    of.sigma_cr_p = of.k_sigma_p * plate_column_stress(plate.thickness, si<Length>(b));
  } else {
    of.model = PlateModel::column;
  }
}

void find_column_stress(StiffenerBuckling& of, const StiffenedPlate& plate,
                        const std::vector<StiffenerColumn>& columns) {
  of.column = columns.front();
  if (!plate.length) {
    // So long that a column by itself bears nothing; nor does the plate hold it without one.
    of.sigma_cr_c = Stress{};
    return;
  }
  const auto at_edge = [&](const StiffenerColumn& column) {
    return Stress(column_stress(column.area, column.inertia, *plate.length) / column.stress);
  };
  of.sigma_cr_c = at_edge(of.column);
  if (of.model == PlateModel::column) {
    // Where nothing holds them the weakest one counts.
    for (const StiffenerColumn& column : columns) {
      if (at_edge(column) >= of.sigma_cr_c) continue;
      of.sigma_cr_c = at_edge(column);
      of.column = column;
    }
    of.sigma_cr_p = of.sigma_cr_c;
  }
  // A column that its plate holds is no weaker than one by itself: of unlike stiffeners a strong
  // one at the edge says nothing of the weak one behind it.
  of.sigma_cr_c = std::min(of.sigma_cr_c, of.sigma_cr_p);
}

void find_reduction(StiffenerBuckling& of, const StiffenedPlate& plate, double psi) {
  const double share = of.local / of.gross, f_y = plate.yield_strength.value();
  if (of.sigma_cr_p.value() > 0.0) {
    of.lambda_p = std::sqrt(share * f_y / of.sigma_cr_p.value());
    of.rho = internal_reduction(of.lambda_p, std::max(least_psi, psi));
  } else {
    of.rho = 0.0;
  }
  if (of.sigma_cr_c.value() > 0.0) {
    of.xi = std::clamp((of.sigma_cr_p / of.sigma_cr_c).value() - 1.0, 0.0, 1.0);
    of.lambda_c =
        std::sqrt((of.column.effective / of.column.area).value() * f_y / of.sigma_cr_c.value());
    const Length radius = sqrt(of.column.inertia / of.column.area);
    of.chi_c = column_like_reduction(of.lambda_c, column_imperfection(of.column.e, radius));
  } else {
    of.chi_c = 0.0;
    of.xi = 1.0;
  }
  of.rho_c = interpolated_reduction(of.rho, of.chi_c, of.xi);
}

std::vector<PanelPart> panels_of(const StiffenedPlate& plate, const Oriented& in) {
  std::vector<PanelPart> panels;
  double from = 0.0;
  for (std::size_t k = 0; k < in.count(); ++k) {
    const double half = 0.5 * in.stiffener(k).thickness.value();
    panels.push_back(subpanel_of(plate, in, from, in.place(k) - half));
    from = in.place(k) + half;
  }
  panels.push_back(subpanel_of(plate, in, from, in.width()));
  return panels;
}

StiffenedWidths widths_of(const StiffenedPlate& plate, const Oriented& in) {
  const double t = plate.thickness.value();
  const std::vector<PanelPart> panels = panels_of(plate, in);

  StiffenedWidths result;
  result.psi = std::max(least_psi, in.psi());
  result.stiffeners.assign(in.count(), 1.0);
  StiffenerBuckling& of = result.buckling;
  std::vector<StiffenerColumn> columns;
  double gross = 0.0, local = 0.0;
  for (std::size_t k = 0; k < in.count() && in.stress(in.place(k)) > 0.0; ++k) {
    columns.push_back(column_of(plate, in, k, panels[k], panels[k + 1]));
    const FlatStiffener& flat = in.stiffener(k);
    gross += (flat.thickness * (flat.depth + plate.thickness)).value();
  }
  of.compressed = static_cast<int>(columns.size());
  local = gross;
  // What the edges hold does not go with the stiffeners.
  const auto edge_at = [&](std::size_t i, bool first) {
    const bool held = first ? i == 0 : i + 1 == panels.size() && in.psi() > 0.0;
    return held;
  };
  for (std::size_t i = 0; i < panels.size(); ++i) {
    for (const bool first : {true, false}) {
      if (edge_at(i, first)) continue;
      const double width = first ? panels[i].first : panels[i].last;
      gross += t * width;
      local += t * panels[i].rho * width;
    }
  }
  of.gross = si<Area>(gross);
  of.local = si<Area>(local);
  find_plate_stress(of, plate, in, columns);
  find_column_stress(of, plate, columns);
  find_reduction(of, plate, in.psi());

  for (std::size_t i = 0; i < panels.size(); ++i) {
    const PanelPart& panel = panels[i];
    const WorkingStrip at = in.strip(panel.from, panel.to, 1.0);
    result.subpanels.push_back({at.low, at.high, panel.pressed, panel.psi, panel.effective});
    const auto works = [&](bool first) { return edge_at(i, first) ? 1.0 : of.rho_c; };
    const auto add = [&](double low, double high, double share) {
      if (high > low) result.strips.push_back(in.strip(low, high, share));
    };
    if (panel.pressed) {
      const double first = panel.from + panel.rho * panel.first;
      const double end = panel.from + panel.compressed, last = end - panel.rho * panel.last;
      add(panel.from, first, works(true));
      add(first, last, 0.0);
      add(last, end, works(false));
      add(end, panel.to, 1.0);
    } else {
      add(panel.from, panel.to, 1.0);
    }
    if (i < columns.size()) {
      const double half = 0.5 * in.stiffener(i).thickness.value();
      add(in.place(i) - half, in.place(i) + half, of.rho_c);
      result.stiffeners[in.index(i)] = of.rho_c;
    } else if (i < in.count()) {
      const double half = 0.5 * in.stiffener(i).thickness.value();
      add(in.place(i) - half, in.place(i) + half, 1.0);
    }
  }
  if (in.from_high()) std::reverse(result.strips.begin(), result.strips.end());
  return result;
}

}  // namespace

bool StiffenedWidths::reduced() const {
  const auto idle = [](double works) { return works < 1.0; };
  return std::any_of(strips.begin(), strips.end(),
                     [&](const WorkingStrip& of) { return idle(of.works); }) ||
         std::any_of(stiffeners.begin(), stiffeners.end(), idle);
}

std::optional<StiffenedWidths> stiffened_widths(const StiffenedPlate& plate, double at_low,
                                                double at_high) {
  if (!(std::max(at_low, at_high) > 0.0)) return std::nullopt;
  const auto from = [&](bool high) -> std::optional<StiffenedWidths> {
    const Oriented in(plate, at_low, at_high, high);
    if (in.count() == 0 || !(in.stress(in.place(0)) > 0.0)) return std::nullopt;
    return widths_of(plate, in);
  };
  if (at_low != at_high) return from(at_high > at_low);
  auto one = from(false), other = from(true);
  if (one && other && other->buckling.rho_c < one->buckling.rho_c) return other;
  return one;
}

}  // namespace boxbeam
