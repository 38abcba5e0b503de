#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "front_end_reader.hpp"
#include "several_beams.hpp"

namespace boxbeam::readers {
namespace {

/// What belongs to rigid bodies.
void refuse_rigid_parts(TableReader& root, const Project& project) {
  const std::string remove =
      fmt::format("remove it from this case of kind = \"{}\"", kind_word_of(project.mechanism));
  for (const auto& [key, hint] : {std::pair<const char*, std::string>{
                                      "bodies", "links are elastic or rigid: write [links.<name>]"},
                                  {"drivers", "what moves it are [loads.<name>] with amplitudes"},
                                  {"forces", "write [loads.<name>], and springs as joints"},
                                  {"hand_formulas", remove},
                                  {"hand_symbols", remove}}) {
    if (!root.has_misplaced(key)) continue;
    root.problem(key, fmt::format("\"{}\" is known for rigid mechanisms only", key), hint);
  }
}

/// The points of the beam's link, named on the axis.
void add_points_of_link(Project& project) {
  const flexible::Link& link =
      flexible_of(project).links[static_cast<std::size_t>(project.beam_body)];
  for (const BodyPoint& point : link.points) {
    const Length s = place_near(places_of(project.beam), si<Length>(point.p.x()));
    const bool end = s == Length{} || s == project.beam.length();
    if (end && (point.name == "start" || point.name == "end")) continue;
    project.beam.points.push_back({point.name, s});
  }
}

/// The beam's link by name; where that is missing or misspelt, which is noted, the link without a
/// profile is meant, so that reading goes on.
std::string read_beam_link(TableReader& root, TableReader& beam) {
  std::string name =
      beam.text({"link", "the link that is the beam; mass and stiffness come from the sections"});
  std::vector<std::string> names;
  std::string meant;
  const Node* const links = root.peek("links");
  for (std::size_t i = 0; links != nullptr && i < links->members.size(); ++i) {
    const Node::Member& link = links->members[i];
    names.push_back(link.key);
    const std::array profile{"section", "sections", "segments", "EA", "mass"};
    const bool bare = std::none_of(profile.begin(), profile.end(), [&](const char* key) {
      return link.value.kind == Node::Kind::table && link.value.find(key) != nullptr;
    });
    if (bare && meant.empty()) meant = link.key;
  }
  if (std::find(names.begin(), names.end(), name) != names.end()) return name;
  if (!name.empty()) {
    beam.problem("link", fmt::format("there is no link \"{}\"", name), unknown_hint(name, names));
  }
  return meant;
}

class FlexibleReader : public FrontEndReader {
 public:
  using FrontEndReader::FrontEndReader;

  void read(TableReader& root, const Node&) override {
    links_.form = read_model(root, *project_);
    TableReader beam = beam_table(root, *project_);
    read_beam(beam, *links_.sections, *project_);
    links_.beam_link = read_beam_link(root, beam);
    for (OtherBeam& other : read_other_beams(root, "link", *sections_, *project_)) {
      if (other.on == links_.beam_link) {
        beam.problem("link", fmt::format("two beams are the link \"{}\"", other.on),
                     "a link is one beam; join a second link to it by stiffness = \"rigid\"");
      }
      links_.other_beams.emplace_back(std::move(other.on), std::move(other.beam));
    }
    beam.finish();
    flexible::Mechanism mechanism = read_flexible(root, links_);
    refuse_planar_parts(root, *project_);
    refuse_rigid_parts(root, *project_);
    project_->beam_body = std::max(0, index_by_name(mechanism.links, links_.beam_link));
    project_->mechanism = std::move(mechanism);
    if (root.problems().empty()) add_points_of_link(*project_);
  }

  Changeable changeable() const override {
    static constexpr std::array parts{"mechanism", "links", "joints", "loads", "motion"};
    return {parts, "loads.drilling.phase", links_.beam_link};
  }

  AnyMechanism changed_mechanism(TableReader& root) const override {
    return read_flexible(root, links_);
  }

  bool vibrates() const override { return true; }

 private:
  LinkDefaults links_{sections_, &project_->beam, "", {}, &project_->model, {}};
};

}  // namespace

std::unique_ptr<FrontEndReader> reader_for(const flexible::Mechanism&, const Sections& sections,
                                           TimeTables& tables, Project& project) {
  return std::make_unique<FlexibleReader>(sections, tables, project);
}

}  // namespace boxbeam::readers
