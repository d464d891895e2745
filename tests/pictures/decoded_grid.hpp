// Decoder of the arrays in a VTU file, by other means than the writer's: Boost's base64, zlib's
// one-call decompression.
#pragma once

#include <cstring>
#include <string>
#include <vector>

namespace kusabi::pictures::test {

/// Decodes base64.
std::string from_base64(std::string text);

/// Bytes of the array of this name; a test failure if it is missing or malformed.
std::string array_bytes(const std::string& vtu, const std::string& name);

template <class Number>
std::vector<Number> array(const std::string& vtu, const std::string& name) {
  const auto bytes = array_bytes(vtu, name);
  std::vector<Number> numbers(bytes.size() / sizeof(Number));
  std::memcpy(numbers.data(), bytes.data(), numbers.size() * sizeof(Number));
  return numbers;
}

}  // namespace kusabi::pictures::test
