/// The C interface of an FMU, declared from the text of the standard FMI 3.0: the types of its
/// arguments, and all functions that a library has to have, also those of other kinds of FMUs than
/// co-simulation, which only report that they are not served.
#pragma once
#include <cstddef>
#include <cstdint>

namespace dynamy::fmi3 {

using Instance = void*;
using Environment = void*;
using State = void*;
using Reference = std::uint32_t;
using String = const char*;
using Bytes = const std::uint8_t*;

enum class Status : int { ok = 0, warning = 1, discard = 2, error = 3, fatal = 4 };

using LogMessage = void (*)(Environment, Status, String category, String message);
using IntermediateUpdate = void (*)(Environment, double time, bool setRequested, bool getAllowed,
                                    bool stepFinished, bool canReturnEarly, bool* returnRequested,
                                    double* returnTime);
using Call = void (*)();
using ClockUpdate = void (*)(Environment);

}  // namespace dynamy::fmi3

#pragma GCC visibility push(default)
extern "C" {

// All FMUs.
const char* fmi3GetVersion();
dynamy::fmi3::Status fmi3SetDebugLogging(dynamy::fmi3::Instance i, bool on, std::size_t n,
                                         const dynamy::fmi3::String* categories);
dynamy::fmi3::Instance fmi3InstantiateCoSimulation(
    dynamy::fmi3::String name, dynamy::fmi3::String token, dynamy::fmi3::String resources,
    bool visible, bool logging, bool eventMode, bool earlyReturn,
    const dynamy::fmi3::Reference* intermediate, std::size_t n, dynamy::fmi3::Environment e,
    dynamy::fmi3::LogMessage log, dynamy::fmi3::IntermediateUpdate update);
void fmi3FreeInstance(dynamy::fmi3::Instance i);
dynamy::fmi3::Status fmi3EnterInitializationMode(dynamy::fmi3::Instance i, bool toleranceGiven,
                                                 double tolerance, double start, bool stopGiven,
                                                 double stop);
dynamy::fmi3::Status fmi3ExitInitializationMode(dynamy::fmi3::Instance i);
dynamy::fmi3::Status fmi3EnterEventMode(dynamy::fmi3::Instance i);
dynamy::fmi3::Status fmi3EnterStepMode(dynamy::fmi3::Instance i);
dynamy::fmi3::Status fmi3Terminate(dynamy::fmi3::Instance i);
dynamy::fmi3::Status fmi3Reset(dynamy::fmi3::Instance i);
dynamy::fmi3::Status fmi3UpdateDiscreteStates(dynamy::fmi3::Instance i, bool* again,
                                              bool* terminate, bool* nominals, bool* states,
                                              bool* hasNext, double* next);
dynamy::fmi3::Status fmi3DoStep(dynamy::fmi3::Instance i, double t, double h, bool forgets,
                                bool* event, bool* terminate, bool* early, double* reached);

// Values.
dynamy::fmi3::Status fmi3GetFloat64(dynamy::fmi3::Instance i, const dynamy::fmi3::Reference* r,
                                    std::size_t n, double* values, std::size_t nValues);
dynamy::fmi3::Status fmi3SetFloat64(dynamy::fmi3::Instance i, const dynamy::fmi3::Reference* r,
                                    std::size_t n, const double* values, std::size_t nValues);
dynamy::fmi3::Status fmi3GetInt64(dynamy::fmi3::Instance i, const dynamy::fmi3::Reference* r,
                                  std::size_t n, std::int64_t* values, std::size_t nValues);

// State.
dynamy::fmi3::Status fmi3GetFMUState(dynamy::fmi3::Instance i, dynamy::fmi3::State* state);
dynamy::fmi3::Status fmi3SetFMUState(dynamy::fmi3::Instance i, dynamy::fmi3::State state);
dynamy::fmi3::Status fmi3FreeFMUState(dynamy::fmi3::Instance i, dynamy::fmi3::State* state);
dynamy::fmi3::Status fmi3SerializedFMUStateSize(dynamy::fmi3::Instance i, dynamy::fmi3::State state,
                                                std::size_t* size);
dynamy::fmi3::Status fmi3SerializeFMUState(dynamy::fmi3::Instance i, dynamy::fmi3::State state,
                                           std::uint8_t* bytes, std::size_t size);
dynamy::fmi3::Status fmi3DeserializeFMUState(dynamy::fmi3::Instance i, dynamy::fmi3::Bytes bytes,
                                             std::size_t size, dynamy::fmi3::State* state);

}  // extern "C"
#pragma GCC visibility pop
