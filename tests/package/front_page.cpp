#include <boxbeam/project/project.hpp>
#include <boxbeam/verification/verify.hpp>
#include <cstdio>

int main(int argc, char** argv) {
  const auto project = boxbeam::read_project(argc > 1 ? argv[1] : "rig.toml");
  const auto verification = boxbeam::verify(project);
  const boxbeam::Check& worst = verification.checks.front().check;  // worst first
  std::printf("%s: %s has factor %.4f, required %.2f (%s)\n", to_text(verification.verdict),
              worst.id.c_str(), worst.safety_factor, worst.required, worst.source.c_str());
  return worst.passes() ? 0 : 1;
}
