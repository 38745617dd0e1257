// A program that runs an FMU as others do: it knows the unpacked folder and the text of FMI 3.0, and
// nothing of dynamY. Its functions are looked up in the library of the FMU.
//
//   fmu_master FOLDER run until=3 h=1e-3 [tolerance=1e-10] [event] [set:mu=0.31] [in:motor=2] out=a,b
//   fmu_master FOLDER state …    state: set back, by another instance, from the start
//   fmu_master FOLDER pid …      a sampled controller for the pendulum on a cart
//
// Prints the outputs at every instant of communication, one line each, and "event t".
#include <dlfcn.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using Reference = std::uint32_t;
using Log = void (*)(void*, int, const char*, const char*);

void say(void*, int status, const char* category, const char* message) {
  std::fprintf(stderr, "%d %s %s\n", status, category, message);
}

std::string readFile(const std::string& name) {
  std::ifstream in(name, std::ios::binary);
  if (!in) throw std::runtime_error("cannot read " + name);
  std::ostringstream out;
  out << in.rdbuf();
  return out.str();
}

struct Variable {
  Reference reference = 0;
  bool enumeration = false;
};

// What modelDescription.xml says, by patterns.
struct Description {
  std::string identifier, token;
  std::map<std::string, Variable> variables;

  explicit Description(const std::string& folder) {
    const std::string text = readFile(folder + "/modelDescription.xml");
    identifier = first(text, "modelIdentifier=\"([^\"]*)\"");
    token = first(text, "instantiationToken=\"([^\"]*)\"");
    const std::regex one("<(Float64|Enumeration) name=\"([^\"]*)\" valueReference=\"([0-9]+)\"");
    for (std::sregex_iterator it(text.begin(), text.end(), one), end; it != end; ++it)
      variables[(*it)[2]] = {static_cast<Reference>(std::stoul((*it)[3])),
                             (*it)[1] == "Enumeration"};
  }
  static std::string first(const std::string& text, const char* pattern) {
    std::smatch match;
    if (!std::regex_search(text, match, std::regex(pattern)))
      throw std::runtime_error(std::string("no ") + pattern);
    return match[1];
  }
};

// The library of an FMU.
class Library {
 public:
  Library(const std::string& folder, const std::string& identifier) {
#if defined(__aarch64__)
    const std::string file = folder + "/binaries/aarch64-linux/" + identifier + ".so";
#else
    const std::string file = folder + "/binaries/x86_64-linux/" + identifier + ".so";
#endif
    handle_ = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (handle_ == nullptr) throw std::runtime_error(dlerror());
  }
  // Calls a function that returns a status, which has to be 0.
  template <class... Arguments>
  void call(const char* name, Arguments... arguments) const {
    if (const int status = function<int(Arguments...)>(name)(arguments...); status != 0)
      throw std::runtime_error(std::string(name) + ": status " + std::to_string(status));
  }
  template <class F>
  F* function(const char* name) const {
    void* found = dlsym(handle_, name);
    if (found == nullptr) throw std::runtime_error(std::string("no function ") + name);
    return reinterpret_cast<F*>(found);
  }

 private:
  void* handle_;
};

struct Task {
  std::string folder, command;
  double until = 1.0, h = 0.01, tolerance = 0.0;
  bool event = false, early = true;
  std::vector<std::pair<std::string, double>> set, in;
  std::vector<std::string> out;
};

struct Step {
  double t = 0.0;
  bool event = false, early = false;
};

class Instance {
 public:
  Instance(const Library& library, const Description& description, const Task& task)
      : library_(library), description_(description), task_(task) {
    using Make = void*(const char*, const char*, const char*, bool, bool, bool, bool,
                       const Reference*, std::size_t, void*, Log, void*);
    instance_ = library.function<Make>("fmi3InstantiateCoSimulation")(
        "one", description.token.c_str(), (task.folder + "/resources/").c_str(), false, false,
        task.event, task.event && task.early, nullptr, 0, nullptr, say, nullptr);
    if (instance_ == nullptr) throw std::runtime_error("no instance");
    for (const auto& [name, value] : task.set) set(name, value);
    library.call("fmi3EnterInitializationMode", instance_, task.tolerance > 0.0, task.tolerance,
                 0.0, true, task.until);
    for (const auto& [name, value] : task.in) set(name, value);
    library.call("fmi3ExitInitializationMode", instance_);
    if (task.event) update();
  }
  Instance(const Instance&) = delete;
  Instance& operator=(const Instance&) = delete;
  ~Instance() { library_.function<void(void*)>("fmi3FreeInstance")(instance_); }

