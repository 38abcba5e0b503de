// A mechanism's motion as an animated scene: the rules of glTF 2.0 by checks of our own, places
// against the motion that the command prints, shapes against volumes by hand.

#include "boxbeam/report/gltf.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/spatial/chain.hpp"
#include "boxbeam/verification/chain_motion_result.hpp"
#include "boxbeam/verification/motion_result.hpp"
#include "catch.hpp"
#include "support/program.hpp"

namespace gltf_test {

using namespace boxbeam;
using Json = nlohmann::ordered_json;

namespace {

const std::string stewart = "sections/stewart-rig/rig.toml";
const std::string crane = "sections/luffing-crane/crane.toml";
const std::string retraction = "sections/landing-gear/retraction.toml";
const std::string sledge = "sections/sledge-rig/rig.toml";

/// Source: RFC 4648, 4.
std::string decoded(const std::string& text) {
  const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned bits = 0, held = 0;
  for (const char c : text) {
    if (c == '=') break;
    const std::size_t value = letters.find(c);
    REQUIRE(value != std::string::npos);
    bits = (bits << 6u) | static_cast<unsigned>(value);
    held += 6;
    if (held < 8) continue;
    held -= 8;
    bytes.push_back(static_cast<char>((bits >> held) & 0xffu));
  }
  return bytes;
}

/// A document as a viewer reads it.
class Scene {
 public:
  explicit Scene(const std::string& text) : json(Json::parse(text)) {
    const std::string uri = json["buffers"][0]["uri"],
                      head = "data:application/octet-stream;base64,";
    REQUIRE(uri.starts_with(head));
    bytes = decoded(uri.substr(head.size()));
    for (std::size_t i = 0; i < json["nodes"].size(); ++i) {
      for (const Json& child : json["nodes"][i].value("children", Json::array())) {
        REQUIRE(parents.emplace(child.get<std::size_t>(), i).second);
      }
    }
    for (const Json& channel : json["animations"][0]["channels"]) {
      const auto key = std::pair(channel["target"]["node"].get<std::size_t>(),
                                 channel["target"]["path"].get<std::string>());
      const Json& sampler =
          json["animations"][0]["samplers"][channel["sampler"].get<std::size_t>()];
      REQUIRE(moved.emplace(key, rows(sampler["output"])).second);
    }
  }

  /// An accessor's numbers, a column for each element.
  Eigen::MatrixXd rows(const Json& index) const {
    const Json& accessor = json["accessors"][index.get<std::size_t>()];
    const Json& view = json["bufferViews"][accessor["bufferView"].get<std::size_t>()];
    static const std::map<std::string, int> sizes{{"SCALAR", 1}, {"VEC3", 3}, {"VEC4", 4}};
    const int size = sizes.at(accessor["type"]);
    const auto count = accessor["count"].get<Eigen::Index>();
    const auto begin = view["byteOffset"].get<std::size_t>();
    REQUIRE(begin % 4 == 0);
    REQUIRE(view["buffer"] == 0);
    REQUIRE(view["byteLength"].get<std::size_t>() == 4 * static_cast<std::size_t>(size * count));
    REQUIRE(begin + view["byteLength"].get<std::size_t>() <= bytes.size());
    Eigen::MatrixXd columns(size, count);
    for (Eigen::Index i = 0; i < columns.size(); ++i) {
      const char* const at = bytes.data() + begin + 4 * static_cast<std::size_t>(i);
      if (accessor["componentType"] == 5126) {
        float value = 0.0F;
        std::memcpy(&value, at, 4);
        columns(i) = static_cast<double>(value);
      } else {
        REQUIRE(accessor["componentType"] == 5125);
        std::uint32_t value = 0;
        std::memcpy(&value, at, 4);
        columns(i) = value;
      }
    }
    return columns;
  }

  /// Of a body: names of joints may be the same as those of others.
  std::size_t node(const std::string& name, const char* with) const {
    for (std::size_t i = 0; i < json["nodes"].size(); ++i) {
      const bool has = json["nodes"][i].contains(with) || moved.count({i, with}) > 0;
      if (json["nodes"][i]["name"] == name && has) return i;
    }
    FAIL("no node " << name);
    return 0;
  }

