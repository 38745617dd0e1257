// Every registered law against its row in doc/laws.md: does it take energy, is it even, what does
// it become in its limits?
#include <gtest/gtest.h>
#include <build_paths.hpp>

#include <dynamy/io/plugin/plugin.hpp>
#include <dynamy/io/xml/xml.hpp>
#include <dynamy/law/standard_laws.hpp>
#include <dynamy_elements/laws/adhesion.hpp>
#include <dynamy_elements/laws/belt_friction.hpp>
#include <dynamy_elements/laws/orthotropic_friction.hpp>
#include <fstream>
#include <random>
#include <sstream>

extern "C" const dynamy::PluginInfo* dynamy_plugin_info();

namespace dynamy {
namespace {

/// Of the second table: what follows the name of the law.
std::map<std::string, std::vector<std::string>> rowsOfThePage() {
  std::map<std::string, std::vector<std::string>> rows;
  std::ifstream page(DYNAMY_SOURCE_DIR "/doc/laws.md");
  bool second = false;
  for (std::string line; std::getline(page, line);) {
    second = second || line.starts_with("## Energy");
    if (!second || !line.starts_with("| `")) continue;
    std::vector<std::string> cells;
    std::istringstream parts(line.substr(2));
    for (std::string cell; std::getline(parts, cell, '|');) cells.push_back(cell);
    rows[cells[0].substr(1, cells[0].find('`', 1) - 1)] = {cells.begin() + 1, cells.end()};
  }
  return rows;
}

/// One argument of a law: what its rows hold, and what the prox makes of it.
struct Sample {
  explicit Sample(int dim, std::mt19937& random)
      : z(dim), gammaA(dim), position(dim), Lambda(dim), dim_(dim) {
    std::uniform_real_distribution<double> number(-2.0, 2.0);
    for (int i = 0; i < dim; ++i)
      z[i] = number(random), gammaA[i] = number(random), position[i] = 0.0;
  }
  void project(const SetValuedForceLaw& law) {
    const Eigen::VectorXd r = Eigen::VectorXd::Ones(dim_), zero = Eigen::VectorXd::Zero(dim_);
    Lambda = z;
    law.prox({dim_, 1.0, gammaA.data(), position.data()}, r.data(), zero.data(), Lambda.data());
  }
  /// All but normal rows turned round.
  Sample turned(const SetValuedForceLaw& law) const {
    Sample out = *this;
    for (int i = 0; i < dim_; ++i)
      if (law.rowKind(i) != RowKind::normal) out.z[i] = -z[i], out.gammaA[i] = -gammaA[i];
    out.project(law);
    for (int i = 0; i < dim_; ++i)
      if (law.rowKind(i) != RowKind::normal) out.Lambda[i] = -out.Lambda[i];
    return out;
  }
  /// Λ·ξ for r = 1, where ξ = Λ − z.
  double power() const { return Lambda.dot(Lambda - z); }

  Eigen::VectorXd z, gammaA, position, Lambda;

 private:
  int dim_;
};

/// Projections that iterate stop at 1e-13 of arguments of this size.
constexpr double kProjection = 1e-12;

TEST(Laws, AreEvenAndTakeEnergyAsTheirPageSays) {
  Registry registry;
  registerFramework(registry);
  dynamy_plugin_info()->registerElements(registry);
  auto rows = rowsOfThePage();
  std::mt19937 random(7);
  int compared = 0;
  for (const RegisteredType* type : registry.types()) {
    if (type->kind != Kind::law) continue;
    SCOPED_TRACE(type->name + ", seed 7");
    ASSERT_TRUE(rows.contains(type->name)) << "doc/laws.md has no row";
    const std::string takes = rows[type->name][0], even = rows[type->name][1];
    rows.erase(type->name);
    const XmlDocument example = XmlDocument::parse(type->attributes.exampleText(), "example");
    std::vector<GivenValue> values;
    for (const XmlAttribute& a : example.root().attributes) values.emplace_back(a.name, a.value);
    const auto element = type->make(Parameters::of(type->attributes, type->name, "", values));
    const auto& law = dynamic_cast<const SetValuedForceLaw&>(*element);
    double odd = 0.0;
    for (const int dim : {1, 2, 3, 4, 5, 6, 8}) {
      if (law.dim(dim) != dim) continue;
      for (int i = 0; i < 200; ++i, ++compared) {
        Sample s(dim, random);
        s.project(law);
        if (takes.starts_with(" always")) {
          EXPECT_LE(s.power(), kProjection);
        }
        odd = std::max(odd, (s.turned(law).Lambda - s.Lambda).norm());
      }
    }
    if (even.starts_with(" yes")) {
      EXPECT_LE(odd, kProjection);
    }
    if (even.starts_with(" no")) {
      EXPECT_GT(odd, 0.1);
    }
  }
  EXPECT_GT(compared, 3000);
  EXPECT_TRUE(rows.empty()) << "doc/laws.md tells of " << rows.begin()->first;
}

TEST(Laws, HaveTheirLimits) {
  const UnilateralCoulomb coulomb(0.0, 0.0, 0.3);
  const UnilateralAdhesion weak(0.0, 0.3, 0.0);
  const UnilateralOrthotropic round(0.0, 0.0, 0.3, 0.3, 0.7);
  const BeltFriction smooth(
      Parameters::of<BeltFriction>("BeltFriction", "", {{"mu", 0.0}, {"wrap", 3.0}}));
  std::mt19937 random(8);
  for (int i = 0; i < 200; ++i) {
    Sample s(3, random), same = s;
    s.project(coulomb);
    for (const SetValuedForceLaw* law : {static_cast<const SetValuedForceLaw*>(&weak),
                                         static_cast<const SetValuedForceLaw*>(&round)}) {
      same.project(*law);
      EXPECT_LE((same.Lambda - s.Lambda).norm(), kProjection) << "seed 8";
    }
    Sample rope(2, random);
    rope.project(smooth);
    EXPECT_EQ(rope.Lambda[1], 0.0) << "seed 8";
  }
}

}  // namespace
}  // namespace dynamy
