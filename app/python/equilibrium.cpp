/// Equilibria of model files.
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <dynamy/io/model/file_equilibrium.hpp>

#include "library.hpp"

namespace py = pybind11;

namespace dynamy::python {
namespace {

py::dict equilibriumOf(const std::string& file, const std::map<std::string, double>& start,
                       bool rest, bool relax, double near, const py::kwargs& set) {
  FileEquilibrium wanted;
  wanted.file = file, wanted.atRest = rest, wanted.options = {near, relax};
  for (const GivenValue& v : givenValues(set)) wanted.set.emplace_back(v.name, v.text);
  for (const auto& [name, value] : start)
    wanted.start.emplace_back(name, py::str(py::float_(value)).cast<std::string>());
  const Equilibrium e = equilibrium(wanted, library().registry, library().plugins);
  py::dict out, state;
  for (const auto& [name, value] : e.state) state[py::str(name)] = value;
  py::list contacts;
  for (const CarryingContact& c : e.contacts) {
    py::dict one;
    one["name"] = c.name, one["status"] = c.status, one["margin"] = c.margin;
    one["force"] = py::array_t<double>(static_cast<py::ssize_t>(c.lambda.size()), c.lambda.data());
    contacts.append(one);
  }
  out["kind"] = e.rest ? "rest" : "steady motion", out["state"] = state;
  out["residual"] = e.residual, out["moved"] = e.moved, out["margin"] = e.margin;
  out["growing"] = e.growing, out["relaxations"] = e.relaxations, out["contacts"] = contacts;
  return out;
}

}  // namespace

void bindEquilibrium(py::module_& m) {
  m.def(
      "equilibrium", &equilibriumOf, py::arg("file"),
      py::arg("start") = std::map<std::string, double>(), py::arg("rest") = false,
      py::arg("relax") = true, py::arg("near") = EquilibriumOptions{}.near,
      "Rest of a model file with forces that its laws permit, or a steady motion if the model\n"
      "starts with one, as a dict: state by signal, residual, contacts with their forces and the\n"
      "distance of these from the bounds of their laws. rest: velocities of the start are set to\n"
      "zero; relax: follow the motion from the start. Keywords replace parameters.");
}

}  // namespace dynamy::python
