#pragma once

#include <string>
#include <vector>

namespace test {

/// A table of numbers with one header line, as the data files of the tests have it; lines that
/// begin with "#" are comments.
struct CsvTable {
  std::vector<std::string> header;
  std::vector<std::vector<double>> rows;
};

CsvTable read_csv(const std::string& path);

}  // namespace test
