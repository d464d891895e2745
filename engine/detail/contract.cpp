// Message of a violated contract.
#include "engine/detail/contract.hpp"

#include <string>
#include <string_view>

namespace kusabi::engine {

void contract_broken(const char* promise, const char* file, int line) {
  // The path relative to the repository; the folder of the build does not belong in a message.
  std::string_view name = file;
  const auto folder = name.rfind("engine/");
  if (folder != std::string_view::npos) name.remove_prefix(folder);
  throw ContractBroken(std::string(name) + ':' + std::to_string(line) +
                       ": contract violated: " + promise);
}

}  // namespace kusabi::engine
