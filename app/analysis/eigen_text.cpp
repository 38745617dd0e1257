#include "analysis/eigen_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <dynamy/core/constants.hpp>

namespace dynamy::app {
namespace {

/// The velocities with the largest amplitudes in a mode, with amplitude and phase.
std::string shapeText(const Linearisation& l, Eigen::Index mode) {
  const Eigen::Index nu = l.modes.rows() / 2;
  std::vector<Eigen::Index> order;
  for (Eigen::Index i = nu; i < 2 * nu; ++i)
    if (std::abs(l.modes(i, mode)) >= 0.1) order.push_back(i);
  std::stable_sort(order.begin(), order.end(), [&](Eigen::Index a, Eigen::Index b) {
    return std::abs(l.modes(a, mode)) > std::abs(l.modes(b, mode));
  });
  std::string out;
  for (std::size_t k = 0; k < std::min<std::size_t>(order.size(), 3); ++k) {
    const std::complex<double> z = l.modes(order[k], mode);
    const double degrees = std::arg(z) * 360.0 / kTwoPi;
    out += out.empty() ? "" : ", ";
    out += l.names[static_cast<std::size_t>(order[k])];
    if (k > 0) out += fmt::format(" {:.2g}", std::abs(z));
    if (k > 0 && std::abs(degrees) > 0.5) out += fmt::format("∠{:.0f}°", degrees);
  }
  return out;
}

/// Frequency, damping and doubling or halving time of an eigenvalue.
std::string behaviour(std::complex<double> z, double noise) {
  const double size = std::abs(z);
  std::string out;
  if (z.imag() != 0.0)
    out = fmt::format("{:.4g} Hz, damping {:.3g}", std::abs(z.imag()) / kTwoPi,
                      std::abs(z.real()) > noise ? -z.real() / size : 0.0);
  const double fold = std::log(2.0) / std::abs(z.real());
  if (std::abs(z.real()) > noise)
    out += fmt::format("{}{} in {:.3g} s", out.empty() ? "" : ", ",
                       z.real() > 0.0 ? "doubles" : "halves", fold);
  return out;
}

void writeComplex(JsonWriter& j, const Eigen::VectorXcd& z) {
  j.beginArray();
  for (const std::complex<double>& x : z) j.beginArray().value(x.real()).value(x.imag()).endArray();
  j.endArray();
}

}  // namespace

std::string sampledText(const std::vector<std::string>& elements) {
  if (elements.empty()) return {};
  return fmt::format(
      " NOTE {} sample{} the motion: outputs are held at their values here, and loops that they "
      "close are not seen\n",
      fmt::join(elements, ", "), elements.size() == 1 ? "s" : "");
}

std::string eigenText(const Model& model, const Linearisation& l) {
  std::string out =
      fmt::format("{}: steady motion, u' = 0 up to {:.1e}\n", model.file.name, l.residual);
  if (l.moved > 0.0) out += fmt::format(" found {:.3g} from the start of the model\n", l.moved);
  for (const HeldMotion::Contact& c : l.contacts) {
    out += fmt::format(" {} {}, force", c.name,
                       c.slips               ? "slips"
                       : c.law->unilateral() ? "sticks"
                                             : "is held");
    for (const double x : c.lambda) out += fmt::format(" {:.10g}", std::abs(x) < 1e-9 ? 0.0 : x);
    out += "\n";
  }
  out += sampledText(l.sampled);
  out += fmt::format(" {} motions permitted of {}; derivatives to {:.0e}\n\n", l.basis.cols(),
                     l.basis.rows(), std::max(l.error, l.leak));
  out += fmt::format(" {:>17} {:>17}   {:<46} {}\n", "real part [1/s]", "imaginary [1/s]", "",
                     "moves most");
  if (l.zeros > 0)
    out += fmt::format(" {:>17} {:>17}   {} times: nothing depends on it\n", 0, 0, l.zeros);
  for (Eigen::Index k = 0; k < l.eigenvalues.size(); ++k) {
    const std::complex<double> z = l.eigenvalues[k];
    if (z.imag() < 0.0) continue;
    out += fmt::format(" {:>17.12g} {:>17}   {:<46} {}\n",
                       std::abs(z.real()) > l.noise ? z.real() : 0.0,
                       z.imag() == 0.0 ? "" : fmt::format("±{:.12g}", z.imag()),
                       behaviour(z, l.noise), shapeText(l, k));
  }
  const int n = l.growing();
  return out + (n == 0 ? " no disturbance grows\n"
                       : fmt::format(" {} of them grow{}\n", n, n == 1 ? "s" : ""));
}

std::string criticalText(const std::vector<CriticalValue>& values) {
  std::string out;
  for (const CriticalValue& v : values)
    out += fmt::format(" {} = {:.11g}: growing motions {} below, {} above; {}\n", v.name, v.value,
                       v.growingBelow, v.growingAbove,
                       v.frequency == 0.0 ? "without oscillation"
                                          : fmt::format("{:.6g} Hz", v.frequency / kTwoPi));
  return out;
}

void writeEigen(JsonWriter& j, const Model& model, const Linearisation& l) {
  j.member("model", model.file.name).member("residual", l.residual).member("moved", l.moved);
  j.member("motions", l.basis.cols()).member("error", l.error).member("leak", l.leak);
  j.member("zeros", l.zeros).member("growing", l.growing());
  j.key("eigenvalues"), writeComplex(j, l.eigenvalues);
  j.key("sampled").values(l.sampled);
  j.key("names").values(l.names);
  j.key("modes").beginArray();
  for (Eigen::Index k = 0; k < l.modes.cols(); ++k) writeComplex(j, l.modes.col(k));
  j.endArray().key("contacts").beginArray();
  for (const HeldMotion::Contact& c : l.contacts)
    j.beginObject()
        .member("name", c.name)
        .member("slips", c.slips)
        .key("force")
        .values(c.lambda)
        .endObject();
  j.endArray();
}

void writeCritical(JsonWriter& j, const std::vector<CriticalValue>& values) {
  j.key("critical").beginArray();
  for (const CriticalValue& v : values) {
    j.beginObject().member("parameter", v.name).member("value", v.value);
    j.member("growingBelow", v.growingBelow).member("growingAbove", v.growingAbove);
    j.member("imaginary", v.frequency).endObject();
  }
  j.endArray();
}

std::string eigenCsv(const Eigen::VectorXcd& eigenvalues) {
  std::string out = "real,imaginary\n";
  for (const std::complex<double>& z : eigenvalues)
    out += fmt::format("{},{}\n", z.real(), z.imag());
  return out;
}

std::string locusCsv(const Locus& locus) {
  std::string out = locus.name + ",real,imaginary\n";
  for (std::size_t i = 0; i < locus.value.size(); ++i)
    for (const std::complex<double>& z : locus.eigenvalues[i])
      out += fmt::format("{},{},{}\n", locus.value[i], z.real(), z.imag());
  return out;
}

}  // namespace dynamy::app
