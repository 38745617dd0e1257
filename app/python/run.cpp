/// Runs and steps from Python: whole runs into folders, which dynamy/runs.py reads, and single
/// steps.
#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <dynamy/io/replay/replay_page.hpp>
#include <dynamy/io/run_files/packed_signals.hpp>
#include <dynamy/io/run_files/run_facts.hpp>
#include <dynamy/io/run_files/run_recording.hpp>
#include <dynamy/simulation/model/initial_values.hpp>
#include <dynamy/simulation/report/consistent_start.hpp>
#include <dynamy/simulation/report/contact_facts.hpp>
#include <dynamy/simulation/run/checkpoints.hpp>
#include <dynamy/simulation/run/sample_instants.hpp>
#include <dynamy/simulation/run/simulation.hpp>

#include <cmath>
#include <memory>

#include "library.hpp"
#include "signals.hpp"

namespace py = pybind11;

namespace dynamy::python {
namespace {

/// Throws ValueError for an input that is no number.
void requireNumber(const std::string& input, double value) {
  if (!std::isfinite(value))
    throw py::value_error("the input \"" + input + "\" gets a number, not " + numberText(value));
}

/// The end of a step of a run, as a Python function sees it while it is called. It may be kept, but
/// then it tells nothing more.
class Moment {
 public:
  Moment(const StepView& view, Simulation& simulation, NamedSignals& signals)
      : view_(&view), simulation_(simulation), signals_(signals) {}
  void pass() { view_ = nullptr; }
  const State& state() const { return view().after; }
  double signal(const std::string& name) { return signals_.value(view(), name); }
  void input(const std::string& name, double value) {
    view();
    requireNumber(name, value);
    simulation_.input(signals_.input(name), value);
  }

 private:
  const StepView& view() const {
    if (view_ == nullptr)
      throw std::runtime_error(
          "this moment is over: keep values of it, such as now.t, and not `now` itself");
    return *view_;
  }
  const StepView* view_;
  Simulation& simulation_;
  NamedSignals& signals_;
};

/// A copy of numbers that nobody changes in the belief that it changed the motion.
py::array_t<double> readOnly(const Eigen::VectorXd& x) {
  py::array_t<double> out(x.size(), x.data());
  out.attr("setflags")(py::arg("write") = false);
  return out;
}

/// True: False of Python or of numpy.
bool isFalse(const py::object& answer) {
  if (answer.is_none()) return false;
  const auto type = std::string(py::str(py::type::of(answer).attr("__name__")));
  return (type == "bool" || type == "bool_") && PyObject_IsTrue(answer.ptr()) == 0;
}

/// Calls a Python function after each step or, with `every` [s], at the start and at multiples of
/// it. The function ends the run by returning False.
class Callback final : public Observer {
 public:
  Callback(py::object call, double every, Simulation& simulation, const Model& model,
           std::atomic<bool>& stop)
      : call_(std::move(call)),
        every_(every),
        simulation_(simulation),
        signals_(model),
        stop_(stop) {}
  bool readsContacts() const override { return !call_.is_none(); }
  void start(const StepView& view) override {
    next_ = view.after.t;
    if (every_ > 0.0) step(view);
  }
  void step(const StepView& view) override {
    try {
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      if (call_.is_none()) return;
      if (every_ > 0.0) {
        if (SampleInstants::isWithin(view.after.t, next_)) return;
        next_ = every_ * (std::floor(view.after.t / every_ * (1.0 + 1e-12)) + 1.0);
      }
      const auto moment = std::make_shared<Moment>(view, simulation_, signals_);
      const Passes passes{*moment};
      if (isFalse(call_(py::cast(moment)))) stop_ = true;
    } catch (const py::error_already_set&) {
      fault_ = std::current_exception(), stop_ = true;
    } catch (const std::exception&) {  // of names and values
      fault_ = std::current_exception(), stop_ = true;
    }
  }
  /// Raises the exception of the function, or that of Ctrl-C.
  void raise() const {
    if (fault_) std::rethrow_exception(fault_);
  }

