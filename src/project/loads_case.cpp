#include <fmt/format.h>

#include "front_end_reader.hpp"
#include "recorded_reader.hpp"
#include "several_beams.hpp"

namespace boxbeam::readers {
namespace {

/// The parts of mechanisms and frames, which loads that are given do without.
void refuse_other_parts(TableReader& root) {
  for (const char* key : {"mechanism", "frame", "bodies", "links", "members", "joints", "supports",
                          "drivers", "forces", "load_cases", "combinations"}) {
    if (!root.has_misplaced(key)) continue;
    root.problem(key, fmt::format("\"{}\" is not known of loads that are given", key),
                 "remove it; what holds or moves the beam acts on it as forces in [loads.<name>]");
  }
}

class LoadsReader : public FrontEndReader {
 public:
  using FrontEndReader::FrontEndReader;

  void read(TableReader& root, const Node&) override {
    read_model(root, *project_);
    if (root.count_of("beam") > 1) {
      root.problem(
          "beam", "loads that are given act on one beam",
          "write a case for each of the beams, or kind = \"static\" where they form a frame");
    }
    TableReader table = beam_table(root, *project_);
    read_beam(table, *sections_, *project_);
    table.finish();
    refuse_other_parts(root);
    if (!root.problems().empty()) {
      for (const char* key : {"files", "loads", "cut_forces", "balance", "motion"}) {
        if (root.has(key) && root.is_table(key)) root.table(key).accept_all();
      }
      return;
    }
    project_->mechanism = read_recorded(root, project_->beam, *tables_, project_->in_space);
    refuse_planar_parts(root, *project_, {.deflection = true});
    add_places();
    project_->beam_body = 0;
  }

  Changeable changeable() const override {
    static constexpr std::array parts{"files", "loads", "cut_forces", "balance", "motion"};
    return {parts, "files.measured.path", "beam"};
  }

  AnyMechanism changed_mechanism(TableReader& root) const override {
    bool in_space = false;
    recorded::Loads loads = read_recorded(root, project_->beam, *tables_, in_space);
    if (in_space && !project_->in_space) {
      root.problem("loads", "the loads of this situation leave the plane of the others",
                   "give F_y, M_x or M_z in the case as well");
    }
    return loads;
  }

  void read_neighbours(TableReader& root) override { read_deflection_of(root, *project_); }

 private:
  /// Where loads act, named.
  void add_places() {
    for (const PointLoad& load : recorded_of(*project_).acting.constant.points) {
      const bool known = std::any_of(project_->beam.points.begin(), project_->beam.points.end(),
                                     [&](const BeamPoint& other) { return other.s == load.s; });
      if (!known && !recorded_of(*project_).as_cuts)
        project_->beam.points.push_back({std::string(load.name), load.s});
    }
  }
};

}  // namespace

std::unique_ptr<FrontEndReader> reader_for(const recorded::Loads&, const Sections& sections,
                                           TimeTables& tables, Project& project) {
  return std::make_unique<LoadsReader>(sections, tables, project);
}

}  // namespace boxbeam::readers
