// The numbers in the text of a VTU file, decoded by other means than it was written by:
// Boost's base64, zlib's one-call decompression.
#pragma once

#include <cstring>
#include <string>
#include <vector>

namespace kusabi::pictures::test {

/// The bytes that a base64 text stands for.
std::string from_base64(std::string text);

/// The bytes of the array of that name; an error of the test if there is none, or it is malformed.
std::string array_bytes(const std::string& vtu, const std::string& name);

template <class Number>
std::vector<Number> array(const std::string& vtu, const std::string& name) {
  const auto bytes = array_bytes(vtu, name);
  std::vector<Number> numbers(bytes.size() / sizeof(Number));
  std::memcpy(numbers.data(), bytes.data(), numbers.size() * sizeof(Number));
  return numbers;
}

}  // namespace kusabi::pictures::test
