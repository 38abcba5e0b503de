#pragma once

#include <string>

namespace boxbeam::program {

struct FatigueOptions {
  std::string history;
  std::string detail;
  std::string shear_detail;
  std::string thickness;  ///< of the plate, with its unit; "" where it is not known
  std::string steel;
  std::string yield;
  std::string count = "astm";
  std::string residue = "half-cycles";
  std::string raw;
  std::string loading = "spectrum";
  double repetitions = 1.0;
  double gamma_Ff = 1.0;
  double gamma_Mf = 1.0;
  bool stress_relieved = false;
  std::string json;
};

/// `boxbeam fatigue`: a stress history by itself. Returns the exit code.
int run_fatigue(const FatigueOptions& options);

}  // namespace boxbeam::program
