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
  {"kinematicbody mocap", "", "a body with a given motion is <Ground motion=\"…; …; …\">"},
  {"inertial inertia massproperties", "", "mass and inertia are attributes of their body: <RigidBody mass=\"…\" inertia=\"…\">"},
  {"origin pose transform", "", "place and axes are attributes: <RigidBody position=\"…\" euler=\"…\">"},
  {"marker coordinatesystem site rigidtransform", "", "a point with axes on a body is <Frame>"},
  {"freejoint floating 6dof free freemobilizer quaternionfloating", "", "<RigidBody> moves freely and needs no joint"},
  {"pendulum", "", "a pendulum is a <RigidBody> with a <Revolute> between it and the <Ground>"},
  {"beam flexiblebody fem ancf softbody cloth", "", "bodies are rigid; several of them with <Revolute> and <JointSpring> between them bend"},
  // Shapes.
  {"cuboid brick block cube bricksolid boxshape", "", "a cuboid is <Box>"},
  {"ball sphericalsolid sphereshape", "", "a ball is <Sphere>"},
  {"plane floor wall ramp halfplane infiniteplane groundplane staticplane", "", "a plane is the shape <HalfSpace>, inside of a <Ground>"},
  {"disk disc wheel cylindricalsolid cylindershape", "", "a disc is a short <Cylinder>"},
  {"pill sweptsphere capsuleshape", "", "a cylinder with round ends is <Capsule>"},
  {"hull convexhull convex convexmesh", "", "a convex hull is <Polyhedron>"},
  {"trimesh trianglemesh triangularmesh triangles stl obj ply dae", "", "a mesh of triangles is <Mesh file=\"…\">, or <Mesh points=\"…\" triangles=\"…\">"},
  {"heightmap hfield terrain elevationgrid heightfieldterrain gridsurface", "", "a ground of heights is <HeightField>"},
  {"polyline segment edge", "", "a line through points is <Line>"},
  {"tire pacejka", "", "a tyre that rolls without slip is <Torus>, one with a slip curve <Tyre>"},
  {"geom geometry collision visual shape collisionshape collider visualshape", "", "a shape has the name of its kind, <Box>, <Sphere>, …, and stands inside of its body (a <Box> has whole edges as its size); with a material it takes part in contact"},
  // Joints.
  {"hinge pin continuous hingejoint revolutejoint jointhinge pinjoint hingeconstraint rotational", "", "a hinge is <Revolute>"},
  {"slider slide prismaticjoint sliderjoint translational translationaljoint sliderconstraint", "", "a slider is <Prismatic>"},
  {"balljoint ballandsocket socket sphericaljoint point2point ballsocket ballrpy", "", "a ball joint is <Spherical>"},
  {"weld rigidconnection fixedjoint weldjoint rigidjoint weldconstraint lock", "", "a rigid connection is <Fixed>"},
  {"cardan hooke universaljoint cardanjoint ujoint", "", "a Cardan joint is <Universal>"},
  {"helical leadscrew screwjoint", "", "a screw joint is <Screw>"},
  {"joint constraint mate equality connector", "", "a joint has the name of its kind: <Revolute>, <Prismatic>, <Spherical>, <Fixed>, …"},
  {"pulley tendon cable beltcable", "", "a rope is <Rope>, one over a pulley <SheaveRope>"},
  {"motor servo", "", "a motor is <JointMotor>, a drive with a given motion <JointDrive>, a controller <PdController>"},
  {"actuator", "", "motors and drives stand in <elements>, <JointMotor>, <JointDrive>, a controller in <forces>, <PdController>"},
  {"linkmotor motorrotationspeed rotationspeed motorspeed", "", "a motor with a speed and a largest moment is <JointMotor>, a drive with a given motion <JointDrive>"},
  {"mimic gearjoint coupler transmission gearbox", "", "joints that turn in a ratio are coupled by <Gear>"},
  {"parent child parentlink childlink parentbody childbody", "", "both sides of a joint stand in one attribute: <Revolute between=\"A B\">"},
  {"limit jointlimit hardstop endstop", "", "the limits of a joint are an element beside it, with the same between, axis and at: <JointStop lower=\"…\" upper=\"…\">, of a slider with coordinate=\"displacement\""},
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
  {"drakeproximityproperties proximityproperties", "", "friction and restitution belong to the law of two materials: <Contact between=\"A B\"><UnilateralCoulomb mu=\"…\" epsilonN=\"…\"/></Contact>"},
  {"pair contactpair collisionpair interaction spatialcontactforce contactforce", "", "the law of two materials is <Contact between=\"A B\">"},
  {"hertz hertzian hertzcontact huntcrossley kelvinvoigt penalty penaltycontact compliantcontact", "", "contacts are rigid: <Unilateral epsilonN=\"…\">, with friction <UnilateralCoulomb>"},
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
  {"solver solvers", "", "a solver has the name of its kind, inside of <simulation>: <ProxGaussSeidel>, <ProximalNewton>, <Lemke>, …"},
  {"integrator integration stepper", "", "a scheme has the name of its kind, inside of <simulation>: <MoreauMidpoint>, <LocatedDormandPrince>, …"},
  {"newton nsn nonsmoothnewton", "", "Newton's method as a solver is <ProximalNewton>, as an impact law <NewtonImpact>"},
  // Words of the file.
  {"bodies links parts objects", "", "bodies stand in <systems>"},
  {"joints constraints interactions materials sensors collisions", "", "joints, contacts and materials stand in <elements>"},
  {"actuators", "", "motors and drives stand in <elements>, <JointMotor>, <JointDrive>, a controller in <forces>, <PdController>"},
  {"springs loads", "", "springs and loads stand in <forces>"},
  {"option options physics simulator solveroptions settings experiment time", "", "time, step, scheme and solver stand in <simulation>"},
  {"output outputs log logging sensor recorder plot plots scope", "", "what is kept of a run stands in <record>"},
  {"accelerometer gyro gyroscope imu", "", "recorded quantities have names, <record signals=\"ball.vz\"/>; accelerations are none of them, they follow from velocities"},
  {"keyframe key initial init initialcondition initialconditions initialstate state startstate", "", "the start is that of each body: <RigidBody position=\"…\" velocity=\"…\">"},
  {"camera light viewpoint", "", "the picture needs none; its direction is <record view=\"xz\">"},
  {"asset assets texture", "", "shapes stand inside of their bodies: <RigidBody><Sphere colour=\"…\"/></RigidBody>"},
  {"variable var define property constant xacro", "", "a number with a name is <parameter>"},
  {"import", "", "another file is taken in by <include>"},
  {"array for loop repeat pattern", "", "copies are made by <replicate>"},
  {"assert expect test", "", "an expected result is <check>"},
  {"library extension", "", "a library with further types is <plugin>"},
  {"description documentation comment note text title author", "", "text for people stands in <doc>"},
  {"default", "", "attributes that elements of a type take if they lack them stand in <defaults>, at an element of that type: <defaults><Sphere colour=\"red\"/></defaults>"},
});

