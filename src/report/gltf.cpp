#include "boxbeam/report/gltf.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <optional>

#include "html_text.hpp"
#include "json_number.hpp"

namespace boxbeam {
namespace {

// Words of the specification.
constexpr int unsigned_int = 5125, single_float = 5126;
constexpr int vertex_data = 34962, index_data = 34963;

/// The materials of a scene, in the order in which it holds them.
enum class Paint : std::size_t { beam, body, rod, ground };

Json materials_of_scene() {
  const auto material = [](const char* name, double red, double green, double blue) {
    return Json{{"name", name},
                {"pbrMetallicRoughness",
                 {{"baseColorFactor", {red, green, blue, 1.0}},
                  {"metallicFactor", 0.0},
                  {"roughnessFactor", 0.7}}}};
  };
  return {material("beam", 0.05, 0.27, 0.62), material("body", 0.5, 0.5, 0.5),
          material("rod", 0.7, 0.7, 0.7), material("ground", 0.15, 0.15, 0.15)};
}

Json numbers_of(const Eigen::Vector3d& v) { return {finite(v.x()), finite(v.y()), finite(v.z())}; }

/// x, y, z, w.
Json numbers_of(const Eigen::Quaterniond& q) {
  return {finite(q.x()), finite(q.y()), finite(q.z()), finite(q.w())};
}

/// Turns one after the other, each by the shorter way from the one before: q and -q are one turn.
class SmoothTurns {
 public:
  void add(Eigen::Quaterniond next) {
    next.normalize();
    if (!turns_.empty() && turns_.back().dot(next) < 0.0) next.coeffs() = -next.coeffs();
    turns_.push_back(next);
  }
  const std::vector<Eigen::Quaterniond>& all() const { return turns_; }

 private:
  std::vector<Eigen::Quaterniond> turns_;
};

class SceneWriter {
 public:
  SceneWriter(const Animation& animation, const Project& project)
      : animation_(&animation), project_(&project) {}

  std::string write() {
    times_ = times();
    const double half = animation_->z_up ? std::numbers::sqrt2 / 2.0 : 0.0;
    const std::size_t root = add_node(
        project_->name, {{"rotation", {-half, 0.0, 0.0, animation_->z_up ? half : 1.0}}}, {});
    std::vector<std::size_t> bodies;
    for (std::size_t i = 0; i < animation_->bodies.size(); ++i)
      bodies.push_back(add_body(static_cast<int>(i), root));
    const std::size_t ground = animation_->ground.empty()
                                   ? root
                                   : add_moving("ground", Json::object(), animation_->ground, root);
    add_joints(ground, bodies);
    for (const AnimatedRod& rod : animation_->rods) add_link(rod, root);
    Json document;
    document["asset"] = {{"version", "2.0"}, {"generator", "boxbeam"}};
    document["scene"] = 0;
    document["scenes"] = Json::array();
    document["scenes"].push_back({{"name", project_->name}, {"nodes", Json::array({root})}});
    document["nodes"] = nodes_;
    document["meshes"] = meshes_;
    document["materials"] = materials_of_scene();
    document["animations"] = Json::array();
    document["animations"].push_back({{"name", "motion"},
                                      {"channels", channels_},
                                      {"samplers", samplers_},
                                      {"extras", {{"begin", finite(animation_->times.front())}}}});
    document["accessors"] = accessors_;
    document["bufferViews"] = views_;
    const std::string uri = "data:application/octet-stream;base64," + report::html::base64(bytes_);
    document["buffers"] = Json::array();
    document["buffers"].push_back({{"byteLength", bytes_.size()}, {"uri", uri}});
    return document.dump(1) + "\n";
  }

 private:
  /// Little-endian, as the specification wants it; all of four bytes, so that nothing is padded.
  void put(std::uint32_t bits) {
    for (int shift = 0; shift < 32; shift += 8)
      bytes_.push_back(static_cast<char>((bits >> shift) & 0xffu));
  }

  std::size_t add_accessor(const char* type, int component, std::size_t count, std::size_t begin,
                           std::optional<int> target) {
    Json view{{"buffer", 0}, {"byteOffset", begin}, {"byteLength", bytes_.size() - begin}};
    if (target) view["target"] = *target;
    views_.push_back(std::move(view));
    accessors_.push_back({{"bufferView", views_.size() - 1},
                          {"componentType", component},
                          {"count", count},
                          {"type", type}});
    return accessors_.size() - 1;
  }

