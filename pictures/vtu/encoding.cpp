// Base64 and zlib compression, in blocks as those of VTK's own writer.
#include "pictures/vtu/encoding.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string_view>
#include <vector>

#include <zlib.h>

namespace kusabi::pictures {
namespace {

constexpr std::size_t block_size = std::size_t{1} << 15U;

std::vector<char> bytes_of(const std::vector<std::uint64_t>& numbers) {
  std::vector<char> bytes(numbers.size() * sizeof(std::uint64_t));
  std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return bytes;
}

// Appends the compressed block. @return its size
std::uint64_t pack(std::span<const char> block, std::vector<char>& packed) {
  auto size = compressBound(static_cast<uLong>(block.size()));
  const auto begin = packed.size();
  packed.resize(begin + size);
  const int result = compress2(reinterpret_cast<Bytef*>(packed.data() + begin), &size,
                               reinterpret_cast<const Bytef*>(block.data()),
                               static_cast<uLong>(block.size()), Z_DEFAULT_COMPRESSION);
  if (result != Z_OK) throw std::runtime_error("zlib could not pack an array");
  packed.resize(begin + size);
  return size;
}

}  // namespace

std::string base64(std::span<const char> bytes) {
  constexpr std::string_view letters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - at);
    std::uint32_t group = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto byte = i < count ? static_cast<unsigned char>(bytes[at + i]) : 0U;
      group = group << 8U | byte;
    }
    for (std::size_t i = 0; i < 4; ++i) {
      text += i <= count ? letters[group >> (18 - 6 * i) & 63U] : '=';
    }
  }
  return text;
}

std::string plain_array(std::span<const char> bytes) {
  auto all = bytes_of({bytes.size()});
  all.insert(all.end(), bytes.begin(), bytes.end());
  return base64(all);
}

std::string packed_array(std::span<const char> bytes) {
  std::vector<std::uint64_t> header{(bytes.size() + block_size - 1) / block_size, block_size,
                                    bytes.size() % block_size};
  std::vector<char> packed;
  for (std::size_t at = 0; at < bytes.size(); at += block_size) {
    header.push_back(pack(bytes.subspan(at, std::min(block_size, bytes.size() - at)), packed));
  }
  return base64(bytes_of(header)) + base64(packed);
}

}  // namespace kusabi::pictures
