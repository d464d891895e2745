// The wire format: any Boost-serialisable value as a packed buffer of bytes, and back.
//
// Boost's binary archive without its header: both ends are the same program on machines of the
// same kind, as MPI jobs are. (A checkpoint file, which outlives its program, adds a version.)
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

/// A stream buffer that appends to a byte vector: std::stringbuf would copy the whole at the end.
class Writer : public std::streambuf {
 public:
  explicit Writer(Bytes& bytes) : bytes_(bytes) {}

 protected:
  std::streamsize xsputn(const char* data, std::streamsize count) override;
  int_type overflow(int_type character) override;

 private:
  Bytes& bytes_;
};

/// A stream buffer that reads from bytes it does not own.
class Reader : public std::streambuf {
 public:
  explicit Reader(std::span<const char> bytes);
};

}  // namespace wire

/// The bytes of `value`.
template <class Value>
Bytes pack(const Value& value) {
  Bytes bytes;
  wire::Writer buffer(bytes);
  boost::archive::binary_oarchive archive(buffer, wire::archive_flags);
  archive << value;
  return bytes;
}

/// Tells how many bytes each of some values takes in one message. (To begin an archive takes longer
/// than to write a small value, so there is one for all of them.)
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
  wire::Writer buffer_{bytes_};
  boost::archive::binary_oarchive archive_{buffer_, wire::archive_flags};
};

template <class Value>
requires std::is_trivially_copyable_v<Value>  // near enough
class PackedSize<Value> {
 public:
  std::size_t operator()(const Value& /*value*/) { return sizeof(Value); }
};

/// The value that `pack` wrote into `bytes`.
/// @throws boost::archive::archive_exception if the bytes end too early.
template <class Value>
Value unpack(std::span<const char> bytes) {
  Value value;
  wire::Reader buffer(bytes);
  boost::archive::binary_iarchive archive(buffer, wire::archive_flags);
  archive >> value;
  return value;
}

}  // namespace kusabi::engine
