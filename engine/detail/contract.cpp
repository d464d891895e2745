// What is said of a broken promise.
#include "engine/detail/contract.hpp"

#include <string>
#include <string_view>

namespace kusabi::engine {

void contract_broken(const char* promise, const char* file, int line) {
  // From the folder on: where the program was built is nobody's business.
  std::string_view name = file;
  const auto folder = name.rfind("engine/");
  if (folder != std::string_view::npos) name.remove_prefix(folder);
  throw ContractBroken(std::string(name) + ':' + std::to_string(line) +
                       ": a promise is broken: " + promise);
}

}  // namespace kusabi::engine
