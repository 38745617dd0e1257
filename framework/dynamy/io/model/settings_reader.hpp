/// SettingsReader: the sections `<simulation>`, `<record>`, `<check>` and `<orbit>` of a model
/// file.
#pragma once
#include <dynamy/io/model/element_reader.hpp>
#include <dynamy/simulation/model/model.hpp>
#include <dynamy/simulation/orbit/orbit_section.hpp>
#include <string_view>
#include <unordered_set>

namespace dynamy {

class SettingsReader {
  struct OrbitSignal {
    std::string name;
    Place place;
  };

 public:
  /// `orbit` receives the section of `<orbit>`; null: nobody wants it. `until`: end time that the caller
  /// sets afterwards; 0: none.
  SettingsReader(Model& model, const ModelSource& source, ElementReader& elements, Faults& faults,
                 OrbitSection* orbit, double until)
      : model_(&model),
        source_(&source),
        elements_(&elements),
        faults_(&faults),
        attributes_(faults, nullptr),
        orbit_(orbit),
        until_(until) {}

  void read(const ModelItem& item);
  /// Call after build(): reports signals that no element has, and checks at times after the end.
  void verifySignals() const;

 private:
  bool isOnly(const XmlNode& node, const Scope& scope);
  void readSimulation(const XmlNode& node, const Scope& scope, const Parameters& x);
  void readMethods(const XmlNode& node, const Scope& scope);
  void readRecord(const XmlNode& node, const Scope& scope, const Parameters& x);
  void readOrbit(const XmlNode& node, const Scope& scope, const Parameters& x);
  void readCheck(const XmlNode& node, const Scope& scope, const Parameters& x);
  bool checkIsSound(const XmlNode& node, const Scope& scope, const Parameters& x) const;
  double longest() const { return std::max(model_->simulation.until, until_); }
  void verifyTime(const CheckSettings& check, const Place& place) const;
  void verifyInstants() const;
  void verifyKept() const;
  void verifyFollow(const std::string& name, const Place& place) const;
  void verify(const std::unordered_set<std::string_view>& signals, const std::string& signal,
              const Place& place, const std::string& element) const;

  Model* model_;
  const ModelSource* source_;
  ElementReader* elements_;
  Faults* faults_;
  AttributeReader attributes_;
  OrbitSection* orbit_;
  double until_;
  OrbitSignal orbitSignal_;
  std::map<std::string, Place> sections_;  ///< the first of each kind
  std::map<Kind, Place> methods_;
  std::vector<Place> checkSignals_, checkTimes_;
  Place recordTimes_;
};

}  // namespace dynamy
