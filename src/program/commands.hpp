#pragma once

#include <string>
#include <vector>

#include "program/case_options.hpp"

/// What the commands of the command line do, but for those of studies: each returns the exit code.
namespace boxbeam::program {

struct VerifyOptions {
  CaseOptions of_case;
  std::string out;
  std::string json;
  std::string level = "governing";
  std::string export_to;  ///< folder for files of other programs; "": none
  bool sensitivities = false;
  bool no_plots = false;
  bool no_html = false;
  bool no_pdf = false;
  bool quiet = false;
  bool watch = false;  ///< verifies again whenever a file changes, without end
};

/// `boxbeam verify`: verifies a case and writes its report. Returns the exit code.
int run_verify(const VerifyOptions& options);

/// `boxbeam validate`: reads a case, and says what it is or everything that is wrong with it.
/// Returns the exit code.
int run_validate(const CaseOptions& options);

struct ExplainOptions {
  std::string check;
  CaseOptions of_case;
};

/// `boxbeam explain`: how one check comes about, line by line; or all ids. Returns the exit code.
int run_explain(const ExplainOptions& options);

struct MotionOptions {
  CaseOptions of_case;
  std::vector<double> at;
  bool assemblies = false;
  std::string axes;
  std::string json;
  std::string gltf;
  std::string csv;
};

/// `boxbeam motion`: the mechanism alone. Returns the exit code.
int run_motion(const MotionOptions& options);

struct SectionOptions {
  std::vector<std::string> profiles;
  std::string steel = "S355";
  std::string forces;  ///< "N = -600 kN, M_y = 1500 kN m"
  std::string json;
};

/// `boxbeam section`: properties of sections. Returns the exit code.
int run_section(const SectionOptions& options);

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

struct CompareOptions {
  CaseOptions of_case;
  std::string published;
  std::string json;
  std::string html;
};

/// `boxbeam compare`: published values beside ours. Returns the exit code.
int run_compare(const CompareOptions& options);

struct InitOptions {
  std::string kind;     ///< or the file; "": planar, of a robot spatial
  std::string file;     ///< "": KIND.toml; "-": standard output
  bool schema = false;  ///< whether the schema that it names is written beside it
  std::string urdf;     ///< file of the robot with which the case begins; "": none
  std::string mjcf;     ///< the same as a MuJoCo model; one of both at most
  std::string beam;     ///< the robot's link that is the beam; "": its heaviest
};

/// Whether a word names a case file: it ends in ".toml".
bool is_case_file(const std::string& word);

/// `boxbeam init`: writes a commented case that runs as it is, or one begun from a robot.
/// Never overwrites a case; a schema beside it is the program's own and is brought up to date.
/// Returns the exit code.
int run_init(const InitOptions& options);

}  // namespace boxbeam::program
