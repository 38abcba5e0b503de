#pragma once

#include "boxbeam/report/document.hpp"
#include "boxbeam/report/optimum_report.hpp"
#include "boxbeam/study/study_reliability.hpp"

/// Pages of studies.
namespace boxbeam {

/// Of `boxbeam sweep`: its designs to be looked through, what makes their scatter, statistics.
report::Document study_document(const StudySummary& summary, const DesignRows& rows);

/// Of `boxbeam reliability`.
report::Document reliability_document(const StudyReliability& of);

/// Of `boxbeam optimise`: the best design, the front of two goals, and all designs looked at.
report::Document optimum_document(const OptimumReport& of);

}  // namespace boxbeam