constexpr auto kOtherAttributes = std::to_array<OtherWord>({
  // Contact.
  {"friction µ μ frictioncoefficient coefficientoffriction mu1 slidingfriction staticfriction lateralfriction mu2", "mu",
   "the coefficient of friction is {}", "friction belongs to the law of two materials, <UnilateralCoulomb mu=\"…\">, or is a law inside of a joint, <GivenFriction force=\"…\">"},
  {"mustatic mu0 mus mus2 frictionstatic frictioncoefficientstatic", "mu",
   "the coefficient of friction is {}; one that weakens while slipping is <UnilateralStribeck mu=\"…\" kineticMu=\"…\">"},
  {"restitution coefficientofrestitution restitutioncoefficient cor bounce bounciness elasticity e epsilon en restitutionn", "epsilonN",
   "the coefficient of restitution is {}", "restitution belongs to a law: of two materials <UnilateralCoulomb epsilonN=\"…\">, of a stop <Unilateral epsilonN=\"…\"/> inside of it"},
  {"et restitutiont tangentialrestitution", "epsilonT", "the tangential coefficient of restitution is {}"},
  {"kineticfriction dynamicfriction slidingfriction muk mud frictiondynamic mudynamic mukinetic muslip", "kineticMu kineticForce",
   "friction while slipping is {}", "friction that weakens while slipping is <UnilateralStribeck mu=\"…\" kineticMu=\"…\">"},
  {"frictionloss jointfriction dryfriction", "force", "the friction is {}", "the friction of a joint is a law inside of it: <GivenFriction force=\"…\">"},
  {"condim", "", "", "the directions of a contact are those of its law: <Unilateral>, <UnilateralCoulomb>, with resistance to rolling and drilling <UnilateralRolling>"},
  {"collisiongroup collisionmask collisionfilter collisionfiltergroup", "", "", "materials say what touches what: <Contact between=\"A B\">, <NoContact between=\"A B\">"},
  {"rollingfriction", "rolling", "resistance to rolling is {}, an arm in m", "resistance to rolling is <UnilateralRolling rolling=\"…\">"},
  {"spinningfriction torsionalfriction", "drilling", "friction about the normal is {}, an arm in m", "friction about the normal is <UnilateralRolling drilling=\"…\">"},
  // Place and axes.
  {"x y z offset", "position", "the place is {}, three numbers"},
  {"offset spacing pitch", "", "", "copies of <replicate> have places by their index: <RigidBody position=\"{0.2*i} 0 0\">"},
  {"pos translation origin location place xyz center centre coordinates r0", "position at point", "the place is {}"},
  {"anchor pivot jointorigin attachment point position", "at pointA", "the place of a joint is {}, in the world at the start"},
  {"anchor pivot jointorigin attachment", "point", "the place of a joint is {}"},
  {"pivotina pivotinb pivota pivotb pointa pointb anchora anchorb frame1point frame2point localanchora localanchorb", "at",
   "a joint has one place for both bodies, in the world at the start: {}"},
  {"armature rotorinertia reflectedinertia", "rotor", "the inertia of a rotor is {}"},
  {"joint jointname", "between", "what it acts on are the two bodies of the joint, and its axis and place: between=\"A B\" axis=\"…\" at=\"…\""},
  {"quaternion quat rotationquaternion orient orientationquaternion", "orientation", "the quaternion w x y z is {}"},
  {"rpy eulerangles rotationangles rollpitchyaw axisangle angles roll pitch yaw", "euler", "angles about the fixed axes x, then y, then z are {}"},
  {"rotation", "orientation", "a rotation is a quaternion {}, or angles euler=\"…\""},
  // Motion.
  {"vel linearvelocity v v0 initialvelocity linvel speed", "velocity", "the velocity is {}"},
  {"omega angvel angularrate w w0 angularspeed spin initialangularvelocity angularvel", "angularVelocity", "the angular velocity is {}"},
  // Mass.
  {"m weight bodymass", "mass", "the mass is {}"},
  {"inertia momentofinertia inertiatensor moment ixx iyy izz diaginertia fullinertia momentsofinertia inertiaxx j jxx jyy jzz ixy ixz iyz jxy jxz jyz", "inertia", "moments of inertia are {}, Jxx Jyy Jzz [Jxy Jxz Jyz]",
   "moments of inertia stand at the body, <RigidBody mass=\"…\" inertia=\"…\">; those of a shape follow from its mass or density"},
  {"rho", "density", "the density is {}"},
  {"com cog centerofmass centreofmass masscenter", "", "", "where mass and inertia are given, position=\"…\" is the centre of mass; else it follows from the shapes inside of the body"},
  // Sizes.
  {"diameter", "radius", "half of the diameter is {}"},
  {"r size", "radius", "the radius is {}"},
  {"halfextents halfsize halflengths halfwidths", "size semiAxes", "the size is {}, whole edges and not half ones"},
  {"extents dimensions dims edges lengths sides scale", "size semiAxes", "the size is {}"},
  {"width depth lx ly lz xlength ylength zlength dx dy dz", "size", "the three edges stand in one attribute: {}"},
  {"radii semiaxis", "semiAxes", "half of the lengths are {}"},
  {"height h l", "length", "the length is {}"},
  {"height h l", "size", "the three edges stand in one attribute: {}"},
  {"halflength halfheight", "length", "the length is {}, the whole and not the half"},
  {"vertices verts corners nodes", "points", "the points are {}"},
  {"faces indices", "triangles", "the numbers of the corners are {}"},
  // Springs.
  {"k springconstant springrate springstiffness stiffnesscoefficient kp", "stiffness", "the stiffness is {}"},
  {"stiffness damping compliance kn contactstiffness contactdamping solref solimp erp cfm", "", "",
   "contacts and joints are rigid and need none; a spring or a damper is <SpringDamper stiffness=\"…\" damping=\"…\">, at a joint <JointSpring between=\"A B\" axis=\"…\" stiffness=\"0\" damping=\"…\">, both in <forces>, the drag of a fluid <Drag>"},
  {"lineardamping angulardamping airdrag", "", "", "the drag of a fluid is <Drag>"},
  {"youngsmodulus youngmodulus elasticmodulus poissonratio poissonsratio shearmodulus", "", "", "bodies and contacts are rigid and need none"},
  {"d b dampingcoefficient dampingconstant damper viscousdamping kv kd dampingrate", "damping", "the damping is {}"},
  {"c", "stiffness", "the stiffness is {}, the damping damping=\"…\""},
  {"restlength freelength naturallength springlength l0 restlen", "length", "the length without force is {}"},
  {"springreference springref restangle qspring reference0", "rest angle", "the place without force is {}"},
  {"g gravity gravityvector", "acceleration", "the acceleration of free fall is {}, three numbers", "gravity is an element: <Gravity acceleration=\"0 0 -9.81\"/>"},
  {"direction", "axis", "the direction of a joint or of a force is {}"},
  {"value vector direction field", "acceleration", "the acceleration is {}, three numbers"},
  // Joints.
  {"parent child body1 body2 bodya bodyb link1 link2 a b base follower bodies frames links materials material1 material2 joins objects connects shafts", "between", "both sides stand in one attribute: between=\"A B\""},
  {"frame coordinates expressedin", "axes", "axes of the frame instead of the world's are {}", "places and axes are those in the world at the start"},
  {"body link system frame target", "on", "what it acts on is {}"},
  {"range limits lowerlimit minangle", "lower", "the limits are lower=\"…\" and upper=\"…\"", "the limits of a joint are an element beside it, with the same between, axis and at: <JointStop lower=\"…\" upper=\"…\">, of a slider with coordinate=\"displacement\""},
  {"upperlimit maxangle", "upper", "the upper limit is {}", "the limits of a joint are an element beside it, with the same between, axis and at: <JointStop lower=\"…\" upper=\"…\">, of a slider with coordinate=\"displacement\""},
  {"maxforce maxtorque effort forcelimit ctrlrange forcerange max", "limit", "the largest force or moment is {}", "the largest force or moment is that of a motor: <JointMotor limit=\"…\">"},
  {"min max lower upper", "axis", "the limits of a joint are an element beside it, with the same between, axis and at: <JointStop lower=\"…\" upper=\"…\">, of a slider with coordinate=\"displacement\""},
  {"setpoint desired targetposition", "target", "the target is {}"},
  {"velocity targetvelocity targetspeed rpm", "speed", "the speed is {}"},
  {"torque tau couple", "moment", "the moment is {}"},
  {"moment torque tau", "force", "a force or moment along the coordinate is {}", "a given moment in a joint is <JointForce force=\"…\">"},
  {"initialposition initialangle qpos", "q0", "the start is {}", "a joint begins where its bodies stand: their position=\"…\" and euler=\"…\""},
  {"jointtype", "", "", "the kind of a joint is the name of its element: <Revolute>, <Prismatic>, <Spherical>, <Fixed>, …"},
  // Simulation.
  {"dt timestep h stepsize maxstep fixedstep samplingtime deltat maxstepsize", "step", "the length of a step is {}"},
  {"steps numsteps nsteps stepcount substeps", "step", "the length of a step is {}, and not their number"},
  {"duration tend endtime stoptime tfinal finaltime simtime simulationtime time t t1 end stop", "until", "the end time is {}"},
  {"tol reltol rtol abstol atol accuracy precision targetaccuracy", "tolerance", "the accuracy is {}"},
  {"iterations maxiter maxit maxiters iter niter solveriterations numsolveriterations itermax", "maxIterations maxNewton", "the most iterations are {}",
   "iterations belong to a solver: <simulation><ProxGaussSeidel maxIterations=\"…\"/></simulation>"},
  {"omegasor relaxation sorparam", "factor", "the factor of the projection is {}"},
  {"integrator solver scheme method", "", "", "scheme and solver are elements: <simulation><MoreauMidpoint/><ProxGaussSeidel/></simulation>"},
  {"fps framerate", "frames", "pictures per second are {}", "pictures per second are <record frames=\"60\">"},
  {"starttime tstart begintime", "", "", "a run begins at t = 0"},
  {"plotstepsize outputstep outputdt dt timestep deltat", "every", "the sample time is {}", "the sample time of what is recorded is <record every=\"…\">"},
  {"interval samplerate sampletime rate frequency outputinterval", "every", "the sample time is {}, a time such as 10ms"},
  {"equals expected equal reference", "value", "the expected value is {}"},
  // What is no attribute.
  {"fromto from to start", "position", "the shape lies about {}, along z; length=\"…\" and euler=\"…\" say the rest"},
  {"plane", "", "", "a body in a plane is <PlanarBody>"},
  {"fixed static kinematic isstatic mobility ikinematic bodyfixed immovable", "", "", "what stands still is <Ground>"},
  {"type", "", "", "the kind of an element is its name, such as <RigidBody>, <Revolute> or <Sphere>"},
  {"collide collidable collision collisions collisionenabled enablecollision contype conaffinity contact", "", "", "a shape with a material takes part in contact, one without touches nothing"},
  {"dof dofs freedom", "", "", "a <RigidBody> has six degrees of freedom, a <PlanarBody> three; joints remove some"},
  // Names.
  {"id label tag", "name", "the name is {}"},
  {"color colour rgba colorrgba diffuse", "colour", "the colour is {}, a name of CSS or #rrggbb", "a colour belongs to a shape: <Sphere colour=\"…\">"},
  {"material surface", "material", "the material is {}", "a material belongs to a shape: <Sphere material=\"…\">"},
  {"name file filename path url uri src", "library", "the library is {}; plug-ins of other programs do not run here"},
  {"file filename path url uri src href", "file", "the file is {}",
   "files of shapes are read by <Mesh file=\"…\"> and, as their hull, by <Polyhedron file=\"…\">"},
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
  {"slug slugs", "", "1slug is 14.593903kg"},
  {"lbf", "", "1lbf is 4.4482216N"},
  {"kgf kp", "", "1kgf is 9.80665N"},
  {"yd yard yards", "", "1yd is 0.9144m"},
  {"mi mile miles", "", "1mi is 1.609344km"},
  {"mph", "", "1mph is 0.44704m/s"},
  {"knot knots", "", "1knot is 1.852km/h"},
  {"psi", "", "1psi is 6.8947573kPa"},
  {"hp", "", "1hp is 0.74569987kW"},
  {"bar", "", "1bar is 100kPa"},
  {"rev turn turns", "", "a turn is 360deg"},
  {"rps", "", "a turn in a second is 60rpm"},
});

