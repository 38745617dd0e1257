/// Parameters of model files from measurements, which are arrays or CSV files.
#include <fmt/format.h>
#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <cmath>
#include <dynamy/io/model/file_fit.hpp>
#include <limits>

#include "library.hpp"

namespace py = pybind11;

namespace dynamy::python {
namespace {

using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

Numbers column(const py::object& table, const std::string& name) {
  auto out = table[py::str(name)].cast<Numbers>();
  if (out.ndim() != 1) throw ModelError('"' + name + "\" is no array of one dimension");
  return out;
}

/// Columns "t", signals and "sigma(signal)" of a dict or a frame of pandas; NaN: not measured.
std::vector<MeasuredValue> measured(const py::object& table) {
  std::vector<std::string> names;
  for (const py::handle name : table) names.push_back(py::str(name));
  const auto has = [&](const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  if (!has("t")) throw ModelError("no column holds the time", "call it \"t\" [s]");
  const Numbers t = column(table, "t");
  std::vector<MeasuredValue> out;
  for (const std::string& name : names) {
    if (name == "t" || name.starts_with("sigma(")) continue;
    const Numbers y = column(table, name);
    const std::string ofSigma = "sigma(" + name + ")";
    const Numbers sigma = has(ofSigma) ? column(table, ofSigma) : Numbers();
    if (y.size() != t.size() || (has(ofSigma) && sigma.size() != t.size()))
      throw ModelError(fmt::format("\"{}\" has {} values at {} times", name, y.size(), t.size()));
    for (py::ssize_t i = 0; i < t.size(); ++i)
      if (!std::isnan(y.at(i)))
        out.push_back({name, t.at(i), y.at(i),
                       has(ofSigma) ? sigma.at(i) : std::numeric_limits<double>::quiet_NaN()});
  }
  if (out.empty()) throw ModelError("there are no measurements");
  return out;
}

/// A run: a file, a table, or a pair of one of them and a dict of the values of this run.
FileFit::Run runOf(const py::handle& given, std::size_t index) {
  py::object data = py::reinterpret_borrow<py::object>(given);
  FileFit::Run out;
  if (py::isinstance<py::tuple>(data)) {
    const auto pair = data.cast<py::tuple>();
    if (pair.size() != 2)
      throw ModelError("a run is a file or a table, or a pair of it and a dict of its values");
    for (const GivenValue& v : givenValues(py::kwargs(pair[1].cast<py::dict>())))
      out.set.emplace_back(v.name, v.text);
    data = pair[0];
  }
  if (py::isinstance<py::str>(data) || py::hasattr(data, "__fspath__")) {
    out.data = py::str(data).cast<std::string>();
    return out;
  }
  out.data = fmt::format("{}", index);
  out.measured = measured(data);
  return out;
}

std::vector<FileFit::Run> runsOf(const py::object& data) {
  std::vector<FileFit::Run> out;
  if (!py::isinstance<py::list>(data)) return {runOf(data, 0)};
  for (const py::handle run : data) out.push_back(runOf(run, out.size()));
  return out;
}

std::string number(const py::handle& value) {
  return value.is_none() ? std::string() : fmt::format("{:.17g}", value.cast<double>());
}

/// name → two numbers, with a text between them.
Overrides pairs(const py::dict& given, const char* between) {
  Overrides out;
  for (const auto& [name, value] : given) {
    const auto two = value.cast<py::sequence>();
    if (two.size() != 2) throw ModelError(py::str(name).cast<std::string>() + " needs two numbers");
    out.emplace_back(py::str(name), number(two[0]) + between + number(two[1]));
  }
  return out;
}

const char* kindOf(const FittedParameter& p) {
  return p.interval == FittedParameter::Interval::gaussian  ? "gaussian"
         : p.interval == FittedParameter::Interval::profile ? "profile"
                                                            : "none";
}

py::dict parametersOf(const Fit& f) {
  py::dict out;
  for (const FittedParameter& p : f.parameters) {
    py::dict one;
    one["value"] = p.value, one["sigma"] = p.sigma;
    one["interval"] = py::make_tuple(p.low, p.high);
    one["identifiable"] = p.identifiable, one["kind"] = kindOf(p), one["at_bound"] = p.atBound;
    out[py::str(fittedName(f, p))] = one;
  }
  return out;
}

py::list runsOf(const Fit& f) {
  py::list out;
  for (const FittedRun& r : f.runs) {
    py::dict one;
    one["name"] = r.name, one["measurements"] = r.count, one["chi2"] = r.chi2;
    one["motions"] = r.effort.runs, one["reordered"] = r.effort.reordered;
    one["across_switches"] = r.effort.across, one["ended"] = r.effort.ended;
    one["other_order_in_interval"] = r.otherOrder;
    out.append(one);
  }
  return out;
}

py::dict residualsOf(const Fit& f) {
  const auto n = static_cast<py::ssize_t>(f.points.size());
  py::array_t<double> t(n), value(n), sigma(n), fitted(n);
  py::array_t<int> run(n);
  py::list signals;
  for (py::ssize_t i = 0; i < n; ++i) {
    const FittedPoint& p = f.points[static_cast<std::size_t>(i)];
    run.mutable_at(i) = p.run, t.mutable_at(i) = p.measured.t;
    value.mutable_at(i) = p.measured.value, sigma.mutable_at(i) = p.measured.sigma;
    fitted.mutable_at(i) = p.fitted, signals.append(p.measured.signal);
  }
  py::dict out;
  out["run"] = run, out["t"] = t, out["signal"] = signals, out["measured"] = value;
  out["sigma"] = sigma, out["fitted"] = fitted;
  return out;
}

py::dict fitOf(const std::string& file, const py::object& data,
               const std::vector<std::string>& parameters, const std::vector<std::string>& each,
               const std::map<std::string, double>& sigma, const py::dict& bounds,
               const py::dict& priors, double tolerance, const py::kwargs& set) {
  FileFit wanted{.file = file,
                 .runs = runsOf(data),
                 .parameters = parameters,
                 .each = each,
                 .bounds = pairs(bounds, ":"),
                 .priors = pairs(priors, "+-"),
                 .tolerance = tolerance};
  for (const GivenValue& v : givenValues(set)) wanted.set.emplace_back(v.name, v.text);
  for (const auto& [name, value] : sigma)
    wanted.sigma.emplace_back(name, fmt::format("{:.17g}", value));
  const Fit f = fit(wanted, library().registry, library().plugins);
  py::dict out, signals;
  for (const FittedSignal& s : f.signals) signals[py::str(s.signal)] = s.sigma;
  out["parameters"] = parametersOf(f), out["covariance"] = f.covariance, out["chi2"] = f.chi2;
  out["freedom"] = f.freedom, out["sigma"] = signals, out["runs"] = runsOf(f);
  out["residuals"] = residualsOf(f), out["open"] = f.unknown, out["converged"] = f.converged;
  out["iterations"] = f.iterations;
  return out;
}

}  // namespace

void bindFit(py::module_& m) {
  m.def("fit", &fitOf, py::arg("file"), py::arg("data"),
        py::arg("parameters") = std::vector<std::string>(),
        py::arg("each") = std::vector<std::string>(),
        py::arg("sigma") = std::map<std::string, double>(), py::arg("bounds") = py::dict(),
        py::arg("priors") = py::dict(), py::arg("tolerance") = 0.0,
        "Parameters of a model file from measurements, as a dict: parameters with value and\n"
        "interval, covariance, chi2, runs, residuals. data: a run or a list of runs, each a CSV\n"
        "file or a table (dict of arrays, frame of pandas) with columns t, signals and\n"
        "sigma(signal), or a pair of it and a dict of values of this run. bounds: name -> (low,\n"
        "high), None: open; priors: name -> (value, sigma). Keywords replace parameters.");
}

}  // namespace dynamy::python