  Eigen::VectorXd part(std::size_t node, const char* path, Eigen::Index instant,
                       const Eigen::VectorXd& none) const {
    if (const auto found = moved.find({node, path}); found != moved.end())
      return found->second.col(instant);
    if (!json["nodes"][node].contains(path)) return none;
    const std::vector<double> values = json["nodes"][node][path];
    return Eigen::Map<const Eigen::VectorXd>(values.data(),
                                             static_cast<Eigen::Index>(values.size()));
  }

  /// Source: glTF 2.0, 3.5.3: T R S, from the root on.
  Eigen::Vector3d place(std::size_t node, Eigen::Index instant, Eigen::Vector3d p) const {
    for (;;) {
      const Eigen::Vector3d t = part(node, "translation", instant, Eigen::Vector3d::Zero());
      const Eigen::Vector3d s = part(node, "scale", instant, Eigen::Vector3d::Ones());
      const Eigen::Vector4d q = part(node, "rotation", instant, Eigen::Vector4d::UnitW());
      p = t + Eigen::Quaterniond(q).toRotationMatrix() * s.cwiseProduct(p);
      const auto parent = parents.find(node);
      if (parent == parents.end()) return p;
      node = parent->second;
    }
  }

  Json json;
  std::string bytes;
  std::map<std::size_t, std::size_t> parents;
  std::map<std::pair<std::size_t, std::string>, Eigen::MatrixXd> moved;
};

struct Film {
  Project project;
  Animation animation;
  Scene scene;
};

/// Each case once.
const Film& film(const std::string& path) {
  static std::map<std::string, Film> films;
  const auto found = films.find(path);
  if (found != films.end()) return found->second;
  const Project project = read_project(test::project_file(path));
  const Animation animation = animation_of(project);
  return films.emplace(path, Film{project, animation, Scene(gltf_of(animation, project))})
      .first->second;
}

/// y is up in a scene, z in the world of a mechanism in space: turned by -90 degrees about x.
Eigen::Vector3d turned_up(const Eigen::Vector3d& p) { return {p.x(), p.z(), -p.y()}; }

/// Single precision of a place, and of places that a rotation turns about.
double round_off(const Film& of, const Eigen::Vector3d& p) {
  return 1e-6 * std::max(of.animation.size, p.norm());
}

/// By the divergence theorem, and the sum of all area vectors, which is zero of a closed surface.
std::pair<double, Eigen::Vector3d> volume_of(const Surface& surface) {
  double volume = 0.0;
  Eigen::Vector3d area = Eigen::Vector3d::Zero();
  for (const auto& [i, j, k] : surface.triangles) {
    const Eigen::Vector3d &a = surface.corners[i], &b = surface.corners[j], &c = surface.corners[k];
    volume += a.dot(b.cross(c)) / 6.0;
    area += 0.5 * (b - a).cross(c - a);
  }
  return {volume, area};
}

Length metres(double value) { return si<Length>(value); }

TaperedBeam beam_of(const Profile& from, const Profile& to, double length) {
  TaperedBeam beam;
  beam.segments.push_back({"S", metres(0.0), metres(length), {from, {}}, {to, {}}});
  return beam;
}

void check_volume(const TaperedBeam& beam, double by_hand) {
  const auto [volume, open] = volume_of(surface_of(beam));
  CHECK(volume == Approx(by_hand).epsilon(1e-12));
  CHECK(open.norm() < 1e-12);
}

}  // namespace

TEST_CASE("a scene keeps the rules of glTF 2.0", "[space]") {
  for (const std::string& path : {stewart, crane, retraction, sledge}) {
    INFO(path);
    const Scene& scene = film(path).scene;
    const Json& json = scene.json;
    CHECK(json["asset"]["version"] == "2.0");
    REQUIRE(json["buffers"].size() == 1);
    CHECK(json["buffers"][0]["byteLength"].get<std::size_t>() == scene.bytes.size());
    // One tree: all nodes but the root have a parent, none stands before it.
    REQUIRE(json["scenes"][json["scene"].get<std::size_t>()]["nodes"] == Json::array({0}));
    CHECK(scene.parents.size() == json["nodes"].size() - 1);
    for (const auto& [child, parent] : scene.parents) CHECK(parent < child);
    for (const Json& mesh : json["meshes"]) {
      REQUIRE(!mesh["primitives"].empty());
      for (const Json& primitive : mesh["primitives"]) {
        CHECK(primitive["mode"] == 4);
        CHECK(primitive["material"].get<std::size_t>() < json["materials"].size());
        const Json& position = primitive["attributes"]["POSITION"];
        const Json& accessor = json["accessors"][position.get<std::size_t>()];
        CHECK(accessor["type"] == "VEC3");
        CHECK(accessor["componentType"] == 5126);
        CHECK(json["bufferViews"][accessor["bufferView"].get<std::size_t>()]["target"] == 34962);
        const Eigen::MatrixXd places = scene.rows(position);
        for (Eigen::Index i = 0; i < 3; ++i) {
          const auto at = static_cast<std::size_t>(i);
          CHECK(accessor["min"][at].get<double>() == places.row(i).minCoeff());
          CHECK(accessor["max"][at].get<double>() == places.row(i).maxCoeff());
        }
        const Json& of = json["accessors"][primitive["indices"].get<std::size_t>()];
        CHECK(of["type"] == "SCALAR");
        CHECK(of["componentType"] == 5125);
        CHECK(json["bufferViews"][of["bufferView"].get<std::size_t>()]["target"] == 34963);
        const Eigen::MatrixXd indices = scene.rows(primitive["indices"]);
        CHECK(indices.size() % 3 == 0);
        CHECK(indices.maxCoeff() < static_cast<double>(places.cols()));
      }
    }
    for (const Json& node : json["nodes"]) {
      if (node.contains("mesh")) CHECK(node["mesh"].get<std::size_t>() < json["meshes"].size());
    }
    for (const Json& sampler : json["animations"][0]["samplers"]) {
      CHECK(sampler["interpolation"] == "LINEAR");
      const Json& accessor = json["accessors"][sampler["input"].get<std::size_t>()];
      const Eigen::MatrixXd times = scene.rows(sampler["input"]);
      CHECK(times(0) == 0.0);
      bool ascending = true;
      for (Eigen::Index k = 1; k < times.size(); ++k)
        ascending = ascending && times(k) > times(k - 1);
      CHECK(ascending);
      CHECK(accessor["min"][0].get<double>() == times.minCoeff());
      CHECK(accessor["max"][0].get<double>() == times.maxCoeff());
      CHECK(scene.rows(sampler["output"]).cols() == times.cols());
    }
    const std::set<std::string> paths{"translation", "rotation", "scale"};
    for (const auto& [target, values] : scene.moved) {
      CHECK(target.first < json["nodes"].size());
      CHECK(paths.count(target.second) == 1);
      if (target.second != "rotation") continue;
      for (Eigen::Index k = 0; k < values.cols(); ++k) {
        if (std::abs(values.col(k).norm() - 1.0) > 1e-6) FAIL_CHECK("no unit quaternion");
        // Half the angle from one to the next: 45 degrees, and by the way of no whole turn.
        if (k > 0 && values.col(k).dot(values.col(k - 1)) < std::sqrt(0.5) - 1e-6)
          FAIL_CHECK("a turn of more than 90 degrees");
      }
    }
  }
}

TEST_CASE("points of bodies stand in a scene where the motion has them", "[space]") {
  for (const std::string& path : {stewart, crane, retraction}) {
    INFO(path);
    const Film& of = film(path);
    const std::vector<double>& times = of.animation.times;
    CHECK(times.size() >= 61);
    const ChainMotionResult motion = chain_motion_of(of.project, times, "world");
    const Eigen::MatrixXd input =
        of.scene.rows(of.scene.json["animations"][0]["samplers"][0]["input"]);
    REQUIRE(input.cols() == static_cast<Eigen::Index>(times.size()));
    std::size_t seen = 0;
    for (const spatial::Body& body : spatial_of(of.project).bodies) {
      const std::size_t node = of.scene.node(body.name, "rotation");
      for (const spatial::BodyPoint& point : body.points) {
        for (std::size_t k = 0; k < times.size(); ++k) {
          const ChainInstant& instant = motion.states[k];
          const auto found =
              std::find_if(instant.points.begin(), instant.points.end(), [&](const auto& at) {
                return at.name == point.name || at.name == body.name + "." + point.name;
              });
          REQUIRE(found != instant.points.end());
          const auto column = static_cast<Eigen::Index>(k);
          const Eigen::Vector3d apart =
              of.scene.place(node, column, point.p) - turned_up(found->position);
          if (apart.norm() > round_off(of, found->position))
            FAIL_CHECK(body.name << "." << point.name << " is off by " << apart.norm());
          const double at = times[k] - times.front();
          if (std::abs(input(0, column) - at) > 1e-7 * std::max(1.0, at)) FAIL_CHECK("time");
          ++seen;
        }
      }
    }
    CHECK(seen >= 3 * times.size());
    // No body turns by more than 90 degrees between two instants, whole turns counted.
    const double step = times[1] - times[0];
    for (const ChainInstant& instant : motion.states) {
      for (const ChainBody& body : instant.bodies)
        CHECK(body.omega.norm() * step <= 0.5 * std::numbers::pi * (1.0 + 1e-9));
    }
  }
}

TEST_CASE("cylinders of a scene reach from the ground to the platform", "[space]") {
  const Film& of = film(stewart);
  const std::vector<double>& times = of.animation.times;
  const ChainMotionResult motion = chain_motion_of(of.project, times, "world");
  const Json& nodes = of.scene.json["nodes"];
  for (const char leg : {'1', '2', '3', '4', '5', '6'}) {
    const std::string name = std::string("leg-") + leg;
    const std::size_t node = of.scene.node(name, "scale");
    std::size_t blocks = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (nodes[i]["name"] != name || i == node) continue;
      ++blocks;
      const Eigen::Vector3d foot = of.scene.place(i, 0, Eigen::Vector3d::Zero());
      for (std::size_t k = 0; k < times.size(); ++k) {
        const auto at = static_cast<Eigen::Index>(k);
        CHECK((of.scene.place(node, at, Eigen::Vector3d::Zero()) - foot).norm() < 1e-6);
        const std::string point(1, static_cast<char>('A' + (leg - '1')));
        const auto& points = motion.states[k].points;
        const auto found = std::find_if(points.begin(), points.end(),
                                        [&](const auto& p) { return p.name == point; });
        REQUIRE(found != points.end());
        CHECK((of.scene.place(node, at, Eigen::Vector3d::UnitX()) - turned_up(found->position))
                  .norm() < 3e-6);
      }
    }
    CHECK(blocks == 1);  // the joint on the ground
  }
}

