// Numbers for the displacements that no support takes.
#include "verify/structure.hpp"

namespace kusabi::verify {

Freedom::Freedom(const Structure& structure) {
  for (const auto& axes : structure.fixed) {
    auto& own = number.emplace_back();
    own.fill(none);
    for (std::size_t axis = 0; axis < structure.dimension; ++axis) {
      if (!axes[axis]) own[axis] = count++;
    }
  }
}

}  // namespace kusabi::verify
