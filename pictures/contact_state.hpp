// What a contact candidate does in an answer.
#pragma once

#include <cstdint>

namespace kusabi::pictures {

enum class ContactState : std::int8_t {
  none = 0,  ///< no candidate, or one that this answer says nothing of
  contact = 1,
  separated = 2,
  at_rest = 3,  ///< neither a reaction nor a gap
};

}  // namespace kusabi::pictures
