#include <algorithm>
#include <cmath>
#include <dynamy/dynamy.hpp>
using namespace dynamy;

/// Skin under a ski: it glides forwards and holds backwards. One convex set is the whole law,
///   B = disc of radius μ about (δ, 0):   S_B(y) = μ |y| + δ y₁   ⇒   slip: Λ_T = Λ_N (−μ e + (δ, 0)),
/// so that the coefficient of friction is μ − δ for slip along the first tangent and μ + δ against
/// it; 0 ∈ B if δ ≤ μ.
class SkiSkin final : public NormalTimesReservoir {
 public:
  static void declare(Attributes& a) {
    a.about("Contact with a skin that glides along the first tangent and holds against it.");
    a.required("glide", Unit::none, "coefficient of friction forwards, mu - delta").nonNegative();
    a.required("hold", Unit::none, "coefficient of friction backwards, mu + delta").positive();
    a.example("<SkiSkin glide=\"0.1\" hold=\"0.4\"/>");
  }
  explicit SkiSkin(const Parameters& x)
      : NormalTimesReservoir(x),
        mu_(0.5 * (double(x["hold"]) + double(x["glide"]))),
        delta_(mu_ - double(x["glide"])) {}
  int dim(int geometric) const override { return std::min(geometric, 3); }
  double support(const LawInput&, int k, const double* y, double* gradient,
                 double* hessian) const override {
    const double length = k == 2 ? std::hypot(y[0], y[1]) : std::abs(y[0]);
    for (int i = 0; i < k; ++i) {
      const double e = length > 0.0 ? y[i] / length : 0.0;
      if (gradient) gradient[i] = mu_ * e + (i == 0 ? delta_ : 0.0);
      for (int j = 0; hessian && j < k; ++j)
        hessian[i * k + j] = length > 0.0 ? mu_ / length * ((i == j) - e * y[j] / length) : 0.0;
    }
    return mu_ * length + delta_ * y[0];
  }

 private:
  double mu_, delta_;
};

static void registerElements(Registry& r) { r.add<SkiSkin>("SkiSkin"); }
DYNAMY_PLUGIN("ski_skin", "1.0.0", registerElements)
