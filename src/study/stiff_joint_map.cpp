#include "boxbeam/study/topics.hpp"

namespace boxbeam::study {

Map stiff_joint_map(const Scenes&, const Effort&) { return {}; }

}  // namespace boxbeam::study