 private:
  struct Passes {
    Moment& moment;
    ~Passes() { moment.pass(); }
  };
  py::object call_;
  double every_, next_ = 0.0;  // [s]
  Simulation& simulation_;
  NamedSignals signals_;
  std::atomic<bool>& stop_;
  std::exception_ptr fault_;
};

const char* endText(RunReport::Ended ended) {
  switch (ended) {
    case RunReport::Ended::finished:
      return "finished";
    case RunReport::Ended::stopped:
      return "stopped";
    case RunReport::Ended::failed:
      return "failed";
  }
  return "failed";
}

py::dict figures(const Simulation& simulation) {
  const RunReport& r = simulation.report();
  py::dict out;
  out["state"] = endText(r.ended), out["reason"] = r.reason, out["t"] = r.t;
  out["steps"] = r.steps, out["rejected"] = r.rejected, out["impacts"] = r.contacts.impacts;
  out["switches"] = r.contacts.switches, out["unconverged"] = r.solver.unconverged;
  out["iterations"] = r.solver.iterations, out["residual"] = r.solver.residual.value;
  out["penetration"] = r.gaps.penetration.value, out["wall_s"] = r.cost.wall;
  bool passed = true;
  for (const CheckResult& c : simulation.checks()) passed = passed && c.pass;
  out["checks_passed"] = passed;
  py::list warnings, notes;
  for (const Warning& w : r.warnings) {
    py::dict one;
    one["kind"] = w.kind, one["text"] = w.text, one["count"] = w.count, one["t"] = w.t;
    one["place"] = w.place;
    (says(w) == Says::note ? notes : warnings).append(one);
  }
  out["warnings"] = warnings, out["notes"] = notes, out["qualified"] = r.qualified();
  return out;
}

void writeFolderFacts(const RunFolder& folder, const Model& model, const Simulation& simulation) {
  folder.writeFacts([&](JsonWriter& j) {
    writeRunFacts(j, model, simulation.report(), simulation.checks(),
                  endText(simulation.report().ended), {});
  });
}

/// Runs a model from its initial state into a run folder.
py::dict runInto(Model& model, const py::object& each, double every, const std::string& out,
                 bool replay) {
  std::atomic<bool> stop{false};
  model.simulation.sampleEvery = each.is_none() ? 0.0 : every;
  Simulation simulation(model);
  Callback callback(each, every, simulation, model, stop);
  simulation.observe(callback);
  simulation.stopWhen(stop);
  const RunFolder folder(out);
  RunRecording recording(folder, model);
  simulation.record(recording);
  writeWholeFile(folder.model(), model.file.text);
  simulation.run();
  recording.flush();
  writeFolderFacts(folder, model, simulation);  // also of a run that the callback ends
  callback.raise();
  if (!recording.fault().empty()) throw std::runtime_error(std::string(recording.fault()));
  if (!replay) return figures(simulation);
  writeReplay(folder.path());
  if (model.record.packed) packSignals(folder, recordedSignals(model), model.title);
  return figures(simulation);
}

/// Takes single steps of the model's scheme; state and inputs may be changed between the steps.
class Steps {
 public:
  static constexpr const char* kSaved = "steps of Python 1";
  explicit Steps(Model& model)
      : model_(model),
        system_(model.mechanicalSystem()),
        attempt_(model, system_),
        samples_(model),
        signals_(model) {
    model.readyScheme();
    attempt_.start();
    left_ = attempt_.x();
  }

