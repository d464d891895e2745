// One value and the end of its line.
#include "run/output/result_file.hpp"

#include <ostream>

namespace kusabi::run {

ResultFile::ResultFile(const std::string& name, const std::string& input)
    : file_("--output", name, input) {}

void ResultFile::write(const nlohmann::ordered_json& result) {
  write([&](JsonWriter& json) { json.value(result); });
}

void ResultFile::write(const std::function<void(JsonWriter&)>& write) {
  if (!file_.wanted()) return;
  JsonWriter json(file_.stream());
  write(json);
  file_.stream() << '\n';
  file_.put_in_place();
}

}  // namespace kusabi::run
