// Names of candidates.
#include "verify/structure.hpp"

namespace kusabi::verify {

std::string name_of(const Structure& structure, const ContactPoint& point) {
  auto name = structure.names[point.node];
  if (point.against.empty()) return name;
  auto nearest = point.against.front();
  for (const auto& part : point.against) {
    if (part.weight > nearest.weight) nearest = part;
  }
  name += "|" + structure.names[nearest.node];
  if (point.against.size() > 1) name += "+";
  return name;
}

}  // namespace kusabi::verify
