#include "boxbeam/project/project.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "readers.hpp"

namespace boxbeam {
namespace {

using readers::Kind;

Kind read_case(TableReader table, Project& project) {
  project.name = table.text({"name", "of the report's folder, too"});
  project.title = table.text({"title", "of the report; the name where not said"}, "");
  if (project.title.empty()) project.title = project.name;
  project.assumptions =
      table.texts({"assumptions", "what is taken for granted; it stands in the report"}, false);
  project.dynamics = table.choice({"dynamics", "where the loads on the beam come from"},
                                  {"rigorous", "newton-chain"}, 0) == 0
                         ? Dynamics::rigorous
                         : Dynamics::newton_chain;
  constexpr Kind kinds[] = {Kind::planar, Kind::spatial, Kind::flexible};
  const Kind kind = kinds[table.choice({"kind", "what moves or loads the beam"},
                                       {"planar", "spatial", "flexible"})];
  table.finish();
  const bool plain = project.name.find_first_not_of(
                         "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_.") ==
                         std::string::npos &&
                     !project.name.starts_with('.') && project.name.size() <= 80;
  if (!plain) {
    table.problem("name", "the name of a case is also the name of its report folder",
                  "use letters, digits, \"-\" and \"_\"");
  }
  return kind;
}

/// Whether a joint pushes a body: with a force, not with a moment alone.
bool acts_on(const planar::Joint& joint, int body) {
  const auto [a, b] = planar::ends_of(joint);
  if (a.body != body && b.body != body) return false;
  for (int row = 0; row < planar::equations_of(joint); ++row) {
    if (planar::is_length_equation(joint, row)) return true;
  }
  return false;
}

EquivalentMassDemand read_equivalent_mass(TableReader table, const planar::Mechanism& mechanism,
                                          int beam_body) {
  EquivalentMassDemand demand;
  demand.joint = readers::joint_of(table, {"joint", "whose mass is felt"}, mechanism);
  demand.on = readers::body_of(table, {"on", "the body that feels it"}, mechanism);
  demand.adjust = readers::body_of(table, {"adjust", "the body whose mass is adjusted"}, mechanism);
  demand.wanted = si<Mass>(table.positive({"wanted", "the equivalent mass wanted"}, wanted::mass));
  table.finish();
  if (demand.adjust >= 0 && demand.adjust == beam_body) {
    table.problem("adjust", "the mass of the beam comes from its sections and cannot be adjusted",
                  "name another body");
  }
  if (demand.joint >= 0 && demand.on >= 0 &&
      !acts_on(mechanism.joints[static_cast<std::size_t>(demand.joint)], demand.on)) {
    table.problem("on",
                  fmt::format("joint \"{}\" does not push body \"{}\"", table.text("joint"),
                              table.text("on")),
                  "name a body that the joint connects");
  }
  return demand;
}

/// Where a point of a body is written.
Place place_of_point(const Node& root, const std::string& body, const std::string& point) {
  return root.find("bodies")->find(body)->find("points")->find(point)->place;
}

/// The beam body's points, named on the axis.
void add_points_of_body(const Node& root, ProblemList& problems, Project& project) {
  if (project.beam_body == planar::ground) return;
  const Body& body = planar_of(project).bodies[static_cast<std::size_t>(project.beam_body)];
  const double centre = mass_properties_of(project.beam).centre.value();
  const double length = project.beam.length().value();
  for (const BodyPoint& point : body.points) {
    const double s = centre + point.p.x();
    if (s < -1e-9 * length || s > (1.0 + 1e-9) * length) {
      problems.add(place_of_point(root, body.name, point.name),
                   fmt::format("point \"{}\" of the beam body lies off the beam, at s = {:.6g} m",
                               point.name, s),
                   fmt::format("s goes from 0 to {:.6g} m", length));
      continue;
    }
    project.beam.points.push_back({point.name, place_near(places_of(project.beam), si<Length>(s))});
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

void check_dynamics(TableReader& root, Kind kind, const Project& project) {
  if (project.dynamics == Dynamics::newton_chain && kind != Kind::planar) {
    root.problem("case", "the loads of a Newton chain are known for mechanisms in the plane only",
                 "use rigorous dynamics");
  } else if (project.dynamics == Dynamics::newton_chain && !project.chain) {
    root.problem("newton_chain",
                 "the loads of a Newton chain are asked for, but the case has no "
                 "[newton_chain]",
                 "name its steps, its ends and the driving mass; see sections/sledge-rig/rig.toml");
  }
  if (project.dynamics == Dynamics::rigorous && project.beam_body == planar::ground &&
      root.has("beam")) {
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

/// A mechanism in the plane and its beam. Returns the name of the beam's body.
std::string read_in_plane(TableReader& root, const Node& tree, const readers::Sections& sections,
                          TimeTables& tables, Project& project) {
  TableReader beam = root.table({"beam", "the verified beam"});
  readers::read_beam(beam, sections, project);
  std::string beam_body =
      beam.text({"body", "the body that is the beam; its mass comes from the sections"}, "");
  readers::MechanismDraft draft = readers::read_mechanism(root, beam_body, tables);
  if (!beam_body.empty() || !root.has("beam")) {
    // A missing table or unknown name has been noted; any body stands in, so that reading goes on.
    project.beam_body = std::max(0, readers::body_of(beam, "body", draft.mechanism));
  }
  beam.finish();
  if (root.problems().empty()) {
    project.mechanism =
        readers::place_at_centres(std::move(draft), project.beam, project.beam_body);
    add_points_of_body(tree, root.problems(), project);
  } else {
    project.mechanism = std::move(draft.mechanism);
  }
  if (root.has("newton_chain")) {
    project.chain = readers::read_newton_chain(
        root.table(
            {"newton_chain", "the published chain of bodies, for its loads and for comparison"}),
        planar_of(project), project.beam, project.beam_body);
  }
  if (root.has("equivalent_mass")) {
    project.equivalent_mass = read_equivalent_mass(
        root.table({"equivalent_mass", "the mass that the mechanism feels like at a joint"}),
        planar_of(project), project.beam_body);
  }
  return beam_body;
}

/// A place of interest under a place in beam axes, if the beam is there; one of a kind at a place.
void add_point_under(const std::string& name, const Eigen::Vector3d& at, Project& project) {
  const double length = project.beam.length().value();
  if (at.x() < -1e-9 * length || at.x() > (1.0 + 1e-9) * length) return;
  const BeamPoint point{name, place_near(places_of(project.beam), si<Length>(at.x()))};
  const auto same = [&](const BeamPoint& other) {
    return other.name == point.name && other.s == point.s;
  };
  std::vector<BeamPoint>& points = project.beam.points;
  if (std::none_of(points.begin(), points.end(), same)) points.push_back(point);
}

/// The beam's own points in space, projected on its axis, and what loads at points of other bodies
/// that do not move against it stand over.
void add_points_on_axis(Project& project) {
  const spatial::Mechanism& mechanism = spatial_of(project);
  const auto body = static_cast<std::size_t>(project.beam_body);
  for (const spatial::BodyPoint& point : mechanism.bodies[body].points) {
    add_point_under(point.name, in_beam(project.placement, point.p), project);
  }
  for (const spatial::AppliedLoad& load : mechanism.loads) {
    if (load.on != project.beam_body || load.at.body == project.beam_body) continue;
    for (const spatial::LastingPlace& place : lasting_places_of(mechanism, project.placement)) {
      if (place.name == load.name) add_point_under(place.name, place.at, project);
    }
  }
}

/// What belongs to rigid mechanisms in the plane.
void refuse_planar_parts(TableReader& root, const char* kind) {
  for (const char* key :
       {"loops", "newton_chain", "equivalent_mass", "pins", "rods", "deflection"}) {
    if (!root.has_misplaced(key)) continue;
    root.problem(key, fmt::format("\"{}\" is known for rigid mechanisms in the plane only", key),
                 fmt::format("remove it from this case of kind = \"{}\"", kind));
  }
}

/// The same in space.
std::string read_in_space(TableReader& root, const readers::Sections& sections, TimeTables& tables,
                          Project& project) {
  TableReader beam = root.table({"beam", "the verified beam"});
  readers::read_beam(beam, sections, project);
  std::string beam_body =
      beam.text({"body", "the body that is the beam; its mass comes from the sections"}, "");
  spatial::Mechanism mechanism = readers::read_chain(root, beam_body, tables);
  project.beam_body = std::max(0, readers::body_of(beam, "body", mechanism));
  if (root.problems().empty()) {
    project.placement = readers::read_placement(beam, mechanism, project.beam_body);
  } else {
    for (const char* key : {"start", "axis", "z"}) static_cast<void>(beam.has(key));
  }
  beam.finish();
  refuse_planar_parts(root, "spatial");
  if (root.problems().empty()) {
    readers::place_beam(root, project.beam, project.placement, mechanism);
    project.hand_formulas = readers::read_hand_formulas(root, mechanism);
  } else {
    for (const char* key : {"hand_formulas", "hand_symbols"}) static_cast<void>(root.has(key));
  }
  project.mechanism = std::move(mechanism);
  if (root.problems().empty()) add_points_on_axis(project);
  return beam_body;
}

/// What belongs to rigid bodies.
void refuse_rigid_parts(TableReader& root) {
  for (const auto& [key, hint] :
       {std::pair{"bodies", "links are elastic or rigid: write [links.<name>]"},
        {"drivers", "what moves it are [loads.<name>] with amplitudes"},
        {"forces", "write [loads.<name>], and springs as joints"},
        {"hand_formulas", "remove it from this case of kind = \"flexible\""},
        {"hand_symbols", "remove it from this case of kind = \"flexible\""}}) {
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
    beam.problem("link", fmt::format("there is no link \"{}\"", name),
                 readers::unknown_hint(name, names));
  }
  return meant;
}

/// A mechanism of elastic links and its beam. Returns the name of the beam's link.
std::string read_elastic(TableReader& root, readers::LinkDefaults& links, Project& project) {
  TableReader beam = root.table({"beam", "the verified beam"});
  readers::read_beam(beam, *links.sections, project);
  links.beam_link = read_beam_link(root, beam);
  beam.finish();
  flexible::Mechanism mechanism = readers::read_flexible(root, links);
  refuse_planar_parts(root, "flexible");
  refuse_rigid_parts(root);
  project.beam_body = std::max(0, readers::index_of(mechanism.links, links.beam_link));
  project.mechanism = std::move(mechanism);
  if (root.problems().empty()) add_points_of_link(project);
  return links.beam_link;
}

Project read(CaseDocument document, const std::vector<std::string>& overrides,
             std::optional<Dynamics> dynamics, KeyRecorder* recorder = nullptr) {
  ProblemList problems(document);
  problems.recorder = recorder;
  TimeTables tables(document);
  Project project;
  project.path = document.path;
  project.overrides = overrides;
  if (document.root.members.empty()) {
    problems.add({document.lines.begin()->first, 1, 1}, "the case is empty",
                 "boxbeam init planar my.toml writes a commented case that runs as it is");
    problems.raise();
  }
  TableReader root(problems, document.root, "");
  const Kind kind = read_case(root.table({"case", "the case itself"}), project);
  if (dynamics) project.dynamics = *dynamics;

  const readers::Sections sections =
      readers::read_sections(root.table({"sections", "cross-sections, each by a name"}));
  readers::LinkDefaults links{&sections, &project.beam, "", &project.model, {}};
  links.form = readers::read_model(root, kind, project.model);
  std::string beam_body;
  switch (kind) {
    case Kind::planar:
      beam_body = read_in_plane(root, document.root, sections, tables, project);
      break;
    case Kind::spatial: beam_body = read_in_space(root, sections, tables, project); break;
    case Kind::flexible: beam_body = read_elastic(root, links, project); break;
  }
  readers::read_situations(root, document.root, beam_body, links, tables, project);
  readers::read_demands(root, project);
  if (kind == Kind::planar) readers::read_neighbours(root, sections, project);
  readers::read_welds(root, sections, project);
  readers::check_net_sections(root, project);
  check_rounding(root, project);
  check_dynamics(root, kind, project);
  root.finish();
  problems.raise();
  for (const std::string& line : document.lines.at(document.path)) project.text += line + "\n";
  project.sha256 = document.sha256_of_input();
  project.tables = document.files;
  return project;
}

}  // namespace

SnCurve curve_of(const Detail& detail) { return scaled(detail.curve, detail.size_factor); }

bool in_space(const Project& project) {
  return std::holds_alternative<spatial::Mechanism>(project.mechanism);
}

bool is_flexible(const Project& project) {
  return std::holds_alternative<flexible::Mechanism>(project.mechanism);
}

const planar::Mechanism& planar_of(const Project& project) {
  return std::get<planar::Mechanism>(project.mechanism);
}

planar::Mechanism& planar_of(Project& project) {
  return std::get<planar::Mechanism>(project.mechanism);
}

spatial::Mechanism& spatial_of(Project& project) {
  return std::get<spatial::Mechanism>(project.mechanism);
}

const spatial::Mechanism& spatial_of(const Project& project) {
  return std::get<spatial::Mechanism>(project.mechanism);
}

const flexible::Mechanism& flexible_of(const Project& project) {
  return std::get<flexible::Mechanism>(project.mechanism);
}

flexible::Mechanism& flexible_of(Project& project) {
  return std::get<flexible::Mechanism>(project.mechanism);
}

const planar::Mechanism& planar_in(const Project& project, const Situation& situation) {
  return std::get<planar::Mechanism>(situation.changed ? *situation.changed : project.mechanism);
}

const spatial::Mechanism& spatial_in(const Project& project, const Situation& situation) {
  return std::get<spatial::Mechanism>(situation.changed ? *situation.changed : project.mechanism);
}

const flexible::Mechanism& flexible_in(const Project& project, const Situation& situation) {
  return std::get<flexible::Mechanism>(situation.changed ? *situation.changed : project.mechanism);
}

spatial::BeamPlacement placement_in(const Project& project, const spatial::Mechanism& mechanism) {
  spatial::BeamPlacement placement = project.placement;
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

Project read_project(const std::string& path, const std::vector<std::string>& overrides,
                     std::optional<Dynamics> dynamics) {
  return read(read_document(path, overrides), overrides, dynamics);
}

Project parse_project(const std::string& path, const std::string& text,
                      const std::vector<std::string>& overrides, std::optional<Dynamics> dynamics) {
  return read(parse_document(path, text, overrides), overrides, dynamics);
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
  read(std::move(document), {}, {}, &recorder);
}

}  // namespace boxbeam
