/// The functions of the standard: each hands its call to a FmuInstance. No exception leaves them: an
/// error becomes a message to the other program and a status.
#include "fmu/fmi3_handle.hpp"

#include <dlfcn.h>

#include <cmath>
#include <cstring>
#include <new>

#include "fmu/fmu_instance.hpp"

namespace dynamy::fmi3 {
namespace {

/// Calls `use`; what it throws becomes a message.
template <class Use>
Status attempt(const Handle& handle, const char* call, const Use& use) {
  try {
    use();
    return Status::ok;
  } catch (const std::bad_alloc&) {
    handle.say(Status::fatal, call, "out of memory");
    return Status::fatal;
  } catch (const std::exception& e) {
    handle.say(Status::error, call, e.what());
  } catch (...) {
    handle.say(Status::error, call, "something was thrown that is no std::exception");
  }
  return Status::error;
}

/// The same with the instance.
template <class Use>
Status guarded(Instance i, const char* call, const Use& use) {
  if (i == nullptr) return Status::error;
  const Handle& handle = *static_cast<const Handle*>(i);
  return attempt(handle, call, [&] { use(*handle.instance); });
}

/// The folder of this library, in which the plug-ins of the FMU are.
std::filesystem::path ownFolder() {
  Dl_info info{};
  if (::dladdr(reinterpret_cast<const void*>(&ownFolder), &info) == 0) return ".";
  return std::filesystem::absolute(info.dli_fname).parent_path();
}

/// "file:///tmp/fmu/resources" and the path itself.
std::filesystem::path pathOf(String resources) {
  const std::string text = resources != nullptr ? resources : "";
  constexpr std::string_view kScheme = "file://";
  return text.starts_with(kScheme) ? text.substr(kScheme.size()) : text;
}

std::string& bytesOf(State state) { return *static_cast<std::string*>(state); }

void expectEqual(std::size_t n, std::size_t nValues) {
  if (n != nValues) throw fmu::FmuError("all variables are scalars: as many values as references");
}

}  // namespace

Handle::Handle() = default;
Handle::~Handle() = default;

void Handle::say(Status status, const char* call, const std::string& text) const {
  if (log != nullptr) log(environment, status, "logStatusError", (call + (": " + text)).c_str());
}

Status unserved(Instance i, const char* call) {
  if (i != nullptr)
    static_cast<const Handle*>(i)->say(Status::error, call, "this FMU does not serve it");
  return Status::error;
}

}  // namespace dynamy::fmi3

using namespace dynamy::fmi3;
using dynamy::fmu::FmuInstance;
using dynamy::fmu::Mode;

const char* fmi3GetVersion() { return "3.0"; }

Status fmi3SetDebugLogging(Instance, bool, std::size_t, const String*) {
  return Status::ok;  // errors are always reported, and nothing else is
}

Instance fmi3InstantiateCoSimulation(String, String token, String resources, bool, bool,
                                     bool eventMode, bool earlyReturn, const Reference*,
                                     std::size_t, Environment e, LogMessage log,
                                     IntermediateUpdate update) {
  auto handle = std::make_unique<Handle>();
  handle->environment = e, handle->log = log, handle->update = update;
  handle->earlyReturn = earlyReturn;
  const Status status = attempt(*handle, "fmi3InstantiateCoSimulation", [&] {
    handle->instance = std::make_unique<FmuInstance>(pathOf(resources), ownFolder() / "dynamy",
                                                     token != nullptr ? token : "",
                                                     dynamy::fmu::Partner{eventMode, earlyReturn});
  });
  return status == Status::ok ? handle.release() : nullptr;
}

void fmi3FreeInstance(Instance i) { delete static_cast<Handle*>(i); }

Status fmi3EnterInitializationMode(Instance i, bool toleranceGiven, double tolerance, double start,
                                   bool stopGiven, double stop) {
  return guarded(i, "fmi3EnterInitializationMode", [&](FmuInstance& f) {
    f.enterInitialization(start, {toleranceGiven ? tolerance : 0.0, stopGiven ? stop : -1.0});
  });
}

Status fmi3ExitInitializationMode(Instance i) {
  return guarded(i, "fmi3ExitInitializationMode", [](FmuInstance& f) { f.exitInitialization(); });
}

Status fmi3EnterEventMode(Instance i) {
  return guarded(i, "fmi3EnterEventMode", [](FmuInstance& f) { f.enter(Mode::event); });
}

Status fmi3EnterStepMode(Instance i) {
  return guarded(i, "fmi3EnterStepMode", [](FmuInstance& f) { f.enter(Mode::step); });
}

