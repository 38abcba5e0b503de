#pragma once

#include <string>
#include <vector>

#include "boxbeam/report/document.hpp"

/// Numbers of a calculation sheet, rounded so that a reader who puts them into a pocket calculator
/// comes to the result that stands there.
namespace boxbeam::report {

using Steps = std::vector<Step>;

/// Steps behind others.
void append(Steps& steps, Steps others);

/// A number behind a plus sign or a factor: negative ones in brackets.
std::string term(const std::string& number);

/// "3.8657e9", "-4.572e-4" with so many significant digits.
std::string scientific(double value, int digits);

/// A damage or a share of it: "0.9975", "2.486e-5".
std::string share(double value);

std::string mm2(double m2);
std::string mm3(double m3);
std::string mm4(double m4);

/// Partial factors and the like, at least two decimals: "1.00", "1.35", "0.9".
std::string number(double value);

/// A sum of stresses, each with as many decimals as the sum needs for four digits.
struct StressSum {
  std::string terms;  ///< "-0.32 MPa + (-16.73 MPa)"
  std::string sum;    ///< "-17.05 MPa"
};

/// `minus`: which of them a minus stands before, none where it is empty.
StressSum sum_of(const std::vector<double>& pascals, const std::vector<bool>& minus = {});

}  // namespace boxbeam::report