  py::dict step(double dt) {
    if (!(dt >= 0.0)) throw py::value_error("a step has a length above 0, not " + numberText(dt));
    if (!(dt > 0.0)) dt = model_.simulation.step;
    if (!(dt > 0.0) && model_.scheme().choosesSteps()) {
      dt = model_.simulation.until - state().t;
      if (isPassed(model_.simulation.until, state().t))
        throw ModelError("the run ended at t = " + numberText(state().t) + " s",
                         "simulation.advance(0.01) goes on, and so does step(1e-3)");
    }
    if (!(dt > 0.0))
      throw ModelError("no step is given",
                       "say step(1e-3), model.step = 1e-3 or model.tolerance = 1e-6");
    take(state().t + dt, dt);
    const StepReport& report = attempt_.report();
    py::dict out;
    out["contacts"] = report.contacts, out["solved"] = report.solved.ok();
    out["status"] = std::string(solveStatusText(report.solved.status));
    out["iterations"] = report.solved.iterations;
    out["residual"] = report.solved.residuals.largest();
    return out;
  }
  /// Takes the steps that end dt later.
  void advance(double dt) {
    if (!(dt > 0.0) || !std::isfinite(dt)) throw py::value_error("advance takes a time above 0");
    const double end = state().t + dt, largest = model_.simulation.step;
    while (!isPassed(end, state().t)) {
      const double rest = end - state().t;
      // A last step shorter than rounding of times is joined to the one before it.
      const bool last = !(largest > 0.0) || rest < largest * (1.0 + 1e-9);
      take(last ? end : state().t + largest, last ? rest : largest);
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    }
  }
  /// Name and percussions of each closed contact of the last step.
  py::list contacts() {
    py::list out;
    const ContactSet& c = system_.slot(0).contacts;
    if (system_.problem().rows() != c.rows()) return out;
    for (int i = 0; i < c.size(); ++i) {
      const auto k = static_cast<std::size_t>(i);
      py::dict one;
      one["name"] = contactName(model_, c.key[k]);
      std::vector<double> Lambda;
      for (int row = c.row0[k]; row < c.row0[k + 1]; ++row)
        Lambda.push_back(system_.problem().Lambda(row));
      one["Lambda"] = py::array_t<double>(static_cast<py::ssize_t>(Lambda.size()), Lambda.data());
      out.append(one);
    }
    return out;
  }
  double energy() {
    EnergyMeter meter(model_);
    return meter.kinetic(state()) + meter.potential(state());
  }
  State& state() { return attempt_.change(); }
  /// Goes back to the state of the model at the start, with its inputs.
  void reset() {
    state() = model_.initialState();
    attempt_.start();
    left_ = state(), steps_ = 0;
  }
  /// All that the next step begins with.
  py::bytes save() {
    Archive a;
    a.section(kSaved);
    a(attempt_), a(steps_);
    return {a.bytes()};
  }
  void restore(const py::bytes& saved) {
    const State before = state();
    try {
      Archive a{std::string(saved)};
      a.section(kSaved);
      a(attempt_), a(steps_);
      refuseForeign(model_, a, state());
    } catch (...) {
      state() = before;
      throw;
    }
    attempt_.resumed();
    left_ = state();
  }
  double signal(const std::string& name) {
    return signals_.value(attempt_.view(steps_, steps_ > 0), name);
  }
  void set(const std::string& name, double value) {
    if (signals_.hasInput(name) || name.find('.') == std::string::npos) {
      requireNumber(name, value);
      state().memory[signals_.input(name).first] = value;
    } else if (!std::isfinite(value)) {
      throw py::value_error('"' + name + "\" gets a number, not " + numberText(value));
    } else {
      setNumber(model_, name, value, state());
    }
  }

