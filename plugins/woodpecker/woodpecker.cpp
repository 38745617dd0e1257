/// The woodpecker toy: a sleeve (M) slides down a pole; a torsion spring connects a bird (S) to it.
///
///   q = (y, φ_M, φ_S)      M u̇ = h + W λ,   all of M, W constant (linearised kinematics)
///
///   M = ⎡ m_S+m_M   m_S l_M          m_S l_G        ⎤      h = ⎡ −(m_S+m_M) g             ⎤
///       ⎢ m_S l_M   J_M + m_S l_M²   m_S l_M l_G    ⎥          ⎢ −c (φ_M−φ_S) − m_S l_M g ⎥
///       ⎣ m_S l_G   m_S l_M l_G      J_S + m_S l_G² ⎦          ⎣ −c (φ_S−φ_M) − m_S l_G g ⎦
///
/// Model and data: Glocker, doctoral thesis, TU München 1995; Pfeiffer and Glocker, Multibody
/// Dynamics with Unilateral Contacts, 1996; Leine, van Campen and Glocker, JVC 9 (2003). The file
/// models/woodpecker_expressions.xml describes the same toy by formulas, without C++. A model of
/// the elastic pole was rejected: its data were never published.
#include <dynamy/dynamy.hpp>
#include <dynamy/law/standard_laws.hpp>
#include <dynamy/system/description.hpp>
#include <memory>
#include <vector>

using namespace dynamy;

namespace {

/// Lengths of the toy [m]; the system and its contacts declare the same attributes.
struct Lengths {
  double lM, lG, lS, hS, hM, rM, r0;
  static void declare(Attributes& a) {
    a.optional("lM", Unit::length, 0.010, "pole to spring").positive();
    a.optional("lG", Unit::length, 0.015, "spring to bird's centre of mass").positive();
    a.optional("lS", Unit::length, 0.0201, "bird's centre of mass back to the beak").positive();
    a.optional("hS", Unit::length, 0.020, "height of the beak over the centre of mass").positive();
    a.optional("hM", Unit::length, 0.0058, "half height of the sleeve").positive();
    a.optional("rM", Unit::length, 0.0031, "inner radius of the sleeve").positive();
    a.optional("r0", Unit::length, 0.0025, "radius of the pole").positive();
  }
  explicit Lengths(const Parameters& x)
      : lM(x["lM"]), lG(x["lG"]), lS(x["lS"]), hS(x["hS"]), hM(x["hM"]), rM(x["rM"]), r0(x["r0"]) {}
};

/// A filled outline, or a line through two points, for the replay.
class Outline final : public Shape {
 public:
  static void declare(Attributes&) {}
  Outline(const char* name, const char* colour, std::vector<Vec3> points)
      : Shape(Parameters::of<Outline>("Outline", name, {{"colour", colour}})),
        points_(std::move(points)) {}
  ShapeGeometry geometry() const override {
    return {points_.size() > 2 ? ShapeType::polygon : ShapeType::line, {}, points_, colour()};
  }

 private:
  std::vector<Vec3> points_;
};

/// Corners of a rectangle in the x–z plane.
std::vector<Vec3> rectangle(double x0, double x1, double z0, double z1) {
  return {{x0, 0, z0}, {x1, 0, z0}, {x1, 0, z1}, {x0, 0, z1}};
}

/// The torsion spring at the end of the sleeve's rod, as a disc, only for the picture. With linear
/// kinematics the arm of the bird ends beside the rod by up to lG φ²/2: within the disc.
std::vector<Vec3> disc(double x, double radius) {
  constexpr int kCorners = 24;
  std::vector<Vec3> points;
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2.0 * M_PI * i / kCorners;
    points.emplace_back(x + radius * std::cos(angle), 0, radius * std::sin(angle));
  }
  return points;
}

/// Outlines of the bird seen from the side, from back to front; only for the picture. The origin is
/// the centre of mass of the bird, and the beak reaches the pole.
std::vector<std::unique_ptr<Outline>> bird(const Lengths& l) {
  std::vector<std::unique_ptr<Outline>> all;
  const auto add = [&all](const char* name, const char* colour, std::vector<Vec3> points) {
    all.push_back(std::make_unique<Outline>(name, colour, std::move(points)));
  };
  add("arm", "#505860", {{-l.lG, 0, 0}, {0, 0, 0}});
  add("tail", "#5a3326",
      {{0.0035, 0, -0.014}, {0.008, 0, -0.013}, {0.012, 0, -0.034}, {0.0075, 0, -0.035}});
  add("body", "#c04030",
      {{-0.0049, 0, 0.0131},
       {-0.0069, 0, 0.0058},
       {-0.0057, 0, -0.0048},
       {-0.0017, 0, -0.0147},
       {0.0034, 0, -0.0202},
       {0.0079, 0, -0.0191},
       {0.0099, 0, -0.0118},
       {0.0087, 0, -0.0012},
       {0.0047, 0, 0.0087},
       {-0.0004, 0, 0.0142}});
  add("wing", "#7d2a20",
      {{0.0035, 0, 0.005},
       {0.008, 0, 0},
       {0.01, 0, -0.014},
       {0.0085, 0, -0.019},
       {0.004, 0, -0.009}});
  add("crest", "#e0b040",
      {{-0.007, 0, 0.0215}, {0.0005, 0, 0.022}, {-0.0005, 0, 0.016}, {-0.004, 0, 0.015}});
  add("head", "#c04030",
      {{0.0002, 0, 0.018},
       {-0.003, 0, 0.0212},
       {-0.0074, 0, 0.0212},
       {-0.0106, 0, 0.018},
       {-0.0106, 0, 0.0136},
       {-0.0074, 0, 0.0104},
       {-0.003, 0, 0.0104},
       {0.0002, 0, 0.0136}});
  add("beak", "#d8a020", {{-l.lS, 0, l.hS}, {-0.0102, 0, 0.0186}, {-0.0104, 0, 0.0142}});
  add("eye", "#ffffff",
      {{-0.006, 0, 0.0172}, {-0.0072, 0, 0.0184}, {-0.0084, 0, 0.0172}, {-0.0072, 0, 0.016}});
  return all;
}

