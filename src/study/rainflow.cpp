#include "boxbeam/study/topics.hpp"

namespace boxbeam::study {

TopicResult rainflow(const Scenes&, const Effort&) { return {}; }

}  // namespace boxbeam::study
