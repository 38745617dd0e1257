/// dynamy import FILE: a model of the machine that a file of another program describes.
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cmath>

#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/io/files/output_file.hpp>
#include <dynamy/io/mesh/mesh_file.hpp>
#include <filesystem>
#include <memory>

#include "import/mesh_reader.hpp"
#include "import/mjcf_reader.hpp"
#include "import/model_text.hpp"
#include "import/sdf_reader.hpp"
#include "import/simplify.hpp"
#include "import/urdf_reader.hpp"
#include "paths.hpp"
#include "program.hpp"

namespace dynamy::app {
namespace {

struct ImportChoice {
  std::string file, out;
  std::vector<std::string> at;
  ImportOptions options;
  bool quiet = false;
};

Machine readMachine(const std::string& file, const ImportOptions& options) {
  if (isMeshFile(file)) return readMeshBody(file, options);
  const XmlDocument document = XmlDocument::read(file);
  const XmlNode& root = document.root();
  if (!options.key.empty() && root.tag != "mujoco")
    throw CLI::ValidationError("--key: only files of MJCF have keyframes");
  if (root.tag == "robot") return readUrdf(document, options);
  if (root.tag == "mujoco") return readMjcf(document, options);
  if (root.tag == "sdf") return readSdf(document, options);
  throw ModelError(
      document.diagnostic(root.place, root, "is no machine that can be imported",
                          "<robot> begins a file of URDF, <mujoco> of MJCF, <sdf> of SDF; "
                          "meshes end with .stl, .obj, .ply or .dae"));
}

/// Options that say nothing about the file are errors, as a wrong value is.
void refuseOthers(const CLI::App& command, bool mesh) {
  for (const char* option : {"--density", "--scale"})
    if (!mesh && command.count(option) > 0)
      throw CLI::ValidationError(option,
                                 "is for files of meshes, which end with .stl, .obj, .ply or .dae");
  for (const char* option :
       {"--at", "--free-base", "--self-contact", "--drives", "--key", "--package"})
    if (mesh && command.count(option) > 0)
      throw CLI::ValidationError(option, "is for machines: a mesh is one body");
}

void requireWithinLimits(const MachineJoint& joint, const std::string& assignment) {
  const double low = joint.lower.value_or(-HUGE_VAL), high = joint.upper.value_or(HUGE_VAL);
  if (low <= joint.start && joint.start <= high) return;
  throw CLI::ValidationError(fmt::format("--at {}: beyond the limits of the joint, {} to {} {}",
                                         assignment, joint.lower ? numberText(low) : "-inf",
                                         joint.upper ? numberText(high) : "inf",
                                         joint.kind == MachineJoint::Kind::slide ? "m" : "rad"));
}

/// Joints start at other values than those of the file's pose.
void startAt(Machine& machine, const std::vector<std::string>& values) {
  for (const std::string& text : values) {
    const auto [name, value] = numberAssignment("--at", text);
    bool found = false;
    std::vector<std::string> known;
    for (Link& link : machine.links)
      for (MachineJoint& joint : link.joints) {
        known.push_back(joint.name);
        if (joint.name != name) continue;
        joint.start = std::stod(value), found = true;
        requireWithinLimits(joint, text);
        std::erase_if(machine.notes, [&](const ImportNote& n) {
          return n.element == "joint " + name && n.text.starts_with("its limits exclude");
        });
      }
    if (found) continue;
    const std::string hint = unknownNameHint(name, known);
    throw CLI::ValidationError("--at: there is no joint \"" + name + '"' +
                               (known.empty() ? "; the machine has none" : " — " + hint));
  }
}

int import(const ImportChoice& choice) {
  for (const std::string& folder : choice.options.packages)
    if (!std::filesystem::is_directory(folder))
      throw CLI::ValidationError("--package", folder + ": there is no such folder");
  requireOtherFile(choice.out, choice.file);
  Machine machine = readMachine(choice.file, choice.options);
  simplify(machine);
  startAt(machine, choice.at);
  const std::string source = std::filesystem::path(choice.file).filename().string();
  const std::string text =
      modelText(machine, source, std::filesystem::path(choice.out).parent_path());
  if (choice.out.empty()) {
    fmt::print("{}", text);
  } else {
    writeWholeFile(choice.out, text);
  }
  if (choice.quiet) return kOk;
  for (const ImportNote& note : machine.notes) fmt::print(stderr, "{}\n", noteText(note));
  if (choice.out.empty()) return kOk;
  std::size_t joints = 0;
  for (const Link& link : machine.links) joints += link.joints.size();
  const auto counted = [](std::size_t n, const char* what) {
    return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s");
  };
  fmt::print("wrote {}: {}, {}, {}\n", choice.out, counted(machine.links.size(), "link"),
             counted(joints, "joint"), counted(machine.notes.size(), "note"));
  return kOk;
}

}  // namespace

void addImport(CLI::App& app, Program& program) {
  auto choice = std::make_shared<ImportChoice>();
  CLI::App* c = app.add_subcommand(
      "import", "a model of the machine in a file of URDF, MJCF or SDF, or of a mesh");
  c->add_option("FILE", choice->file,
                "file of URDF, MJCF or SDF; a closed mesh of STL, OBJ, PLY or DAE")
      ->required()
      ->check(someName());
  c->add_option("-o,--out", choice->out, "model file to write; default: print it")
      ->check(someName());
  c->add_option("--at", choice->at, "value of a joint at the start [rad or m]")
      ->type_name("JOINT=VALUE");
  c->add_flag("--free-base", choice->options.freeBase,
              "URDF: the root link moves freely; else it stands still");
  c->add_flag("--self-contact", choice->options.selfContact,
              "URDF: links that are no neighbours can touch each other");
  c->add_flag("--drives", choice->options.drives,
              "URDF: each joint gets an <Input>, the force or moment of its drive");
  c->add_option("--key", choice->options.key, "MJCF: the keyframe that the model starts from")
      ->type_name("NAME");
  c->add_option("--package", choice->options.packages,
                "folder that holds packages, for package:// paths")
      ->type_name("FOLDER");
  c->add_option("--density", choice->options.density, "mesh: density of the body [kg/m^3]")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  c->add_option("--scale", choice->options.scale,
                "mesh: metres of a unit of the file; 0.001 for mm")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  c->add_option("--pieces", choice->options.pieces,
                "most convex pieces by which a mesh touches; default: 32 of a mesh file, else its "
                "hull, which is one")
      ->check(CLI::Range(1, 200));
  c->add_flag("--quiet", choice->quiet, "do not list what has no equivalent");
  c->callback([choice, c, &program] {
    refuseOthers(*c, isMeshFile(choice->file));
    program.exitCode = import(*choice);
  });
}

}  // namespace dynamy::app
