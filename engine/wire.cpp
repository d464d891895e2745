// Stream buffers of the wire format.
#include "engine/wire.hpp"

namespace kusabi::engine::wire {

std::streamsize ByteWriter::xsputn(const char* data, std::streamsize count) {
  bytes_.insert(bytes_.end(), data, data + count);
  return count;
}

ByteWriter::int_type ByteWriter::overflow(int_type character) {
  if (traits_type::eq_int_type(character, traits_type::eof()))
    return traits_type::not_eof(character);
  bytes_.push_back(traits_type::to_char_type(character));
  return character;
}

ByteReader::ByteReader(std::span<const char> bytes) {
  // std::streambuf requires mutable pointers; the get area is never written to.
  char* begin = const_cast<char*>(bytes.data());  // NOLINT(cppcoreguidelines-pro-type-const-cast)
  setg(begin, begin, begin + bytes.size());
}

}  // namespace kusabi::engine::wire
