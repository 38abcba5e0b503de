#include "program/commands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>

#include "boxbeam/core/error.hpp"
#include "boxbeam/project/project.hpp"
#include "boxbeam/project/robot.hpp"
#include "boxbeam/report/case_schema.hpp"
#include "boxbeam/report/files.hpp"
#include "program/exit_code.hpp"
#include "program/terminal.hpp"
#include "template_data.hpp"

namespace boxbeam::program {

namespace fs = std::filesystem;

namespace {

/// The commented case of a kind, which is the first of its examples.
std::string template_of(const std::string& kind) {
  return std::find_if(std::begin(template_data::examples), std::end(template_data::examples),
                      [&](const auto& example) { return example.kind == kind; })
      ->text;
}

/// The file that the first line of every template names for editors.
constexpr const char* schema_file = "boxbeam-case.schema.json";

bool begins_with_robot(const InitOptions& options) {
  return !options.urdf.empty() || !options.mjcf.empty();
}

/// The text of the case. That of a robot is read once, so that none is written that is no case.
std::string text_of(const InitOptions& options) {
  if (!begins_with_robot(options)) {
    if (!options.beam.empty())
      throw InputError("a template has its own beam",
                       "write --from-urdf or --from-mjcf with --beam, or leave it out");
    return template_of(options.kind);
  }
  if (options.kind != "spatial") {
    throw InputError("a robot moves in space", "write boxbeam init spatial, or leave the kind out");
  }
  const bool urdf = !options.urdf.empty();
  const std::string& file = urdf ? options.urdf : options.mjcf;
  std::string text =
      robots::case_text(urdf ? robots::read_urdf(file) : robots::read_mjcf(file), options.beam);
  parse_project(file + " as a case", text);
  return text;
}

}  // namespace

bool is_case_file(const std::string& word) { return word.ends_with(".toml"); }

int run_init(const InitOptions& given) {
  InitOptions options = given;
  const std::string usual = begins_with_robot(options) ? "spatial" : "planar";
  if (is_case_file(given.kind)) {
    if (!given.file.empty()) {
      throw InputError(fmt::format("two files: {} and {}", given.kind, given.file),
                       "name the kind first: boxbeam init planar FILE.toml");
    }
    options.kind = usual;
    options.file = given.kind;
  }
  if (options.kind.empty()) options.kind = usual;
  const std::string text = text_of(options);
  if (options.file == "-") {
    if (options.schema) {
      throw InputError("the schema is written beside a case that is a file",
                       "name a file, or write it alone: boxbeam schema case");
    }
    put(text);
    return all_pass;
  }
  const std::string file = options.file.empty() ? options.kind + ".toml" : options.file;
  std::error_code error;
  if (fs::exists(fs::symlink_status(file, error))) {
    throw InputError(fmt::format("{} is there already, and nothing is overwritten", file),
                     fmt::format("name another file: boxbeam init {} FILE.toml", options.kind));
  }
  const fs::path folder = fs::path(file).parent_path();
  if (!folder.empty() && !fs::is_directory(folder, error)) {
    throw OutputError(fmt::format("there is no folder {} to write the case to", folder.string()));
  }
  std::string written = fmt::format("Written: {}, a case that runs as it is", file);
  if (options.schema) {
    const std::string schema = (folder / schema_file).string();
    write_file(schema, schema_of("case"));
    written += fmt::format(", and {}, by which editors of TOML know its keys", schema);
  }
  write_file(file, text);
  put_text(fmt::format("{}. Next:\n\n  boxbeam verify {}\n", written, shell_word(file)));
  return all_pass;
}

}  // namespace boxbeam::program
