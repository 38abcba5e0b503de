#include "boxbeam/study/topics.hpp"

namespace boxbeam::study {

TopicResult kinematics(const Scenes&, const Effort&) { return {}; }

}  // namespace boxbeam::study
