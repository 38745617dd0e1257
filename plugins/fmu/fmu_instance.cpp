#include "fmu_instance.hpp"

#include <array>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

namespace dynamy {
namespace {

/// Status above which a call has failed: ok 0, warning 1, discard 2, error 3, fatal 4.
constexpr int kWarning = 1;

/// A step ends this part of it before its end at the latest.
constexpr double kReached = 1e-9;

/// Updates of discrete states after which an event has no end.
constexpr int kMostUpdates = 1000;

void keep(void* environment, int status, const char* message) {
  if (environment != nullptr && status > kWarning && message != nullptr)
    *static_cast<std::string*>(environment) = message;
}

// ---- FMI 2.0 -----------------------------------------------------------------------------------

/// Takes what an FMU 2.0 logs, a format with its arguments.
void log2(void* environment, const char*, int status, const char*, const char* format, ...) {
  std::array<char, 1000> text{};
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(text.data(), text.size(), format, arguments);
  va_end(arguments);
  keep(environment, status, text.data());
}

struct Callbacks2 {
  void (*logger)(void*, const char*, int, const char*, const char*, ...) = log2;
  void* (*allocate)(std::size_t, std::size_t) = std::calloc;
  void (*release)(void*) = std::free;
  void (*stepFinished)(void*, int) = nullptr;
  void* environment = nullptr;
};

class Fmu2 final : public FmuInstance {
 public:
  Fmu2(const std::shared_ptr<const FmuFile>& file, const std::string& name) : FmuInstance(file) {
    callbacks_.environment = &library.logged;
    using Make = void*(const char*, int, const char*, const char*, const Callbacks2*, int, int);
    constexpr int kCoSimulation = 1;
    component = library.function<Make>("Instantiate")(
        name.c_str(), kCoSimulation, file->token.c_str(),
        ("file://" + (file->folder / "resources").string()).c_str(), &callbacks_, 0, 0);
  }
  void advance(double t, double h) override { library.call("DoStep", component, t, h, 1); }
  void exchange(const Values& inputs, bool) override { set(inputs); }
  ~Fmu2() override { release(); }

 private:
  void begin(double t) override {
    library.call("SetupExperiment", component, 0, 0.0, t, 0, 0.0);
    library.call("EnterInitializationMode", component);
  }
  void initialized() override { library.call("ExitInitializationMode", component); }
  const char* functionFor(FmuType type) const override {
    return type == FmuType::real ? "Real" : type == FmuType::flag ? "Boolean" : "Integer";
  }
  Callbacks2 callbacks_;
};

// ---- FMI 3.0 -----------------------------------------------------------------------------------

void log3(void* environment, int status, const char*, const char* message) {
  keep(environment, status, message);
}

class Fmu3 final : public FmuInstance {
 public:
  Fmu3(const std::shared_ptr<const FmuFile>& file, const std::string& name) : FmuInstance(file) {
    using Make =
        void*(const char*, const char*, const char*, bool, bool, bool, bool, const std::uint32_t*,
              std::size_t, void*, void (*)(void*, int, const char*, const char*), void*);
    component = library.function<Make>("InstantiateCoSimulation")(
        name.c_str(), file->token.c_str(), (file->folder / "resources/").c_str(), false, false,
        file->events, file->events, nullptr, 0, &library.logged, log3, nullptr);
  }
  void advance(double t, double h) override {
    const double end = t + h;
    // An event at the end belongs to exchange(), which sets the inputs in it.
    while (end - t > kReached * h) {
      bool event = false, terminate = false, early = false;
      double reached = end;
      library.call("DoStep", component, t, end - t, true, &event, &terminate, &early, &reached);
      if (terminate) throw std::runtime_error("it ends its run");
      if (!early) return;
      if (!(reached > t) && !event) throw std::runtime_error("its step stands still");
      t = reached;
      if (event && library.file().events && end - t > kReached * h) update({}, false);
    }
  }
  void exchange(const Values& inputs, bool ticks) override {
    if (!library.file().events) return set(inputs);
    update(inputs, ticks);
  }
  ~Fmu3() override { release(); }