Status fmi3Terminate(Instance i) {
  return guarded(i, "fmi3Terminate", [](FmuInstance& f) { f.enter(Mode::terminated); });
}

Status fmi3Reset(Instance i) {
  return guarded(i, "fmi3Reset", [](FmuInstance& f) { f.reset(); });
}

Status fmi3UpdateDiscreteStates(Instance i, bool* again, bool* terminate, bool* nominals,
                                bool* states, bool* hasNext, double* next) {
  return guarded(i, "fmi3UpdateDiscreteStates", [&](FmuInstance& f) {
    const double at = f.updateDiscrete();
    *again = *terminate = *nominals = *states = false;
    *hasNext = std::isfinite(at), *next = *hasNext ? at : 0.0;
  });
}

Status fmi3DoStep(Instance i, double t, double h, bool, bool* event, bool* terminate, bool* early,
                  double* reached) {
  const auto* handle = static_cast<const Handle*>(i);
  return guarded(i, "fmi3DoStep", [&](FmuInstance& f) {
    dynamy::fmu::CoupledRun::OnTheWay onTheWay;
    if (handle->update != nullptr)
      onTheWay = [&](double now) {
        bool returns = false;
        double at = now;
        handle->update(handle->environment, now, true, true, true, handle->earlyReturn, &returns,
                       &at);
        if (!returns || !handle->earlyReturn) return false;
        f.endAt(std::max(at, now));
        return true;
      };
    const dynamy::fmu::StepEnd end = f.step(t, h, onTheWay);
    *event = end.event, *terminate = false, *early = end.early, *reached = end.t;
  });
}

Status fmi3GetFloat64(Instance i, const Reference* r, std::size_t n, double* values,
                      std::size_t nValues) {
  return guarded(i, "fmi3GetFloat64", [&](FmuInstance& f) {
    expectEqual(n, nValues);
    for (std::size_t k = 0; k < n; ++k) values[k] = f.number(r[k]);
  });
}

Status fmi3SetFloat64(Instance i, const Reference* r, std::size_t n, const double* values,
                      std::size_t nValues) {
  return guarded(i, "fmi3SetFloat64", [&](FmuInstance& f) {
    expectEqual(n, nValues);
    for (std::size_t k = 0; k < n; ++k) f.set(r[k], values[k]);
  });
}

Status fmi3GetInt64(Instance i, const Reference* r, std::size_t n, std::int64_t* values,
                    std::size_t nValues) {
  return guarded(i, "fmi3GetInt64", [&](FmuInstance& f) {
    expectEqual(n, nValues);
    for (std::size_t k = 0; k < n; ++k) values[k] = f.status(r[k]);
  });
}

Status fmi3GetFMUState(Instance i, State* state) {
  return guarded(i, "fmi3GetFMUState", [&](FmuInstance& f) {
    std::string bytes = f.state();
    if (*state == nullptr)
      *state = new std::string(std::move(bytes));
    else
      bytesOf(*state) = std::move(bytes);
  });
}

Status fmi3SetFMUState(Instance i, State state) {
  return guarded(i, "fmi3SetFMUState", [&](FmuInstance& f) {
    if (state == nullptr) throw dynamy::fmu::FmuError("there is no state");
    f.state(bytesOf(state));
  });
}

Status fmi3FreeFMUState(Instance, State* state) {
  if (state != nullptr) {
    delete static_cast<std::string*>(*state);
    *state = nullptr;
  }
  return Status::ok;
}

Status fmi3SerializedFMUStateSize(Instance i, State state, std::size_t* size) {
  return guarded(i, "fmi3SerializedFMUStateSize", [&](FmuInstance&) {
    if (state == nullptr) throw dynamy::fmu::FmuError("there is no state");
    *size = bytesOf(state).size();
  });
}

Status fmi3SerializeFMUState(Instance i, State state, std::uint8_t* bytes, std::size_t size) {
  return guarded(i, "fmi3SerializeFMUState", [&](FmuInstance&) {
    if (state == nullptr || size != bytesOf(state).size())
      throw dynamy::fmu::FmuError("the size is not that of the state");
    std::memcpy(bytes, bytesOf(state).data(), size);
  });
}

Status fmi3DeserializeFMUState(Instance i, Bytes bytes, std::size_t size, State* state) {
  return guarded(i, "fmi3DeserializeFMUState", [&](FmuInstance&) {
    auto text = std::make_unique<std::string>(reinterpret_cast<const char*>(bytes), size);
    if (*state == nullptr)
      *state = text.release();
    else
      bytesOf(*state) = std::move(*text);
  });
}
