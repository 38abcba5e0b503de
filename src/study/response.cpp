#include "boxbeam/study/topics.hpp"

namespace boxbeam::study {

TopicResult response(const Scenes&, const Effort&) { return {}; }

}  // namespace boxbeam::study
