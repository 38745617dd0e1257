/// Force laws written in Python, to try out a law before writing a plug-in. A law is a class with
/// the functions below, registered under a name that models use like that of any other law.
///
///   reservoir law (normal force times a convex set B):   support(y) → S_B(y), ∇S_B, Hessian
///   any other law:                                       prox(Lambda − r ξ, r) → Λ
///
/// Every call of a Python function costs a microsecond or more; a step of a plug-in has no such
/// cost. Rejected: Python classes derived from C++ classes, whose lifetimes two languages would
/// share.
#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <dynamy/law/set_valued_force_law.hpp>

#include "library.hpp"

namespace py = pybind11;

namespace dynamy::python {
namespace {

py::array_t<double> array(const double* x, int n) {
  return py::array_t<double>(static_cast<py::ssize_t>(n), x);
}

/// Copies `n` numbers that Python returned; the error for another count names the function `what`.
void take(const py::object& from, int n, double* to, const char* what) {
  const auto values = from.cast<std::vector<double>>();
  if (static_cast<int>(values.size()) != n)
    throw std::runtime_error(std::string(what) + " has to return " + std::to_string(n) +
                             " numbers, returned " + std::to_string(values.size()));
  std::copy(values.begin(), values.end(), to);
}

void takeRestitution(const py::object& law, int dim, double* epsilon) {
  std::fill(epsilon, epsilon + dim, 0.0);
  if (py::hasattr(law, "epsilonN")) epsilon[0] = law.attr("epsilonN").cast<double>();
}

class ReservoirInPython final : public NormalTimesReservoir {
 public:
  ReservoirInPython(const Parameters& x, py::object law)
      : NormalTimesReservoir(x), law_(std::move(law)) {}
  int dim(int geometric) const override { return std::min(geometric, 3); }
  void epsilon(int dim, double* epsilon) const override { takeRestitution(law_, dim, epsilon); }
  double support(const LawInput&, int k, const double* y, double* gradient,
                 double* hessian) const override {
    const py::tuple all = law_.attr("support")(array(y, k));
    if (all.size() != 3)
      throw std::runtime_error("support has to return (value, gradient, hessian)");
    if (gradient != nullptr) take(all[1], k, gradient, "the gradient of support");
    if (hessian != nullptr)
      take(all[2].attr("reshape")(k * k), k * k, hessian, "the Hessian of support");
    return all[0].cast<double>();
  }

 private:
  py::object law_;
};

class LawInPython final : public SetValuedForceLaw {
 public:
  LawInPython(const Parameters& x, py::object law) : SetValuedForceLaw(x), law_(std::move(law)) {
    if (py::hasattr(law_, "rows")) rows_ = law_.attr("rows").cast<int>();
    if (py::hasattr(law_, "unilateral")) unilateral_ = law_.attr("unilateral").cast<bool>();
  }
  int dim(int geometric) const override { return std::min(geometric, rows_); }
  bool unilateral() const override { return unilateral_; }
  RowKind rowKind(int row) const override {
    return row == 0 && unilateral_ ? RowKind::normal : RowKind::friction;
  }
  int groupEnd(int row, int dim) const override { return row == 0 && unilateral_ ? 1 : dim; }
  void epsilon(int dim, double* epsilon) const override { takeRestitution(law_, dim, epsilon); }
  void prox(const LawInput& in, const double* r, const double* xi, double* Lambda) const override {
    std::vector<double> z(Lambda, Lambda + in.dim);
    for (int i = 0; i < in.dim; ++i) z[static_cast<std::size_t>(i)] -= r[i] * xi[i];
    take(law_.attr("prox")(array(z.data(), in.dim), array(r, in.dim), in.dt), in.dim, Lambda,
         "prox");
  }
  Status status(const LawInput& in, const double* argument) const override {
    if (unilateral_ && !(argument[0] > 0.0)) return Status::separating;
    // The contact sticks if the argument lies in the set.
    std::vector<double> one(static_cast<std::size_t>(in.dim), 1.0), x(one.size());
    take(law_.attr("prox")(array(argument, in.dim), array(one.data(), in.dim), in.dt), in.dim,
         x.data(), "prox");
    return std::equal(x.begin(), x.end(), argument) ? Status::stick : Status::slip;
  }

 private:
  py::object law_;
  int rows_ = 3;
  bool unilateral_ = true;
};

/// Attributes of the law: a number is a default, None makes the attribute required.
Attributes declared(const std::string& about, const py::dict& attributes) {
  Attributes a;
  a.about(about);
  for (const auto& [name, value] : attributes) {
    if (value.is_none())
      a.required(name.cast<std::string>(), Unit::any, "of the law in Python");
    else
      a.optional(name.cast<std::string>(), Unit::any, value.cast<double>(), "of the law in Python");
  }
  return a;
}

void registerLaw(const std::string& name, const py::object& make, const py::dict& attributes) {
  if (PyCallable_Check(make.ptr()) == 0)
    throw ModelError("register_law(\"" + name + "\"): a class or a function is needed, not " +
                     py::repr(make).cast<std::string>());
  const std::string about =
      py::isinstance<py::str>(make.attr("__doc__")) ? make.attr("__doc__").cast<std::string>() : "";
  RegisteredType type{name, Kind::law, "python", declared(about, attributes), {}};
  std::vector<std::string> names;
  for (const Attribute& a : type.attributes.list()) names.push_back(a.name);
  type.make = [make, names](const Parameters& x) -> std::unique_ptr<Element> {
    py::dict values;
    for (const std::string& n : names) values[py::str(n)] = double(x[n]);
    py::object law = make(**values);
    if (py::hasattr(law, "support")) return std::make_unique<ReservoirInPython>(x, std::move(law));
    if (py::hasattr(law, "prox")) return std::make_unique<LawInPython>(x, std::move(law));
    throw ModelError("a law in Python needs a function support(y) or prox(z, r, dt)");
  };
  library().registry.add(std::move(type));
}

}  // namespace

void bindLaws(py::module_& m) {
  m.def("register_law", &registerLaw, py::arg("name"), py::arg("law"),
        py::arg("attributes") = py::dict(),
        "Makes a class of Python a law of models: law(**attributes) is called for each element.\n"
        "It has support(y) -> (S, gradient, hessian) of a unit reservoir B that the normal force\n"
        "multiplies, or prox(z, r, dt) -> nearest point of its set in the metric 1/r; `epsilonN`,\n"
        "`rows`, `unilateral` if they differ from 0, 3, True.");
}

}  // namespace dynamy::python
