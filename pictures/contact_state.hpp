// ContactState: state of a contact candidate in an answer.
#pragma once

#include <cstdint>

namespace kusabi::pictures {

enum class ContactState : std::int8_t {
  none = 0,  ///< no candidate, or one that the answer does not cover
  contact = 1,
  separated = 2,
  inactive = 3,  ///< neither a reaction nor a gap
};

}  // namespace kusabi::pictures
