#include <dynamy/system/own_numbers.hpp>
#include <stdexcept>

namespace dynamy {

void OwnNumbers::assign(const Topology& whole, const std::vector<int>& systems,
                        const std::vector<int>& frames) {
  systems_ = systems, frames_ = frames;
  handles_.clear();
  SystemHandle end{.index = 0, .blocks = 0};  // where the next system begins
  for (const int i : systems_) {
    SystemHandle own = whole.system(i);
    own.index = end.index++, own.q0 = end.q0, own.u0 = end.u0, own.block0 = end.block0;
    end.q0 += own.nq, end.u0 += own.nu, end.block0 += own.blocks;
    handles_.push_back(own);
  }
}

const SystemHandle& OwnNumbers::handle(int system) const {
  const int i = of(system);
  if (i < 0)
    throw std::logic_error(
        "it reads or acts on a system that takes no part in this evaluation; ask "
        "Kinematics::leavesOut() first");
  return handles_[static_cast<std::size_t>(i)];
}

}  // namespace dynamy
