/// Which shapes of a machine may touch, as materials of a model: shapes that touch the same others
/// in the same way share a material.
#pragma once
#include "import/machine.hpp"

namespace dynamy::app {

struct MachineMaterial {
  std::string name;
  double mu = 0.0;
};

struct ContactRules {
  std::vector<MachineMaterial> materials;
  std::vector<std::pair<int, int>> apart;  ///< materials that never touch, i <= j
  std::vector<std::vector<int>> ofSkin;    ///< material of each skin of each link; −1: none
  std::vector<int> ofGround;               ///< of each skin of the world
};

/// \pre the machine is simplified
ContactRules contactRules(const Machine& machine);

}  // namespace dynamy::app