  double get(const std::string& name) const {
    const Variable v = variable(name);
    if (v.enumeration) {
      std::int64_t value = 0;
      library_.call("fmi3GetInt64", instance_, &v.reference, std::size_t{1}, &value,
                    std::size_t{1});
      return static_cast<double>(value);
    }
    double value = 0.0;
    library_.call("fmi3GetFloat64", instance_, &v.reference, std::size_t{1}, &value,
                  std::size_t{1});
    return value;
  }
  void set(const std::string& name, double value) {
    const Variable v = variable(name);
    const double* from = &value;
    library_.call("fmi3SetFloat64", instance_, &v.reference, std::size_t{1}, from, std::size_t{1});
  }
  std::vector<double> outputs() const {
    std::vector<double> out;
    for (const std::string& name : task_.out) out.push_back(get(name));
    return out;
  }
  // One step of communication, with the events on the way.
  std::vector<double> advance(double t, double h, bool print) {
    const double end = t + h;
    double now = t;
    while (now < end) {
      const Step step = doStep(now, end - now);
      if (step.early != (step.t < end)) throw std::runtime_error("early return is not told");
      now = step.t;
      if (!step.event) continue;
      if (print) std::printf("event %.17g\n", now);
      library_.call("fmi3EnterEventMode", instance_);
      update();
    }
    return outputs();
  }
  Step doStep(double t, double h) {
    Step out;
    bool terminate = false;
    library_.call("fmi3DoStep", instance_, t, h, false, &out.event, &terminate, &out.early, &out.t);
    return out;
  }
  void* state() {
    void* out = nullptr;
    library_.call("fmi3GetFMUState", instance_, &out);
    return out;
  }
  void state(void* from) { library_.call("fmi3SetFMUState", instance_, from); }
  void forget(void* state) { library_.call("fmi3FreeFMUState", instance_, &state); }
  std::vector<std::uint8_t> bytes(void* state) {
    std::size_t size = 0;
    library_.call("fmi3SerializedFMUStateSize", instance_, state, &size);
    std::vector<std::uint8_t> out(size);
    library_.call("fmi3SerializeFMUState", instance_, state, out.data(), size);
    return out;
  }
  void* stateOf(const std::vector<std::uint8_t>& bytes) {
    void* out = nullptr;
    library_.call("fmi3DeserializeFMUState", instance_, bytes.data(), bytes.size(), &out);
    return out;
  }

 private:
  Variable variable(const std::string& name) const {
    const auto at = description_.variables.find(name);
    if (at == description_.variables.end()) throw std::runtime_error("no variable " + name);
    return at->second;
  }
  void update() {
    bool again = true, terminate = false, nominals = false, states = false, defined = false;
    double next = 0.0;
    while (again)
      library_.call("fmi3UpdateDiscreteStates", instance_, &again, &terminate, &nominals, &states,
                    &defined, &next);
    library_.call("fmi3EnterStepMode", instance_);
  }
  const Library& library_;
  const Description& description_;
  const Task& task_;
  void* instance_;
};

void print(double t, const std::vector<double>& values) {
  std::printf("%.17g", t);
  for (const double v : values) std::printf(" %.17g", v);
  std::printf("\n");
}

void run(const Library& library, const Description& description, const Task& task) {
  Instance fmu(library, description, task);
  print(0.0, fmu.outputs());
  const long n = std::lround(task.until / task.h);
  for (long i = 0; i < n; ++i) {
    const double t = static_cast<double>(i) * task.h, end = static_cast<double>(i + 1) * task.h;
    print(end, fmu.advance(t, end - t, true));
  }
}

using Rows = std::vector<std::vector<double>>;

