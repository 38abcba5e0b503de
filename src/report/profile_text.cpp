#include "profile_text.hpp"

#include <fmt/format.h>

namespace boxbeam {
namespace {

std::string text_of(const Box& box) {
  std::string out = fmt::format("box {} x {}", plain_mm(box.width), plain_mm(box.height));
  if (box.top_flange == box.bottom_flange)
    out += fmt::format(", flanges {}", plain_mm(box.top_flange));
  else
    out += fmt::format(", flanges {} (top), {}", plain_mm(box.top_flange),
                       plain_mm(box.bottom_flange));
  if (box.left_web == box.right_web)
    out += fmt::format(", webs {}", plain_mm(box.left_web));
  else
    out += fmt::format(", webs {} (left), {}", plain_mm(box.left_web), plain_mm(box.right_web));
  if (!box.stiffeners.empty()) out += fmt::format(", {} stiffeners", box.stiffeners.size());
  return out;
}

std::string text_of(const RectangularTube& tube) {
  std::string out = fmt::format("rectangular tube {} x {}, wall {}", plain_mm(tube.width),
                                plain_mm(tube.height), plain_mm(tube.wall));
  if (tube.outer_radius.value() > 0.0) {
    out += fmt::format(", radii {}/{}", plain_mm(tube.outer_radius), plain_mm(tube.inner_radius));
  }
  return out;
}

std::string text_of(const RoundTube& tube) {
  return fmt::format("round {}, wall {}", plain_mm(tube.diameter), plain_mm(tube.wall));
}

std::string text_of(const Plate& plate) {
  return fmt::format("plate {} x {}", plain_mm(plate.width), plain_mm(plate.height));
}

std::string text_of(const Polygon& polygon) {
  return fmt::format("polygon of {} corners, {} hollows", polygon.outer.size(),
                     polygon.hollows.size());
}

std::string text_of(const ThinWalled& path) {
  return fmt::format("{} thin walls between {} nodes", path.walls.size(), path.nodes.size());
}

}  // namespace

std::string plain_mm(Length x) { return fmt::format("{:.6g}", x.value() * 1e3); }

std::string profile_text(const Profile& profile) {
  return std::visit([](const auto& shape) { return text_of(shape); }, profile);
}

}  // namespace boxbeam
