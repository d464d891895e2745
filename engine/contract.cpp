// What is said of a broken promise.
#include "engine/contract.hpp"

#include <string>
#include <string_view>

namespace kusabi::engine {

void contract_broken(const char* promise, const std::source_location& place) {
  // From the folder on: where the program was built is nobody's business.
  std::string_view file = place.file_name();
  const auto folder = file.rfind("engine/");
  if (folder != std::string_view::npos) file.remove_prefix(folder);
  throw ContractBroken(std::string(file) + ':' + std::to_string(place.line()) +
                       ": a promise is broken: " + promise);
}

}  // namespace kusabi::engine
