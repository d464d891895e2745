// Stamp of a message: the number of reduction waves that its sender had joined, behind the body.
#pragma once

#include <cstdint>
#include <cstring>

#include "engine/detail/contract.hpp"
#include "engine/wire.hpp"

namespace kusabi::engine {

using Stamp = std::uint64_t;

inline Bytes stamped(Bytes body, Stamp stamp) {
  body.resize(body.size() + sizeof stamp);
  std::memcpy(body.data() + body.size() - sizeof stamp, &stamp, sizeof stamp);
  return body;
}

/// Removes the stamp of a body and returns it.
inline Stamp take_stamp(Bytes& body) {
  Stamp stamp = 0;
  ensure(body.size() >= sizeof stamp, "a counted message has a stamp");
  std::memcpy(&stamp, body.data() + body.size() - sizeof stamp, sizeof stamp);
  body.resize(body.size() - sizeof stamp);
  return stamp;
}

}  // namespace kusabi::engine
