/// What all bindings share: the registry with the standard elements, loaded when the module is.
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

/// One for the interpreter: models hold code of the libraries that it loaded.
Library& library();

/// name=value of Python as an XML author would have written it: 0.3, True, "wood", (0, 0, 1).
std::vector<GivenValue> givenValues(const pybind11::kwargs& values);

void bindModel(pybind11::module_& m);
void bindRun(pybind11::module_& m);
void bindLaws(pybind11::module_& m);

}  // namespace dynamy::python
