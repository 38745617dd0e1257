/// What the text and the page of a fit share.
#pragma once
#include <dynamy/io/model/file_fit.hpp>
#include <string>
#include <vector>

namespace dynamy::app {

/// A number with two digits of its standard deviation.
std::string fitNumber(double x, double sigma);

struct FitCorrelation {
  std::string a, b;
  double value = 0.0;
};
/// Those of at least this size, the largest first.
std::vector<FitCorrelation> correlations(const Fit& fit, double least);

/// How the interval was found, or that there is none.
std::string intervalWords(const FittedParameter& parameter);

/// What a reader has to know of the fit, a sentence each.
std::vector<std::string> fitRemarks(const Fit& fit);

}  // namespace dynamy::app
