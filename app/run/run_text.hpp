/// Describes a run for people (standard output) and for programs (run.json).
#pragma once
#include <dynamy/io/fclib/problem_dump.hpp>
#include <dynamy/io/files/json_writer.hpp>
#include <dynamy/io/replay/replay_page.hpp>

#include "run/run_job.hpp"

namespace dynamy::app {

/// "step 0.001 s" or "tolerance 1e-06".
std::string stepText(const Model& model);
/// A line about joints that became coordinates; empty: none did.
std::string coordinatesText(const Composition& c);
/// Lines that say why joints are coordinates or constraints, and which bodies may sleep.
std::string reasonsText(const Model& model);
/// Two lines with model, sizes, scheme, solver, step and end time, then the notes on the model.
std::string headText(const Model& model, const RunChoice& choice);

/// Steps, energy, penetration, solver, checks, files and hash.
std::string resultText(const Model& model, const RunReport& report,
                       const std::vector<CheckResult>& checks, const std::filesystem::path& folder);

/// How the run ended: "finished", "stopped by SIGTERM", "failed".
std::string stateText(const RunReport& report);

/// Writes the member `files` of run.json: size and CRC-32 of the recorded files at the end of the
/// run.
void writeFiles(JsonWriter& json, const std::vector<RecordedFile>& files);

/// "max ball.z 0.4 … 1 s"
std::string checkText(const CheckResult& check);

/// The lines of the checks that failed, for calls that print nothing else; "" if all hold.
std::string failedChecks(const std::vector<CheckResult>& checks);

/// Message that the replay does not hold all frames; "" if it does.
std::string thinningText(const ReplaySize& size);

/// One line for each warning, except those about unsolved inclusions, which unsolvedText() reports.
/// With `accepted`: without notes and without the kinds that are accepted.
std::string warningsText(const RunReport& report, const Accepted* accepted = nullptr);

/// "finished, but: …" with the exit status of a qualified run; empty if the run is not qualified or
/// has failed.
std::string qualifiedText(const RunReport& report, const std::vector<CheckResult>& checks,
                          const Accepted& accepted);

/// The worst step whose inclusion was not solved: place, methods tried, reason and advice; "" if
/// all were solved.
std::string unsolvedText(const RunReport& report);

/// Folder of the dumped problems, and how many do not fit FCLIB's layout, with the reason.
std::string problemsText(const ProblemDump& dump, const std::filesystem::path& folder);
void writeProblems(JsonWriter& json, const ProblemDump& dump);

}  // namespace dynamy::app