TEST_CASE("seen from a body it stays, and all else moves about it", "[space]") {
  const Project project = read_project(test::project_file(retraction));
  const spatial::Mechanism& mechanism = spatial_of(project);
  const Animation animation = animation_of(project, "aircraft");
  const Scene scene(gltf_of(animation, project));
  const auto aircraft = static_cast<std::size_t>(spatial::body_index(mechanism, "aircraft"));
  const spatial::Chain chain(mechanism);
  const std::size_t ground = scene.node("ground", "rotation");
  for (std::size_t k = 0; k < animation.times.size(); ++k) {
    const auto at = static_cast<Eigen::Index>(k);
    const spatial::State state = chain.at(animation.times[k]);
    const spatial::BodyMotion& from = state.bodies[aircraft];
    const auto seen = [&](const Eigen::Vector3d& p) {
      return turned_up(from.R_WB.transpose() * (p - from.position));
    };
    for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
      const std::size_t node = scene.node(mechanism.bodies[i].name, "rotation");
      for (const spatial::BodyPoint& point : mechanism.bodies[i].points) {
        const Eigen::Vector3d here =
            seen(spatial::position_of(state, {static_cast<int>(i), point.p}));
        if ((scene.place(node, at, point.p) - here).norm() >
            1e-6 * std::max(animation.size, here.norm()))
          FAIL_CHECK(point.name);
      }
    }
    const Eigen::Vector3d origin = seen(Eigen::Vector3d::Zero());
    CHECK((scene.place(ground, at, Eigen::Vector3d::Zero()) - origin).norm() <=
          1e-6 * std::max(1.0, origin.norm()));
    CHECK(scene.place(scene.node("aircraft", "rotation"), at, Eigen::Vector3d::Zero()).norm() <
          1e-12);
  }
  CHECK_THROWS_AS(animation_of(project, "airship"), InputError);
  CHECK_THROWS_AS(animation_of(read_project(test::project_file(sledge)), "blade"), InputError);
}

