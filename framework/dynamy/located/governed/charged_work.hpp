/// ChargedWork: which systems the work of located steps is charged to, and which of them are to be
/// stepped in time because their switches are dense (theory 50.7).
#pragma once
#include <dynamy/located/governed/switch_governor.hpp>
#include <dynamy/located/step/located_motion.hpp>
#include <dynamy/stages/islands.hpp>

namespace dynamy {

class ChargedWork {
 public:
  /// Begins with no work. `systems`: their number.
  void begin(const SystemParts& parts, Eigen::Index systems);
  /// Works in the governor's window charged to each system: of steps with its switches; of steps
  /// whose length its error bounded.
  Eigen::VectorXd numbers() const { return work_.reshaped(); }
  void resume(const SystemParts& parts, const Eigen::VectorXd& numbers);
  void forget() { work_.setZero(); }
  /// Charges the work of a step to the system of its switch, or to that with the largest error.
  void charge(const MechanicalSystem& s, const LocatedMotion& motion, double work, bool switched);
  /// Chooses the systems that are stepped in time from x on, right after the governor has turned.
  /// `lost`: because the contact of the last switch cannot be followed.
  void choose(const MechanicalSystem& s, const State& x, const LocatedMotion& motion,
              const SwitchGovernor& governor, bool lost, std::vector<char>& stepped);

 private:
  bool chooseStalled(const LocatedMotion& motion, bool lost, double touch,
                     std::vector<char>& chosen) const;
  void chooseExpensive(const SwitchGovernor& governor, std::vector<char>& chosen) const;
  Islands islands_;
  Eigen::Matrix<double, Eigen::Dynamic, 2> work_;
};

}  // namespace dynamy
