#include "boxbeam/study/topics.hpp"

namespace boxbeam::study {

TopicResult integration(const Scenes&, const Effort&) { return {}; }

}  // namespace boxbeam::study
