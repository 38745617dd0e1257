/// Python classes Model and State. A model is made from a file, from text, or element by element.
#include <fmt/format.h>
#include <pybind11/eigen.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <dynamy/core/other_words.hpp>
#include <dynamy/simulation/run/simulation.hpp>
#include <sstream>
#include <variant>

#include "library.hpp"

namespace py = pybind11;

namespace dynamy::python {
namespace {

/// An element that has not yet been added to a model or to another element.
struct Made {
  Kind kind;
  std::unique_ptr<Element> element;
  std::unique_ptr<Element> release() {
    if (!element) throw ModelError("this element is part of a model already", "make a second one");
    return std::move(element);
  }
};

Made makeElement(const std::string& type, const std::string& name,
                 const std::vector<Made*>& children, const py::kwargs& values) {
  const Registry& registry = library().registry;
  const RegisteredType* found = registry.find(type);
  if (found == nullptr) {
    std::vector<std::string> known;
    for (const RegisteredType* t : registry.types()) known.push_back(t->name);
    const std::string meant = elementOfOthers(type);
    throw ModelError("there is no type \"" + type + '"',
                     meant.empty() ? unknownNameHint(type, known) : meant);
  }
  Parameters x = Parameters::of(found->attributes, type, name, givenValues(values));
  for (Made* child : children) {
    const auto& rules = found->attributes.children();
    const bool fits = std::any_of(rules.begin(), rules.end(),
                                  [&](const ChildRule& r) { return r.kind == child->kind; });
    if (!fits)
      throw ModelError("<" + type + "> takes no " + std::string(kindText(child->kind)) + " inside");
    x.children.push_back({child->kind, child->release()});
  }
  return {found->kind, found->make(x)};
}

Overrides overrides(const py::kwargs& set) {
  Overrides out;
  for (const GivenValue& v : givenValues(set)) out.emplace_back(v.name, v.text);
  return out;
}

Model load(const std::filesystem::path& file, const py::kwargs& set) {
  if (const std::string text = file.string(); text.find('<') != std::string::npos)
    throw ModelError("the name of a file is needed, this is a text", "write dynamy.model(text)");
  LoadOptions options;
  options.set = overrides(set);
  try {
    return loadModel(file.string(), library().registry, library().plugins, options);
  } catch (const ModelError& e) {
    for (const char* setting : {"until", "step", "tolerance", "record", "every"})
      if (std::string(e.what()).find(std::string("no parameter \"") + setting) != std::string::npos)
        throw ModelError(
            std::string("keywords replace parameters of the file, of which none is \"") + setting +
                '"',
            std::string("set it afterwards: model.") + setting + " = …");
    throw;
  }
}

Model fromText(const std::string& text, const py::kwargs& set) {
  if (text.find('<') == std::string::npos && text.ends_with(".xml"))
    throw ModelError("the text of a model is needed, this is the name of a file",
                     "write dynamy.load(\"" + text + "\")");
  LoadOptions options;
  options.set = overrides(set);
  return loadModelText(text, "model", library().registry, library().plugins, options);
}

void add(Model& model, Made& made) {
  if (made.kind == Kind::scheme)
    model.scheme(std::unique_ptr<OneStep>(static_cast<OneStep*>(made.release().release())));
  else if (made.kind == Kind::solver)
    model.solver(
        std::unique_ptr<InclusionSolver>(static_cast<InclusionSolver*>(made.release().release())));
  else
    model.add(made.kind, made.release());
}

std::vector<std::string> signalNames(const Model& model) {
  std::vector<std::string> out;
  for (const NamedSignal& s : model.signals()) out.push_back(s.name);
  return out;
}

void bindState(py::module_& m) {
  py::class_<State>(m, "State", "All that changes in a run: t [s], q, u.")
      .def(py::init<const State&>(), "A copy.")
      .def_readwrite("t", &State::t)
      .def_property(
          "q", [](State& x) -> Eigen::Ref<Eigen::VectorXd> { return x.q; },
          [](State& x, const Eigen::VectorXd& q) {
            if (q.size() != x.q.size()) throw py::value_error("q keeps its size");
            x.q = q;
          },
          py::return_value_policy::reference_internal, "Positions; a view that may be written.")
      .def_property(
          "u", [](State& x) -> Eigen::Ref<Eigen::VectorXd> { return x.u; },
          [](State& x, const Eigen::VectorXd& u) {
            if (u.size() != x.u.size()) throw py::value_error("u keeps its size");
            x.u = u;
          },
          py::return_value_policy::reference_internal, "Velocities; a view that may be written.");
}

}  // namespace

void bindModel(py::module_& m) {
  const py::class_<Made> element(m, "Element", "An element that waits to be added to a model.");
  m.def("element", &makeElement, py::arg("type"), py::arg("name") = "",
        py::arg("children") = std::vector<Made*>{},
        "An element of a registered type; attributes as keywords, as in the model file.");
  m.def(
      "plugin", [](const std::string& file) { library().plugins.load(file, library().registry); },
      py::arg("library"),
      "Loads a shared library with further types: a name, or a path with a '/'.");
  m.def(
      "trust", [](const std::string& folder) { library().plugins.trust(folder); },
      py::arg("folder"), "Models in this folder, or below it, may bring libraries of their own.");
  m.def("load", &load, py::arg("file"), "The model of a file; keywords replace its parameters.");
  m.def("model", &fromText, py::arg("text"), "The model of a text in XML.");

  bindState(m);
  py::class_<Model>(m, "Model", "All elements of a scene; fixed after build().")
      .def(py::init([] {
        Model model;
        for (const auto& c : library().registry.completions()) model.addCompletion(c);
        return model;
      }))
      .def("add", &add, py::arg("element"), "Takes an element, a scheme or a solver.")
      .def("build", &Model::build)
      .def_property(
          "until", [](const Model& x) { return x.simulation.until; },
          [](Model& x, double until) { x.simulation.until = until; }, "End time [s].")
      .def_property(
          "step", [](const Model& x) { return x.simulation.step; }, &Model::askStep,
          "Length of a step [s], in place of a tolerance.")
      .def_property(
          "tolerance", [](const Model& x) { return x.simulation.tolerance; }, &Model::askTolerance,
          "Wanted accuracy, in place of a step: the program chooses the steps.")
      .def_property(
          "every", [](const Model& x) { return x.record.every; },
          [](Model& x, double every) { x.record.every = every; },
          "Sample time of signals [s]; 0: 1000 samples.")
      .def_property(
          "record", [](const Model& x) { return x.record.signals; },
          [](Model& x, const std::variant<std::string, std::vector<std::string>>& wanted) {
            std::vector<std::string> names;
            if (const auto* text = std::get_if<std::string>(&wanted)) {
              std::istringstream words(*text);
              for (std::string word; words >> word;) names.push_back(word);
            } else {
              names = std::get<std::vector<std::string>>(wanted);
            }
            x.record.places.assign(names.size(), Place());
            x.record.signals = std::move(names);
          },
          "Names of the signals that runs record, as a list or with blanks between; empty: all of "
          "systems.")
      .def("__repr__",
           [](const Model& x) {
             return fmt::format("<dynamy.Model{}: {} systems, {} forces, {} contact elements>",
                                x.title.empty() ? "" : " \"" + x.title + '"', x.systems().size(),
                                x.forces().size(), x.contacts().size());
           })
      .def_readwrite("title", &Model::title)
      .def_property_readonly("signals", &signalNames, "Names of all signals.")
      .def_property_readonly("length", &Model::length, "Length of the scene [m].")
      .def_property_readonly("scheme", [](const Model& x) { return x.scheme().type(); })
      .def_property_readonly("solver", [](const Model& x) { return x.solver().type(); })
      .def("state", &Model::initialState, "The initial state.");
}

}  // namespace dynamy::python
