#include "program/init_command.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "boxbeam/core/error.hpp"
#include "boxbeam/report/files.hpp"
#include "program/exit_code.hpp"
#include "program/terminal.hpp"
#include "template_data.hpp"

namespace boxbeam::program {

int run_init(const InitOptions& options) {
  const char* text = options.kind == "spatial"    ? template_data::spatial
                     : options.kind == "flexible" ? template_data::flexible
                                                  : template_data::planar;
  if (options.file == "-") {
    put(text);
    return all_pass;
  }
  const std::string file = options.file.empty() ? options.kind + ".toml" : options.file;
  std::error_code error;
  if (std::filesystem::exists(std::filesystem::symlink_status(file, error))) {
    throw InputError(fmt::format("{} is there already, and nothing is overwritten", file),
                     fmt::format("name another file: boxbeam init {} FILE.toml", options.kind));
  }
  write_file(file, text);
  put(fmt::format("Written: {}, a case that runs as it is. Next:\n\n  boxbeam verify {}\n", file,
                  shell_word(file)));
  return all_pass;
}

}  // namespace boxbeam::program