class Woodpecker final : public PartialMechanicalSystem {
 public:
  static void declare(Attributes& a) {
    a.about(
        "Woodpecker toy: sleeve with play on a pole, bird on a torsion spring; coordinates "
        "y, phiM, phiS. Its contacts are three WoodpeckerContact.");
    Lengths::declare(a);
    a.optional("mM", Unit::mass, 0.0003, "mass of the sleeve").positive();
    a.optional("mS", Unit::mass, 0.0045, "mass of the bird").positive();
    a.optional("JM", Unit::inertia, 5.0e-9, "inertia of the sleeve").positive();
    a.optional("JS", Unit::inertia, 7.0e-7, "inertia of the bird").positive();
    a.optional("c", Unit::rotationalStiffness, 0.0056, "torsion spring").nonNegative();
    a.optional("gravity", Unit::acceleration, 9.81, "acceleration of gravity, down");
    a.vector("q0", Unit::any, 3, "0 0 0", "initial y [m], phiM, phiS [rad]");
    a.vector("u0", Unit::any, 3, "0 0 0", "their rates [m/s], [rad/s]");
    a.example("<Woodpecker name=\"toy\" q0=\"0 {-0.6/5.8} -0.2788\" u0=\"-0.3411 0 -7.4583\"/>");
  }
  explicit Woodpecker(const Parameters& x)
      : PartialMechanicalSystem(x),
        l_(x),
        mM_(x["mM"]),
        mS_(x["mS"]),
        JM_(x["JM"]),
        JS_(x["JS"]),
        c_(x["c"]),
        g_(x["gravity"]),
        q0_(x["q0"].vec3()),
        u0_(x["u0"].vec3()),
        pole_("pole", "#b08050", rectangle(-l_.r0, l_.r0, -0.45, 0.05)),
        innerWall_("wall", "#4878a8", rectangle(l_.rM, l_.rM + 0.002, -l_.hM, l_.hM)),
        outerWall_("wall", "#4878a8", rectangle(-l_.rM - 0.002, -l_.rM, -l_.hM, l_.hM)),
        rod_("rod", "#505860", {{l_.rM + 0.002, 0, 0}, {l_.lM, 0, 0}}),
        spring_("spring", "#8d99a6", disc(l_.lM, 0.0018)),
        bird_(bird(l_)) {}

  Blocks blocks() const override { return {3, 3, 1, true}; }
  void initialState(Vec q, Vec u) const override { q = q0_, u = u0_; }

  void M(double, ConstVec, MassBlocks M) const override {
    const double a = mS_ * l_.lM, b = mS_ * l_.lG;
    M[0] << mS_ + mM_, a, b,            //
        a, JM_ + a * l_.lM, a * l_.lG,  //
        b, a * l_.lG, JS_ + b * l_.lG;
  }
  void h(double, ConstVec q, ConstVec, Vec h) const override {
    const double moment = c_ * (q[1] - q[2]);
    h << -(mS_ + mM_) * g_, -moment - mS_ * l_.lM * g_, moment - mS_ * l_.lG * g_;
  }
  double potentialEnergy(double, ConstVec q) const override {
    const double twist = q[1] - q[2];
    return (mM_ + mS_) * g_ * q[0] + mS_ * g_ * (l_.lM * q[1] + l_.lG * q[2]) +
           0.5 * c_ * twist * twist;
  }

