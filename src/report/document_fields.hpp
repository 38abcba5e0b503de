#pragma once

#include "boxbeam/report/comparison.hpp"
#include "boxbeam/report/optimum_report.hpp"
#include "boxbeam/study/sensitivities.hpp"
#include "boxbeam/study/solution.hpp"
#include "boxbeam/study/study_reliability.hpp"
#include "boxbeam/study/study_summary.hpp"
#include "boxbeam/verification/any_motion_result.hpp"
#include "boxbeam/verification/history_fatigue.hpp"
#include "boxbeam/verification/section_summary.hpp"
#include "boxbeam/verification/verify.hpp"
#include "fields.hpp"

/// The fields of the documents in JSON.
namespace boxbeam::report {

/// `beams`: all of a case, where it has several; `sensitivities`: where they are asked for.
void put_results(Fields& to, const Project& project, const Verification& verification,
                 const std::vector<VerifiedBeam>* beams = nullptr,
                 const Sensitivities* sensitivities = nullptr);
/// Beside the document, for those who ask by key: "utilisation", of the check that is used most,
/// and "governing.effective_section" and the like, of every criterion that is judged.
void put_governing(Fields& to, const Verification& verification);
void put_motion(Fields& to, const AnyMotionResult& motion);
void put_motion(Fields& to, const MotionResult& motion);
void put_motion(Fields& to, const ChainMotionResult& motion);
void put_motion(Fields& to, const FlexibleMotionResult& motion);
void put_state(Fields& to, const InstantResult& state);
void put_state(Fields& to, const ChainInstant& state);
void put_history(Fields& to, const HistoryDemand& demand, const HistoryFatigue& fatigue);
void put_section_summary(Fields& to, const SectionSummary& summary);
void put_sensitivities(Fields& to, const Sensitivities& of);
void put_study(Fields& to, const StudySummary& summary);
void put_reliability(Fields& to, const StudyReliability& of);
void put_solution(Fields& to, const Solution& solution);
void put_optimum(Fields& to, const OptimumReport& of);
void put_comparison(Fields& to, const Project& project, const Comparison& comparison);

/// The text of a document that `put` fills.
template <class Put>
std::string document_text(const Put& put) {
  Json document = Json::object();
  put(Fields(document));
  return document.dump(2) + "\n";
}

}  // namespace boxbeam::report
