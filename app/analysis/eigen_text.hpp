/// Eigenvalues of a steady motion as text for people and as JSON and CSV for programs.
#pragma once
#include <dynamy/io/files/json_writer.hpp>
#include <dynamy/simulation/linear/linearisation.hpp>
#include <string>
#include <vector>

namespace dynamy::app {

/// The value of a parameter at which the real part of an eigenvalue changes its sign.
struct CriticalValue {
  std::string name;
  double value = 0.0;
  double frequency = 0.0;                  ///< imaginary part at this value [1/s]
  int growingBelow = 0, growingAbove = 0;  ///< growing motions below and above it
};

/// Eigenvalues over a parameter: value[i] has eigenvalues[i].
struct Locus {
  std::string name;
  std::vector<double> value;
  std::vector<Eigen::VectorXcd> eigenvalues;
};

/// Note on elements that sample the motion; empty: there are none.
std::string sampledText(const std::vector<std::string>& elements);
std::string eigenText(const Model& model, const Linearisation& l);
std::string criticalText(const std::vector<CriticalValue>& values);
void writeEigen(JsonWriter& json, const Model& model, const Linearisation& l);
void writeCritical(JsonWriter& json, const std::vector<CriticalValue>& values);
/// CSV with the columns real and imaginary; locusCsv() puts the parameter before them.
std::string eigenCsv(const Eigen::VectorXcd& eigenvalues);
std::string locusCsv(const Locus& locus);

}  // namespace dynamy::app