TEST_CASE("in the plane y is up as it is", "[planar]") {
  const Film& of = film(sledge);
  const MotionResult motion = motion_of(of.project, of.animation.times);
  const auto& bodies = planar_of(of.project).bodies;
  for (std::size_t k = 0; k < motion.states.size(); ++k) {
    auto point = motion.states[k].points.begin();
    for (const Body& body : bodies) {
      const std::size_t node = of.scene.node(body.name, "rotation");
      for (const BodyPoint& at : body.points) {
        const Eigen::Vector3d here(point->position.x(), point->position.y(), 0.0);
        CHECK((of.scene.place(node, static_cast<Eigen::Index>(k), {at.p.x(), at.p.y(), 0.0}) - here)
                  .norm() < round_off(of, here));
        ++point;
      }
    }
  }
}

TEST_CASE("the beam of a scene is as wide and as high as its sections", "[space]") {
  for (const std::string& path : {stewart, crane, retraction, sledge}) {
    INFO(path);
    const Film& of = film(path);
    const spatial::BeamPlacement& placement = of.animation.beam;
    const std::string& name = of.animation.bodies[static_cast<std::size_t>(placement.body)].name;
    const Json& node = of.scene.json["nodes"][of.scene.node(name, "mesh")];
    const Json& mesh = of.scene.json["meshes"][node["mesh"].get<std::size_t>()];
    CHECK(
        of.scene.json["materials"][mesh["primitives"][0]["material"].get<std::size_t>()]["name"] ==
        "beam");
    const Eigen::MatrixXd places = of.scene.rows(mesh["primitives"][0]["attributes"]["POSITION"]);
    for (const Segment& segment : of.project.beam.segments) {
      const auto check = [&](Length s, const Section& section) {
        Eigen::AlignedBox2d box;
        for (Eigen::Index k = 0; k < places.cols(); ++k) {
          const Eigen::Vector3d p =
              placement.axes.transpose() * (Eigen::Vector3d(places.col(k)) - placement.start);
          if (std::abs(p.x() - s.value()) < 1e-6) box.extend(Eigen::Vector2d(p.y(), p.z()));
        }
        REQUIRE(!box.isEmpty());
        const Extent extent = extent_of(section.outer);
        const double width = (extent.y_high - extent.y_low).value();
        const double height = (extent.z_high - extent.z_low).value();
        // Where sections jump the larger one is in the box.
        CHECK(box.volume() >= width * height * (1.0 - 1e-5));
        if (of.project.beam.segments.size() == 1)
          CHECK(box.volume() == Approx(width * height).epsilon(1e-5));
      };
      check(segment.start, segment.from);
      check(segment.end(), segment.to);
    }
  }
}

