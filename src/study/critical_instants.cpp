#include "boxbeam/study/topics.hpp"

namespace boxbeam::study {

TopicResult critical_instants(const Scenes&, const Effort&) { return {}; }

}  // namespace boxbeam::study
