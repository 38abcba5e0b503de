#include "support/csv.hpp"

#include <sstream>

#include "support/program.hpp"

namespace test {

CsvTable read_csv(const std::string& path) {
  CsvTable table;
  std::istringstream text(read_file(path));
  for (std::string line; std::getline(text, line);) {
    if (line.empty() || line.front() == '#') continue;
    std::istringstream cells(line);
    const bool header = table.header.empty();
    if (!header) table.rows.emplace_back();
    for (std::string cell; std::getline(cells, cell, ',');) {
      if (header)
        table.header.push_back(cell);
      else
        table.rows.back().push_back(std::stod(cell));
    }
  }
  return table;
}

}  // namespace test
