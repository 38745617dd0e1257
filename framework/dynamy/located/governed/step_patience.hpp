/// StepPatience: the shortest step in time that is worth its work (theory 50.7).
///
/// Steps have order 1 at impacts and do not reach tolerances below 1e-5. Where many evaluations have
/// covered hardly any time, the least step becomes longer, since the tolerance cannot be met. After
/// a great many it grows with the time that all steps in time have covered: their number is then at
/// most logarithmic in time, however fast a part of the motion is.
#pragma once
#include <dynamy/core/number_archive.hpp>
#include <dynamy/stages/search_pauses.hpp>

namespace dynamy {

class StepPatience {
 public:
  /// [s]; T: time of the motion [s].
  double least(double tolerance, double T) const;
  /// Notes that a step of length h [s] was taken, with work worth so many evaluations. end: of the
  /// run [s]; infinity: not known.
  void spend(double h, double evaluations, double T, double end);
  /// What solvers may spend on the next step, if they might spend `usual`.
  Effort effort(Effort usual) const;
  void archive(NumberArchive& a) {
    a(longer_), a(spent_), a(covered_), a(all_), a(time_), a(bounded_);
  }

 private:
  double longer_ = 1.0;                 // factor on the least step of the tolerance
  double spent_ = 0.0, covered_ = 0.0;  // since its last check: evaluations, time covered [s]
  double all_ = 0.0, time_ = 0.0;       // evaluations of all steps in time, and their sum [s]
  double bounded_ = 0.0;                // least step that bounds their number [s]
};

}  // namespace dynamy
