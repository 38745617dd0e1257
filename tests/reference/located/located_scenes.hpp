/// Scenes of one or two coordinates whose motion is known to many digits.
#pragma once
#include <string>

namespace dynamy::reference::scenes {

/// Ball on a floor; g = 9.81, released at rest 1 m above.
inline const std::string kBall = R"xml(<dynamy version="1">
  <parameter name="e" value="0.5"/>
  <systems><Coordinates name="ball" q="z" units="m" q0="1" u0="0" M="1" potential="9.81*z"/></systems>
  <elements><CoordinateContact name="floor" on="ball" gap="z">
    <Unilateral epsilonN="{e}"/></CoordinateContact></elements>
  <simulation until="1" step="1"/></dynamy>)xml";

/// x'' + x = cos(2.2 t + phase) with a wall at x <= 0, e = 0.8, started right after an impact of
/// the orbit with one impact a period (truth N07).
inline const std::string kImpactOscillator = R"xml(<dynamy version="1">
  <systems><Coordinates name="mass" q="x" units="m" q0="0" u0="{-0.8*1.8987487383113029}" M="1"
    h="-x + cos(2.2*t + 2.803786574972142)"/></systems>
  <elements><CoordinateContact name="wall" on="mass" gap="-x">
    <Unilateral epsilonN="0.8"/></CoordinateContact></elements>
  <simulation until="1" step="1"/></dynamy>)xml";

/// Belt with F = 1/(1 + 3|v_rel|), set-valued at 0 (truth N05e): what weakens is smooth on each
/// side of rest. Started sticking, at the place where the limit cycle sticks again.
inline const std::string kWeakeningBelt = R"xml(<dynamy version="1">
  <systems><Coordinates name="block" q="x" units="m" q0="-0.5410063538700847" u0="0.2" M="1"
    h="-x + sign(0.2 - x_dot)*(1/(1 + 3*abs(0.2 - x_dot)) - 1)"/></systems>
  <elements><CoordinateContact name="friction" on="block" slipVelocity="x_dot - 0.2">
    <GivenFriction force="1"/></CoordinateContact></elements>
  <simulation until="1" step="1"/></dynamy>)xml";

/// Belt with static friction 1 N and kinetic 0.5 N (truth N05).
inline const std::string kBelt = R"xml(<dynamy version="1">
  <systems><Coordinates name="block" q="x" units="m" q0="0" u0="0.2" M="1" h="-x"/></systems>
  <elements><CoordinateContact name="friction" on="block" slipVelocity="x_dot - 0.2">
    <GivenFriction force="1" kineticForce="0.5"/></CoordinateContact></elements>
  <simulation until="1" step="1"/></dynamy>)xml";

/// Bead across an inclined slot, clearance 0.01 m, 30 degrees, e = 0.5, mu = 0.1, at rest at the
/// upper wall (truth N19). x along, y across.
inline const std::string kSlot = R"xml(<dynamy version="1">
  <parameter name="a" value="{pi/6}"/>
  <systems><Coordinates name="bead" q="x y" units="m m" q0="0 0.01" u0="0 0" M="1 ; 0 ; 1"
    h="9.81*sin(a) ; -9.81*cos(a)"/></systems>
  <elements>
    <CoordinateContact name="lower" on="bead" gap="y" slip="1 ; 0">
      <UnilateralCoulomb mu="0.1" epsilonN="0.5"/></CoordinateContact>
    <CoordinateContact name="upper" on="bead" gap="0.01 - y" slip="1 ; 0">
      <UnilateralCoulomb mu="0.1" epsilonN="0.5"/></CoordinateContact>
  </elements>
  <simulation until="1" step="1"/></dynamy>)xml";

