/// Derivatives of runs with respect to parameters and initial values, as arrays.
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <dynamy/io/model/file_gradient.hpp>

#include "library.hpp"

namespace py = pybind11;

namespace dynamy::python {
namespace {

py::dict gradientOf(const std::string& file, const std::vector<std::string>& of,
                    const std::vector<std::string>& by, bool checks, double tolerance,
                    const py::kwargs& set) {
  FileGradient wanted{.file = file, .of = of, .by = by, .checks = checks, .tolerance = tolerance};
  for (const GivenValue& v : givenValues(set)) wanted.set.emplace_back(v.name, v.text);
  const Gradient g = gradient(wanted, library().registry, library().plugins);
  const auto n = static_cast<py::ssize_t>(g.values.size());
  const auto m = static_cast<py::ssize_t>(g.by.size());
  py::list names;
  py::array_t<double> at(n), value(n), error(n), d({n, m}), dError({n, m});
  py::array_t<double> left({n, m}), right({n, m});
  const auto side = [](const std::vector<SideDerivative>& all, py::ssize_t i) {
    return all.empty() ? SideDerivative().d : all[static_cast<std::size_t>(i)].d;
  };
  for (py::ssize_t k = 0; k < n; ++k) {
    const GradientValue& v = g.values[static_cast<std::size_t>(k)];
    names.append(v.measure.empty() || v.measure == "instant" ? v.of : v.of + " " + v.measure);
    at.mutable_at(k) = v.at, value.mutable_at(k) = v.value, error.mutable_at(k) = v.error;
    for (py::ssize_t i = 0; i < m; ++i) {
      d.mutable_at(k, i) = v.d[static_cast<std::size_t>(i)];
      dError.mutable_at(k, i) = v.dError[static_cast<std::size_t>(i)];
      left.mutable_at(k, i) = side(v.left, i), right.mutable_at(k, i) = side(v.right, i);
    }
  }
  py::dict out, refused;
  for (std::size_t i = 0; i < g.by.size(); ++i)
    if (!g.refused[i].empty()) refused[py::str(g.by[i])] = g.refused[i];
  out["of"] = names, out["at"] = at, out["value"] = value, out["error"] = error;
  out["by"] = g.by, out["d"] = d, out["dError"] = dError, out["refused"] = refused;
  out["left"] = left, out["right"] = right;
  return out;
}

}  // namespace

void bindGradient(py::module_& m) {
  m.def("gradient", &gradientOf, py::arg("file"), py::arg("of") = std::vector<std::string>(),
        py::arg("by") = std::vector<std::string>(), py::arg("checks") = false,
        py::arg("tolerance") = 0.0,
        "Derivatives of signals (\"ball.z@0.6\") and of instants (\"t:floor=impact\") of a model "
        "file\n"
        "by parameters and initial values (\"ball.z\"), as a dict: value and error of each "
        "signal,\n"
        "d[signal, parameter] and dError; refused: name -> why there is no derivative, left and\n"
        "right: the derivatives towards either side. Keywords replace parameters.");
}

}  // namespace dynamy::python
