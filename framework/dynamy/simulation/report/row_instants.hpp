/// RowInstants: when the recorder writes a row: at the instants i·Δ, at given instants, or at both.
#pragma once
#include <algorithm>
#include <cmath>
#include <dynamy/simulation/model/settings.hpp>
#include <dynamy/simulation/model/time_grid.hpp>
#include <limits>
#include <vector>

namespace dynamy {

class RowInstants {
 public:
  /// With given instants there is a grid only if `every` is given, too; with neither, a thousand rows
  /// until the end of the run [s].
  RowInstants(const RecordSettings& r, double until)
      : grid_(r.every > 0.0 ? r.every
              : until > 0.0 ? until / 1000.0
                            : 1.0),
        gridded_(r.every > 0.0 || r.at.empty()),
        given_(r.at) {
    std::sort(given_.begin(), given_.end());
  }
  /// The next instant; positive infinity: there is none.
  double next() const { return std::min(ofGrid(), ofGiven()); }
  /// Goes on to the instants after next(); those that differ from it by rounding are one.
  void pass() {
    const double t = next(), near = 1e-12 * std::max(1.0, t);
    if (ofGrid() <= t + near) ++row_;
    while (ofGiven() <= t + near) ++at_;
  }
  /// The start of the run has its row, and this is the first one after it.
  void startedAt(double t) {
    row_ = 1;
    while (ofGiven() <= t) ++at_;
  }
  /// Goes to the first instant after t, later or earlier than next().
  void after(double t) {
    row_ = static_cast<long>(std::floor(t / grid_.at(1))) + 1, at_ = 0;
    while (ofGiven() <= t) ++at_;
  }
  /// Rows of the grid so far, which a checkpoint keeps, and the time of the last row.
  long row() const { return row_; }
  void resume(long row, double last) {
    row_ = row, at_ = 0;
    while (ofGiven() <= last) ++at_;
  }

 private:
  double ofGrid() const {
    return gridded_ ? grid_.at(row_) : std::numeric_limits<double>::infinity();
  }
  double ofGiven() const {
    return at_ < given_.size() ? given_[at_] : std::numeric_limits<double>::infinity();
  }
  TimeGrid grid_;
  bool gridded_;
  std::vector<double> given_;
  long row_ = 0;
  std::size_t at_ = 0;
};

}  // namespace dynamy