/// Uniform ladder, L = 2 m, at rest at 60 degrees on smooth wall and floor (truth N22).
inline const std::string kLadder = R"xml(<dynamy version="1">
  <parameter name="s" value="{pi/3}"/>
  <systems><Coordinates name="ladder" q="x y phi" units="m m rad"
    q0="{cos(s)} {sin(s)} {s}" M="1 ; 0 ; 0 ; 1 ; 0 ; 1/3" potential="9.81*y"/></systems>
  <elements>
    <CoordinateContact name="wall" on="ladder" gap="x - cos(phi)"><Unilateral/></CoordinateContact>
    <CoordinateContact name="floor" on="ladder" gap="y - sin(phi)"><Unilateral/></CoordinateContact>
    <CoordinateContact name="end" on="ladder" gap="y + sin(phi)"><Unilateral/></CoordinateContact>
  </elements>
  <simulation until="1" step="1"/></dynamy>)xml";

/// Free body near its intermediate axis (truth S06).
inline const std::string kTop = R"xml(<dynamy version="1">
  <systems><RigidBody name="top" mass="1" inertia="1 2 3" angularVelocity="0.01 5 0.01"/></systems>
  <simulation until="1" step="1"/></dynamy>)xml";

/// Two point masses on massless rods, minimal coordinates, from the horizontal (truth S09).
inline const std::string kDoublePendulum = R"xml(<dynamy version="1">
  <systems><Coordinates name="minimal" q="a b" units="rad rad" q0="{pi/2} {pi/2}"
    kineticEnergy="a_dot^2 + b_dot^2/2 + a_dot*b_dot*cos(a - b)"
    potential="-9.81*(2*cos(a) + cos(b))"/></systems>
  <simulation until="1" step="1"/></dynamy>)xml";

/// The same as two masses with two rods.
inline const std::string kRodPendulum = R"xml(<dynamy version="1">
  <systems>
    <PointMass name="upper" plane="xz" position="1 0 0" mass="1"/>
    <PointMass name="lower" plane="xz" position="2 0 0" mass="1"/>
    <Ground name="world"/>
  </systems>
  <forces><Gravity acceleration="0 0 -9.81"/></forces>
  <elements><Distance name="rod1" between="world upper"/><Distance name="rod2" between="upper lower"/>
  </elements>
  <simulation until="1" step="1"/></dynamy>)xml";

/// Point mass on a rod of 1 m, let go from the horizontal (truth S01).
inline const std::string kPendulum = R"xml(<dynamy version="1">
  <parameter name="start" value="0"/>
  <systems>
    <PointMass name="bob" plane="xz" position="{-cos(start)} 0 {-sin(start)}" mass="1"/>
    <Ground name="world"/>
  </systems>
  <forces><Gravity acceleration="0 0 -9.81"/></forces>
  <elements><Distance name="rod" between="world bob"/></elements>
  <simulation until="1" step="1"/></dynamy>)xml";

/// Ball on a table that shakes with 10 Hz and 1.3 g, e = 0.5, on its orbit with one impact a
/// period, started right behind one (truth N02).
inline const std::string kShakenBall = R"xml(<dynamy version="1">
  <parameter name="A" value="0.0032303726374768341"/><parameter name="p" value="0.6342158689257742"/>
  <systems><Coordinates name="ball" q="z" units="m" q0="{A*sin(p)}" u0="0.4905" M="1"
    potential="9.81*z"/></systems>
  <elements><CoordinateContact name="table" on="ball" gap="z - A*sin(20*pi*t + p)">
    <Unilateral epsilonN="0.5"/></CoordinateContact></elements>
  <simulation until="1" step="1"/></dynamy>)xml";

/// A cube of 1 kg that rests on its four corners.
inline const std::string kRestingBox = R"xml(<dynamy version="1">
  <systems>
    <RigidBody name="box" position="0 0 0.1"><Box size="0.2 0.2 0.2" mass="1" material="wood"/></RigidBody>
    <Ground name="world"><HalfSpace material="floor"/></Ground>
  </systems>
  <forces><Gravity/></forces>
  <elements><Contact between="wood floor"><UnilateralCoulomb mu="0.5" epsilonN="0.3"/></Contact></elements>
  <simulation until="1" step="1"/></dynamy>)xml";

}  // namespace dynamy::reference::scenes
