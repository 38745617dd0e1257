/// Fmu: a controller, or anything else that has inputs and outputs, that another program exported for
/// co-simulation (FMI 2.0 or 3.0), as a sampled block. At each of the instants t_k = offset + k T:
///
///   the FMU steps from t_{k−1} to t_k with the inputs u_{k−1}
///   u_k is set;  in FMI 3.0 with event mode its clocks tick and its discrete states are updated
///   outputs are read, and held until t_{k+1}
///
/// so that an FMU whose outputs follow inputs at once has no delay, and one whose outputs change in a
/// step has that of one period. What it holds is part of State::memory: its state as bytes where it
/// writes them (six in a number, which keeps them exact), else a sum over its inputs so far, by
/// which a step that was rejected is recognised; then it is made anew and follows these inputs again.
#pragma once
#include <dynamy_elements/blocks/sampled_block.hpp>
#include <memory>

#include "fmu_instance.hpp"

namespace dynamy {

class Fmu final : public SampledBlock {
 public:
  static void declare(Attributes& a);
  /// Throws ModelError with the place of what the FMU does not have.
  explicit Fmu(const Parameters& x);
  void describe(Description& d) const override;
  std::string memoryFault(ConstVec memory) const override;

 private:
  /// Where an instance is: how many samples it has taken, a sum over their instants and inputs, and
  /// the instant of the last one.
  struct At {
    long taken = 0;
    std::uint64_t sum = 0;
    double t = 0.0;
    bool operator==(const At&) const = default;
  };
  struct Sample {
    At at;
    std::vector<double> inputs;
  };
  Fmu(const Parameters& x, std::shared_ptr<const FmuFile> file);
  std::vector<double> held() const override;
  std::vector<SignalFormulas*> formulas() override { return {&values_}; }
  void sample(const Kinematics& k, double* held) const override;
  void readNames(const Parameters& x);
  void make() const;
  FmuInstance::Values with(const std::vector<double>& inputs) const;
  void step(double t, const std::vector<double>& inputs) const;
  void setBack(const At& wanted, const double* state) const;
  void follow(long taken) const;
  void keep(double* state) const;
  long stateNumbers() const;

  std::shared_ptr<const FmuFile> file_;
  std::string who_;
  std::vector<const FmuVariable*> inputs_, outputs_;
  FmuInstance::Values parameters_;
  SignalFormulas values_;
  std::vector<double> initial_;  ///< outputs before the first sample
  std::size_t stateBytes_ = 0;   ///< room for a state; 0: it writes none
  /// The instance is a state of its own, which follows State::memory.
  mutable std::unique_ptr<FmuInstance> instance_;
  mutable At at_;
  mutable std::vector<Sample> history_;  ///< what it has taken, if it writes no state
};

}  // namespace dynamy
