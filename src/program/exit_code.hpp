#pragma once

namespace boxbeam::program {

/// What the program tells the shell. Where several apply: 2 before 3 before 4 before 1.
enum ExitCode {
  all_pass = 0,
  check_fails = 1,
  wrong_input = 2,
  not_possible = 3,
  output_failed = 4
};

}  // namespace boxbeam::program
