// Calls of `kusabi limit`: input files, and the result of one call.
#pragma once

#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "shell.hpp"
#include "support/sha1.hpp"

namespace kusabi::test {

inline std::string case_file(const std::string& name) {
  return quoted(std::string(KUSABI_SOURCE_DIR) + "/tests/cases/" + name);
}

inline std::string example(const std::string& name) {
  return quoted(std::string(KUSABI_SOURCE_DIR) + "/examples/" + name);
}

/// A certificate with a correct digest.
inline std::string sealed(const std::string& text) {
  const auto body = text.substr(0, text.rfind("digest "));
  return body + "digest " + support::hexadecimal(support::sha1(body)) + "\n";
}

class LimitCalls : public Command {
 protected:
  /// Result file of a call, which must exit with `exit_code`.
  nlohmann::json file_of(const std::string& call, int exit_code = 0) const {
    const auto run = shell(command + " limit " + call + " --output " + argument("out.json"));
    EXPECT_EQ(run.exit_code, exit_code) << run.output;
    return nlohmann::json::parse(content(in_folder("out.json")));
  }
};

}  // namespace kusabi::test
