#include <dynamy/io/xml/vocabulary.hpp>

namespace dynamy {
namespace {

Word word(std::string name, std::string about, std::vector<std::string> children = {},
          std::vector<Kind> kinds = {}) {
  Word w;
  w.name = std::move(name);
  w.attributes.about(std::move(about));
  w.children = std::move(children);
  w.kinds = std::move(kinds);
  return w;
}

Word parameter() {
  Word w = word("parameter",
                "A number with a name, for {expressions}; replaced by --set name=value.", {"doc"});
  w.attributes.add(AttributeType::name, "name", std::nullopt, "name in expressions");
  w.attributes.required("value", Unit::any, "value; may use other parameters");
  w.attributes.required("min", Unit::any, "smallest value that is allowed").mayBeAbsent();
  w.attributes.required("max", Unit::any, "largest value that is allowed").mayBeAbsent();
  w.attributes.example("<parameter name=\"e\" value=\"0.8\" min=\"0\" max=\"0.999\"/>");
  return w;
}

Word simulation() {
  Word w = word("simulation", "How long and how accurately; the expert also says with what.",
                {"doc"}, {Kind::scheme, Kind::solver, Kind::impact});
  Attributes& a = w.attributes;
  a.optional("until", Unit::time, 1.0, "end time").positive();
  a.required(
       "step", Unit::time,
       "length of a step; one that is too long for the motion is divided, if no scheme is named")
      .positive()
      .mayBeAbsent();
  a.required("tolerance", Unit::none, "wanted accuracy; the program chooses the steps")
      .positive()
      .mayBeAbsent();
  a.required("gTol", Unit::length, "a contact is closed at g <= gTol; default: 1e-12 of the scene")
      .nonNegative()
      .mayBeAbsent();
  a.required("sleep", Unit::velocity,
             "bodies slower than this, at rest by their own forces, sleep until something touches "
             "them; with fixed steps; default: 0, none sleeps")
      .nonNegative()
      .mayBeAbsent();
  a.choice("onNonConvergence", {"stop", "warn", "retry"}, "warn",
           "what happens if a step's impulses are not found");
  a.choice("project", {"none", "positions", "both"}, "none",
           "after a step of any scheme: positions, or velocities as well, are brought back to "
           "joints and contacts in the metric of the mass");
  a.choice(
      "coordinates", {"auto", "absolute", "minimal"}, "auto",
      "of bodies with joints: absolute, joints are constraints; minimal, those of the joints of a "
      "spanning tree, only joints that close loops are constraints; auto, minimal in runs to a "
      "tolerance wherever nothing speaks against it and for small mechanisms in steps of a fixed "
      "length, and bodies that move in a plane are computed there, which dynamy check tells");
  a.choice(
      "start", {"given", "equilibrium"}, "given",
      "given: as the systems say; equilibrium: the rest, or the steady motion, nearest to that");
  a.add(AttributeType::names, "keep", "",
        "systems, velocities (crank.omega) or coordinates that stay as given where the start is "
        "brought onto the joints; all others take what the joints demand");
  a.child(Kind::scheme, 0, 1, "scheme of time stepping");
  a.child(Kind::solver, 0, 1, "solver of the inclusion problem");
  a.child(Kind::impact, 0, 1, "impact law");
  a.example("<simulation until=\"5\" step=\"1e-3\"><EnergyMomentum/></simulation>");
  return w;
}

Word record() {
  Word w = word("record", "Which signals and pictures are kept.", {"doc"});
  Attributes& a = w.attributes;
  a.add(AttributeType::names, "signals", "",
        "names such as ball.z; ball.* are all of ball, * are all; default: those of systems that "
        "move");
  a.required("every", Unit::time, "sample time; default: 1000 samples").positive().mayBeAbsent();
  a.requiredVector("at", Unit::time, 0, "instants of rows; with `every`: of rows beside those")
      .mayBeAbsent();
  a.optional("frames", Unit::frequency, 60.0, "pictures of the replay per second").nonNegative();
  a.choice(
      "format", {"csv", "hdf5"}, "csv",
      "of the signals of a run that has ended: signals.csv, or signals.h5, compressed and with "
      "units, for long runs");
  a.choice("view", {"auto", "xy", "xz", "yz", "iso"}, "auto", "direction of view of the replay");
  a.add(AttributeType::names, "follow", "", "system or frame that the replay goes with");
  a.example("<record signals=\"ball.z ball.vz\" every=\"10ms\" frames=\"60Hz\"/>");
  return w;
}

Word check() {
  Word w = word("check", "What must come out: a measure of a signal lies in a band.", {"doc"});
  Attributes& a = w.attributes;
  a.add(AttributeType::text, "signal", std::nullopt,
        "name such as ball.z, or a figure of the run's report such as run.penetration");
  a.choice(
      "measure", {"value", "mean", "min", "max", "period", "count"}, "value",
      "what is taken of the signal; period: mean time between upward passes through the middle "
      "of its values; count: upward jumps of a signal that has only whole values, changes of "
      "sign of any other");
  a.required("at", Unit::time, "time of the value; default: the end").nonNegative().mayBeAbsent();
  a.requiredVector("over", Unit::time, 2, "from and to, inf: the end; default: the whole run")
      .mayBeAbsent()
      .choices = {"inf"};
  a.required("value", Unit::any, "expected value").mayBeAbsent();
  a.required("tolerance", Unit::any, "accepted difference").nonNegative().mayBeAbsent();
  a.requiredVector("between", Unit::any, 2, "accepted band; -inf or inf: no bound")
      .mayBeAbsent()
      .choices = {"inf", "-inf"};
  a.example("<check signal=\"ball.z\" measure=\"max\" over=\"1 5\" between=\"0.7 0.8\"/>");
  return w;
}

Word orbit() {
  Word w = word("orbit", "Where dynamy orbit cuts the periodic motion of the model.", {"doc"});
  Attributes& a = w.attributes;
  a.add(AttributeType::text, "signal", "",
        "name such as toy.phiM; it passes a value once a period");
  a.optional("value", Unit::any, 0.0, "this value");
  a.choice("direction", {"rising", "falling"}, "rising", "in which it passes the value");
  a.required("period", Unit::time, "of a forcing, in place of a signal").positive().mayBeAbsent();
  a.add(AttributeType::integer, "returns", "1", "passes, or periods of the forcing, in one orbit")
      .between(1, 1000);
  a.add(AttributeType::names, "mirror", "",
        "symmetry of a motion that repeats itself mirrored after half a period: signals of "
        "coordinates that change their signs, or are exchanged (left.x=right.x, left.x=-right.x)");
  a.example("<orbit signal=\"ball.vz\" value=\"0\" direction=\"falling\"/>");
  return w;
}

Word include() {
  Word w =
      word("include",
           "Takes over parameters, defaults, plug-ins, systems, forces and elements of another "
           "model; its simulation, record, check and orbit are its own.",
           {"doc", "set"});
  w.attributes.add(AttributeType::text, "file", std::nullopt, "path, counted from this file");
  w.attributes.add(AttributeType::name, "prefix", "", "its names become prefix/name");
  w.attributes.example(
      "<include file=\"hopper.xml\" prefix=\"hopper\"><set name=\"opening\" value=\"{12*r}\"/>"
      "</include>");
  return w;
}

Word replicate() {
  Word w =
      word("replicate",
           "Repeats its content; names get [0], [1], …; the index may stand in {expressions}. A "
           "name without index means the one of the same turn.",
           {"doc", "replicate", "include", "systems", "forces", "elements"},
           {Kind::system, Kind::force, Kind::contact, Kind::rule, Kind::observer, Kind::shape,
            Kind::part});
  w.attributes.add(AttributeType::integer, "count", std::nullopt, "number of turns")
      .between(0, kMostTurns);
  w.attributes.add(AttributeType::name, "index", "i", "name of the index in expressions");
  w.attributes.example(
      "<replicate count=\"3\"><RigidBody name=\"ball\" position=\"0 0 {0.3*i}\"><Sphere "
      "radius=\"0.1\" mass=\"1\"/></RigidBody></replicate>");
  return w;
}

}  // namespace

Vocabulary::Vocabulary() {
  Word root = word("dynamy", "A model.",
                   {"doc", "plugin", "parameter", "defaults", "systems", "forces", "elements",
                    "simulation", "record", "check", "orbit", "include", "replicate"});
  root.attributes.add(AttributeType::integer, "version", "1", "version of the file format");
  root.attributes.add(AttributeType::text, "title", "", "title of the replay; default: file name");
  root.attributes.example(
      "<dynamy version=\"1\" title=\"Free fall\">\n"
      "  <systems><RigidBody name=\"ball\"><Sphere radius=\"0.1\" "
      "mass=\"1\"/></RigidBody></systems>\n"
      "  <forces><Gravity/></forces>\n"
      "  <simulation until=\"1\" step=\"1e-3\"/>\n"
      "</dynamy>");
  words_.push_back(std::move(root));
  words_.push_back(word("doc", "Text for people."));
  words_.back().text = true;
  words_.back().attributes.example("<doc>A ball falls from 1 m.</doc>");
  words_.push_back(word("plugin", "A shared library with further types.", {"doc"}));
  words_.back().attributes.add(AttributeType::text, "library", std::nullopt, "name or path");
  words_.back().attributes.example("<plugin library=\"woodpecker\"/>");
  words_.push_back(parameter());
  words_.push_back(word("defaults", "Attributes that elements of a type take if they lack them."));
  words_.back().attributes.example(
      "<defaults><Sphere material=\"rubber\"/><Sphere class=\"heavy\" mass=\"5kg\"/></defaults>");
  words_.push_back(word("systems", "All that has coordinates or carries shapes.",
                        {"doc", "replicate"}, {Kind::system}));
  words_.back().attributes.example(
      "<systems><PointMass name=\"bob\" position=\"0 0 1\" mass=\"1\"/></systems>");
  words_.push_back(
      word("forces", "Gravity, springs, dampers, actuators.", {"doc", "replicate"}, {Kind::force}));
  words_.back().attributes.example("<forces><Gravity acceleration=\"0 0 -9.81\"/></forces>");
  words_.push_back(word("elements", "Contacts, joints, clutches, observers.", {"doc", "replicate"},
                        {Kind::contact, Kind::rule, Kind::observer}));
  words_.back().attributes.example(
      "<elements><Contact between=\"rubber concrete\"><UnilateralCoulomb mu=\"0.3\"/></Contact>"
      "</elements>");
  words_.push_back(simulation());
  words_.push_back(record());
  words_.push_back(check());
  words_.push_back(orbit());
  words_.push_back(include());
  words_.push_back(word("set", "Replaces a parameter of the included model."));
  words_.back().attributes.add(AttributeType::name, "name", std::nullopt, "parameter there");
  words_.back().attributes.required("value", Unit::any, "its value, with parameters of this file");
  words_.back().attributes.example(
      "<include file=\"hopper.xml\"><set name=\"opening\" value=\"0.12\"/></include>");
  words_.push_back(replicate());
}

const Word* Vocabulary::find(std::string_view name) const {
  for (const Word& w : words_)
    if (w.name == name) return &w;
  return nullptr;
}

std::string_view sectionOf(Kind kind) {
  switch (kind) {
    case Kind::system:
      return "systems";
    case Kind::force:
      return "forces";
    case Kind::contact:
    case Kind::rule:
    case Kind::observer:
      return "elements";
    case Kind::scheme:
    case Kind::solver:
    case Kind::impact:
      return "simulation";
    case Kind::law:
    case Kind::shape:
    case Kind::part:
      return "";
  }
  return "";
}

std::string kindWithArticle(Kind kind) {
  const std::string text(kindText(kind));
  const bool vowel = std::string_view("aeiou").find(text[0]) != std::string_view::npos;
  return (vowel ? "an " : "a ") + text;
}

}  // namespace dynamy
