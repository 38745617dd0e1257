/// ElasticRope: a massless elastic rope from A past free sheaves to B.                 (theory 43.5)
///
///   l = Σ l_i + Σ r_i θ_i            way of the rope, strands and arcs
///   ε = (l − l0)/l0,   S = EA (ε + τ ε̇) ≥ 0 for ε > 0,   V = EA (l − l0)²/(2 l0)
///
/// Sheaves turn without friction, so that S is the same everywhere. An end may be wound on a drum
/// of radius r, where the rope has no strain: with ψ, the angle by which the drum turns against the
/// strand, l̇0 = σ r ψ̇ at A and −σ r ψ̇ at B. Since V depends on l0, the drum feels the moment
///
///   M = ±σ r (S + S²/(2 EA)),   and the strand S²/(2 EA) r/l across itself,
///
/// so that winding keeps the energy. A strand that leans by h along the axis pulls along itself, and by
/// S ρ (1 − l/L)/l across, since sheaves keep the rope in their plane; what carries the axis feels
/// (D (S²/(2 EA)) + ρ S) h/l along t, D = ∓σ r of a drum, else 0 (theory 43.5). ψ is an angle between two directions; a state of the element
/// counts its full turns.
#pragma once
#include <dynamy/system/external_force.hpp>
#include <dynamy_elements/forces/rope_way.hpp>
#include <dynamy_elements/frame_pair.hpp>

namespace dynamy {

/// `<Sheave on= radius= side=/>` in an ElasticRope: a free sheave that the rope passes.
class Sheave final : public Element {
 public:
  static constexpr Kind kKind = Kind::part;
  static void declare(Attributes& a);
  explicit Sheave(const Parameters& x);
  const std::string& on() const { return on_; }
  const Vec3& point() const { return point_; }
  double radius() const { return radius_; }
  const Vec3& side() const { return side_; }

 private:
  std::string on_;
  Vec3 point_, side_;
  double radius_;
};

class ElasticRope final : public ExternalForce {
 public:
  static void declare(Attributes& a);
  explicit ElasticRope(const Parameters& x);
  std::unique_ptr<PartialMechanicalSystem> ownSystem() const override;
  void connect(Topology& topology) override;
  void describe(Description& d) const override;
  void addTo(const Kinematics& k, ForceSink& sink) const override;
  bool hasPotential() const override { return damping_ == 0.0; }
  double potentialEnergy(const Kinematics& k) const override;

 private:
  /// Where the rope passes a frame: an end, a drum or a sheave.
  struct Post {
    FrameHandle frame;
    Vec3 point;  ///< in axes of the frame [m]
    double radius = 0.0, sense = 1.0, wrap0 = 0.0;
    Vec3 mark = Vec3::Zero();  ///< on a drum, in its axes: where the rope left it at the start
    int state = -1;            ///< of the counted angle; −1: no drum
  };
  /// The rope as it lies: lengths, strain and their rates.
  struct Taut {
    double length = 0.0, free = 0.0, rate = 0.0, freeRate = 0.0;  ///< l, l0, l̇, l̇0 [m], [m/s]
    double strain = 0.0, spring = 0.0, damper = 0.0;              ///< ε, parts of S [N]
    double turn[2] = {0.0, 0.0}, turnRate[2] = {0.0, 0.0};        ///< ψ of A and B [rad], [rad/s]
  };
  Vec3 axis(const Kinematics& k) const;
  RopeCircle circle(const Kinematics& k, const Post& p, const Vec3& axis) const;
  RopeWay way(const Kinematics& k) const;
  Taut taut(const Kinematics& k, const RopeWay& way) const;
  /// Tension `S` along the way, `extra` across the strands at drums.
  void pull(const Kinematics& k, const RopeWay& way, double S, double extra, ForceSink& sink) const;
  Vec3 strandVelocity(const Kinematics& k, int i) const;
  Vec3 carrierRate(const Kinematics& k) const;
  /// −σ r of a drum at the begin of strand i, σ r of one at its end; 0: none [m].
  double drumRadius(int i) const;
  void findPosts(Topology& topology);
  void draw(const Kinematics& k, const RopeWay& way);

  FramePair ends_;
  std::vector<std::unique_ptr<Sheave>> sheaves_;
  std::string carrierName_;
  Vec3 axis_, sideA_, sideB_;
  FrameHandle carrier_;
  std::vector<Post> posts_;
  SystemHandle states_;
  double EA_, damping_, length_, preload_;
  bool flat_ = false;  // planar bodies: places across their plane mean nothing
  std::vector<PlacedLink> links_;
};

}  // namespace dynamy
