#pragma once

#include <string>
#include <vector>

namespace boxbeam::program {

struct SweepOptions {
  std::string study;
  std::string out;          ///< "": reports/NAME of the study
  std::size_t threads = 0;  ///< 0: as many as the machine runs at once
  std::string shard;        ///< "2/8": the second of eight parts; "": all
  bool resume = false;
  bool quiet = false;
  bool netcdf = false;  ///< rows.nc as well
  std::string json;
};

/// `boxbeam sweep`: verifies all designs of a study, or a part of them. Returns the exit code.
int run_sweep(const SweepOptions& options);

struct MergeOptions {
  std::vector<std::string> folders;
  std::string out;  ///< "": the first of them
  bool netcdf = false;
  std::string json;
};

/// `boxbeam merge`: joins the parts of a study. Returns the exit code.
int run_merge(const MergeOptions& options);

}  // namespace boxbeam::program
