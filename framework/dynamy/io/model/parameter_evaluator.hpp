/// Evaluates the `<parameter>`s of one file; each may use the others, in any order.
#pragma once
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/io/model/model_scope.hpp>
#include <dynamy/io/xml/vocabulary.hpp>
#include <functional>
#include <unordered_map>

namespace dynamy {

class ParameterEvaluator {
 public:
  /// A value that replaces the one in the file.
  struct Replacement {
    std::string name;
    double value = 0.0;
    std::function<void(std::string fault)> report;  ///< if it does not fit min and max
  };

  ParameterEvaluator(Scope& scope, const Word& word, Faults& faults)
      : scope_(&scope), word_(&word), faults_(&faults) {}
  /// Adds a `<parameter>`; reports a name that is given twice.
  void add(const XmlNode& node);
  void replace(Replacement replacement) {
    std::string name = replacement.name;
    replacements_.emplace(std::move(name), std::move(replacement));
  }
  /// Evaluates all parameters: numbers go to scope.numbers, names of faulty parameters to
  /// scope.broken.
  void evaluate();
  std::vector<std::string> names() const;
  bool has(const std::string& name) const { return index_.contains(name); }

 private:
  enum class Progress { waiting, running, done };
  struct Item {
    std::string name;
    const XmlNode* node;
    Progress progress = Progress::waiting;
  };
  /// An item that waits for the items it uses.
  struct Pending {
    std::size_t item;
    std::vector<std::pair<std::size_t, const XmlAttribute*>> uses;
    std::size_t next = 0;
    bool good = true;
  };
  Pending start(std::size_t item);
  void evaluate(std::size_t item);
  std::string loop(const std::vector<Pending>& stack, std::size_t item) const;
  void finish(Item& item, bool good);
  double replaced(const Item& item, const Attribute& declared, const ParameterValue& value);

  Scope* scope_;
  const Word* word_;
  Faults* faults_;
  std::vector<Item> items_;
  std::unordered_map<std::string, std::size_t> index_;  ///< of the items
  std::multimap<std::string, Replacement> replacements_;
};

}  // namespace dynamy
