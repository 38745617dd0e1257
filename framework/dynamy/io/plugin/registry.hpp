/// Registry: maps type names to declarations and constructors. `elements` and users' plug-ins
/// register through the same calls.
#pragma once
#include <concepts>
#include <dynamy/core/declared/parameters.hpp>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace dynamy {

class Model;

/// One registered type.
struct RegisteredType {
  std::string name;
  Kind kind = Kind::part;
  std::string library;  ///< plug-in that registered it; "dynamy": the framework
  Attributes attributes;
  std::function<std::unique_ptr<Element>(const Parameters&)> make;
};

class Registry {
 public:
  /// Registers T under `name` (the XML tag). T has `static void declare(Attributes&)`, a
  /// constructor from `const Parameters&` and, through its base, `kKind`. If a base has
  /// `declareCommon(Attributes&)`, that is called first.
  template <class T>
  void add(std::string name) {
    Attributes a;
    if constexpr (requires { T::declareCommon(a); }) T::declareCommon(a);
    T::declare(a);
    add({std::move(name), T::kKind, library_, std::move(a),
         [](const Parameters& x) -> std::unique_ptr<Element> { return std::make_unique<T>(x); }});
  }
  /// Throws ModelError naming both libraries if the name is taken.
  void add(RegisteredType type);
  /// Model::Completion, without the header of models, which few plug-ins need.
  using Completion = std::function<void(Model&)>;
  /// Adds a completion that every Model::build() calls at its beginning.
  void addCompletion(Completion completion) { completions_.push_back(std::move(completion)); }

  const RegisteredType* find(std::string_view name) const;
  /// All types, ordered by kind and name.
  std::vector<const RegisteredType*> types() const;
  const std::vector<Completion>& completions() const { return completions_; }
  /// Sets the name of the library whose registration follows.
  void library(std::string name) { library_ = std::move(name); }

 private:
  std::map<std::string, RegisteredType, std::less<>> types_;
  std::vector<Completion> completions_;
  std::string library_ = "dynamy";
};

/// The framework's own schemes, solvers and impact laws.
void registerFramework(Registry& registry);

}  // namespace dynamy