  /// Rows of numbers in single precision; `bounded` ones with the least and largest of each column.
  std::size_t add_rows(const char* type, const Eigen::MatrixXd& columns, bool bounded,
                       std::optional<int> target = {}) {
    const std::size_t begin = bytes_.size();
    const Eigen::MatrixXf single = columns.cast<float>();
    for (const float value : single.reshaped()) {
      finite(value);
      put(std::bit_cast<std::uint32_t>(value));
    }
    const std::size_t accessor =
        add_accessor(type, single_float, static_cast<std::size_t>(single.cols()), begin, target);
    if (bounded) {
      for (const float value : single.rowwise().minCoeff())
        accessors_[accessor]["min"].push_back(value);
      for (const float value : single.rowwise().maxCoeff())
        accessors_[accessor]["max"].push_back(value);
    }
    return accessor;
  }

  std::size_t times() {
    const auto n = static_cast<Eigen::Index>(animation_->times.size());
    Eigen::MatrixXd row(1, n);
    for (Eigen::Index k = 0; k < n; ++k)
      row(0, k) = animation_->times[static_cast<std::size_t>(k)] - animation_->times.front();
    return add_rows("SCALAR", row, true);
  }

  Json primitive_of(const Surface& surface, Paint paint) {
    Eigen::MatrixXd places(3, static_cast<Eigen::Index>(surface.corners.size()));
    for (std::size_t i = 0; i < surface.corners.size(); ++i)
      places.col(static_cast<Eigen::Index>(i)) = surface.corners[i];
    const std::size_t position = add_rows("VEC3", places, true, vertex_data);
    const std::size_t begin = bytes_.size();
    for (const auto& triangle : surface.triangles) {
      for (const std::uint32_t corner : triangle) put(corner);
    }
    const std::size_t indices =
        add_accessor("SCALAR", unsigned_int, 3 * surface.triangles.size(), begin, index_data);
    return {{"attributes", {{"POSITION", position}}},
            {"indices", indices},
            {"mode", 4},
            {"material", static_cast<std::size_t>(paint)}};
  }

  std::size_t add_mesh(const std::string& name, Json primitives) {
    meshes_.push_back({{"name", name}, {"primitives", std::move(primitives)}});
    return meshes_.size() - 1;
  }

  std::size_t add_node(const std::string& name, const Json& of, std::optional<std::size_t> parent) {
    Json node{{"name", name}};
    node.update(of);
    nodes_.push_back(std::move(node));
    if (parent) nodes_[*parent]["children"].push_back(nodes_.size() - 1);
    return nodes_.size() - 1;
  }

  void add_channel(std::size_t node, const char* path, const char* type,
                   const Eigen::MatrixXd& columns) {
    samplers_.push_back({{"input", times_},
                         {"output", add_rows(type, columns, false)},
                         {"interpolation", "LINEAR"}});
    channels_.push_back(
        {{"sampler", samplers_.size() - 1}, {"target", {{"node", node}, {"path", path}}}});
  }

  void add_turns(std::size_t node, const std::vector<Eigen::Quaterniond>& turns) {
    Eigen::MatrixXd columns(4, static_cast<Eigen::Index>(turns.size()));
    for (std::size_t k = 0; k < turns.size(); ++k)
      columns.col(static_cast<Eigen::Index>(k)) = turns[k].coeffs();
    add_channel(node, "rotation", "VEC4", columns);
  }

  double thickness() const { return animation_->size / 200.0; }
  double block() const { return animation_->size / 50.0; }

  /// What a body looks like: its rods, or a block where its mass has no other place than its
  /// joint's; of the beam its own shape and rods to what stands off its axis, the stroke behind the
  /// axis itself.
  Json primitives_of(int index) {
    const AnimatedBody& body = animation_->bodies[static_cast<std::size_t>(index)];
    const std::vector<PostureFigure::Stroke>& strokes = body.drawn.strokes;
    const spatial::BeamPlacement& placement = animation_->beam;
    const bool beam = index == placement.body;
    Json primitives = Json::array();
    if (beam) {
      Surface surface = surface_of(project_->beam);
      for (Eigen::Vector3d& corner : surface.corners)
        corner = (placement.start + placement.axes * corner).eval();
      primitives.push_back(primitive_of(surface, Paint::beam));
    }
    Surface rods;
    for (std::size_t k = beam ? 1 : 0; k < strokes.size(); ++k)
      add_rod(rods, strokes[k].from, strokes[k].to, thickness());
    if (strokes.empty() && body.has_mass) {
      const Eigen::Vector3d origin = Eigen::Vector3d::Zero();
      add_block(rods, body.drawn.points.empty() ? origin : body.drawn.points.front(), block());
    }
    if (!rods.triangles.empty()) primitives.push_back(primitive_of(rods, Paint::body));
    return primitives;
  }

