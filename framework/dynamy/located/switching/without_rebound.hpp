/// WithoutRebound: another law without its restitution, for impacts of contacts that are to stay
/// closed.
#pragma once
#include <dynamy/law/set_valued_force_law.hpp>

namespace dynamy {

class WithoutRebound final : public SetValuedForceLaw {
 public:
  explicit WithoutRebound(const SetValuedForceLaw* of = nullptr) : law_(of) {}
  int dim(int geometric) const override { return law_->dim(geometric); }
  bool unilateral() const override { return law_->unilateral(); }
  RowKind rowKind(int row) const override { return law_->rowKind(row); }
  int groupEnd(int row, int dim) const override { return law_->groupEnd(row, dim); }
  void prox(const LawInput& in, const double* r, const double* xi, double* Lambda) const override {
    law_->prox(in, r, xi, Lambda);
  }
  void naturalMap(const LawInput& in, double rho, const double* xi, const double* Lambda,
                  double* e) const override {
    law_->naturalMap(in, rho, xi, Lambda, e);
  }
  bool proxDerivative(const LawInput& in, double rho, const double* xi, const double* Lambda,
                      double* A, double* B) const override {
    return law_->proxDerivative(in, rho, xi, Lambda, A, B);
  }
  SimpleSet simpleSet(const LawInput& in) const override { return law_->simpleSet(in); }
  const NormalTimesReservoir* reservoir() const override { return law_->reservoir(); }
  const NormalTimesReservoir* discs() const override { return law_->discs(); }
  Status status(const LawInput& in, const double* argument) const override {
    return law_->status(in, argument);
  }

 private:
  const SetValuedForceLaw* law_;
};

}  // namespace dynamy
