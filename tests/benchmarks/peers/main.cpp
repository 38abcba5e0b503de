// boxbeam and Simbody for the comparison with other programs, asked by peers.py:
//
//   boxbeam_peers                 answers requests, a line of JSON each, from the standard input
//   boxbeam_peers draw FOLDER     draws the charts and maps that come as JSON from there

#include <fmt/format.h>
#include <time.h>

#include <Eigen/Core>
#include <exception>
#include <iostream>
#include <string>
#include <string_view>

#include "peers/answers.hpp"
#include "peers/simbody_rig.hpp"
#include "version.hpp"

namespace peers {

double processor_time() {
  timespec now{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

namespace {

Json answer_versions() {
  return {{"boxbeam", boxbeam::version},
          {"Simbody", bench::simbody_version()},
          {"Eigen",
           fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
          {"compiler", std::string("GCC ") + __VERSION__}};
}

Json answer(const Json& request) {
  const std::string about = request.at("about");
  if (about == "sledge") return answer_sledge(request);
  if (about == "free") return answer_free(request);
  if (about == "beam") return answer_beam(request);
  return answer_versions();
}

}  // namespace
}  // namespace peers

int main(int argc, char** argv) {
  try {
    if (argc == 3 && std::string_view(argv[1]) == "draw") {
      peers::draw(peers::Json::parse(std::cin), argv[2]);
      return 0;
    }
    for (std::string line; std::getline(std::cin, line);) {
      std::cout << peers::answer(peers::Json::parse(line)).dump() << std::endl;
    }
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "boxbeam_peers: {}\n", error.what());
    return 3;
  }
}
