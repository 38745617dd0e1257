/// Periodic orbits of model files, and branches of them.
#include <pybind11/complex.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <dynamy/io/model/file_branch.hpp>
#include <limits>

#include "library.hpp"

namespace py = pybind11;

namespace dynamy::python {
namespace {

FileOrbit wantedOrbit(const std::string& file, const std::string& section, double period,
                      int returns, const std::map<std::string, double>& start, double tolerance,
                      const std::vector<std::string>& mirror, const py::kwargs& set) {
  FileOrbit out{.file = file,
                .section = section,
                .period = period,
                .returns = returns,
                .mirror = mirror,
                .tolerance = tolerance};
  for (const GivenValue& v : givenValues(set)) out.set.emplace_back(v.name, v.text);
  for (const auto& [name, value] : start)
    out.start.emplace_back(name, py::str(py::float_(value)).cast<std::string>());
  return out;
}

/// Values by signal, a column each; `rows`: one state a row.
py::dict columnsOf(const std::vector<std::string>& signals,
                   const std::vector<const std::vector<double>*>& rows) {
  const auto n = static_cast<py::ssize_t>(rows.size());
  py::dict out;
  for (std::size_t k = 0; k < signals.size(); ++k) {
    py::array_t<double> values(n);
    for (py::ssize_t i = 0; i < n; ++i)
      values.mutable_at(i) = (*rows[static_cast<std::size_t>(i)])[k];
    out[py::str(signals[k])] = values;
  }
  return out;
}

/// Passes of plain runs.
py::dict bruteOf(const NamedBranch& named) {
  py::array_t<double> parameter(static_cast<py::ssize_t>(named.brute.size()));
  std::vector<const std::vector<double>*> rows;
  for (const BrutePoint& b : named.brute) {
    parameter.mutable_at(static_cast<py::ssize_t>(rows.size())) = b.p;
    rows.push_back(&b.state);
  }
  py::dict out;
  out["parameter"] = parameter, out["state"] = columnsOf(named.branch.signals, rows);
  return out;
}

py::dict branchOf(const std::string& file, const std::string& over, const std::string& section,
                  double period, int returns, const std::map<std::string, double>& start,
                  double tolerance, int brute, const std::vector<std::string>& mirror,
                  const py::kwargs& set) {
  const NamedBranch named =
      branch({.orbit = wantedOrbit(file, section, period, returns, start, tolerance, mirror, set),
              .over = over,
              .brute = brute},
             library().registry, library().plugins);
  const OrbitBranch& b = named.branch;
  const auto n = static_cast<py::ssize_t>(b.points.size());
  Eigen::Index most = 0;
  std::vector<const std::vector<double>*> states;
  for (const BranchPoint& p : b.points)
    most = std::max(most, p.multipliers.size()), states.push_back(&p.state);
  py::array_t<double> parameter(n), periods(n);
  py::array_t<bool> stable(n);
  py::array_t<std::complex<double>> multipliers({n, static_cast<py::ssize_t>(most)});
  py::list kinds, texts;
  for (py::ssize_t i = 0; i < n; ++i) {
    const BranchPoint& p = b.points[static_cast<std::size_t>(i)];
    parameter.mutable_at(i) = p.p, periods.mutable_at(i) = p.period;
    stable.mutable_at(i) = p.stable;
    for (py::ssize_t k = 0; k < most; ++k)
      multipliers.mutable_at(i, k) =
          k < p.multipliers.size() ? p.multipliers[k] : std::numeric_limits<double>::quiet_NaN();
    kinds.append(p.kind), texts.append(p.text);
  }
  py::dict out;
  out["parameter"] = parameter, out["period"] = periods;
  out["state"] = columnsOf(b.signals, states), out["brute"] = bruteOf(named);
  out["multipliers"] = multipliers, out["stable"] = stable, out["bifurcation"] = kinds;
  out["text"] = texts, out["start"] = b.start, out["section"] = b.section.text();
  return out;
}

py::dict orbitOf(const std::string& file, const std::string& section, double period, int returns,
                 const std::map<std::string, double>& start, double tolerance,
                 const std::vector<std::string>& mirror, const py::kwargs& set) {
  const FileOrbit wanted =
      wantedOrbit(file, section, period, returns, start, tolerance, mirror, set);
  const Orbit o = orbit(wanted, library().registry, library().plugins);
  py::array_t<std::complex<double>> multipliers(o.multipliers.size());
  for (py::ssize_t i = 0; i < o.multipliers.size(); ++i)
    multipliers.mutable_at(i) = o.multipliers[i];
  py::dict out, state, shift;
  for (const auto& [name, value] : o.state) state[py::str(name)] = value;
  for (const auto& [name, value] : o.shift) shift[py::str(name)] = value;
  out["period"] = o.period, out["period_error"] = o.periodError;
  out["section"] = o.section.text(), out["state"] = state, out["shift"] = shift;
  out["multipliers"] = multipliers, out["multiplier_error"] = o.multiplierError;
  out["zeros"] = o.zeros, out["residual"] = o.residual, out["newton"] = o.newton;
  return out;
}

}  // namespace

void bindOrbit(py::module_& m) {
  m.def(
      "branch", &branchOf, py::arg("file"), py::arg("over"), py::arg("section") = "",
      py::arg("period") = 0.0, py::arg("returns") = 0,
      py::arg("start") = std::map<std::string, double>(), py::arg("tolerance") = 0.0,
      py::arg("brute") = 0, py::arg("mirror") = std::vector<std::string>(),
      "The periodic orbit of a model file followed over a parameter, \"mu=0.2:0.5:50\", as a dict "
      "of\n"
      "arrays along the branch: parameter, period, state (a dict by signal), multipliers (NaN: "
      "none),\n"
      "stable; bifurcation and text name what happens at a point. brute: values of the parameter\n"
      "at which plain runs show, after a transient, where the motion passes the section: a dict "
      "of\n"
      "parameter and state. Other arguments: as for orbit.");
  m.def(
      "orbit", &orbitOf, py::arg("file"), py::arg("section") = "", py::arg("period") = 0.0,
      py::arg("returns") = 0, py::arg("start") = std::map<std::string, double>(),
      py::arg("tolerance") = 0.0, py::arg("mirror") = std::vector<std::string>(),
      "A periodic orbit of a model file, stable or not, as a dict: period, state at the section,\n"
      "shift of coordinates on which nothing depends, multipliers, number of zeros. section:\n"
      "\"toy.phiM=0-\"; period: of a forcing in place of a section; default: <orbit> of the "
      "model.\n"
      "mirror: coordinates that change their signs after half a period, or are exchanged.\n"
      "Keywords replace parameters.");
}

}  // namespace dynamy::python