 private:
  void begin(double t) override {
    library.call("EnterInitializationMode", component, false, 0.0, t, false, 0.0);
  }
  void initialized() override {
    library.call("ExitInitializationMode", component);  // it is in event mode then, if it has one
    if (library.file().events) update({}, true, true);
  }
  /// One event: inputs, clocks that tick, discrete states until nothing changes.
  void update(const Values& inputs, bool ticks, bool inEvent = false) {
    if (!inEvent) library.call("EnterEventMode", component);
    set(inputs);
    if (ticks)
      for (const FmuClock& clock : library.file().clocks) {
        const bool active = true;
        library.call("SetClock", component, &clock.reference, std::size_t{1}, &active);
      }
    bool again = true;
    for (int i = 0; again; ++i) {
      if (i == kMostUpdates) throw std::runtime_error("its event has no end");
      bool terminate = false, nominals = false, states = false, hasNext = false;
      double next = 0.0;
      library.call("UpdateDiscreteStates", component, &again, &terminate, &nominals, &states,
                   &hasNext, &next);
      if (terminate) throw std::runtime_error("it ends its run");
    }
    library.call("EnterStepMode", component);
  }
  const char* functionFor(FmuType type) const override {
    switch (type) {
      case FmuType::real:
        return "Float64";
      case FmuType::real32:
        return "Float32";
      case FmuType::int8:
        return "Int8";
      case FmuType::uint8:
        return "UInt8";
      case FmuType::int16:
        return "Int16";
      case FmuType::uint16:
        return "UInt16";
      case FmuType::int32:
        return "Int32";
      case FmuType::uint32:
        return "UInt32";
      case FmuType::int64:
        return "Int64";
      case FmuType::uint64:
        return "UInt64";
      case FmuType::flag:
        break;
    }
    return "Boolean";
  }
};

}  // namespace

std::unique_ptr<FmuInstance> FmuInstance::make(const std::shared_ptr<const FmuFile>& file,
                                               const std::string& name) {
  std::unique_ptr<FmuInstance> out;
  if (file->version == 2)
    out = std::make_unique<Fmu2>(file, name);
  else
    out = std::make_unique<Fmu3>(file, name);
  if (out->component == nullptr)
    throw std::runtime_error(
        "it makes no instance" +
        (out->library.logged.empty()
             ? std::string(file->onlyOnce ? ": it allows one in a program" : "")
             : ": " + out->library.logged));
  return out;
}

/// To be called by the destructor of each kind: its callbacks serve until then.
void FmuInstance::release() const {
  if (component != nullptr) library.function<void(void*)>("FreeInstance")(component);
}

void FmuInstance::start(double t, const Values& parameters, const Values& inputs) {
  set(parameters);
  begin(t);
  set(inputs);
  initialized();
}

template <class T>
double FmuInstance::exchangeAs(const FmuVariable& v, const double* write) const {
  T value =
      write != nullptr ? static_cast<T>(std::is_integral_v<T> ? std::round(*write) : *write) : T{};
  const std::string name = (write != nullptr ? "Set" : "Get") + std::string(functionFor(v.type));
  if (library.file().version == 2)
    library.call(name.c_str(), component, &v.reference, std::size_t{1}, &value);
  else
    library.call(name.c_str(), component, &v.reference, std::size_t{1}, &value, std::size_t{1});
  return static_cast<double>(value);
}

double FmuInstance::exchangeOne(const FmuVariable& v, const double* write) const {
  if (v.type == FmuType::flag) {
    const double one = write != nullptr && *write > 0.5 ? 1.0 : 0.0;
    const double* flag = write != nullptr ? &one : nullptr;
    return library.file().version == 2 ? exchangeAs<int>(v, flag) : exchangeAs<bool>(v, flag);
  }
  switch (v.type) {
    case FmuType::real32:
      return exchangeAs<float>(v, write);
    case FmuType::int8:
      return exchangeAs<std::int8_t>(v, write);
    case FmuType::uint8:
      return exchangeAs<std::uint8_t>(v, write);
    case FmuType::int16:
      return exchangeAs<std::int16_t>(v, write);
    case FmuType::uint16:
      return exchangeAs<std::uint16_t>(v, write);
    case FmuType::int32:
      return exchangeAs<std::int32_t>(v, write);
    case FmuType::uint32:
      return exchangeAs<std::uint32_t>(v, write);
    case FmuType::int64:
      return exchangeAs<std::int64_t>(v, write);
    case FmuType::uint64:
      return exchangeAs<std::uint64_t>(v, write);
    default:
      return exchangeAs<double>(v, write);
  }
}

FmuInstance::Bytes FmuInstance::state() const {
  const std::string word = library.file().version == 2 ? "FMUstate" : "FMUState";
  void* state = nullptr;
  library.call(("Get" + word).c_str(), component, &state);
  std::size_t size = 0;
  library.call(("Serialized" + word + "Size").c_str(), component, state, &size);
  Bytes bytes(size);
  library.call(("Serialize" + word).c_str(), component, state, bytes.data(), size);
  library.call(("Free" + word).c_str(), component, &state);
  return bytes;
}

void FmuInstance::setBack(std::span<const std::uint8_t> bytes) const {
  const bool two = library.file().version == 2;
  const std::string word = two ? "FMUstate" : "FMUState";
  void* state = nullptr;
  library.call(((two ? "DeSerialize" : "Deserialize") + word).c_str(), component, bytes.data(),
               bytes.size(), &state);
  library.call(("Set" + word).c_str(), component, state);
  library.call(("Free" + word).c_str(), component, &state);
}

double FmuInstance::get(const FmuVariable& v) const { return exchangeOne(v, nullptr); }

void FmuInstance::set(const Values& values) {
  for (const auto& [v, value] : values) exchangeOne(*v, &value);
}

}  // namespace dynamy
