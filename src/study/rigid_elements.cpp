#include "boxbeam/study/topics.hpp"

namespace boxbeam::study {

TopicResult rigid_elements(const Scenes&, const Effort&) { return {}; }

}  // namespace boxbeam::study
