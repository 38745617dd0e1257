/// What `dynamy fit` prints, and its page.
#pragma once
#include <dynamy/io/model/file_fit.hpp>
#include <string>

namespace dynamy::app {

std::string fitText(const std::string& model, const Fit& fit);

/// A page with parameters, correlations, runs, and measurements beside signals and residuals.
std::string fitPage(const std::string& model, const Fit& fit);

}  // namespace dynamy::app
