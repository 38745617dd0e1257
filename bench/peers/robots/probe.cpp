/// Mass matrix and poses of a model with given values of its joints, for comparison with other programs.
///
///   bench_machine MODEL "JOINT ..." "BODY ..." < VALUES
///
/// A line of VALUES holds pairs of a joint and its value against the model's start. For each line one
/// line of JSON: {"index": {joint: row of M}, "nu": n, "M": n·n numbers, "bodies": {body: [x y z, qw
/// qx qy qz]}}. The coordinate of a joint is the one that changes its signal by the same amount.
#include <cmath>
#include <cstdio>
#include <dynamy/core/error.hpp>
#include <dynamy/io/model/model_loader.hpp>
#include <dynamy/io/plugin/plugin_loader.hpp>
#include <dynamy/io/plugin/registry.hpp>
#include <dynamy/simulation/model/model.hpp>
#include <dynamy/stages/mechanical_system.hpp>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace {

using namespace dynamy;

/// Row of the coordinate in q and in u.
struct Coordinate {
  int q = 0, u = 0;
};

class Machine {
 public:
  explicit Machine(Model& model) : model_(model), state_(model.initialState()), start_(state_) {}
  void reset() { state_ = start_; }
  void set(int q, double value) { state_.q[q] = value; }
  double startOf(int q) const { return start_.q[q]; }
  void evaluate() {
    kinematics_.evaluate(model_.topology(), 0.0, view(std::as_const(state_.q)),
                         view(std::as_const(state_.u)), view(std::as_const(state_.memory)));
  }
  double signal(const std::string& name) const;
  bool find(const std::string& joint, Coordinate& out);
  Eigen::MatrixXd M() const;

 private:
  Model& model_;
  State state_, start_;
  Kinematics kinematics_;
};

double Machine::signal(const std::string& name) const {
  const NamedSignal* found = model_.signal(name);
  if (found == nullptr) return NAN;
  SignalView v;
  if (found->system >= 0) {
    const SystemHandle& h = model_.topology().system(found->system);
    new (&v.q) ConstVec(state_.q.data() + h.q0, h.nq);
    new (&v.u) ConstVec(state_.u.data() + h.u0, h.nu);
  }
  v.kinematics = &kinematics_;
  new (&v.memory) ConstVec(state_.memory.data() + found->memory0, found->memory);
  v.element = found->contact;
  return found->signal.value(v);
}

bool Machine::find(const std::string& joint, Coordinate& out) {
  const std::string angle = joint + ".angle";
  const std::string name = model_.signal(angle) != nullptr ? angle : joint + ".displacement";
  reset();
  evaluate();
  const double before = signal(name);
  for (std::size_t s = 0; s < model_.systems().size(); ++s) {
    const SystemHandle& h = model_.topology().system(static_cast<int>(s));
    // A free base has three slides and a ball, whose four numbers are followed by those of joints.
    const bool ball = h.nq != h.nu;
    for (int i = 0; i < h.nu; ++i) {
      if (ball && i >= 3 && i < 6) continue;
      const int q = h.q0 + i + (ball && i >= 6 ? 1 : 0);
      reset();
      set(q, startOf(q) + 0.1);
      evaluate();
      if (std::abs(signal(name) - before - 0.1) < 1e-9) {
        out = {q, h.u0 + i};
        return true;
      }
    }
  }
  return false;
}

Eigen::MatrixXd Machine::M() const {
  const int n = model_.topology().nu();
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(n, n);
  for (std::size_t s = 0; s < model_.systems().size(); ++s) {
    const SystemHandle& h = model_.topology().system(static_cast<int>(s));
    if (h.nu == 0) continue;
    RowMatrix block = RowMatrix::Zero(h.nu, h.nu);
    model_.systems()[s]->M(0.0, ConstVec(state_.q.data() + h.q0, h.nq), {block.data(), h.nu, 1});
    all.block(h.u0, h.u0, h.nu, h.nu) = block;
  }
  return all;
}

std::vector<std::string> words(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> out;
  for (std::string word; in >> word;) out.push_back(word);
  return out;
}

void print(const Machine& machine, const std::map<std::string, Coordinate>& joints,
           const std::vector<std::string>& bodies) {
  const char* comma = "";
  std::printf("{\"index\":{");
  for (const auto& [name, coordinate] : joints) {
    std::printf("%s\"%s\":%d", comma, name.c_str(), coordinate.u);
    comma = ",";
  }
  const Eigen::MatrixXd M = machine.M();
  std::printf("},\"nu\":%d,\"M\":[", static_cast<int>(M.rows()));
  for (Eigen::Index i = 0; i < M.size(); ++i)
    std::printf("%s%.17g", i > 0 ? "," : "", M(i / M.cols(), i % M.cols()));
  std::printf("],\"bodies\":{");
  comma = "";
  for (const std::string& body : bodies) {
    std::printf("%s\"%s\":[", comma, body.c_str());
    comma = ",";
    const char* inner = "";
    for (const char* part : {".x", ".y", ".z", ".qw", ".qx", ".qy", ".qz"}) {
      std::printf("%s%.17g", inner, machine.signal(body + part));
      inner = ",";
    }
    std::printf("]");
  }
  std::printf("}}\n");
}

int probe(const std::string& file, const std::string& jointNames, const std::string& bodyNames) {
  Registry registry;
  PluginLoader loader;
  registerFramework(registry);
  loader.load("dynamy_elements", registry);
  Model model = loadModel(file, registry, loader);
  Machine machine(model);
  std::map<std::string, Coordinate> joints;
  for (const std::string& name : words(jointNames))
    if (!machine.find(name, joints[name])) {
      std::cerr << "no coordinate of " << name << '\n';
      return 1;
    }
  for (std::string line; std::getline(std::cin, line);) {
    std::istringstream in(line);
    std::string name;
    machine.reset();
    for (double value = 0.0; in >> name >> value;) machine.set(joints.at(name).q, value);
    machine.evaluate();
    print(machine, joints, words(bodyNames));
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::cerr << "bench_machine MODEL \"JOINT ...\" \"BODY ...\" < VALUES\n";
    return 2;
  }
  try {
    return probe(argv[1], argv[2], argv[3]);
  } catch (const dynamy::ModelError& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
