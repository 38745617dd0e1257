/// What all Python bindings share: the registry with the standard elements, loaded when the module
/// is imported.
#pragma once
#include <pybind11/pybind11.h>
#include <dynamy/io/model/model_loader.hpp>
#include <dynamy/io/plugin/plugin_loader.hpp>
#include <dynamy/io/plugin/registry.hpp>

namespace dynamy::python {

struct Library {
  Registry registry;
  PluginLoader plugins;
  Library() {
    registerFramework(registry);
    plugins.howToTrust("dynamy.trust(folder)");
    plugins.load(kStandardElements, registry);
  }
};

/// The one library of the interpreter. It is never destroyed, because models hold code of the
/// plug-ins that it loaded.
Library& library();

/// Converts Python keyword arguments (0.3, True, "wood", (0, 0, 1)) to the texts that an author
/// would write in XML.
std::vector<GivenValue> givenValues(const pybind11::kwargs& values);

void bindModel(pybind11::module_& m);
void bindRun(pybind11::module_& m);
void bindGradient(pybind11::module_& m);
void bindOrbit(pybind11::module_& m);
void bindEquilibrium(pybind11::module_& m);
void bindFit(pybind11::module_& m);
void bindLaws(pybind11::module_& m);

}  // namespace dynamy::python
