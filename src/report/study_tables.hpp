#pragma once

#include "boxbeam/report/optimum_report.hpp"
#include "boxbeam/study/study_reliability.hpp"
#include "text_layout.hpp"

/// What the texts and the pages of studies both have.
namespace boxbeam::report {

layout::Table statistics_table(const StudySummary& summary);
/// How exact its quantiles are; "" where they are.
std::string quantiles_text(const StudySummary& summary);
layout::Table indices_table(const StudySummary& summary, const SobolIndices& indices);
/// Which designs have a row, where not all have.
std::string kept_text(const StudySummary& summary);
/// Why designs were not verified, the most frequent first.
std::vector<std::string> reasons_text(const StudySummary& summary);

layout::Table methods_table(const StudyReliability& of);
/// What is to be known of the methods.
std::vector<std::string> methods_remarks(const StudyReliability& of);
layout::Table point_table(const std::vector<VariableAtPoint>& point);

layout::Table chosen_table(const OptimumReport& of);
layout::Table active_table(const OptimumReport& of);
layout::Table front_table(const OptimumReport& of);
/// The least goal, its verdict, how it was searched and checked: names with what is said of each.
std::vector<std::pair<std::string, std::string>> optimum_facts(const OptimumReport& of);

}  // namespace boxbeam::report