Rows rows(Instance& fmu, const Task& task, long from, long to) {
  Rows out;
  for (long i = from; i < to; ++i)
    out.push_back(fmu.advance(static_cast<double>(i) * task.h, task.h, false));
  return out;
}

// "same" where the numbers have the same bits.
void state(const Library& library, const Description& description, const Task& task) {
  const long n = std::lround(task.until / task.h), half = n / 2;
  const auto word = [](const Rows& a, const Rows& b) { return a == b ? "same" : "other"; };
  Instance straight(library, description, task), fmu(library, description, task);
  const Rows all = rows(straight, task, 0, n);
  void* const first = fmu.state();
  const Rows begin = rows(fmu, task, 0, half);
  void* const middle = fmu.state();
  const std::vector<double> there = fmu.outputs();
  const Rows end = rows(fmu, task, half, n);
  Rows joined = begin;
  joined.insert(joined.end(), end.begin(), end.end());
  std::printf("with a state taken: %s\n", word(all, joined));
  fmu.state(middle);
  std::printf("values of the state: %s\n", word({there}, {fmu.outputs()}));
  std::printf("set back: %s\n", word(end, rows(fmu, task, half, n)));
  Instance other(library, description, task);
  void* const copy = other.stateOf(fmu.bytes(middle));
  other.state(copy);
  std::printf("in another instance: %s\n", word(end, rows(other, task, half, n)));
  fmu.state(first);
  std::printf("from the start: %s\n", word(begin, rows(fmu, task, 0, half)));
  for (void* s : {first, middle}) fmu.forget(s);
  other.forget(copy);
}

// The controller of models/cart_pid.xml, at the instants of communication.
void pid(const Library& library, const Description& description, const Task& task) {
  constexpr double kp = 40.0, ki = 5.0, kd = 8.0, most = 9.0;
  Instance fmu(library, description, task);
  double integral = 0.0, before = 0.0;
  const long n = std::lround(task.until / task.h);
  for (long i = 0; i <= n; ++i) {
    const double t = static_cast<double>(i) * task.h;
    const double e = -fmu.get("rod.phi"), change = i > 0 ? e - before : 0.0;
    const double rest =
        kp * e + kd * change / task.h + 3.0 * (fmu.get("cart.x") - 0.5) + 4.0 * fmu.get("cart.vx");
    const double step = ki * task.h * e, wanted = rest + integral + step;
    const bool further = (wanted > most && step > 0.0) || (wanted < -most && step < 0.0);
    if (!further) integral += step;
    before = e;
    print(t, fmu.outputs());
    if (i == n) break;
    fmu.set("motor", std::clamp(rest + integral, -most, most));
    fmu.advance(t, static_cast<double>(i + 1) * task.h - t, true);
  }
}

Task read(int count, char** words) {
  if (count < 3) throw std::runtime_error("a folder and a command are missing");
  Task task;
  task.folder = words[1], task.command = words[2];
  for (int i = 3; i < count; ++i) {
    const std::string word = words[i];
    const std::string name = word.substr(0, word.find('='));
    const std::string value = name == word ? "" : word.substr(name.size() + 1);
    if (name == "event") task.event = true;
    if (name == "late") task.early = false;
    if (name == "until") task.until = std::stod(value);
    if (name == "h") task.h = std::stod(value);
    if (name == "tolerance") task.tolerance = std::stod(value);
    if (name.rfind("set:", 0) == 0) task.set.emplace_back(name.substr(4), std::stod(value));
    if (name.rfind("in:", 0) == 0) task.in.emplace_back(name.substr(3), std::stod(value));
    std::istringstream names(name == "out" ? value : "");
    for (std::string one; std::getline(names, one, ',');) task.out.push_back(one);
  }
  return task;
}

}  // namespace

int main(int count, char** words) {
  try {
    const Task task = read(count, words);
    const Description description(task.folder);
    const Library library(task.folder, description.identifier);
    if (task.command == "run") run(library, description, task);
    if (task.command == "state") state(library, description, task);
    if (task.command == "pid") pid(library, description, task);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "fmu_master: %s\n", e.what());
    return 1;
  }
  return 0;
}
