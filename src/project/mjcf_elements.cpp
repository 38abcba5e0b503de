#include "mjcf_elements.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>

namespace boxbeam::robots {
namespace {

constexpr const char* orientations[]{"quat", "axisangle", "xyaxes", "zaxis", "euler"};

/// Attributes over others. Who says how something is turned, or from where to where it goes,
/// takes what others say of that away.
void merge_attributes(const MjcfAttributes& over, MjcfAttributes& under) {
  const auto says = [&](const char* name) { return over.count(name) > 0; };
  if (std::any_of(std::begin(orientations), std::end(orientations), says))
    for (const char* name : orientations) under.erase(name);
  for (const auto& [name, value] : over) under[name] = value;
}

}  // namespace

std::string called(const XmlElement& element) {
  const std::string* const name = element.attribute("name");
  return name == nullptr || name->empty() ? fmt::format("<{}>", element.tag)
                                          : fmt::format("{} \"{}\"", element.tag, *name);
}

void MjcfElements::read_settings(const XmlElement& model) {
  refuse_what_makes_elements(model);
  file_->raise();
  classes_["main"];
  for (const XmlElement& child : model.children) {
    if (child.tag == "compiler") read_compiler(child);
    if (child.tag == "option") read_option(child);
    if (child.tag == "default") read_class(child, "main", true);
  }
  file_->raise();
}

std::optional<std::vector<double>> MjcfElements::numbers(const MjcfElement& in, const char* name,
                                                         std::size_t least, std::size_t most) {
  const std::string* const text = in.attribute(name);
  if (text == nullptr) return {};
  return file_->numbers(in.of, in.of.element->tag, name, *text, least, most);
}

double MjcfElements::number(const MjcfElement& in, const char* name, double otherwise) {
  const auto found = numbers(in, name, 1, 1);
  return found ? found->front() : otherwise;
}

Eigen::Vector3d MjcfElements::triple(const MjcfElement& in, const char* name,
                                     const Eigen::Vector3d& otherwise) {
  const auto found = numbers(in, name, 3, 3);
  return found ? Eigen::Vector3d((*found)[0], (*found)[1], (*found)[2]) : otherwise;
}

std::size_t MjcfElements::choice(const MjcfElement& in, const char* name,
                                 const std::string& otherwise,
                                 const std::vector<std::string>& words) {
  const std::string word = in.text(name, otherwise);
  const auto found = std::find(words.begin(), words.end(), word);
  if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
  file_->problem(in.of, fmt::format("{} = \"{}\" is no word for it", name, word),
                 fmt::format("{}", fmt::join(words, ", ")));
  return 0;
}

void MjcfElements::refuse_what_makes_elements(const XmlElement& element) {
  for (const XmlElement& child : element.children) {
    for (const char* tag : {"include", "replicate", "attach", "composite", "flexcomp"}) {
      if (child.tag != tag) continue;
      file_->problem({&child, called(child)}, "what it stands for is not read",
                     "load the model into MuJoCo and save it by mj_saveLastXML, which writes the "
                     "elements themselves");
    }
    if (child.tag != "asset" && child.tag != "extension") refuse_what_makes_elements(child);
  }
}

void MjcfElements::read_compiler(const XmlElement& element) {
  const MjcfElement in{{&element, "<compiler>"}, element.attributes};
  if (in.attribute("angle"))
    settings_.degrees = choice(in, "angle", "degree", {"degree", "radian"}) == 0;
  if (in.attribute("coordinate")) choice(in, "coordinate", "local", {"local"});
  if (in.attribute("autolimits"))
    settings_.autolimits = choice(in, "autolimits", "true", {"false", "true"}) == 1;
  if (in.attribute("inertiafromgeom"))
    settings_.mass_from = static_cast<MjcfSettings::MassFrom>(
        choice(in, "inertiafromgeom", "auto", {"false", "true", "auto"}));
  settings_.least_mass = number(in, "boundmass", settings_.least_mass);
  settings_.least_moment = number(in, "boundinertia", settings_.least_moment);
  if (number(in, "settotalmass", -1.0) > 0.0 || in.text("balanceinertia", "false") == "true")
    file_->problem(in.of, "settotalmass and balanceinertia change masses, which is not computed",
                   "write the masses as they are to be");
  if (const auto range = numbers(in, "inertiagrouprange", 2, 2)) {
    settings_.first_group = (*range)[0];
    settings_.last_group = (*range)[1];
  }
  if (!in.attribute("eulerseq")) return;
  settings_.euler = in.text("eulerseq");
  if (settings_.euler.size() != 3 ||
      settings_.euler.find_first_not_of("xyzXYZ") != std::string::npos) {
    file_->problem(in.of,
                   fmt::format("eulerseq = \"{}\" is no sequence of three axes", settings_.euler),
                   "write for example \"xyz\"; capitals are axes that do not turn");
    settings_.euler = "xyz";
  }
}

void MjcfElements::read_option(const XmlElement& element) {
  const MjcfElement in{{&element, "<option>"}, element.attributes};
  robot_->gravity = triple(in, "gravity", robot_->gravity);
  for (const char* fluid : {"density", "viscosity"})
    if (number(in, fluid, 0.0) != 0.0) leave_out(fmt::format("option {}", fluid));
  for (const XmlElement& child : element.children) {
    if (child.tag != "flag") continue;
    const auto off = [&](const char* what) {
      const std::string* const word = child.attribute(what);
      return word != nullptr && *word == "disable";
    };
    if (off("gravity")) settings_.no_gravity = true;
    if (off("equality")) settings_.no_equality = true;
  }
  if (settings_.no_gravity) robot_->gravity.setZero();
}

void MjcfElements::read_class(const XmlElement& element, const std::string& parent,
                              bool outermost) {
  const std::string* const given = element.attribute("class");
  if (given == nullptr && !outermost) {
    file_->problem({&element, "<default>"}, "it has no class", "write <default class=\"...\">");
    return;
  }
  const std::string name = outermost ? "main" : *given;
  if (!outermost) {
    if (classes_.count(name) > 0) {
      file_->problem({&element, called(element)},
                     fmt::format("another class is called \"{}\"", name),
                     "each class has a name of its own");
      return;
    }
    classes_[name] = classes_[parent];
  }
  for (const XmlElement& child : element.children) {
    if (child.tag == "default") continue;
    merge_attributes(child.attributes, classes_[name][child.tag]);
  }
  if (outermost && given != nullptr && *given != name) classes_[*given] = classes_[name];
  for (const XmlElement& child : element.children)
    if (child.tag == "default") read_class(child, name, false);
}

MjcfElement MjcfElements::with_class(const XmlElement& element, const std::string& childclass) {
  MjcfElement with{{&element, called(element)}, {}};
  const std::string* const given = element.attribute("class");
  const std::string& name = given == nullptr ? childclass : *given;
  const auto found = classes_.find(name);
  if (found == classes_.end())
    file_->problem(with.of, fmt::format("there is no class \"{}\"", name),
                   "write it in <default>, or leave it out");
  else if (const auto of_tag = found->second.find(element.tag); of_tag != found->second.end())
    with.attributes = of_tag->second;
  merge_attributes(element.attributes, with.attributes);
  return with;
}

std::string MjcfElements::class_in(const XmlElement& element, const std::string& before) {
  const std::string* const given = element.attribute("childclass");
  if (given == nullptr) return before;
  if (classes_.count(*given) > 0) return *given;
  file_->problem({&element, called(element)}, fmt::format("there is no class \"{}\"", *given),
                 "write it in <default>, or leave it out");
  return before;
}

double MjcfElements::angle(double given) const {
  return settings_.degrees ? given * std::numbers::pi / 180.0 : given;
}

Eigen::Matrix3d MjcfElements::rotation_in(const MjcfElement& in) {
  using Eigen::Quaterniond;
  using Eigen::Vector3d;
  int said = 0;
  Quaterniond q = Quaterniond::Identity();
  const auto is_none = [&](double length, const char* name) {
    ++said;
    if (length > 1e-9) return false;
    file_->problem(in.of, fmt::format("{} says no direction", name), "its numbers are all zero");
    return true;
  };
  if (const auto of = numbers(in, "quat", 4, 4)) {
    const Quaterniond given((*of)[0], (*of)[1], (*of)[2], (*of)[3]);
    if (!is_none(given.norm(), "quat")) q = given.normalized();
    said = 0;  // the others replace it
  }
  if (const auto of = numbers(in, "axisangle", 4, 4)) {
    const Vector3d axis((*of)[0], (*of)[1], (*of)[2]);
    if (!is_none(axis.norm(), "axisangle"))
      q = Eigen::AngleAxisd(angle((*of)[3]), axis.normalized());
  }
  if (const auto of = numbers(in, "euler", 3, 3)) {
    ++said;
    q = Quaterniond::Identity();
    for (std::size_t k = 0; k < 3; ++k) {
      const bool with_body = settings_.euler[k] >= 'x';
      const Eigen::AngleAxisd turn(angle((*of)[k]),
                                   Vector3d::Unit(settings_.euler[k] - (with_body ? 'x' : 'X')));
      q = with_body ? q * turn : Quaterniond(turn * q);
    }
  }
  if (const auto of = numbers(in, "zaxis", 3, 3)) {
    const Vector3d z((*of)[0], (*of)[1], (*of)[2]);
    if (!is_none(z.norm(), "zaxis")) q = Quaterniond::FromTwoVectors(Vector3d::UnitZ(), z);
  }
  if (const auto of = numbers(in, "xyaxes", 6, 6)) {
    const Vector3d x = Vector3d((*of)[0], (*of)[1], (*of)[2]).stableNormalized();
    const Vector3d y((*of)[3], (*of)[4], (*of)[5]);
    const Vector3d square = y - y.dot(x) * x;
    if (!is_none(std::min(x.norm(), square.norm()), "xyaxes")) {
      Eigen::Matrix3d R;
      R.col(0) = x;
      R.col(1) = square.normalized();
      R.col(2) = R.col(0).cross(R.col(1));
      q = R;
    }
  }
  if (said > 1)
    file_->problem(in.of, "it says more than once how it is turned",
                   "leave one of axisangle, euler, zaxis and xyaxes");
  return q.toRotationMatrix();
}

Pose MjcfElements::pose_in(const MjcfElement& in) { return {rotation_in(in), triple(in, "pos")}; }

}  // namespace boxbeam::robots
