#include "tests/pictures/decoded_grid.hpp"

#include <algorithm>
#include <cstdint>

#include <boost/archive/iterators/binary_from_base64.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <gtest/gtest.h>
#include <zlib.h>

namespace kusabi::pictures::test {
namespace {

std::uint64_t number_at(const std::string& bytes, std::size_t index) {
  std::uint64_t number = 0;
  if (bytes.size() >= 8 * (index + 1)) std::memcpy(&number, bytes.data() + 8 * index, 8);
  return number;
}

std::string unpacked(const std::string& text) {
  // Number of blocks, block size, size of the last block; then one number per block, in a base64
  // text of its own.
  const auto blocks = number_at(from_base64(text.substr(0, 32)), 0);
  const std::size_t header_size = 8 * (3 + blocks);
  const std::size_t header_text = (header_size + 2) / 3 * 4;
  const auto header = from_base64(text.substr(0, header_text));
  const auto packed = from_base64(text.substr(header_text));
  std::string bytes;
  std::size_t at = 0;
  for (std::uint64_t i = 0; i < blocks; ++i) {
    const bool partial = i + 1 == blocks && number_at(header, 2) != 0;
    uLongf size = partial ? number_at(header, 2) : number_at(header, 1);
    const auto room = size;
    const auto packed_size = number_at(header, 3 + i);
    std::string block(size, '\0');
    EXPECT_LE(at + packed_size, packed.size());
    EXPECT_EQ(uncompress(reinterpret_cast<Bytef*>(block.data()), &size,
                         reinterpret_cast<const Bytef*>(packed.data() + at), packed_size),
              Z_OK);
    EXPECT_EQ(size, room);
    bytes += block;
    at += packed_size;
  }
  EXPECT_EQ(at, packed.size());
  return bytes;
}

}  // namespace

std::string from_base64(std::string text) {
  using namespace boost::archive::iterators;
  using Bytes = transform_width<binary_from_base64<std::string::const_iterator>, 8, 6>;
  const auto padding = static_cast<std::size_t>(std::count(text.begin(), text.end(), '='));
  std::replace(text.begin(), text.end(), '=', 'A');
  std::string bytes(Bytes(text.cbegin()), Bytes(text.cend()));
  bytes.resize(bytes.size() - padding);
  return bytes;
}

std::string array_bytes(const std::string& vtu, const std::string& name) {
  // A regular expression over the whole file is avoided: libstdc++ recurses once per character.
  const auto tag = vtu.find("Name=\"" + name + "\"");
  EXPECT_NE(tag, std::string::npos) << name;
  if (tag == std::string::npos) return {};
  const auto begin = vtu.find('>', tag) + 1;
  const auto text = vtu.substr(begin, vtu.find('<', begin) - begin);
  if (vtu.find("compressor=\"vtkZLibDataCompressor\"") != std::string::npos) return unpacked(text);
  const auto bytes = from_base64(text);
  EXPECT_EQ(number_at(bytes, 0), bytes.size() - 8) << name;
  return bytes.substr(8);
}

}  // namespace kusabi::pictures::test
