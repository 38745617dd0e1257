/// Evaluates the `<parameter>`s of one file; each may use the others, in any order.
#pragma once
#include <dynamy/io/model_scope.hpp>
#include <dynamy/io/vocabulary.hpp>
#include <functional>

namespace dynamy {

class ParameterEvaluator {
 public:
  /// A value that replaces what the file says.
  struct Replacement {
    std::string name;
    double value = 0.0;
    std::function<void(std::string fault)> report;  ///< if it does not fit min and max
  };

  ParameterEvaluator(Scope& scope, const Word& word, Faults& faults)
      : scope_(&scope), word_(&word), faults_(&faults) {}
  /// Takes a `<parameter>`; reports a name that is given twice.
  void add(const XmlNode& node);
  void replace(Replacement replacement) { replacements_.push_back(std::move(replacement)); }
  /// Evaluates all into scope.symbols; wrong ones into scope.broken.
  void evaluate();
  std::vector<std::string> names() const;

 private:
  enum class Progress { waiting, running, done };
  struct Item {
    std::string name;
    const XmlNode* node;
    Progress progress = Progress::waiting;
  };
  void evaluate(Item& item);
  bool dependenciesReady(Item& item);
  Item* find(const std::string& name);

  Scope* scope_;
  const Word* word_;
  Faults* faults_;
  std::vector<Item> items_;
  std::vector<Replacement> replacements_;
};

}  // namespace dynamy