constexpr auto kOtherFunctions = std::to_array<OtherWord>({
  {"if ifelse iif ite where piecewise switch", "condition ? a : b", ""},
  {"ln loge", "log", ""},
  {"lg", "log10", ""},
  {"fabs", "abs", ""},
  {"sgn signum", "sign", ""},
  {"arcsin", "asin", ""},
  {"arccos", "acos", ""},
  {"arctan", "atan", ""},
  {"arctan2 atan2d", "atan2", ""},
  {"power", "pow", ""},
  {"sqr square", "x^2", ""},
  {"cbrt", "x^(1/3)", ""},
  {"fmod rem remainder modulo", "mod", ""},
  {"heaviside unitstep", "step", ""},
  {"haversin step5 smoothramp ramp", "smoothstep", ""},
  {"limit limiter saturate saturation sat clip bound", "clamp", ""},
  {"minimum amin", "min", ""},
  {"maximum amax", "max", ""},
  {"round rint nint", "floor(x + 0.5)", ""},
  {"trunc fix int", "floor", ""},
  {"ceiling", "ceil", ""},
  {"norm length magnitude", "hypot", ""},
  {"radians deg2rad degtorad", "30deg", ""},
});
/// Last parts of signals.
constexpr auto kOtherSignals = std::to_array<OtherWord>({
  {"force reaction reactionforce contactforce f", "lambda_N lambda_T1 lambda", ""},
  {"torque moment", "lambda", ""},
  {"n fn normalforce", "lambda_N", ""},
  {"ft frictionforce friction", "lambda_T1", ""},
  {"impulse percussion", "Lambda_N Lambda_T1", ""},
  {"gap distance penetration depth", "g", ""},
  {"energy ke kinetic kineticenergy", "kineticEnergy", ""},
  {"xdot dx velocityx velx xvel", "vx", ""},
  {"ydot dy velocityy vely yvel", "vy", ""},
  {"zdot dz velocityz velz zvel", "vz", ""},
  {"velocity vel speed", "rate", ""},
  {"wx omegax angularvelocityx angvelx", "Omega_x", ""},
  {"wy omegay angularvelocityy angvely", "Omega_y", ""},
  {"wz omegaz angularvelocityz angvelz", "Omega_z omega", ""},
  {"omega angularvelocity", "omega phi_dot rate", ""},
  {"q theta rotation phi", "angle phi", ""},
  {"qdot thetadot phidot angularspeed", "rate phi_dot", ""},
});
// clang-format on