  std::size_t add_body(int index, std::size_t root) {
    const AnimatedBody& body = animation_->bodies[static_cast<std::size_t>(index)];
    Json of = Json::object();
    Json primitives = primitives_of(index);
    if (!primitives.empty()) of["mesh"] = add_mesh(body.name, std::move(primitives));
    return add_moving(body.name, std::move(of), body.poses, root);
  }

  /// A node that moves through poses.
  std::size_t add_moving(const std::string& name, Json of, const std::vector<BodyPose>& poses,
                         std::size_t root) {
    SmoothTurns turns;
    Eigen::MatrixXd places(3, static_cast<Eigen::Index>(poses.size()));
    for (std::size_t k = 0; k < poses.size(); ++k) {
      turns.add(Eigen::Quaterniond(poses[k].axes));
      places.col(static_cast<Eigen::Index>(k)) = poses[k].origin;
    }
    of["translation"] = numbers_of(poses.front().origin);
    of["rotation"] = numbers_of(turns.all().front());
    const std::size_t node = add_node(name, of, root);
    add_channel(node, "translation", "VEC3", places);
    add_turns(node, turns.all());
    return node;
  }

  void add_joints(std::size_t ground, const std::vector<std::size_t>& bodies) {
    std::optional<std::size_t> mesh;
    for (const AnimatedJoint& joint : animation_->joints) {
      Json node{{"translation", numbers_of(joint.at.p)}};
      const bool grounded = joint.at.body == spatial::ground;
      const std::size_t parent =
          grounded ? ground : bodies[static_cast<std::size_t>(joint.at.body)];
      // Seen from a body that travels the ground may be far away: no block where nobody looks.
      if (!grounded || !animation_->ground.empty()) {
        add_node(joint.name, node, parent);
        continue;
      }
      if (!mesh) {
        Surface surface;
        add_block(surface, Eigen::Vector3d::Zero(), block());
        Json primitives = Json::array();
        primitives.push_back(primitive_of(surface, Paint::ground));
        mesh = add_mesh("ground", std::move(primitives));
      }
      node["mesh"] = *mesh;
      add_node(joint.name, node, ground);
    }
  }

  /// A rod of one metre along x that is turned and stretched.
  void add_link(const AnimatedRod& rod, std::size_t root) {
    if (!link_) {
      Surface surface;
      add_rod(surface, Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitX(), 0.8 * thickness());
      Json primitives = Json::array();
      primitives.push_back(primitive_of(surface, Paint::rod));
      link_ = add_mesh("rod", std::move(primitives));
    }
    const auto n = static_cast<Eigen::Index>(rod.ends.size());
    Eigen::MatrixXd places(3, n), scales = Eigen::MatrixXd::Ones(3, n);
    SmoothTurns turns;
    Eigen::Vector3d before = Eigen::Vector3d::UnitX();
    Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
    for (Eigen::Index k = 0; k < n; ++k) {
      const PostureFigure::Stroke& ends = rod.ends[static_cast<std::size_t>(k)];
      const Eigen::Vector3d way = ends.to - ends.from;
      // Ends that meet keep the direction; a scale of zero would leave none.
      const double length = std::max(way.norm(), 1e-9 * animation_->size);
      const Eigen::Vector3d along = way.norm() < length ? before : Eigen::Vector3d(way / length);
      turn = (Eigen::Quaterniond::FromTwoVectors(before, along) * turn).normalized();
      turns.add(turn);
      places.col(k) = ends.from;
      scales(0, k) = length;
      before = along;
    }
    const std::size_t node = add_node(rod.name,
                                      {{"mesh", *link_},
                                       {"translation", numbers_of(rod.ends.front().from)},
                                       {"rotation", numbers_of(turns.all().front())},
                                       {"scale", numbers_of(Eigen::Vector3d(scales.col(0)))}},
                                      root);
    add_channel(node, "translation", "VEC3", places);
    add_turns(node, turns.all());
    add_channel(node, "scale", "VEC3", scales);
  }

  const Animation* animation_;
  const Project* project_;
  std::string bytes_;
  std::size_t times_ = 0;
  std::optional<std::size_t> link_;
  Json nodes_ = Json::array(), meshes_ = Json::array(), accessors_ = Json::array(),
       views_ = Json::array(), samplers_ = Json::array(), channels_ = Json::array();
};

}  // namespace

std::string gltf_of(const Animation& animation, const Project& project) {
  return SceneWriter(animation, project).write();
}

}  // namespace boxbeam
