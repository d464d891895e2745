// What rank 0 knows, told to all ranks.
#pragma once

#include <span>
#include <string>
#include <type_traits>

#include "engine/wire.hpp"
#include "run/session/session.hpp"

namespace kusabi::run {

/// What `make` returns on rank 0, on every rank. Boost-serialisable; errors as for
/// Session::on_first_rank.
template <class Make>
std::invoke_result_t<Make> told_by_first_rank(Session& session, Make make) {
  const std::string packed = session.on_first_rank([&]() -> std::string {
    const auto bytes = engine::pack(make());
    return {bytes.begin(), bytes.end()};
  });
  return engine::unpack<std::invoke_result_t<Make>>(std::span(packed.data(), packed.size()));
}

}  // namespace kusabi::run
