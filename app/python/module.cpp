/// The compiled part of the Python package `dynamy`: models, simulations, states and laws for
/// notebooks and prototypes.
#include <dynamy/core/version.hpp>
#include <dynamy/io/reference/describe.hpp>

#include "library.hpp"

namespace py = pybind11;

namespace dynamy::python {

Library& library() {
  // Never destroyed, because Python objects may outlive it.
  static auto* all = new Library;  // NOLINT(cppcoreguidelines-owning-memory)
  return *all;
}

namespace {

std::string text(py::handle value) {
  if (py::isinstance<py::bool_>(value)) return value.cast<bool>() ? "true" : "false";
  if (py::isinstance<py::str>(value)) return value.cast<std::string>();
  if (PyFloat_Check(value.ptr()) != 0 || PyLong_Check(value.ptr()) != 0)
    return numberText(value.cast<double>());
  if (py::hasattr(value, "__iter__")) {
    std::string out;
    for (const py::handle part : value) out += (out.empty() ? "" : " ") + text(part);
    return out;
  }
  try {
    return numberText(value.cast<double>());  // includes numbers of numpy
  } catch (const py::cast_error&) {
    throw ModelError("a value is a number, a text or a list, not " +
                     py::repr(value).cast<std::string>());
  }
}

}  // namespace

std::vector<GivenValue> givenValues(const py::kwargs& values) {
  std::vector<GivenValue> out;
  for (const auto& [name, value] : values) {
    const std::string given = name.cast<std::string>();
    try {
      out.emplace_back(given, text(value));
    } catch (const ModelError& e) {
      throw ModelError(given + ": " + e.diagnostics().front().text);
    }
  }
  return out;
}

}  // namespace dynamy::python

PYBIND11_MODULE(_core, m) {
  using namespace dynamy;
  m.doc() = "dynamY: simulation of multibody systems with impacts and friction";
  m.attr("__version__") = versionString();
  static const py::exception<ModelError> modelError(m, "ModelError", PyExc_ValueError);
  py::register_exception_translator(
      [](const std::exception_ptr p) {  // NOLINT(performance-unnecessary-value-param)
        try {
          if (p) std::rethrow_exception(p);
        } catch (const ModelError& e) {
          PyErr_SetString(modelError.ptr(), format(e.diagnostics()).c_str());
        }
      });
  python::library();
  m.def(
      "describe",
      [](const std::string& name) {
        const Registry& registry = python::library().registry;
        return name.empty() ? listTypes(registry.types()) : describe(registry, name);
      },
      py::arg("name") = "",
      "What an element or a word of the format is: its attributes with units and defaults, what\n"
      "stands inside, an example. Without a name: all types by kind.");
  python::bindLaws(m);
  python::bindModel(m);
  python::bindRun(m);
  python::bindGradient(m);
  python::bindOrbit(m);
  python::bindEquilibrium(m);
  python::bindFit(m);
}
