#pragma once

#include <optional>
#include <string>
#include <vector>

#include "boxbeam/project/case_source.hpp"
#include "boxbeam/project/project.hpp"

namespace boxbeam::program {

/// A case and what the command line changes of it.
struct CaseOptions {
  std::string file;
  std::vector<std::string> set;
  std::string beam;                 ///< of several by its name; "": the first
  std::string dynamics;             ///< "": as the case says
  std::string model;                ///< likewise
  std::optional<double> tolerance;  ///< of the model, likewise
};

/// The case so changed, for the beam that is asked for. Throws InputError with all problems.
Project read_case(const CaseOptions& options);

/// The same for all its beams, or the one that is asked for.
std::vector<Project> read_beams_of(const CaseOptions& options);

/// The same of a file that has been read already; `set` as --set, behind that of the options.
std::vector<Project> read_beams_of(const CaseOptions& options, const CaseSource& source,
                                   const std::vector<std::string>& set);

}  // namespace boxbeam::program
