/// TravelWatch: how far bodies move and turn in a step:
///
///   turn        the largest |Ω| Δt of a frame that is not a ball's (turning_frames.hpp)
///   way         the distance of the fastest frame or contact in a step, which bounds overlaps of a
///               scheme on velocity level
///   leap        the distance a shape moves in a step, over the sum of its smallest size and that
///               of the smallest shape it could meet: above 1 they may pass through each other
///               unnoticed; half spaces are never passed
#pragma once
#include <dynamy/simulation/model/observer.hpp>
#include <dynamy/simulation/report/run_report.hpp>

namespace dynamy {

class TravelWatch {
 public:
  /// Results go to report.trust. Both arguments outlive the watch; `model` is built.
  TravelWatch(const Model& model, RunReport& report);
  /// Examines the frames.
  void step(const StepView& view);
  /// Examines the contacts, which are those of an impact for one step only.
  void contacts(const StepView& view);

 private:
  void collectShapes();
  struct Mover {
    FrameHandle frame;
    double size;  ///< sum of its smallest size and that of the smallest it could meet [m]
  };
  const Model& model_;
  RunTrust& trust_;
  std::vector<FrameHandle> turning_;
  std::vector<Mover> movers_;
};

}  // namespace dynamy
