// Wire format: Boost-serialisable values as byte buffers.
//
// Boost's binary archive without its header: both ends are the same program on machines of the same
// kind, as in an MPI job. (A checkpoint file, which outlives its program, adds a version.)
#pragma once

#include <cstddef>
#include <span>
#include <streambuf>
#include <type_traits>
#include <vector>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>

namespace kusabi::engine {

using Bytes = std::vector<char>;

namespace wire {

inline constexpr unsigned archive_flags =
    boost::archive::no_header | boost::archive::no_codecvt | boost::archive::no_tracking;

/// A stream buffer that appends to a byte vector; std::stringbuf would copy the content at the end.
class ByteWriter : public std::streambuf {
 public:
  explicit ByteWriter(Bytes& bytes) : bytes_(bytes) {}

 protected:
  std::streamsize xsputn(const char* data, std::streamsize count) override;
  int_type overflow(int_type character) override;

 private:
  Bytes& bytes_;
};

/// A stream buffer that reads from bytes it does not own.
class ByteReader : public std::streambuf {
 public:
  explicit ByteReader(std::span<const char> bytes);
};

}  // namespace wire

/// Serialised form of `value`.
template <class Value>
Bytes pack(const Value& value) {
  Bytes bytes;
  wire::ByteWriter buffer(bytes);
  boost::archive::binary_oarchive archive(buffer, wire::archive_flags);
  archive << value;
  return bytes;
}

/// Serialised size, in bytes, of each of several values in one message. (One archive serves all,
/// since its construction takes longer than writing a small value.)
template <class Value>
class PackedSize {
 public:
  std::size_t operator()(const Value& value) {
    bytes_.clear();
    archive_ << value;
    return bytes_.size();
  }

 private:
  Bytes bytes_;
  wire::ByteWriter buffer_{bytes_};
  boost::archive::binary_oarchive archive_{buffer_, wire::archive_flags};
};

template <class Value>
requires std::is_trivially_copyable_v<Value>  // approximately
class PackedSize<Value> {
 public:
  std::size_t operator()(const Value& /*value*/) { return sizeof(Value); }
};

/// Deserialises a value written by `pack`.
/// @throws boost::archive::archive_exception if the bytes end too early
template <class Value>
Value unpack(std::span<const char> bytes) {
  Value value;
  wire::ByteReader buffer(bytes);
  boost::archive::binary_iarchive archive(buffer, wire::archive_flags);
  archive >> value;
  return value;
}

}  // namespace kusabi::engine
