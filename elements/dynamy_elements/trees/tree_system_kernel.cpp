#include <Eigen/Cholesky>
#include <algorithm>
#include <dynamy/core/rotation.hpp>
#include <dynamy_elements/bodies/body_parts.hpp>
#include <dynamy_elements/trees/tree_system.hpp>
#include <limits>

namespace dynamy {

using Free = FreeMotion::Kind;

namespace {

/// Turn of a step [rad] below which it does not matter at which velocity gyroscopic terms are taken.
constexpr double kHardlyTurns = 1e-8;
/// Fixed-point iterations for the mean velocity, the square of the share of it at which they end,
/// and the largest number of equal parts of a step that turns fast.
constexpr int kMostTurns = 30;
constexpr double kExactTurn = 1e-20;
constexpr int kMostParts = 64;

/// w.u after M(q) (u^E − u^A) = Δt (f + h(q, ū)), ū = ½ (u^A + u^E), from u^A = w.u, by fixed-point
/// iterations; w.h: f + h(q, ū). False: they do not converge.
bool turnedByMean(const TreeSystem& tree, ConstVec q, double dt, TreeResults::Mean& w) {
  w.before = w.mean = w.u;
  double last = std::numeric_limits<double>::infinity();
  for (int turn = 0; turn < kMostTurns; ++turn) {
    tree.h(0.0, q, view(std::as_const(w.mean)), view(w.h));
    w.h += w.f;
    tree.applyInverseMass(0.0, q, view(std::as_const(w.h)), view(w.change));
    w.u = w.before + dt * w.change;
    w.change = 0.5 * (w.before + w.u);
    const double off = (w.change - w.mean).squaredNorm();
    if (off <= kExactTurn * w.mean.squaredNorm()) return true;
    if (!(off < last)) return false;
    w.mean = w.change, last = off;
  }
  return false;
}

/// Signals of the coordinates of the body's joint: body.joint.angle and so
/// on, numbered if there are several.
void describeJoint(const Tree& tree, const TreeBody& body, Description& d) {
  const std::string start =
      (body.system->name().empty() ? "" : body.system->name() + ".") + "joint.";
  int turns = 0, slides = 0;
  const auto count = [&](auto kind) {
    int n = 0;
    for (int k = body.first; k <= body.node; ++k) n += kind(tree.node(k).kind) ? 1 : 0;
    return n;
  };
  const auto isSlide = [](Free kind) { return kind == Free::slide; };
  const auto isTurn = [](Free kind) { return kind == Free::turn || kind == Free::screw; };
  const bool manyTurns = count(isTurn) > 1, manySlides = count(isSlide) > 1;
  for (int k = body.first; k <= body.node; ++k) {
    const TreeNode& n = tree.node(k);
    if (n.kind == Free::ball) {
      const char axes[] = "wxyz";
      for (int i = 0; i < 4; ++i)
        d.coordinate(start + "q" + axes[i], Unit::none, n.q0 + i, "quaternion since the start");
      for (int i = 0; i < 3; ++i)
        d.velocity(start + "Omega_" + axes[i + 1], Unit::angularVelocity, n.u0 + i,
                   "relative angular velocity in axes of the other side");
    } else if (isSlide(n.kind)) {
      const std::string number = manySlides ? std::to_string(++slides) : "";
      d.coordinate(start + "way" + number, Unit::length, n.q0, "way since the start");
      d.velocity(start + "speed" + number, Unit::velocity, n.u0, "its rate");
    } else {
      const std::string number = manyTurns ? std::to_string(++turns) : "";
      d.coordinate(start + "angle" + number, Unit::angle, n.q0, "angle since the start");
      d.velocity(start + "rate" + number, Unit::angularVelocity, n.u0, "its rate");
    }
  }
}

}  // namespace

// ---- making ------------------------------------------------------------------------------------

int TreeSystem::carry(System system, int parent, const Vec3& at_I,
                      const std::vector<FreeMotion>& free) {
  TreeBody body;
  body.node = parent < 0 ? -1 : carried_.all()[static_cast<std::size_t>(parent)].node;
  body.first = tree_.size();
  for (const FreeMotion& motion : free) {
    TreeNode node;
    node.kind = motion.kind, node.parent = body.node;
    node.axis = motion.axis_I, node.pitch = motion.pitch, node.rotor = motion.rotor;
    // All axes are those of the world at the start.
    node.arm = at_I;
    for (int k = body.node; k >= 0; k = tree_.node(k).parent) node.arm -= tree_.node(k).arm;
    body.node = tree_.add(node);
  }
  body.system = std::move(system);
  body.part = body.system->abilities().rigid->rigidPart();
  body.blocks = body.system->blocks();
  placeFrames(body);
  carried_.add(std::move(body));
  return bodies() - 1;
}

/// Computes the frames of the body from its node's origin, its mass, and its velocity at the start.
void TreeSystem::placeFrames(TreeBody& body) {
  Vec3 origin = Vec3::Zero();
  for (int k = body.node; k >= 0; k = tree_.node(k).parent) origin += tree_.node(k).arm;
  Eigen::VectorXd q = Eigen::VectorXd::Zero(body.blocks.nq),
                  u = Eigen::VectorXd::Zero(body.blocks.nu);
  body.system->initialState(view(q), view(u));
  std::vector<double> jacobians(static_cast<std::size_t>(6 * body.blocks.nu));
  body.frame0 = frames();
  for (int id = 0; id < body.system->frames(); ++id) {
    Frame f;
    new (&f.J_S_I) Mat3X(jacobians.data(), 3, body.blocks.nu);
    new (&f.J_R_I) Mat3X(jacobians.data() + 3 * body.blocks.nu, 3, body.blocks.nu);
    const Eigen::VectorXd &cq = q, &cu = u;
    body.system->frame(0.0, view(cq), view(cu), id, f);
    frames_.push_back({body.node, f.r_OS_I - origin, f.A_IK});
    if (id > 0) continue;
    const Vec3 rho = f.A_IK * body.part.r_BS_K;
    body.S = f.r_OS_I + rho - origin;
    body.v = f.velocity(rho), body.Omega = f.Omega_I;
    if (body.node >= 0)
      tree_.addMass(body.node, body.part.m, body.S, f.A_IK * body.part.J_S_K * f.A_IK.transpose());
  }
}

TreeSystem::StartChange TreeSystem::finish() {
  results_.resize(tree_);
  u0_.setZero(tree_.nu()), start_.setZero(tree_.nq());
  for (int k = 0; k < tree_.size(); ++k)
    if (tree_.node(k).kind == Free::ball) start_[tree_.node(k).q0] = 1.0;
  Eigen::VectorXd momentum = Eigen::VectorXd::Zero(tree_.nu());
  const Tree::Motions& x = results_.at(tree_, view(std::as_const(start_)));

  // M u = Σ Jᵀ (m v, J Ω): the impact after which the velocities fit the joints.
  std::vector<Vec3>& wrench = results_.wrench;
  for (Vec3& w : wrench) w.setZero();
  StartChange out;
  bool any = false;
  for (const TreeBody& b : carried_.all()) {
    any = any || !b.v.isZero(0.0) || !b.Omega.isZero(0.0);
    if (b.node < 0) continue;
    const Mat3 A = frames_[static_cast<std::size_t>(b.frame0)].A;
    const Vec3 p = b.part.m * b.v, L = A * (b.part.J_S_K * (A.transpose() * b.Omega));
    out.kineticBefore += 0.5 * (p.dot(b.v) + L.dot(b.Omega));
    wrench[2 * static_cast<std::size_t>(b.node)] += p;
    wrench[2 * static_cast<std::size_t>(b.node) + 1] += L + b.S.cross(p);
  }
  if (!any || tree_.nu() == 0) return out;
  tree_.project(x, wrench, view(momentum));
  if (const int nu = tree_.nu(); nu <= kDense) {
    RowMatrix mass(nu, nu);
    tree_.mass(x, results_.inertia, {mass.data(), nu, nu});
    u0_ = mass.ldlt().solve(momentum);
  } else {
    tree_.solve(x, results_.factors(tree_), view(std::as_const(momentum)), wrench, view(u0_));
  }
  out.kineticAfter = 0.5 * u0_.dot(momentum);
  results_.at(tree_, view(std::as_const(start_)), view(std::as_const(u0_)));
  for (const TreeBody& b : carried_.all()) {
    const RigidMotion is = carried_.motion(b, start_.data(), x);
    out.off.push_back(std::max((is.v_S_I - b.v).norm(), (is.Omega_I - b.Omega).norm()));
  }
  return out;
}

// ---- equations of motion -----------------------------------------------------------------------

void TreeSystem::initialState(Vec q, Vec u) const { q = start_, u = u0_; }

void TreeSystem::M(double, ConstVec q, MassBlocks M) const {
  if (tree_.nu() == 0) return;
  // If M does not depend on q, it is always computed at the start, and thus bitwise the same.
  tree_.mass(results_.at(tree_, tree_.constantMass() ? ConstVec(view(start_)) : q),
             results_.inertia, M[0]);
}

void TreeSystem::applyInverseMass(double, ConstVec q, ConstVec in, Vec out) const {
  const Tree::Motions& x = results_.at(tree_, q);
  tree_.solve(x, results_.factors(tree_), in, results_.wrench, out);
}

void TreeSystem::h(double, ConstVec q, ConstVec u, Vec h) const {
  tree_.gyroscopic(results_.at(tree_, q, u), results_.wrench, h);
}

double TreeSystem::gravity(double, ConstVec q, const Vec3& g_I, Vec h) const {
  return tree_.gravity(results_.at(tree_, q), g_I, h);
}

void TreeSystem::qdot(double, ConstVec q, ConstVec u, Vec qdot) const {
  for (int k = 0; k < tree_.size(); ++k) {
    const TreeNode& node = tree_.node(k);
    const double* p = q.data() + node.q0;
    if (node.kind == Free::ball)
      quaternionRate(p, rotationMatrix(p).transpose() * u.segment<3>(node.u0),
                     qdot.data() + node.q0);
    else
      qdot[node.q0] = u[node.u0];
  }
}

void TreeSystem::move(double, Vec q, ConstVec u, double dt) const {
  for (int k = 0; k < tree_.size(); ++k) {
    const TreeNode& node = tree_.node(k);
    double* p = q.data() + node.q0;
    if (node.kind == Free::ball)
      rotate(p, dt * (rotationMatrix(p).transpose() * u.segment<3>(node.u0)));
    else
      q[node.q0] += dt * u[node.u0];
  }
}

void TreeSystem::gyroscopicAtMean(double, ConstVec q, ConstVec uA, double dt, Vec h) const {
  double turn = 0.0;
  for (const NodeMotion& node : results_.at(tree_, q, uA))
    turn = std::max(turn, dt * node.Omega.norm());
  if (tree_.constantMass() || !(turn > kHardlyTurns)) return;
  TreeResults::Mean& w = results_.step;
  for (Eigen::VectorXd* v : {&w.f, &w.u, &w.h, &w.change, &w.sum}) v->resize(tree_.nu());
  this->h(0.0, q, uA, view(w.u));
  w.f = h - w.u;
  for (int parts = 1; parts <= kMostParts; parts *= 2) {
    w.u = uA, w.sum.setZero();
    int done = 0;
    for (; done < parts && turnedByMean(*this, q, dt / parts, w); ++done) w.sum += w.h;
    if (done < parts) continue;
    h = w.sum / parts;  // M(q) (u^E − u^A)/Δt
    return;
  }
}

void TreeSystem::normalise(Vec q) const {
  for (int k = 0; k < tree_.size(); ++k)
    if (tree_.node(k).kind == Free::ball) q.segment<4>(tree_.node(k).q0).normalize();
}

void TreeSystem::frame(double, ConstVec q, ConstVec u, int id, Frame& out) const {
  const FixedFrame& f = frames_[static_cast<std::size_t>(id)];
  out.nu_S_I.setZero(), out.nu_R_I.setZero();
  if (f.node < 0) {
    out.block = -1;
    out.r_OS_I = f.r, out.A_IK = f.A;
    out.v_S_I.setZero(), out.Omega_I.setZero(), out.bias_S_I.setZero(), out.bias_R_I.setZero();
    return;
  }
  out.block = 0;
  const Tree::Motions& x = results_.at(tree_, q, u);
  const NodeMotion& node = x[static_cast<std::size_t>(f.node)];
  const Vec3 rho = node.A * f.r, drag = node.Omega.cross(rho);
  out.r_OS_I = node.r + rho, out.A_IK = node.A * f.A;
  out.v_S_I = node.v + drag, out.Omega_I = node.Omega;
  out.bias_S_I = node.biasS + node.biasR.cross(rho) + node.Omega.cross(drag);
  out.bias_R_I = node.biasR;
  for (int k = f.node; k >= 0; k = tree_.node(k).parent)
    addColumns(x, tree_.node(k), x[static_cast<std::size_t>(k)], out);
}

// ---- names -------------------------------------------------------------------------------------

void TreeSystem::describe(Description& d) const {
  for (const TreeBody& body : carried_.all()) {
    const std::string& name = body.system->name();
    Description own;
    body.system->describe(own);
    d.body({name, body.frame0, body.system->frames(), body.system->place()});
    for (const PlacedShape& p : own.shapes) d.shape(*p.shape, body.frame0 + p.frame);
    for (const auto& [label, id] : own.frames) d.frame(label, body.frame0 + id);
    for (const Signal& s : own.signals)
      d.signal(
          name.empty() ? s.name : name + "." + s.name, s.unit, std::string(s.text),
          [this, &body, f = s.value](const SignalView& v) { return carried_.signal(body, f, v); });
    describeJoint(tree_, body, d);
  }
}

}  // namespace dynamy
