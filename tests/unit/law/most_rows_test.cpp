// A contact with more rows than the arrays of laws and solvers hold is refused where its element is
// first asked, by name; with as many it works.
#include <gtest/gtest.h>

#include <dynamy/core/declared/element_fault.hpp>
#include <dynamy/law/bilateral_rate.hpp>
#include <dynamy/law/most_rows.hpp>
#include <unit/simulation/scenes.hpp>

namespace dynamy {
namespace {

/// Holds the ball's height by n equal rows: any share of the forces does.
class ManyRows final : public NonSmoothElement {
 public:
  static void declare(Attributes& a) {
    a.add(AttributeType::integer, "rows", "1", "rows of the one contact");
    a.optional("gap", Unit::length, 0.0, "gap of the contact");
  }
  explicit ManyRows(const Parameters& x)
      : NonSmoothElement(x), rows_(x["rows"].integer()), gap_(x["gap"]) {}
  void connect(Topology& topology) override { system_ = topology.system("ball", *this); }
  void contacts(const Kinematics&, ContactSink& sink) const override {
    auto out = sink.add(7, gap_, law(), rows_);
    if (!out) return;
    Block W = out.segment(system_);
    for (int r = 0; r < rows_; ++r) W(r, 1) = 1.0;
  }

 private:
  const SetValuedForceLaw& law() const {
    if (gap_ > 0.0) return wide_;
    return bilateral_;
  }
  /// Unilateral, with as many rows as it is offered.
  class Wide final : public SetValuedForceLaw {
   public:
    using SetValuedForceLaw::SetValuedForceLaw;
    int dim(int geometric) const override { return geometric; }
    bool unilateral() const override { return true; }
    RowKind rowKind(int) const override { return RowKind::friction; }
    void prox(const LawInput&, const double*, const double*, double*) const override {}
    Status status(const LawInput&, const double*) const override { return Status::open; }
  };
  int rows_;
  double gap_;
  SystemHandle system_;
  BilateralRate bilateral_;
  Wide wide_;
};

Model held(int rows, double gap = 0.0) {
  Model m;
  scenes::addBall(m, "ball", 1.0);
  m.add<ManyRows>("ties", {{"rows", static_cast<double>(rows)}, {"gap", gap}});
  m.simulation.until = 0.1, m.simulation.step = 0.01;
  m.build();
  return m;
}

std::string faultOf(Model& m) {
  MechanicalSystem system = m.mechanicalSystem();
  try {
    system.evaluate(m.initialState());
  } catch (const ElementFault& e) {
    return e.what();
  }
  return "none";
}

TEST(MostRows, AreHeld) {
  Model m = held(kMostRows);
  Simulation s(m);
  EXPECT_EQ(s.run().ended, RunReport::Ended::finished) << s.report().reason;
  // Held by exact constraints, solved to 1e-10 of the gravity of a step each.
  EXPECT_NEAR(s.state().q[1], 1.0, 1e-9);
}

TEST(MostRows, MoreAreRefusedByElementLawAndNumber) {
  for (const int rows : {9, 10, 100}) {
    Model m = held(rows);
    const std::string text = faultOf(m);
    for (const std::string& part :
         {std::string("<element name=\"ties\"> failed: "), std::string("its contact 7 has "),
          std::to_string(rows) + " rows", std::string("1 to 8"),
          std::string("report the rows as several contacts")})
      EXPECT_NE(text.find(part), std::string::npos) << part << '\n' << text;
    Simulation s(m);
    EXPECT_EQ(s.run().ended, RunReport::Ended::failed);
    EXPECT_NE(s.report().reason.find("\"ties\"> failed: "), std::string::npos) << s.report().reason;
  }
}

TEST(MostRows, AreAskedOfOpenContactsToo) {
  Model m = held(9, 1.0);
  EXPECT_NE(faultOf(m).find("9 rows"), std::string::npos) << faultOf(m);
}

TEST(MostRows, NoneAreRefused) {
  Model m = held(0);
  EXPECT_NE(faultOf(m).find("0 rows"), std::string::npos) << faultOf(m);
}

}  // namespace
}  // namespace dynamy