TEST_CASE("surfaces of beams are closed and hold what their sections enclose", "[section]") {
  // A pyramid's stump: L/6 (A_0 + 4 A_m + A_1), exact where both sides are linear.
  const Box wide = symmetric_box(metres(0.4), metres(0.6), metres(0.02), metres(0.01));
  const Box narrow = symmetric_box(metres(0.2), metres(0.3), metres(0.02), metres(0.01));
  check_volume(beam_of(wide, narrow, 3.0), 3.0 / 6.0 * (0.4 * 0.6 + 4.0 * 0.3 * 0.45 + 0.2 * 0.3));
  // A round tube is a regular polygon of 48 corners: n/2 sin(2 pi/n) r^2.
  const double area = 24.0 * std::sin(2.0 * std::numbers::pi / 48.0) * 0.1 * 0.1;
  check_volume(
      beam_of(RoundTube{metres(0.2), metres(0.01)}, RoundTube{metres(0.2), metres(0.01)}, 2.0),
      2.0 * area);
  // An angle, which no fan of triangles fills, in both senses of turning.
  std::vector<SectionPlace> corners;
  for (const auto& [y, z] : std::vector<std::pair<double, double>>{
           {0.0, 0.0}, {0.3, 0.0}, {0.3, 0.1}, {0.1, 0.1}, {0.1, 0.4}, {0.0, 0.4}})
    corners.push_back({metres(y), metres(z)});
  const double angle = 0.3 * 0.1 + 0.1 * 0.3;
  check_volume(beam_of(Polygon{corners}, Polygon{corners}, 1.5), 1.5 * angle);
  std::reverse(corners.begin(), corners.end());
  check_volume(beam_of(Polygon{corners}, Polygon{corners}, 1.5), 1.5 * angle);
  // A path: every wall by itself.
  ThinWalled path;
  path.nodes = {
      {metres(-0.1), metres(0.0)}, {metres(0.1), metres(0.0)}, {metres(0.1), metres(0.3)}};
  path.walls = {{0, 1, metres(0.01)}, {1, 2, metres(0.02)}};
  check_volume(beam_of(path, path, 1.0), 0.2 * 0.01 + 0.3 * 0.02);
  // Corners that become sharp: between the volumes of both.
  const RectangularTube sharp{metres(0.2), metres(0.3), metres(0.01)};
  RectangularTube round = sharp;
  round.outer_radius = metres(0.02);
  const auto [volume, open] = volume_of(surface_of(beam_of(sharp, round, 1.0)));
  CHECK(volume < 0.2 * 0.3);
  CHECK(volume > 0.2 * 0.3 - (4.0 - std::numbers::pi) * 0.02 * 0.02);
  CHECK(open.norm() < 1e-12);
}

