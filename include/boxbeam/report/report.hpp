#pragma once

#include <functional>
#include <string>

#include "boxbeam/project/project.hpp"
#include "boxbeam/report/document.hpp"
#include "boxbeam/verification/verify.hpp"

namespace boxbeam {

/// How much a report says.
enum class ReportLevel {
  summary,    ///< verdict, governing checks, remarks, the pictures that decide
  governing,  ///< and everything that the governing checks rest on
  full,       ///< and every check, the worst of every station derived, every table, the input
};

/// The report of a verification. Source of its date: SOURCE_DATE_EPOCH where it is set, else the
/// clock (UTC).
report::Document report_of(const Project& project, const Verification& verification,
                           ReportLevel level = ReportLevel::governing);

/// The same with those of its pictures only that have been drawn; a chapter that held no more than
/// pictures goes with them.
report::Document with_pictures(report::Document document,
                               const std::function<bool(const std::string& name)>& drawn);

/// One check as formula, substituted values, result and source.
report::Sheet sheet_of(const Project& project, const Verification& verification,
                       const CheckResult& result);

/// "2026-11-21" by SOURCE_DATE_EPOCH or the clock, UTC.
std::string report_date();

}  // namespace boxbeam