bool isCapital(char c) { return c >= 'A' && c <= 'Z'; }

/// The word in lower case, without "_", "-" and ":".
std::string plainWord(std::string_view word) {
  std::string out;
  for (const char c : word)
    if (c != '_' && c != '-' && c != ':')
      out += isCapital(c) ? static_cast<char>(c - 'A' + 'a') : c;
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
std::span<const OtherWord> otherFunctions() { return kOtherFunctions; }

std::string elementOfOthers(std::string_view word) {
  const auto found = rowsWith(kOtherElements, word);
  return found.empty() ? std::string() : inDynamy(found.front()->hint);
}

std::string elementByLastWord(std::string_view word) {
  for (std::size_t at = 1; at < word.size(); ++at) {
    const bool begins = (isCapital(word[at]) && !isCapital(word[at - 1])) || word[at - 1] == '_';
    if (!begins) continue;
    if (std::string hint = elementOfOthers(word.substr(at)); !hint.empty()) return hint;
  }
  return {};
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

std::string signalOfOthers(std::string_view name, std::span<const std::string> known) {
  const std::size_t dot = name.rfind('.');
  if (dot == std::string_view::npos) return {};
  for (const OtherWord* row : rowsWith(kOtherSignals, name.substr(dot + 1)))
    for (const std::string_view ours : wordsOfRow(row->ours)) {
      std::string meant = std::string(name.substr(0, dot + 1)) + std::string(ours);
      if (std::find(known.begin(), known.end(), meant) != known.end()) return meant;
    }
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

std::string functionOfOthers(std::string_view word) {
  const auto found = rowsWith(kOtherFunctions, word);
  return found.empty() ? std::string() : std::string(found.front()->ours);
}

std::string unitInOurs(std::string_view word) {
  const auto found = rowsWith(kOtherUnits, word);
  return found.empty() ? std::string() : std::string(found.front()->hint);
}

std::string amountInOurs(std::string_view word) {
  constexpr std::string_view kIs = " is ";
  const std::string hint = unitInOurs(word);
  const std::size_t is = hint.find(kIs);
  return is == std::string::npos ? std::string() : hint.substr(is + kIs.size());
}

}  // namespace dynamy
