#include "boxbeam/project/project.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <limits>
#include <utility>

#include "boxbeam/project/case_source.hpp"
#include "boxbeam/project/hole_rows.hpp"
#include "boxbeam/project/key_reference.hpp"
#include "boxbeam/project/limits.hpp"
#include "case_text.hpp"
#include "front_end_reader.hpp"
#include "readers.hpp"
#include "several_beams.hpp"

namespace boxbeam {
namespace {

/// A mechanism of the kind of an index, with nothing in it yet.
template <std::size_t... index>
AnyMechanism empty_mechanism(std::size_t kind, std::index_sequence<index...>) {
  const AnyMechanism kinds[] = {AnyMechanism(std::in_place_index<index>)...};
  return kinds[kind];
}

/// [case]; of the project's mechanism it gives the kind.
CaseHeader read_header(TableReader& table) {
  CaseHeader header;
  header.project = table.text({"project", "for which it is verified"}, "");
  header.client = table.text({"client", "for whom"}, "");
  header.revision = table.text({"revision", "of the case"}, "");
  header.standard = table.text(
      {"standard", "\"EN 1993 with DIN NA\": whose partial factors the case has; it changes none"},
      "");
  header.author = table.text({"author", "who prepared it, for the field to sign"}, "");
  header.checker = table.text({"checker", "who checks it"}, "");
  header.remarks = table.texts({"remarks", "that stand first among those of the report"}, false);
  return header;
}

void read_case(TableReader table, Project& project) {
  project.name = table.text({"name", "of the report's folder, too"});
  project.title = table.text({"title", "of the report; the name where not said"}, "");
  if (project.title.empty()) project.title = project.name;
  project.header = read_header(table);
  project.assumptions =
      table.texts({"assumptions", "what is taken for granted; it stands in the report"}, false);
  project.dynamics = table.choice({"dynamics", "where the loads on the beam come from"},
                                  {"rigorous", "newton-chain"}, 0) == 0
                         ? Dynamics::rigorous
                         : Dynamics::newton_chain;
  const std::size_t kind = table.choice({"kind", "what moves or loads the beam"}, case_kinds());
  project.mechanism =
      empty_mechanism(kind, std::make_index_sequence<std::variant_size_v<AnyMechanism>>());
  table.finish();
  if (!readers::is_plain_name(project.name)) {
    table.problem("name", "the name of a case is also the name of its report folder",
                  "use letters, digits, \"-\" and \"_\"");
  }
}

/// A strength must not be rounded to nothing.
void check_rounding(TableReader& root, const Project& project) {
  const FatigueInput& fatigue = project.fatigue;
  if (!fatigue.asked || !fatigue.round_strength_to || !root.problems().empty()) return;
  const Stress strength =
      strength_at(curve_of(fatigue.beam.detail), most_cycles_of(project), fatigue.demand.loading);
  if (*fatigue.round_strength_to <= strength) return;
  root.table("fatigue", false)
      .problem("round_strength_to",
               fmt::format(
                   "\"round_strength_to\" is larger than the strength that it rounds, {:.4g} MPa",
                   strength.value() * 1e-6),
               "write for example \"0.1 MPa\"");
}

void check_dynamics(TableReader& root, const Project& project) {
  const bool rigid_in_plane = std::holds_alternative<planar::Mechanism>(project.mechanism);
  if (project.dynamics == Dynamics::newton_chain && !rigid_in_plane) {
    root.problem("case", "the loads of a Newton chain are known for mechanisms in the plane only",
                 "use rigorous dynamics");
  } else if (project.dynamics == Dynamics::newton_chain && !project.chain) {
    root.problem("newton_chain",
                 "the loads of a Newton chain are asked for, but the case has no "
                 "[newton_chain]",
                 "name its steps, its ends and the driving mass; see sections/sledge-rig/rig.toml");
  }
  // Other kinds than those in the plane have no beam without a body, nor a chain to go over to.
  if (rigid_in_plane && project.dynamics == Dynamics::rigorous &&
      project.beam_body == planar::ground && root.has("beam")) {
    root.problem("beam",
                 "rigorous loads need the beam to be one body, whose mass comes from its "
                 "sections; this [beam] has no \"body\"",
                 "use --dynamics newton-chain, or make the beam one body as in "
                 "sections/sledge-rig/rig.toml");
  }
  if (project.dynamics == Dynamics::rigorous && !project.given_stresses.empty()) {
    root.problem("given_stresses",
                 "given stresses replace the computed ones and belong to the "
                 "published calculation",
                 "use --dynamics newton-chain, or remove [[given_stresses]]");
  }
}

/// The case as it is for one of its beams; notes problems. `root` stays as long as the project.
Project read_for_beam(const CaseDocument& document, const Node& tree, std::size_t beam,
                      const std::vector<std::string>& overrides, std::optional<Dynamics> dynamics,
                      ProblemList& problems, TimeTables& tables) {
  Project project;
  project.path = document.path;
  project.overrides = overrides;
  project.beam_index = beam;
  TableReader root(problems, tree, "");
  if (root.count_of("beam") > 1) {
    for (const Node& each : tree.find("beam")->items) {
      const Node* const name = each.find("name");
      project.beam_names.push_back(name != nullptr ? name->text : "");
    }
    project.beam_name = project.beam_names[beam];
  }
  read_case(root.table({"case", "the case itself"}), project);
  if (dynamics) project.dynamics = *dynamics;

  const readers::Sections sections =
      readers::read_sections(root.table({"sections", "cross-sections, each by a name"}));
  readers::read_material(root, project);
  const auto front_end = readers::front_end_reader(sections, tables, project);
  front_end->read(root, tree);
  readers::read_part_materials(root, project);
  readers::check_modulus(root, tree, project);
  readers::read_situations(root, tree, *front_end, project);
  readers::read_demands(root, project);
  front_end->read_neighbours(root);
  readers::read_welds(root, sections, project);
  readers::check_net_sections(root, project);
  check_rounding(root, project);
  check_dynamics(root, project);
  root.finish();
  if (beam > 0) {  // of the mechanism, not of a beam
    // Where beams have demands of their own, pins and rods are held to those of each.
    if (!readers::differ_in_demands(document.root)) {
      project.pins.clear();
      project.rods.clear();
    }
    project.equivalent_mass.reset();
    project.hand_formulas.clear();
  }
  return project;
}

std::vector<Project> read(CaseDocument document, const std::vector<std::string>& overrides,
                          std::optional<Dynamics> dynamics, KeptFiles& files,
                          KeyRecorder* recorder = nullptr) {
  ProblemList problems(document);
  problems.recorder = recorder;
  TimeTables tables(document, files);
  if (document.root.members.empty()) {
    problems.add({document.lines.begin()->first, 1, 1}, "the case is empty",
                 "boxbeam init planar my.toml writes a commented case that runs as it is");
    problems.raise();
  }
  if (const Node* const study = document.root.find("study");
      study != nullptr && document.root.find("case") == nullptr) {
    problems.add(study->place, "this is a study, not a case",
                 "boxbeam sweep, optimise and reliability take it; the case that it changes stands "
                 "in its [study]");
    problems.raise();
  }
  readers::check_beams(problems, document.root);
  const Node* const beams = document.root.find("beam");
  const bool several = beams != nullptr && beams->kind == Node::Kind::array;
  // Of too many, which is said, the first are read.
  const std::size_t count =
      several ? std::clamp<std::size_t>(beams->items.size(), 1, limits::most_beams) : 1;
  // What is read looks at its tree.
  std::deque<Node> trees;
  std::vector<Project> projects;
  for (std::size_t beam = 0; beam < count; ++beam) {
    const Node& tree = trees.emplace_back(readers::case_of_beam(document.root, beam));
    projects.push_back(read_for_beam(document, tree, beam, overrides, dynamics, problems, tables));
  }
  problems.raise();
  for (Project& project : projects) {
    for (const std::string& line : document.lines.at(document.path)) project.text += line + "\n";
    project.sha256 = document.sha256_of_input();
    project.tables = document.files;
  }
  return projects;
}

}  // namespace

Project::Project() = default;
Project::Project(const Project&) = default;
Project::Project(Project&&) noexcept = default;
Project& Project::operator=(const Project&) = default;
Project& Project::operator=(Project&&) noexcept = default;
Project::~Project() = default;

bool readers::is_plain_name(const std::string& name) {
  return name.find_first_not_of(
             "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_.") ==
             std::string::npos &&
         !name.starts_with('.') && name.size() <= 80;
}

SnCurve curve_of(const Detail& detail) { return scaled(detail.curve, detail.size_factor); }

void add_hole(Project& project, BeamHole hole) {
  project.beam.marks.push_back(hole.s);
  project.holes.push_back(std::move(hole));
}

namespace {

/// What is free of a plate around a place between the holes that are taken out of it.
std::pair<Length, Length> free_around(Length place, const std::vector<Hole>& taken,
                                      HoleWalls walls) {
  Length low = si<Length>(-std::numeric_limits<double>::infinity()), high = -low;
  for (const Hole& of : taken) {
    if (of.walls != walls) continue;
    // Strips that touch would leave walls without length between them.
    const Length reach = (0.5 + 1e-4) * of.diameter;
    if (of.position > place)
      high = std::min(high, Length(of.position - reach));
    else
      low = std::max(low, Length(of.position + reach));
  }
  return {low, high};
}

/// What of a hole counts in a section beside it: less s^2/(4 p) for the way to the hole there that
/// it is nearest to by that, and no more than does not lie behind those.
std::optional<Hole> counted_beside(const BeamHole& beside, const std::vector<BeamHole>& counted,
                                   const std::vector<Hole>& taken) {
  Length left;
  for (const BeamHole& of : counted) {
    const Length s = abs(beside.s - of.s), p = abs(beside.hole.position - of.hole.position);
    if (of.hole.walls != beside.hole.walls || !(p > Length{})) continue;
    left = std::max(left, Length(beside.hole.diameter - s * s / (4.0 * p)));
  }
  Hole hole = beside.hole;
  const auto [free_low, free_high] = free_around(hole.position, taken, hole.walls);
  const Length low = std::max(free_low, Length(hole.position - 0.5 * hole.diameter));
  const Length high = std::min(free_high, Length(hole.position + 0.5 * hole.diameter));
  const Length width = std::min(left, Length(high - low));
  if (!(width > Length{})) return std::nullopt;
  hole.position = std::clamp(hole.position, Length(low + 0.5 * width), Length(high - 0.5 * width));
  hole.diameter = width;
  return hole;
}

}  // namespace

std::vector<Hole> holes_at(const Project& project, Length s) { return holes_at(project.holes, s); }

std::vector<Hole> holes_at(const std::vector<BeamHole>& holes, Length s) {
  std::vector<Hole> taken;
  for (const BeamHole& at : holes) {
    if (at.s == s) taken.push_back(at.hole);
  }
  if (taken.empty() || taken.size() == holes.size()) return taken;
  std::vector<BeamHole> counted, beside;
  for (const BeamHole& at : holes) (at.s == s ? counted : beside).push_back(at);
  std::stable_sort(beside.begin(), beside.end(), [&](const BeamHole& a, const BeamHole& b) {
    return abs(a.s - s) < abs(b.s - s);
  });
  for (const BeamHole& of : beside) {
    const auto hole = counted_beside(of, counted, taken);
    if (!hole) continue;
    taken.push_back(*hole);
    counted.push_back(of);
  }
  return taken;
}

spatial::BeamPlacement placement_in(const Project& project, const spatial::Mechanism& mechanism) {
  return placement_in(project, project.placement, mechanism);
}

spatial::BeamPlacement placement_in(const Project& project, spatial::BeamPlacement placement,
                                    const spatial::Mechanism& mechanism) {
  const spatial::Mechanism& base = spatial_of(project);
  placement.body =
      body_index(mechanism, base.bodies[static_cast<std::size_t>(placement.body)].name);
  return placement;
}

const Duration& duration_of(const Project& project) {
  return std::visit([](const auto& mechanism) -> const Duration& { return mechanism.duration; },
                    project.mechanism);
}

double most_cycles_of(const Project& project) {
  double most = 0.0;
  for (const Situation& situation : project.situations) most = std::max(most, situation.cycles);
  return most;
}

const char* to_text(Dynamics dynamics) {
  return dynamics == Dynamics::rigorous ? "rigorous" : "newton-chain";
}

std::vector<Project> read_beams(const std::string& path, const std::vector<std::string>& overrides,
                                std::optional<Dynamics> dynamics) {
  KeptFiles files;
  return read(read_document(path, overrides), overrides, dynamics, files);
}

CaseSource::CaseSource(const std::string& path)
    : text_(read_case_text(path)),
      document_(parse_document(path, text_, {})),
      files_(std::make_unique<KeptFiles>()) {}

CaseSource::~CaseSource() = default;

std::vector<Project> CaseSource::read_beams(const std::vector<std::string>& overrides,
                                            std::optional<Dynamics> dynamics) const {
  CaseDocument document = document_;  // whose places are those of the text of this one
  apply_overrides(document, text_, overrides);
  return read(std::move(document), overrides, dynamics, *files_);
}

Project read_project(const std::string& path, const std::vector<std::string>& overrides,
                     std::optional<Dynamics> dynamics) {
  return std::move(read_beams(path, overrides, dynamics).front());
}

std::vector<Project> parse_beams(const std::string& path, const std::string& text,
                                 const std::vector<std::string>& overrides,
                                 std::optional<Dynamics> dynamics) {
  KeptFiles files;
  return read(parse_document(path, text, overrides), overrides, dynamics, files);
}

Project parse_project(const std::string& path, const std::string& text,
                      const std::vector<std::string>& overrides, std::optional<Dynamics> dynamics) {
  return std::move(parse_beams(path, text, overrides, dynamics).front());
}

void record_keys(const std::string& path, const std::string& text, KeyRecorder& recorder) {
  recorder.begin_case();
  CaseDocument document = parse_document(path, text, {});
  // The tables that examples name.
  for (const auto& [file, column] : {std::pair{"stroke.csv", "stroke [m]"},
                                     {"angle.csv", "angle [rad]"},
                                     {"force.csv", "force [N]"},
                                     {"couple.csv", "moment [N m]"},
                                     {"line.csv", "line force [N/m]"}})
    document.add_file(file, file, fmt::format("time [s], {}\n0, 0\n1, 0.1\n2, 0\n", column));
  KeptFiles files;
  read(std::move(document), {}, {}, files, &recorder);
}

}  // namespace boxbeam