  /// Frames: 0 pole, 1 sleeve, 2 bird. Positive angles turn x towards z.
  int frames() const override { return 3; }
  void frame(double, ConstVec q, ConstVec u, int id, Frame& out) const override {
    if (id == 0) return;  // the pole does not move
    out.block = 0;
    const double angle = q[id], rate = u[id];
    out.A_IK << std::cos(angle), 0, -std::sin(angle), 0, 1, 0, std::sin(angle), 0, std::cos(angle);
    out.Omega_I = Vec3(0, -rate, 0);
    out.J_R_I(1, id) = -1.0;
    const double lM = id == 2 ? l_.lM : 0.0, lG = id == 2 ? l_.lG : 0.0;
    out.r_OS_I = Vec3(lM + lG, 0, q[0] + lM * q[1] + lG * q[2]);
    out.J_S_I.row(2) << 1.0, lM, lG;
    out.v_S_I = Vec3(0, 0, u[0] + lM * u[1] + lG * u[2]);
  }

  void describe(Description& d) const override {
    d.coordinate("y", Unit::length, 0, "height of the sleeve");
    d.coordinate("phiM", Unit::angle, 1, "angle of the sleeve");
    d.coordinate("phiS", Unit::angle, 2, "angle of the bird");
    d.velocity("y_dot", Unit::velocity, 0);
    d.velocity("phiM_dot", Unit::angularVelocity, 1);
    d.velocity("phiS_dot", Unit::angularVelocity, 2);
    d.frame("pole", 0), d.frame("sleeve", 1), d.frame("bird", 2);
    d.shape(pole_, 0);  // painted in this order
    d.shape(rod_, 1), d.shape(innerWall_, 1), d.shape(outerWall_, 1);
    d.shape(*bird_.front(), 2), d.shape(spring_, 1);  // the arm, below the spring
    for (std::size_t i = 1; i < bird_.size(); ++i) d.shape(*bird_[i], 2);
  }

 private:
  Lengths l_;
  double mM_, mS_, JM_, JS_, c_, g_;
  Vec3 q0_, u0_;
  Outline pole_, innerWall_, outerWall_, rod_, spring_;
  std::vector<std::unique_ptr<Outline>> bird_;
};

/// One of the three places where the toy touches the pole; g = a + b·q, γ_T = d·u.
///
///   beak     g = l_M + l_G − l_S − r_0 − h_S φ_S     d = (1, l_M, l_G − l_S)
///   sleeve2  g = r_M − r_0 + h_M φ_M                 d = (1, r_M, 0)        lower edge
///   sleeve3  g = r_M − r_0 − h_M φ_M                 d = (1, r_M, 0)        upper edge
class WoodpeckerContact final : public SimpleContact {
 public:
  static void declare(Attributes& a) {
    a.about(
        "Contact of the woodpecker toy with its pole: beak, lower or upper edge of the sleeve.");
    a.choice("place", {"beak", "sleeve2", "sleeve3"}, "beak",
             "beak, sleeve2 (lower edge) or sleeve3 (upper edge)");
    Lengths::declare(a);
    a.example(
        "<WoodpeckerContact name=\"beak\" on=\"toy\" place=\"beak\">"
        "<UnilateralCoulomb epsilonN=\"0.5\" mu=\"0.3\"/></WoodpeckerContact>");
  }
  explicit WoodpeckerContact(const Parameters& x) : SimpleContact(x) {
    const Lengths l(x);
    const std::string& where = x["place"];
    r0_ = l.r0;
    if (where == "beak") {
      g0_ = l.lM + l.lG - l.lS - l.r0;
      normal_ = Vec3(0, 0, -l.hS);
      slip_ = Vec3(1, l.lM, l.lG - l.lS);
      drawn_ = slip_ - Vec3(1, 0, 0), height_ = l.hS;
    } else {
      g0_ = l.rM - l.r0;
      normal_ = Vec3(0, where == "sleeve2" ? l.hM : -l.hM, 0);
      slip_ = Vec3(1, l.rM, 0);
      drawn_ = slip_ - Vec3(1, 0, 0), height_ = where == "sleeve2" ? -l.hM : l.hM;
    }
  }
  /// The point on the pole, and the directions of g (away from the pole) and γ_T (up).
  bool drawnAt(double, ConstVec q, DrawnPlace& at) const override {
    at.point = Vec3(r0_, 0, q[0] + drawn_.dot(q.head<3>()) + height_);
    at.normal = Vec3(1, 0, 0), at.t1 = Vec3(0, 0, 1);
    return true;
  }
  int rows() const override { return 2; }
  double g(double, ConstVec q) const override { return g0_ + normal_.dot(q.head<3>()); }
  void gamma(double, ConstVec, ConstVec u, Vec gamma) const override {
    gamma[0] = normal_.dot(u.head<3>());
    gamma[1] = slip_.dot(u.head<3>());
  }
  bool bias(const Kinematics&, Vec bias) const override {
    bias.setZero();  // W is constant
    return true;
  }

 private:
  double g0_ = 0.0;
  Vec3 normal_, slip_;
  double r0_ = 0.0, height_ = 0.0;  // where it is drawn [m]
  Vec3 drawn_ = Vec3::Zero();
};

void registerElements(Registry& r) {
  r.add<Woodpecker>("Woodpecker");
  r.add<WoodpeckerContact>("WoodpeckerContact");
}

}  // namespace

DYNAMY_PLUGIN("woodpecker", "1.0.0", registerElements)
