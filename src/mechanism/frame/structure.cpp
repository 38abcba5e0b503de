#include "boxbeam/mechanism/frame/structure.hpp"

namespace boxbeam::frame {

Eigen::Vector3d in_world(const Structure& structure, const Place& at) {
  if (at.member == ground) return at.p;
  const Member& member = structure.members[static_cast<std::size_t>(at.member)];
  return member.start + member.axes * at.p;
}

}  // namespace boxbeam::frame
