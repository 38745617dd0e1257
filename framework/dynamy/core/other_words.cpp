#include <algorithm>
#include <array>
#include <dynamy/core/other_words.hpp>

namespace dynamy {
namespace {

// clang-format off
constexpr auto kOtherElements = std::to_array<OtherWord>({
  // Bodies.
  {"body rigid rigidsolid link chbody solid multibody actor", "", "a body is <RigidBody>, in a plane <PlanarBody>"},
  {"body2d planarrigidbody", "", "a body in a plane is <PlanarBody>"},
  {"particle masspoint pointparticle", "", "a mass without rotation is <PointMass>"},
  {"static world staticbody fixedbody worldbody environment worldframe", "", "what stands still is <Ground>"},
  {"kinematicbody mocap", "", "a body that moves as told is <Ground motion=\"…; …; …\">"},
  {"inertial inertia massproperties", "", "mass and inertia are attributes of their body: <RigidBody mass=\"…\" inertia=\"…\">"},
  {"origin pose transform", "", "place and axes are attributes: <RigidBody position=\"…\" euler=\"…\">"},
  {"marker coordinatesystem site rigidtransform", "", "a point with axes on a body is <Frame>"},
  {"freejoint floating 6dof", "", "<RigidBody> moves freely and needs no joint"},
  // Shapes.
  {"cuboid brick block cube bricksolid boxshape", "", "a cuboid is <Box>"},
  {"ball sphericalsolid sphereshape", "", "a ball is <Sphere>"},
  {"plane floor halfplane infiniteplane groundplane staticplane", "", "a plane is <HalfSpace>"},
  {"disk disc wheel cylindricalsolid cylindershape", "", "a disc is a short <Cylinder>"},
  {"pill sweptsphere capsuleshape", "", "a cylinder with round ends is <Capsule>"},
  {"hull convexhull convex convexmesh", "", "a convex hull is <Polyhedron>"},
  {"trimesh trianglemesh triangularmesh triangles", "", "a mesh of triangles is <Mesh>"},
  {"heightmap hfield terrain elevationgrid heightfieldterrain gridsurface", "", "a ground of heights is <HeightField>"},
  {"polyline segment edge", "", "a line through points is <Line>"},
  {"tire tyre", "", "a tyre is <Torus>"},
  {"geom geometry collision visual shape collisionshape collider visualshape", "", "a shape has the name of its kind, <Box>, <Sphere>, …, and stands inside of its body; with a material it takes part in contact"},
  // Joints.
  {"hinge pin continuous hingejoint revolutejoint jointhinge pinjoint hingeconstraint rotational", "", "a hinge is <Revolute>"},
  {"slider slide prismaticjoint sliderjoint translational translationaljoint sliderconstraint", "", "a slider is <Prismatic>"},
  {"balljoint ballandsocket socket sphericaljoint point2point ballsocket ballrpy", "", "a ball joint is <Spherical>"},
  {"weld rigidconnection fixedjoint weldjoint rigidjoint weldconstraint lock", "", "a rigid connection is <Fixed>"},
  {"cardan hooke universaljoint cardanjoint", "", "a Cardan joint is <Universal>"},
  {"helical leadscrew screwjoint", "", "a screw joint is <Screw>"},
  {"joint constraint mate equality connector", "", "a joint has the name of its kind: <Revolute>, <Prismatic>, <Spherical>, <Fixed>, …"},
  {"pulley tendon cable beltcable", "", "a rope is <Rope>, one over a pulley <SheaveRope>"},
  {"motor actuator servo", "", "a motor is <JointMotor>, a drive that moves as told <JointDrive>, a controller <PdController>"},
  {"limit jointlimit hardstop endstop", "", "the limits of a joint are <JointStop lower=\"…\" upper=\"…\">"},
  {"rod distanceconstraint massless massslessrod", "", "a rod without mass is <Distance>"},
  // Forces.
  {"spring dashpot damper tsda springdamperforce springanddamper linearspring", "", "a spring or a damper is <SpringDamper>"},
  {"rsda rotspring rotationalspring torsionalspring", "", "a spring about an axis is <TorsionSpring>"},
  {"force torque wrench load externalforce appliedforce bodyforce motionforce", "", "a given force or moment is <ForceInput>"},
  {"weight gravityfield gravitationalfield gravitationalforce", "", "weight comes from <Gravity>"},
  {"airresistance fluiddrag aerodynamics", "", "the drag of a fluid is <Drag>"},
  // Laws and rules.
  {"friction coulomb coulombfriction coulomblaw newtonimpactfrictionnsl frictioncontact", "", "contact with friction is <UnilateralCoulomb mu=\"…\" epsilonN=\"…\">"},
  {"newtonimpactnsl restitution complementarityconditionnsl frictionless", "", "contact without friction is <Unilateral epsilonN=\"…\">"},
  {"surface physicsmaterial contactmaterial materialsurface chmaterialsurface contactproperties", "", "values of a material are <Material name=\"…\" mu=\"…\" epsilonN=\"…\">, the law of two materials <Contact between=\"A B\">"},
  {"pair contactpair collisionpair interaction spatialcontactforce contactforce", "", "the law of two materials is <Contact between=\"A B\">"},
  {"exclude disablecollisions nocollision disablecollision", "", "materials that pass through each other are <NoContact between=\"A B\">"},
  // Methods.
  {"timestepping moreaujean moreaujeanosi moreau", "", "Moreau's time stepping is <MoreauMidpoint>"},
  {"rungekutta rk4 rk45 ode45 dopri dopri5 dormandprince runge", "", "a Runge-Kutta scheme with located impacts is <LocatedDormandPrince>, the default with a tolerance"},
  {"euler semiimplicit semiimpliciteuler symplecticeuler impliciteuler", "", "a scheme of steps of given length is <MoreauMidpoint>, the default with a step"},
  {"hht newmark bathe alpha genalpha", "", "a generalised-alpha scheme is <GeneralizedAlpha>"},
  {"verlet rattle shake leapfrog", "", "the scheme of Verlet and RATTLE is <NonsmoothRattle>"},
  {"pgs psor sor gaussseidel projectedgaussseidel nsgs sequentialimpulse sequentialimpulses", "", "projected Gauss-Seidel is <ProxGaussSeidel>"},
  {"jacobi projectedjacobi", "", "projected Jacobi is <ProxJacobi>"},
  {"lcp lcpsolver dantzig pivoting", "", "a pivoting solver is <Lemke>"},
  {"newton nsn nonsmoothnewton", "", "Newton's method as a solver is <ProximalNewton>, as an impact law <NewtonImpact>"},
  // Words of the file.
  {"bodies links parts objects", "", "bodies stand in <systems>"},
  {"joints constraints interactions materials sensors collisions", "", "joints, contacts and materials stand in <elements>"},
  {"actuators springs loads", "", "springs, drives and loads stand in <forces>"},
  {"option options physics simulator solveroptions settings solver experiment time", "", "time, step, scheme and solver stand in <simulation>"},
  {"output outputs log logging sensor recorder", "", "what is kept of a run stands in <record>"},
  {"variable var define property constant xacro", "", "a number with a name is <parameter>"},
  {"import", "", "another file is taken in by <include>"},
  {"array for loop repeat pattern", "", "copies are made by <replicate>"},
  {"assert expect test", "", "an expected result is <check>"},
  {"library extension", "", "a library with further types is <plugin>"},
  {"description documentation comment note text", "", "text for people stands in <doc>"},
  {"default", "", "attributes that elements of a type take if they lack them stand in <defaults>"},
});

constexpr auto kOtherAttributes = std::to_array<OtherWord>({
  // Contact.
  {"friction frictioncoefficient coefficientoffriction mu1 slidingfriction staticfriction lateralfriction mus frictionstatic", "mu",
   "the coefficient of friction is {}", "friction belongs to the law of two materials: <UnilateralCoulomb mu=\"…\">"},
  {"restitution coefficientofrestitution restitutioncoefficient cor bounce bounciness elasticity e epsilon en restitutionn", "epsilonN",
   "the coefficient of restitution is {}", "restitution belongs to the law of two materials: <UnilateralCoulomb epsilonN=\"…\">"},
  {"et restitutiont tangentialrestitution", "epsilonT", "the tangential coefficient of restitution is {}"},
  {"kineticfriction dynamicfriction muk mud frictiondynamic mudynamic", "kineticMu kineticForce mu",
   "friction while slipping is {}", "friction that weakens while slipping is <UnilateralStribeck mu=\"…\" kineticMu=\"…\">"},
  {"rollingfriction", "rolling", "resistance to rolling is {}, an arm in m", "resistance to rolling is <UnilateralRolling rolling=\"…\">"},
  {"spinningfriction torsionalfriction", "drilling", "friction about the normal is {}, an arm in m", "friction about the normal is <UnilateralRolling drilling=\"…\">"},
  // Place and axes.
  {"pos translation origin location place xyz center centre coordinates r0", "position at point", "the place is {}"},
  {"anchor pivot jointorigin attachment", "at point pointA", "the place of a joint is {}"},
  {"quaternion quat rotationquaternion orient orientationquaternion", "orientation", "the quaternion w x y z is {}"},
  {"rpy eulerangles rotationangles rollpitchyaw axisangle angles", "euler", "angles about the fixed axes x, then y, then z are {}"},
  {"rotation", "orientation", "a rotation is a quaternion {}, or angles euler=\"…\""},
  // Motion.
  {"vel linearvelocity v v0 initialvelocity linvel speed", "velocity", "the velocity is {}"},
  {"omega angvel angularrate w w0 angularspeed spin initialangularvelocity angularvel", "angularVelocity", "the angular velocity is {}"},
  // Mass.
  {"m weight bodymass", "mass", "the mass is {}"},
  {"inertia momentofinertia inertiatensor moment ixx diaginertia fullinertia momentsofinertia inertiaxx j jxx", "inertia", "moments of inertia are {}",
   "moments of inertia stand at the body, <RigidBody mass=\"…\" inertia=\"…\">; those of a shape follow from its mass or density"},
  {"rho", "density", "the density is {}"},
  // Sizes.
  {"diameter", "radius", "half of the diameter is {}"},
  {"r", "radius", "the radius is {}"},
  {"halfextents halfsize halflengths halfwidths", "size semiAxes", "the size is {}, whole edges and not half ones"},
  {"extents dimensions dims edges lengths sides scale", "size semiAxes", "the size is {}"},
  {"radii semiaxis", "semiAxes", "half of the lengths are {}"},
  {"height h l", "length", "the length is {}"},
  {"vertices verts corners nodes", "points", "the points are {}"},
  {"faces indices", "triangles", "the numbers of the corners are {}"},
  // Springs.
  {"k springconstant springrate springstiffness stiffnesscoefficient kp", "stiffness", "the stiffness is {}"},
  {"stiffness damping compliance kn contactstiffness contactdamping solref solimp erp cfm", "", "",
   "contacts and joints are rigid and need none; a spring is <SpringDamper stiffness=\"…\" damping=\"…\">, in a joint <JointSpring>"},
  {"d b dampingcoefficient dampingconstant damper viscousdamping kv kd dampingrate", "damping", "the damping is {}"},
  {"c", "stiffness", "the stiffness is {}, the damping damping=\"…\""},
  {"restlength freelength naturallength springlength l0 restlen", "length", "the length without force is {}"},
  {"springreference springref restangle qspring reference0", "rest angle", "the place without force is {}"},
  {"g gravity gravityvector", "acceleration", "the acceleration of free fall is {}, three numbers", "gravity is an element: <Gravity acceleration=\"0 0 -9.81\"/>"},
  {"value vector direction field", "acceleration", "the acceleration is {}, three numbers"},
  // Joints.
  {"parent child body1 body2 bodya bodyb link1 link2 a b base follower bodies frames links materials material1 material2 joins objects", "between", "both sides stand in one attribute: between=\"A B\""},
  {"body link system frame", "on", "what it acts on is {}"},
  {"range limits lowerlimit minangle", "lower", "the limits are lower=\"…\" and upper=\"…\"", "the limits of a joint are <JointStop lower=\"…\" upper=\"…\">"},
  {"upperlimit maxangle", "upper", "the upper limit is {}", "the limits of a joint are <JointStop lower=\"…\" upper=\"…\">"},
  {"maxforce maxtorque effort forcelimit ctrlrange forcerange", "limit", "the largest force or moment is {}"},
  {"setpoint desired targetposition", "target", "the target is {}"},
  {"jointtype", "", "", "the kind of a joint is the name of its element: <Revolute>, <Prismatic>, <Spherical>, <Fixed>, …"},
  // Simulation.
  {"dt timestep h stepsize maxstep fixedstep samplingtime deltat maxstepsize", "step", "the length of a step is {}"},
  {"duration tend endtime stoptime tfinal finaltime simtime simulationtime t t1 end stop", "until", "the end time is {}"},
  {"tol reltol rtol abstol atol accuracy precision targetaccuracy", "tolerance", "the accuracy is {}"},
  {"iterations maxiter maxit maxiters iter niter solveriterations numsolveriterations itermax", "maxIterations maxNewton", "the most iterations are {}",
   "iterations belong to a solver: <simulation><ProxGaussSeidel maxIterations=\"…\"/></simulation>"},
  {"omegasor relaxation sorparam", "factor", "the factor of the projection is {}"},
  {"integrator solver scheme method", "", "", "scheme and solver are elements: <simulation><MoreauMidpoint/><ProxGaussSeidel/></simulation>"},
  {"fps framerate", "frames", "pictures per second are {}"},
  {"interval samplerate sampletime", "every", "the sample time is {}"},
  // What is no attribute.
  {"fixed static kinematic isstatic mobility ikinematic bodyfixed immovable", "", "", "what stands still is <Ground>"},
  {"type", "", "", "the kind of an element is its name, such as <RigidBody>, <Revolute> or <Sphere>"},
  // Names.
  {"id label tag", "name", "the name is {}"},
  {"color rgba colorrgba diffuse", "colour", "the colour is {}"},
  {"name file filename path url uri src", "library", "the library is {}"},
  {"file filename path url uri src", "file", "the file is {}",
   "files of shapes are not read; their corners stand in the model: <Polyhedron points=\"…\">, <Mesh points=\"…\" triangles=\"…\">"},
  {"default expr val", "value", "the value is {}"},
  {"n number times copies", "count", "the count is {}"},
});

constexpr auto kOtherUnits = std::to_array<OtherWord>({
  {"degree degrees", "deg", ""},
  {"radian radians", "rad", ""},
  {"meter meters metre metres", "m", ""},
  {"millimeter millimeters millimetre millimetres", "mm", ""},
  {"centimeter centimeters centimetre centimetres", "cm", ""},
  {"sec secs second seconds", "s", ""},
  {"msec millisecond milliseconds", "ms", ""},
  {"minute minutes", "min", ""},
  {"hr hour hours", "h", ""},
  {"kilogram kilograms kgs kilo", "kg", ""},
  {"gram grams gr", "g", ""},
  {"ton tons tonne tonnes", "t", ""},
  {"newton newtons", "N", ""},
  {"joule joules", "J", ""},
  {"watt watts", "W", ""},
  {"pascal", "Pa", ""},
  {"hertz", "Hz", ""},
  {"kph kmh", "km/h", ""},
  {"mps", "m/s", ""},
  {"in inch inches", "", "1in is 0.0254m"},
  {"ft foot feet", "", "1ft is 0.3048m"},
  {"lb lbs lbm pound pounds", "", "1lb is 0.45359237kg"},
  {"oz ounce ounces", "", "1oz is 28.349523g"},
  {"lbf", "", "1lbf is 4.4482216N"},
  {"mph", "", "1mph is 0.44704m/s"},
  {"bar", "", "1bar is 100kPa"},
  {"rev turn turns", "", "a turn is 360deg"},
  {"rps", "", "a turn in a second is 60rpm"},
});
// clang-format on

/// The word in lower case, without "_", "-" and ":".
std::string plainWord(std::string_view word) {
  std::string out;
  for (const char c : word)
    if (c != '_' && c != '-' && c != ':')
      out += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return out;
}

std::vector<std::string_view> wordsOfRow(std::string_view text) {
  std::vector<std::string_view> out;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    out.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return out;
}

/// The rows that have this word, in the order of the table.
std::vector<const OtherWord*> rowsWith(std::span<const OtherWord> table, std::string_view word) {
  const std::string wanted = plainWord(word);
  std::vector<const OtherWord*> out;
  for (const OtherWord& row : table) {
    const auto words = wordsOfRow(row.words);
    if (std::find(words.begin(), words.end(), wanted) != words.end()) out.push_back(&row);
  }
  return out;
}

std::string inDynamy(std::string_view hint) { return "in dynamY " + std::string(hint); }

}  // namespace

std::span<const OtherWord> otherElements() { return kOtherElements; }
std::span<const OtherWord> otherAttributes() { return kOtherAttributes; }
std::span<const OtherWord> otherUnits() { return kOtherUnits; }

std::string elementOfOthers(std::string_view word) {
  const auto found = rowsWith(kOtherElements, word);
  return found.empty() ? std::string() : inDynamy(found.front()->hint);
}

std::string withoutKind(std::string_view word) {
  std::string out = plainWord(word);
  while (!out.empty() && out.back() >= '0' && out.back() <= '9') out.pop_back();
  if (out.starts_with("ch")) out.erase(0, 2);
  for (const std::string_view kind : {"joint", "constraint", "force", "shape", "collider", "law",
                                      "geometry", "solver", "integrator", "scheme"})
    if (out.ends_with(kind) && out.size() > kind.size()) {
      out.resize(out.size() - kind.size());
      break;
    }
  return out;
}

AttributeOfOthers attributeOfOthers(std::string_view word, std::span<const std::string> known) {
  const auto found = rowsWith(kOtherAttributes, word);
  for (const OtherWord* row : found)
    for (const std::string_view name : wordsOfRow(row->ours)) {
      if (std::find(known.begin(), known.end(), name) == known.end()) continue;
      std::string hint(row->hint);
      if (const std::size_t at = hint.find("{}"); at != std::string::npos)
        hint.replace(at, 2, std::string(name) + "=\"…\"");
      return {std::string(name), inDynamy(hint)};
    }
  for (const OtherWord* row : found)
    if (!row->elsewhere.empty()) return {"", inDynamy(row->elsewhere)};
  return {};
}

std::string unitOfOthers(std::string_view word) {
  // Units such as "degrees/sec" are replaced part by part; a part that is not in the table stays.
  std::string out;
  bool changed = false;
  for (std::size_t at = 0; at <= word.size();) {
    const std::size_t end = std::min(word.find('/', at), word.size());
    const std::string_view part = word.substr(at, end - at);
    const auto found = rowsWith(kOtherUnits, part);
    const bool ours = !found.empty() && !found.front()->ours.empty();
    out += (at > 0 ? "/" : "") + std::string(ours ? found.front()->ours : part);
    changed = changed || ours;
    at = end + 1;
  }
  return changed ? out : std::string();
}

std::string unitInOurs(std::string_view word) {
  const auto found = rowsWith(kOtherUnits, word);
  return found.empty() ? std::string() : std::string(found.front()->hint);
}

}  // namespace dynamy
