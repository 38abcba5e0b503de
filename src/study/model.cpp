#include "boxbeam/study/topics.hpp"

namespace boxbeam::study {

TopicResult model(const Scenes&, const Effort&) { return {}; }

}  // namespace boxbeam::study
