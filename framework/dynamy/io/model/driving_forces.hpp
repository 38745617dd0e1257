/// Forces that depend on the time t, because of which a model has no steady motion or rest; and a
/// parameter whose value 0 switches them off.
#pragma once
#include <dynamy/io/model/model_loader.hpp>

namespace dynamy {

/// `error` with a hint that names such forces and the parameter: "<ForceInput> of m.xml:19 depends
/// on t: --set push=0 switches it off"; `error` itself if no force depends on t.
ModelError namingDrivingForces(const ModelError& error, const std::filesystem::path& file,
                               const Overrides& set, Registry& registry, PluginLoader& plugins);

}  // namespace dynamy