 private:
  /// In the past nothing has been sampled yet that was not sampled at the start. Inputs stay.
  void goBack(State& x) {
    const std::vector<double>& start = model_.topology().memories().start();
    const Eigen::VectorXd memory = x.memory;
    x.memory = Eigen::Map<const Eigen::VectorXd>(start.data(), x.memory.size());
    for (const auto& f : model_.forces())
      if (const MemoryHandle own = model_.topology().memories().of(*f); f->type() == "Input")
        x.memory.segment(own.first, own.size) = memory.segment(own.first, own.size);
    system_.evaluate(x);
    system_.remember(x);
  }
  void take(double end, double dt) {
    State& x = state();
    if (!std::isfinite(x.t)) throw py::value_error("the time t is not a number");
    if (x.t < left_.t) goBack(x);
    // What a scheme carries from step to step belongs to the motion that it left.
    if (x.t != left_.t || x.q != left_.q || x.u != left_.u) x.scheme.resize(0);
    if (const double at = samples_.after(x.t); SampleInstants::isWithin(at, end))
      end = at, dt = at - x.t;
    attempt_.take(end, dt, nullptr);
    ++steps_;
    if (!attempt_.sound()) {
      const std::string fault = attempt_.fault();
      attempt_.undo();
      throw std::runtime_error(fault);
    }
    left_ = x;
  }
  Model& model_;
  MechanicalSystem system_;
  StepAttempt attempt_;
  SampleInstants samples_;
  NamedSignals signals_;
  State left_;  // as the last step left it
  long steps_ = 0;
};

}  // namespace

void bindRun(py::module_& m) {
  m.def("_run_into", &runInto, py::arg("model"), py::arg("each"), py::arg("every"), py::arg("out"),
        py::arg("replay"), "Runs a model into a folder; dynamy.run reads it. Returns the figures.");
  m.def(
      "_write_replay", [](const std::string& folder) { writeReplay(folder); }, py::arg("folder"));
  py::class_<Moment, std::shared_ptr<Moment>>(m, "Moment",
                                              "The end of a step, while each(now) is called.")
      .def_property_readonly("t", [](const Moment& x) { return x.state().t; })
      .def_property_readonly("q", [](const Moment& x) { return readOnly(x.state().q); })
      .def_property_readonly("u", [](const Moment& x) { return readOnly(x.state().u); })
      .def_property_readonly(
          "state", [](const Moment& x) { return State(x.state()); }, "A copy.")
      .def("__getitem__", &Moment::signal, py::arg("signal"), "Value of a signal.")
      .def("__setitem__", &Moment::input, py::arg("input"), py::arg("value"),
           "Sets an <Input> from here on.");
  py::class_<Steps>(m, "Simulation",
                    "Single steps of a built model; what is to be kept of them, keep yourself.")
      .def(py::init([](const py::object& model) {
             if (!py::isinstance<Model>(model))
               throw py::type_error("Simulation() steps a model, such as dynamy.load(" +
                                    std::string(py::repr(model)) + ")");
             return std::make_unique<Steps>(model.cast<Model&>());
           }),
           py::arg("model"), py::keep_alive<1, 2>())
      .def_property_readonly("state", &Steps::state, py::return_value_policy::reference_internal)
      .def("step", &Steps::step, py::arg("dt") = 0.0,
           "One step of length dt [s]; default: the model's. With a tolerance, the next step of "
           "the\n"
           "scheme, dt at most. A step ends where a block samples. Returns contacts, status,\n"
           "iterations, residual of the inclusion.")
      .def("advance", &Steps::advance, py::arg("dt"),
           "Takes the steps that end exactly dt [s] later, with every scheme, also beyond the\n"
           "model's `until`.")
      .def("reset", &Steps::reset, "Goes back to the start of the model, with its inputs.")
      .def("save", &Steps::save, "All that the next step begins with, as bytes for restore().")
      .def("restore", &Steps::restore, py::arg("saved"),
           "Goes on from what save() of a simulation of the same model returned.")
      .def("__getitem__", &Steps::signal, py::arg("signal"), "Value of a signal now.")
      .def("__setitem__", &Steps::set, py::arg("name"), py::arg("value"),
           "Sets an <Input> from now on, or a coordinate or velocity by its name: \"cart.vx\". A\n"
           "velocity of a body in coordinates of joints changes as by a percussion along it.")
      .def_property_readonly(
          "t", [](Steps& x) { return x.state().t; }, "Time [s].")
      .def_property_readonly("contacts", &Steps::contacts,
                             "Contacts of the last step: name, Lambda [N s].")
      .def_property_readonly("energy", &Steps::energy, "T + V [J].");
}

}  // namespace dynamy::python
