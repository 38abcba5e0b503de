#include <fmt/format.h>

#include "blocks.hpp"
#include "front_end_text.hpp"
#include "function_text.hpp"

namespace boxbeam::report {
namespace {

std::string three(const Eigen::Vector3d& v) {
  return fmt::format("({}, {}, {})", plain(v.x()), plain(v.y()), plain(v.z()));
}

Table sources_table(const recorded::Loads& of) {
  Table table = table_of(
      "", {of.as_cuts ? "station" : "load", "what", "column", "file", "least", "largest", "unit"});
  for (const recorded::ChannelSource& source : of.sources) {
    if (source.file.empty()) continue;
    add_row(table, row_of(source.load, source.what, source.column, source.file,
                          text::significant(source.low, 5), text::significant(source.high, 5),
                          source.unit));
  }
  return table;
}

class RecordedText : public FrontEndText {
 public:
  using FrontEndText::FrontEndText;

  std::string word() const override { return "beam"; }
  std::string heading() const override { return "Given loads"; }
  std::string inputs_heading() const override { return heading(); }

  std::string source_of_loads() const override {
    return recorded_of(*project_).as_cuts ? "cut forces from files, linear between their stations"
                                          : "forces and moments from files";
  }

  std::string gravity() const override {
    const recorded::Loads& of = recorded_of(*project_);
    if (of.inertia) return "in the given motion";
    if (of.gravity.isZero(0.0)) return "contained in the loads";
    return three(of.gravity) + " m/s^2, beam axes";
  }

  Entries entries() const override {
    const recorded::Loads& of = recorded_of(*project_);
    Entries entries;
    if (of.as_cuts) {
      entries.emplace_back("cut forces", "at stations, see the table of their columns");
      return entries;
    }
    const BeamLoads& constant = of.acting.constant;
    for (std::size_t p = 0; p < constant.points.size(); ++p) {
      const PointLoad& point = constant.points[p];
      if (of.balance && p == of.balance->point) {
        entries.emplace_back("load", fmt::format("{}: at s = {} m, what the others lack to be in "
                                                 "balance",
                                                 point.name, plain(point.s.value())));
        continue;
      }
      std::string text = fmt::format("{}: at s = {} m", point.name, plain(point.s.value()));
      if (!point.force.isZero(0.0)) text += fmt::format(", force {} kN", three(point.force / 1e3));
      if (!point.moment.isZero(0.0))
        text += fmt::format(", moment {} kN m", three(point.moment / 1e3));
      std::string changing;
      for (const recorded::ChannelSource& source : of.sources) {
        if (source.load != point.name || source.file.empty()) continue;
        changing += (changing.empty() ? "" : ", ") + source.what;
      }
      if (!changing.empty()) text += ", over time " + changing;
      entries.emplace_back("load", text);
    }
    return entries;
  }

  void add_remarks(std::vector<std::string>& remarks) const override {
    const recorded::Loads& of = recorded_of(*project_);
    if (of.inertia)
      remarks.push_back("the beam's own weight and inertia are added by its given motion");
    else if (of.gravity.isZero(0.0))
      remarks.push_back("the beam's own weight and inertia are taken to be in the given loads");
    else
      remarks.push_back(
          "of the beam's own mass its weight is added to the given loads, and no "
          "inertia");
    constexpr double worth_saying = 0.02;
    if (of.shear_defect > worth_saying) {
      remarks.push_back(fmt::format(
          "given shear forces and the slope of given moments differ by {:.3g} % of the largest "
          "shear force, {}: stations too far apart for the loads between them, or signs of "
          "another program",
          100.0 * of.shear_defect, of.shear_defect_at));
    }
    if (of.held.empty()) {
      remarks.push_back(
          of.balance
              ? fmt::format("against buckling the beam is taken to be clamped at {} and free "
                            "elsewhere; [balance] held says otherwise",
                            of.balance->name)
              : std::string(
                    "how the beam is held against buckling is not said: it is taken as a "
                    "cantilever, clamped at its softer end; [balance] held says otherwise"));
    }
  }
  using FrontEndText::add_remarks;

  std::vector<Block> blocks(const Verification& verification) const override {
    const recorded::Loads& of = recorded_of(*project_);
    std::vector<Block> blocks;
    Table sources = sources_table(of);
    if (!sources.rows.empty()) blocks.push_back(std::move(sources));
    if (of.balance) {
      const std::vector<std::size_t> shown = project_->in_space
                                                 ? std::vector<std::size_t>{0, 1, 2, 3, 4, 5}
                                                 : std::vector<std::size_t>{0, 2, 4};
      blocks.push_back(reactions_table(
          "What the given loads lack to be in balance, least to largest of all situations; beam "
          "axes",
          shown, verification.motions));
    }
    return blocks;
  }
};

}  // namespace

std::unique_ptr<const FrontEndText> text_for(const recorded::Loads&, const Project& project) {
  return std::make_unique<RecordedText>(project);
}

}  // namespace boxbeam::report
