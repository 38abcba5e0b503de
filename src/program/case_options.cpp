#include "program/case_options.hpp"

namespace boxbeam::program {

Project read_case(const std::string& path, const std::vector<std::string>& set,
                  const std::string& dynamics) {
  if (dynamics.empty()) return read_project(path, set);
  return read_project(path, set,
                      dynamics == "rigorous" ? Dynamics::rigorous : Dynamics::newton_chain);
}

}  // namespace boxbeam::program
