#pragma once

#include <deque>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "boxbeam/project/hole_rows.hpp"
#include "boxbeam/verification/stress_points.hpp"
#include "details_at.hpp"

namespace boxbeam {

/// Details of one station, each looked up once per plate.
class DetailsAtStation {
 public:
  DetailsAtStation(const FatigueInput& fatigue, const Station& station)
      : fatigue_(&fatigue), station_(station) {}

  const std::vector<ResistingDetail>& at(const PlaceOfDetails& place, Length plate) {
    for (const Found& found : found_) {
      if (found.place == place && found.plate == plate) return found.details;
    }
    found_.push_back({place, plate, details_at(*fatigue_, station_, place, plate)});
    return found_.back().details;
  }

 private:
  struct Found {
    PlaceOfDetails place;
    Length plate;
    std::vector<ResistingDetail> details;
  };
  const FatigueInput* fatigue_;
  Station station_;
  std::deque<Found> found_;  // references to its members stay
};

/// The points of one station as they are gathered.
class GatheredPoints {
 public:
  GatheredPoints(const Project& project, const std::vector<BendingZone>& zones,
                 const Station& station, StressFields& fields);

  /// All of the section but its holes.
  void add_section();
  /// The throats of the seams of its outer profile.
  void add_throats();
  void add_named(const NamedPoint& named);
  /// Of places where unlike details lie the same points once more, by each of the others.
  void add_other_details();
  /// A hole that the section cuts, its edge, what is beside it and goes through its row.
  void add_hole(const CutHole& at);

  std::vector<StressPoint> points;

 private:
  /// On the plate, outside of it, in the section on either side of where it ends.
  void add_flat(const AttachmentWeld& weld);
  /// Where flats of a weaker steel than their plates stand on these, and bear as much stress.
  void add_feet();
  void add_throat(SectionPoint place);
  void add_stretches();
  /// The points at a level, whose direct stress is not judged yet.
  std::span<StressPoint> add_level(const std::string& name, Length z);
  /// The plates at a place, and, where the one half is looked at for both, at its mirror image.
  std::vector<PlateOf> plates_here(Length y, Length z) const;
  /// Of a case that asks for no fatigue nothing resists it.
  void resist(StressPoint& point);
  /// The details of another place of the same wall.
  void resist(StressPoint& point, Length y, Length z);
  /// The weakest of them; points of the others follow once the places are gathered.
  void take(const std::vector<ResistingDetail>& details, StressPoint& point);
  static void take(const ResistingDetail& detail, StressPoint& point);
  const Detail* if_asked(const Detail& detail) const;
  void find_webs();
  /// Stops where a stress is not known.
  void stop_where(const std::optional<std::string>& unknown) const;
  StressPoint& add(const SectionPoint& place);
  static void set_yield(StressPoint& point, const PlateOf& plate);
  /// What goes along the beam from hole to hole in a row, at each of its plates.
  void add_posts(const CutHole& at);
  /// The flow beside a hole is that of one section, which the hole passes on. What the plate
  /// carries as a whole before and behind it, goes through the strips.
  void add_strips(const CutHole& at);
  /// A hole may have a detail of its own.
  void resist_hole(StressPoint& point, const CutHole& at);
  EdgeBasis edge_basis_of(const Hole& hole, HoleCase hole_case) const;
  void add_edge(const std::string& name, std::vector<HoleEdge> edges, bool webs, Length plate,
                const CutHole& at, const EdgeConcentration& concentration);

  const Project* project_;
  Station station_;
  DetailsAtStation details_;
  PlateMaterials materials_;
  Taper taper_;
  PointSet set_;
  StressFields* fields_;
  std::shared_ptr<const StressField> shared_field_;
  const StressField& field_;  ///< the same
  SectionProperties gross_, net_;
  ShearLags lags_;
  std::vector<std::size_t> webs_;  ///< of a path, where any detail is of webs or seams alone
  std::vector<std::pair<std::size_t, ResistingDetail>> others_;  ///< by the numbers of their points
};

}  // namespace boxbeam
