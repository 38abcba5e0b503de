#include "boxbeam/study/topics.hpp"

namespace boxbeam::study {

TopicResult cut_forces(const Scenes&, const Effort&) { return {}; }

}  // namespace boxbeam::study
