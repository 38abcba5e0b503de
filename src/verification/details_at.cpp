#include "details_at.hpp"

#include <algorithm>
#include <utility>

#include "boxbeam/project/attachment_welds.hpp"
#include "boxbeam/project/plate_detail.hpp"

namespace boxbeam {
bool lies_in(const BeamDetail& stretch, Length s) { return s >= stretch.from && s <= stretch.to; }

bool goes_on(const BeamDetail& stretch, const Station& station) {
  return station.side == Side::before ? station.s > stretch.from : station.s < stretch.to;
}

namespace {

bool is_meant(const BeamDetail& stretch, const PlaceOfDetails& place) {
  return stretch.on == DetailPlace::section || stretch.on == place.on ||
         (place.fibre_too && stretch.on == DetailPlace::fibres);
}

ResistingDetail in_its_plate(const BeamDetail& stretch, Length plate) {
  auto detail = in_plate(stretch.detail, plate);
  if (!detail) return {&stretch, {}, false};
  auto own = std::make_shared<BeamDetail>(stretch);
  own->detail = std::move(*detail);
  return {own.get(), own, false};
}

/// All that resists at a place, in the case's order.
std::vector<ResistingDetail> all_there(const FatigueInput& fatigue, const Station& station,
                                       const PlaceOfDetails& place, Length plate,
                                       const BeamDetail* flat) {
  std::vector<ResistingDetail> all;
  bool inside = false;
  for (const BeamDetail& stretch : fatigue.details) {
    if (!is_meant(stretch, place) || !lies_in(stretch, station.s)) continue;
    all.push_back(in_its_plate(stretch, plate));
    inside = inside || station.side == Side::both || goes_on(stretch, station);
  }
  // Just behind the end of a stretch the beam's own detail holds again.
  if (!inside) all.push_back(in_its_plate(fatigue.beam, plate));
  for (const AttachmentWeld& weld : fatigue.attachments) {
    if (!weld.flat && lies_in(weld.detail, station.s))
      all.push_back(in_its_plate(weld.detail, plate));
  }
  if (flat != nullptr) all.push_back(in_its_plate(*flat, plate));
  return all;
}

/// The weakest first, at 2e6 cycles.
void put_weakest_first(std::vector<ResistingDetail>& all) {
  std::size_t weakest = 0;
  double least = comparable_strength_of(*all.front().detail);
  for (std::size_t i = 1; i < all.size(); ++i) {
    const double strength = comparable_strength_of(*all[i].detail);
    if (strength >= least) continue;
    least = strength;
    weakest = i;
  }
  std::rotate(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(weakest),
              all.begin() + static_cast<std::ptrdiff_t>(weakest) + 1);
}

}  // namespace

std::vector<ResistingDetail> details_at(const FatigueInput& fatigue, const Station& station,
                                        const PlaceOfDetails& place, Length plate,
                                        const BeamDetail* flat) {
  std::vector<ResistingDetail> all = all_there(fatigue, station, place, plate, flat);
  bool reduced = true;
  double range_factor = 0.0;
  for (const ResistingDetail& of : all) {
    reduced = reduced && of.detail->detail.compression_reduced;
    range_factor = std::max(range_factor, of.detail->stress_factor);
  }
  if (all.size() > 1) put_weakest_first(all);
  std::vector<ResistingDetail> deciding;
  for (ResistingDetail& of : all) {
    const bool weaker =
        std::any_of(deciding.begin(), deciding.end(), [&](const ResistingDetail& other) {
          return is_nowhere_stronger(*other.detail, *of.detail);
        });
    if (weaker) continue;
    of.compression_reduced = reduced;
    of.range_factor = range_factor;
    deciding.push_back(std::move(of));
  }
  return deciding;
}

}  // namespace boxbeam