TEST_CASE("motion --gltf writes a scene beside the tables, or says why not", "[program]") {
  const test::TemporaryFolder folder;
  const std::string file = (folder.path() / "rig.gltf").string();
  const test::ProgramResult written = test::run_program({"motion", stewart, "--gltf", file});
  INFO(written.err);
  REQUIRE(written.exit_code == 0);
  CHECK(!written.out.empty());
  CHECK(Json::parse(test::read_file(file)) == film(stewart).scene.json);
  // Nothing but the file: what it was written to first is renamed.
  CHECK(std::distance(std::filesystem::directory_iterator(folder.path()), {}) == 1);

  const auto fails = [&](const std::vector<std::string>& arguments, const std::string& words) {
    const test::ProgramResult result = test::run_program(arguments);
    INFO(result.err);
    CHECK(result.exit_code > 1);
    CHECK(result.err.find(words) != std::string::npos);
    CHECK(!std::filesystem::exists(folder.path() / "none"));
  };
  const std::string astray = (folder.path() / "none" / "rig.gltf").string();
  const std::string none = (folder.path() / "none").string();
  fails({"motion", stewart, "--gltf", astray}, "there is no folder " + none);
  fails({"motion", stewart, "--gltf", "-"}, "give --gltf the name of one");
  fails({"motion", sledge, "--assemblies", "--gltf", none}, "leave out --assemblies or --gltf");
  fails({"motion", "sections/drill-truck/truck.toml", "--gltf", none}, "leave out --gltf");
  fails({"motion", "sections/crane-girder/girder.toml", "--gltf", none}, "has no motion");
}

}  // namespace gltf_test
