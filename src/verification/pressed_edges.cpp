#include "pressed_edges.hpp"

#include <algorithm>
#include <cmath>

#include "boxbeam/project/plate_detail.hpp"
#include "boxbeam/verification/station_samples.hpp"
#include "patch_search.hpp"
#include "plate_panels.hpp"

namespace boxbeam {

const PressedEdges::Resisting& PressedEdges::at(const PressedEdge& edge) const {
  const auto known = resisting_.find(edge);
  if (known != resisting_.end()) return known->second;
  const Length s = si<Length>(edge.s);
  std::optional<Resisting> weaker;
  const auto strength = [](const Resisting& of) {
    return of.detail->detail.curve.reference.value() / of.detail->stress_factor;
  };
  for (const Side side : {Side::before, Side::behind}) {
    if (side == Side::before ? s == Length{} : s == project_->beam.length()) continue;
    Resisting of = resisting_on({s, side}, edge.web, edge.unsaid_as_fillets);
    if (!weaker || strength(of) < strength(*weaker)) weaker = std::move(of);
  }
  return resisting_.emplace(edge, *std::move(weaker)).first->second;
}

PressedEdges::Resisting PressedEdges::resisting_on(const Station& at, BoxPlate plate,
                                                   bool unsaid_as_fillets) const {
  const Section section = section_at(project_->beam, at);
  const auto walls = judged_walls_at(*project_, at);
  Resisting of;
  if (walls) of.thickness = walls->of(plate).thickness;
  auto detail = std::make_shared<BeamDetail>();
  const auto* const box = std::get_if<Box>(&section.outer);
  static const Detail rolled = detail_of_row("8.10/1", "web without a seam");
  static const Detail seamed = detail_of_row("8.10/2", "web at its seam");
  static const Detail root = detail_of_row("8.10/4", "throat of a seam");
  detail->detail = box == nullptr ? rolled : seamed;
  if (box != nullptr) {
    const double web = detail->detail.curve.reference.value();
    const Length throat =
        box->seam_throat > Length{} || !unsaid_as_fillets ? box->seam_throat : of.thickness;
    if (throat > Length{}) {
      const double over = of.thickness / throat;
      if (root.curve.reference.value() / over < web) {
        detail->detail = root;
        detail->stress_factor = over;
        of.throat = throat;
      }
    }
  }
  of.detail = std::move(detail);
  return of;
}

SnCurve PressedEdges::shear_curve_at(const PressedEdge& edge) const {
  return curve_of(at(edge).throat > Length{} ? project_->fatigue.throat : project_->fatigue.shear);
}

const std::vector<StressPoint>& PressedEdges::sheared_points_at(const Station& station,
                                                                bool seamed) const {
  const auto key = std::pair(station.s.value(), station.side);
  const auto known = points_.find(key);
  if (known != points_.end()) return known->second;
  return points_
      .emplace(key, seamed ? seam_throats_at(*project_, *zones_, station)
                           : stress_points_at(*project_, *zones_, station))
      .first->second;
}

std::vector<PressedEdges::Sheared> PressedEdges::sheared_at(const PressedEdge& edge) const {
  std::vector<Sheared> all;
  const Resisting& resisting = at(edge);
  const Length s = si<Length>(edge.s);
  const Length resists = resisting.throat > Length{} ? resisting.throat : resisting.thickness;
  for (const Side side : {Side::before, Side::behind}) {
    if (side == Side::before ? s == Length{} : s == project_->beam.length()) continue;
    const Station station{s, side};
    const bool seamed = std::holds_alternative<Box>(section_at(project_->beam, station).outer);
    for (const StressPoint& point : sheared_points_at(station, seamed)) {
      if (seamed ? !joins(point, edge.web) : point.shear_detail == nullptr) continue;
      Sheared& of = all.emplace_back(Sheared{station, point.influence});
      if (!seamed) continue;
      const double over = seam_throat_of(point) / resists;
      for (double& factor : of.influence.shear) factor *= over;
    }
  }
  return all;
}

bool PressedEdges::shear_may_count(const PressedEdge& edge, double k) const {
  const SnCurve curve = shear_curve_at(edge);
  if (!curve.cut_off) return true;
  const auto [known, is_new] = most_shear_.try_emplace(edge, 0.0);
  if (is_new) {
    double force = 0.0, moment = 0.0;
    for (const SituationRun& run : *runs_) {
      force = std::max(force, run.loads.largest_force());
      moment = std::max(moment, run.loads.largest_moment());
    }
    for (const Sheared& of : sheared_at(edge)) {
      double most = 0.0;
      for (std::size_t j = 0; j < cut_force::count; ++j)
        most += std::abs(of.influence.shear[j]) * (j < cut_force::T ? force : moment);
      known->second = std::max(known->second, most);
    }
  }
  // Between instants and situations; from one sense to the other.
  constexpr double more = 1.5, both_ways = 2.0;
  const FatigueDemand& demand = project_->fatigue.demand;
  return k * demand.gamma_Ff * demand.gamma_Mf * more * both_ways * known->second > *curve.cut_off;
}

const std::vector<LifeChannel>& PressedEdges::shear_at(const PressedEdge& edge) const {
  const auto [known, is_new] = shear_.try_emplace(edge);
  std::vector<LifeChannel>& channels = known->second;
  if (!is_new) return channels;
  const SnCurve curve = shear_curve_at(edge);
  std::optional<StationSamples> samples;
  std::optional<Side> side;
  for (const Sheared& of : sheared_at(edge)) {
    if (side != of.station.side) samples.emplace(*project_, histories_at(*runs_, of.station));
    side = of.station.side;
    LifeChannel channel{{}, curve};
    double largest = 0.0;
    for (const SituationCycles& cycles :
         life_cycles_of(*project_, samples->shear_turns_of(of.influence), false)) {
      for (SpectrumRow& row :
           rows_of(project_->situations[cycles.situation].name, StressKind::shear, cycles.cycles)) {
        largest = std::max(largest, row.cycle.range.value());
        channel.spectrum.push_back(std::move(row));
      }
    }
    if (largest >= no_stress) channels.push_back(std::move(channel));
  }
  return channels;
}

const PressedEdges::Resisting& PressedEdges::weld() {
  static const Resisting root = [] {
    auto detail = std::make_shared<BeamDetail>();
    detail->detail = detail_of_row("8.5/3", "weld of a diaphragm");
    return Resisting{std::move(detail), {}, {}};
  }();
  return root;
}

}  // namespace boxbeam
