#include "document.hpp"
#include <build_paths.hpp>

#include <fstream>
#include <stdexcept>

namespace dynamy {
namespace {

const std::string kMark = "<!-- test: ";
#ifdef DYNAMY_PYTHON
const std::string kPython = DYNAMY_PYTHON;
#else
const std::string kPython = "false";
#endif

/// A part of a model becomes a whole one.
std::string around(const std::string& section, const std::string& part) {
  const std::string bodies =
      "<systems><RigidBody name=\"b\"><Sphere radius=\"0.1\" mass=\"1\"/></RigidBody></systems>\n";
  const std::string simulation = part.find("<simulation") == std::string::npos
                                     ? "<simulation until=\"1\" step=\"1e-3\"/>\n"
                                     : "";
  const std::string body =
      section == "dynamy" ? part : "<" + section + ">\n" + part + "</" + section + ">\n";
  return "<dynamy version=\"1\">\n" + body + bodies + simulation + "</dynamy>\n";
}

std::string saved(const std::string& name, const std::string& text) {
  const std::size_t slash = name.rfind('/');
  const std::string folder = slash == std::string::npos ? "." : name.substr(0, slash);
  return "mkdir -p " + folder + "\ncat > " + name + " <<'END_OF_BLOCK'\n" + text + "END_OF_BLOCK\n";
}

/// The blocks of a page are one program; it runs up to each of them, if Python can.
std::string python(const MarkedBlock& block, const std::string& kind) {
  const std::string program = "page_" + kind + ".py";
  const std::string needed = kind == "module" ? "dynamy, numpy" : "numpy";
  return "cat >> " + program + " <<'END_OF_BLOCK'\n" + block.text + "END_OF_BLOCK\nif " + kPython +
         " -c 'import " + needed + "'; then\n  " + kPython + ' ' + program + "\nfi\n";
}

std::string commands(const MarkedBlock& block, const std::string& kind,
                     const std::string& argument) {
  if (kind == "shell" && argument.empty()) return block.text;
  if (kind == "shell") {
    const std::string code = argument.substr(argument.rfind(' ') + 1);
    return "ended=0\n( set -e\n" + block.text + ") || ended=$?\n[ $ended = " + code +
           " ] || { echo \"ended with $ended, expected " + code + "\"; exit 1; }\n";
  }
  if (kind == "build")
    return "pushd " + argument + " > /dev/null\n" + block.text + "popd > /dev/null\n";
  if (kind == "file") return saved(argument, block.text);
  if (kind == "run") return saved(argument, block.text) + "dynamy run " + argument + "\n";
  if (kind == "check") return saved(argument, block.text) + "dynamy check " + argument + "\n";
  if (kind == "inside")
    return saved("part.xml", around(argument, block.text)) + "dynamy check part.xml\n";
  if (kind == "python" || kind == "module") return python(block, kind);
  if (kind == "output") return "";
  throw std::runtime_error("unknown mark: " + block.mark);
}

}  // namespace

std::vector<MarkedBlock> markedBlocks(const std::string& file) {
  std::ifstream in(std::string(DYNAMY_SOURCE_DIR) + "/" + file);
  std::vector<MarkedBlock> all;
  std::string line;
  bool inside = false, wanted = false;
  for (int number = 1; std::getline(in, line); ++number) {
    if (line.starts_with("```")) {
      inside = !inside;
      if (!inside) wanted = false;
    } else if (inside && wanted) {
      all.back().text += line + "\n";
    } else if (line.starts_with(kMark)) {
      all.push_back({line.substr(kMark.size(), line.find(" -->") - kMark.size()), "", number});
      wanted = true;
    }
  }
  return all;
}

std::string scriptOf(const std::vector<MarkedBlock>& blocks, const std::string& file) {
  std::string script = "set -eo pipefail\n";
  for (const MarkedBlock& block : blocks) {
    const std::size_t space = block.mark.find(' ');
    const std::string kind = block.mark.substr(0, space);
    const std::string argument = space == std::string::npos ? "" : block.mark.substr(space + 1);
    script += "echo '== " + file + ":" + std::to_string(block.line) + "'\n" +
              commands(block, kind, argument);
  }
  return script;
}

}  // namespace dynamy
