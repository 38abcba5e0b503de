#include "boxbeam/study/topics.hpp"

namespace boxbeam::study {

TopicResult precision(const Scenes&, const Effort&) { return {}; }

}  // namespace boxbeam::study
