/// A run for people (standard output) and for programs (run.json).
#pragma once
#include <dynamy/io/fclib/problem_dump.hpp>
#include <dynamy/io/files/json_writer.hpp>
#include <dynamy/io/replay/replay_page.hpp>

#include "run/run_job.hpp"

namespace dynamy::app {

/// Model, sizes, scheme, solver, step and end time: two lines.
/// "step 0.001 s" or "tolerance 1e-06".
std::string stepText(const Model& model);
std::string headText(const Model& model, const RunChoice& choice);

/// Steps, energy, penetration, solver, checks, files and hash.
std::string resultText(const Model& model, const RunReport& report,
                       const std::vector<CheckResult>& checks, const std::filesystem::path& folder);

/// All members of run.json. `state` "": how the run ended.
void writeFacts(JsonWriter& json, const Model& model, const RunChoice& choice,
                const RunReport& report, const std::vector<CheckResult>& checks,
                const std::string& state);

/// "finished", "stopped by SIGTERM", "failed".
std::string stateText(const RunReport& report);

/// Member `files` of run.json: bytes and CRC-32 of the recorded files at the end of the run.
void writeFiles(JsonWriter& json, const std::vector<RecordedFile>& files);

/// "max ball.z 0.4 … 1 s"
std::string checkText(const CheckResult& check);

/// The lines of the checks that failed, for calls that print nothing else; "" if all hold.
std::string failedChecks(const std::vector<CheckResult>& checks);

/// What to say when the replay does not hold all frames; else "".
std::string thinningText(const ReplaySize& size);

/// A line a warning, but for unsolved inclusions, which unsolvedText() reports; with `accepted`
/// only those that qualify the run and are not accepted.
std::string warningsText(const RunReport& report, const Accepted* accepted = nullptr);

/// "finished, but: …" with the exit status that follows; empty: as the model asks, or failed.
std::string qualifiedText(const RunReport& report, const std::vector<CheckResult>& checks,
                          const Accepted& accepted);

/// The worst step whose inclusion was not solved: where, what was tried, why, what to do; "": none.
std::string unsolvedText(const RunReport& report);

/// Where the dumped problems lie, how many had no place in FCLIB's layout and why.
std::string problemsText(const ProblemDump& dump, const std::filesystem::path& folder);
void writeProblems(JsonWriter& json, const ProblemDump& dump);

/// "16 hexadecimal digits".
std::string hashText(std::uint64_t hash);

}  // namespace dynamy::app
