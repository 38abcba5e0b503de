#include <fmt/format.h>

#include <filesystem>

#include "boxbeam/core/code_points.hpp"
#include "number_rows.hpp"
#include "signal_reader.hpp"
#include "text_lines.hpp"

namespace boxbeam {
namespace {

struct ByExtension {
  std::string_view extension;
  SignalFormat format;
};
constexpr ByExtension by_extension[] = {{".outb", SignalFormat::openfast_binary},
                                        {".jnt", SignalFormat::mbdyn},
                                        {".frc", SignalFormat::mbdyn},
                                        {".act", SignalFormat::mbdyn},
                                        {".tab", SignalFormat::request_table},
                                        {".out", SignalFormat::request_table},
                                        {".rpc", SignalFormat::rpc3},
                                        {".rsp", SignalFormat::rpc3},
                                        {".tim", SignalFormat::rpc3}};

/// Files that are known and not read, by their first bytes.
struct NotRead {
  std::string_view beginning;
  const char* name;
  const char* hint;
};
constexpr NotRead not_read[] = {{"MDF ", "MDF", "convert it to CSV, for example with asammdf"},
                                {"TDSm", "TDMS", "convert it to CSV, for example with npTDMS"},
                                {"MATLAB", "MATLAB", "convert it to CSV"},
                                {"PK\x03\x04", "a spreadsheet or an archive", "save it as CSV"}};

std::string small_extension(const std::string& path) {
  return small_letters(std::filesystem::path(path).extension().string());
}

/// The format of a text whose first lines tell it.
std::optional<SignalFormat> format_by_lines(const FileBytes& bytes, const std::string& extension) {
  constexpr int most_lines = 200;
  TextLines lines(std::make_unique<FileBytes>(bytes.path()));
  bool after_names = false;
  while (lines.number() < most_lines && lines.next()) {
    const std::string_view line = trimmed(lines.line());
    if (line.starts_with("#Exudyn")) return SignalFormat::exudyn;
    if (line.starts_with("# Step ") || line.starts_with("Step ")) {
      if (extension == ".out") {
        bytes.fail("this is the file of MBDyn's steps",
                   "give the .jnt, .frc, .act or .nc file beside it");
      }
    }
    if (line.empty()) continue;
    const std::vector<Field> words = signal_fields(line, ' ');
    // Units of CSV stand in parentheses too, but with something between the columns.
    if (extension != ".csv" && after_names && words.front().text.starts_with('(') &&
        words.size() > 1 && line.find_first_of(",;") == std::string_view::npos) {
      return SignalFormat::openfast_text;
    }
    after_names = words.front().text == "Time" || words.front().text == "TIME";
    if (begins_with_number(line)) break;
  }
  return std::nullopt;
}

}  // namespace

SignalFormat format_of(const FileBytes& bytes, const SignalSource& source) {
  if (bytes.size() == 0) bytes.fail("the file is empty", "give a file of signals");
  if (source.format) return *source.format;
  char raw[16] = {};
  const std::string_view first(raw, bytes.read_some(0, raw, sizeof raw));
  for (const NotRead& kind : not_read) {
    if (first.starts_with(kind.beginning)) {
      bytes.fail(std::string("files of ") + kind.name + " are not read", kind.hint);
    }
  }
  using namespace std::string_view_literals;
  // Classic, with 64-bit places, with 64-bit data; NetCDF-4 is HDF5.
  for (const std::string_view& of : {"CDF\1"sv, "CDF\2"sv, "CDF\5"sv, "\x89HDF"sv}) {
    if (first.starts_with(of)) return SignalFormat::netcdf;
  }
  if (first.starts_with("FORMAT\0"sv) || first.starts_with("FORMAT  ")) return SignalFormat::rpc3;
  const bool small_number = first.size() > 4 && first[0] >= 1 && first[0] <= 4 && first[1] == '\0';
  if (small_number) return SignalFormat::openfast_binary;
  const std::string extension = small_extension(source.path);
  for (const ByExtension& known : by_extension) {
    const bool text = known.format == SignalFormat::request_table;
    if (!text && extension == known.extension) return known.format;
  }
  if (const auto format = format_by_lines(bytes, extension)) return *format;
  if (extension == ".req") return SignalFormat::request_steps;
  for (const ByExtension& known : by_extension) {
    if (extension == known.extension) return known.format;
  }
  return SignalFormat::csv;
}

std::string_view word_of(SignalFormat format) {
  switch (format) {
    case SignalFormat::csv: return "csv";
    case SignalFormat::openfast_text: return "openfast-text";
    case SignalFormat::openfast_binary: return "openfast-binary";
    case SignalFormat::mbdyn: return "mbdyn";
    case SignalFormat::exudyn: return "exudyn";
    case SignalFormat::request_table: return "request-table";
    case SignalFormat::request_steps: return "request-steps";
    case SignalFormat::rpc3: return "rpc3";
    case SignalFormat::netcdf: return "netcdf";
  }
  return "";
}

std::string_view name_of(SignalFormat format) {
  switch (format) {
    case SignalFormat::csv: return "CSV";
    case SignalFormat::openfast_text: return "OpenFAST text";
    case SignalFormat::openfast_binary: return "OpenFAST binary";
    case SignalFormat::mbdyn: return "MBDyn";
    case SignalFormat::exudyn: return "Exudyn sensor";
    case SignalFormat::request_table: return "request table";
    case SignalFormat::request_steps: return "request steps";
    case SignalFormat::rpc3: return "RPC III";
    case SignalFormat::netcdf: return "NetCDF";
  }
  return "";
}

OpenedSignals open_signals(const SignalSource& source) {
  auto bytes = std::make_unique<FileBytes>(source.path);
  for (const std::optional<double>& given : {source.time_step, source.time_unit}) {
    if (given && !(*given > 0.0 && *given <= 1e9)) {
      bytes->fail(fmt::format("a time step or unit of the time of {} s is given", *given),
                  "it is above zero, for example \"0.01 s\"");
    }
  }
  switch (format_of(*bytes, source)) {
    case SignalFormat::csv: return open_csv_signals(std::move(bytes), source);
    case SignalFormat::openfast_text: return open_openfast_text(std::move(bytes), source);
    case SignalFormat::openfast_binary: return open_openfast_binary(std::move(bytes), source);
    case SignalFormat::mbdyn: return open_mbdyn_signals(std::move(bytes), source);
    case SignalFormat::exudyn: return open_exudyn_sensor(std::move(bytes), source);
    case SignalFormat::request_table: return open_request_table(std::move(bytes), source);
    case SignalFormat::request_steps: return open_request_steps(std::move(bytes), source);
    case SignalFormat::rpc3: return open_rpc3_signals(std::move(bytes), source);
    case SignalFormat::netcdf: return open_netcdf_signals(std::move(bytes), source);
  }
  return nullptr;
}

void refuse_time_step(const FileBytes& bytes, const SignalSource& source) {
  if (!source.time_step) return;
  bytes.fail("the file has its own time, and a time step is given", "take the time step away");
}

}  // namespace boxbeam
