/// GuideShoes: four shoes guide a cabin with play between two rails that run along z.
///
///   shoe at (a, b) of the cabin, a = ±width/2, b = ±height/2, in the plane xz, side s = ±1:
///   g = play + s (x_P − x_0 − a − e(z_P)),   γ_N = s (v_Px − e′ v_Pz),   γ_T = v_Pz
///
/// e(z) is the misalignment of a rail at height z. Contact 4 j + 2 k + l belongs to an upper or
/// lower shoe (j = 0, 1) at the right or left rail (k = 0, 1); growing x opens it if l = 0 and
/// closes it if l = 1. A shoe is a point between two lines. A body with faces was rejected: a
/// longer shoe would only add the effect of the slope of e, some mm per m.
#include <cmath>
#include <dynamy/contact/contact_signals.hpp>
#include <dynamy/core/expression/expression.hpp>
#include <dynamy/dynamy.hpp>
#include <memory>
#include <string>

using namespace dynamy;

namespace {

constexpr int kContacts = 8;

/// Misalignment e(z) with two derivatives. The registers of the formula are work space, so that
/// only one thread at a time may use a Rail.
class Rail {
 public:
  Rail(const Parameters& x, const char* attribute) : formula_(compile(x, attribute)) {}
  double at(double z) { return formula_.value(&z); }
  double slope(double z) { return formula_.derivative(&z, &kOne); }
  double curvature(double z) { return formula_.secondDerivative(&z, &kOne, &kOne); }

 private:
  static constexpr double kOne = 1.0;
  static Expression compile(const Parameters& x, const char* attribute) {
    const ParameterValue& value = x[attribute];
    SymbolTable symbols;
    for (const auto& [name, number] : x.symbols) symbols.constant(name, number);
    symbols.variable("z");
    try {
      return Expression::compile(value.text, symbols);
    } catch (const ExpressionError& e) {
      throw value.fault(e.message(), didYouMean(e.suggestion()), e.offset(), e.length());
    }
  }
  Expression formula_;
};

class GuideShoes final : public NonSmoothElement {
 public:
  static void declare(Attributes& a) {
    a.about(
        "Four shoes guide a cabin with play between two rails along z that are not straight: eight "
        "contacts with friction. Signals top, bottom: force of the rails on the upper and lower "
        "shoes along x.");
    a.reference("on", "frame", "the cabin, a body that moves in the plane xz");
    a.required("width", Unit::length, "distance of the rails").positive();
    a.required("height", Unit::length, "distance of upper and lower shoes").positive();
    a.required("play", Unit::length, "play of a shoe, each side").nonNegative();
    a.required("x", Unit::length, "middle between the rails");
    a.add(AttributeType::expression, "left", "0", "misalignment of the left rail at height z")
        .in(Unit::length);
    a.add(AttributeType::expression, "right", "0", "misalignment of the right rail at height z")
        .in(Unit::length);
    a.child(Kind::law, 1, 1, "law of shoe and rail, e.g. UnilateralCoulomb");
    a.example(
        "<GuideShoes on=\"cabin\" width=\"2\" height=\"3\" play=\"1mm\" x=\"0\" "
        "left=\"0.001*sin(z)\"><UnilateralCoulomb mu=\"0.12\"/></GuideShoes>");
  }
  explicit GuideShoes(const Parameters& x)
      : NonSmoothElement(x),
        on_(x["on"].text),
        a_(0.5 * double(x["width"])),
        b_(0.5 * double(x["height"])),
        play_(x["play"]),
        x0_(x["x"]),
        rail_{Rail(x, "right"), Rail(x, "left")},
        law_(x.takeOne<SetValuedForceLaw>()) {
    if (!law_->unilateral())
      throw ModelError("a shoe needs a law that acts while its gap is closed",
                       "e.g. <UnilateralCoulomb mu=\"0.12\"/>");
  }
  void connect(Topology& topology) override { cabin_ = topology.frame(on_, *this); }

  void contacts(const Kinematics& k, ContactSink& sink) const override {
    const Frame& cabin = k.frame(cabin_);
    for (int i = 0; i < kContacts; ++i) {
      const double a = left(i) ? -a_ : a_, b = bottom(i) ? -b_ : b_, s = i % 2 == 0 ? 1.0 : -1.0;
      const Vec3 rho = cabin.A_IK * Vec3(a, 0.0, b), P = cabin.r_OS_I + rho;
      Rail& rail = rail_[left(i) ? 1 : 0];
      const double g = play_ + s * (P.x() - x0_ - a - rail.at(P.z()));
      if (ContactRows out = sink.add(static_cast<std::uint64_t>(i), g, *law_, 2))
        fill(out, cabin, rho, Vec3(s, 0.0, -s * rail.slope(P.z())), -s * rail.curvature(P.z()));
    }
  }

  void describe(Description& d) const override {
    for (int i = 0; i < kContacts; ++i)
      describeContact(d, static_cast<std::uint64_t>(i), 2, *law_, contactName(i) + ".");
    for (const bool low : {false, true})
      d.signal(low ? "bottom" : "top", Unit::force, "force of the rails on these shoes along x",
               [low](const SignalView& v) { return force(v, low); });
  }
  std::string contactName(std::uint64_t id) const override {
    const int i = static_cast<int>(id);
    return std::string(bottom(i) ? "bottom" : "top") + (left(i) ? "Left" : "Right") +
           (i % 2 == 0 ? "Plus" : "Minus");
  }

 private:
  static bool bottom(int i) { return i / 4 == 1; }
  static bool left(int i) { return (i / 2) % 2 == 1; }

  /// Fills the rows along n and e_z. `turn`: bias factor from the curvature of the rail, with which
  /// the direction n turns.
  static void fill(ContactRows& out, const Frame& f, const Vec3& rho, const Vec3& n, double turn) {
    const Vec3 v = f.velocity(rho), nu = f.nu_S_I + f.nu_R_I.cross(rho), up = Vec3::UnitZ();
    const bool slips = out.dim() > 1;
    if (f.block >= 0) {
      const Block W = out.segment(f);
      addPointRow(W, 0, f, rho, n, 1.0);
      if (slips) addPointRow(W, 1, f, rho, up, 1.0);
    }
    out.chi(0) += n.dot(nu);
    if (slips) out.chi(1) += nu.z();
    out.place(f.r_OS_I + rho, n.normalized(), up);
    if (!out.wantsBias()) return;
    const Vec3 a = f.bias_S_I + f.bias_R_I.cross(rho) + f.Omega_I.cross(f.Omega_I.cross(rho));
    out.bias(0) = n.dot(a) + turn * v.z() * v.z();
    if (slips) out.bias(1) = a.z();
  }

  static double force(const SignalView& v, bool low) {
    double sum = 0.0;
    for (int i = low ? 4 : 0; i < (low ? 8 : 4); ++i) {
      const int at = v.contacts->find(v.element, static_cast<std::uint64_t>(i));
      if (at < 0 || v.Lambda.size() == 0) continue;
      const double N = v.Lambda[v.contacts->row0[static_cast<std::size_t>(at)]];
      sum += i % 2 == 0 ? N : -N;
    }
    return v.dt > 0.0 ? sum / v.dt : 0.0;
  }

  std::string on_;
  double a_, b_, play_, x0_;
  mutable Rail rail_[2];  // right, left
  std::unique_ptr<SetValuedForceLaw> law_;
  FrameHandle cabin_;
};

void registerElements(Registry& r) { r.add<GuideShoes>("GuideShoes"); }

}  // namespace

DYNAMY_PLUGIN("elevator", "1.0.0", registerElements)
