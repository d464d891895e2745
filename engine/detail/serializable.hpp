// Serializable: compile-time check that Boost.Serialization supports a type. The errors of Boost
// itself take pages.
#pragma once

#include <type_traits>

#include <boost/archive/binary_oarchive.hpp>
#include <boost/serialization/level.hpp>
#include <boost/serialization/serialization.hpp>

#include "engine/detail/member_names.hpp"

namespace kusabi::engine {
namespace serialization {

// As general as Boost's own serialize(), which requires a member function: where nothing more
// special has been declared (as the header for std::vector does) the two are ambiguous.
template <class Archive, class Value>
void serialize(Archive& archive, Value& value, unsigned version);

template <class Value>
concept ByFunction = requires(boost::archive::binary_oarchive& archive, Value& value) {
  serialize(archive, value, boost::serialization::version_type{0U});
};

// A member that cannot be called from here may be private, with Boost as a friend. The usual
// mistake is a missing `version`.
template <class Value>
concept ByMember =
    NamesSerialize<Value> && !requires(boost::archive::binary_oarchive & archive, Value& value) {
  value.serialize(archive);
};

template <class Value>
constexpr bool can_be_written() {
  if constexpr (boost::serialization::implementation_level<Value>::value <=
                boost::serialization::primitive_type) {
    return boost::serialization::implementation_level<Value>::value ==
           boost::serialization::primitive_type;
  } else if constexpr (ByFunction<Value>) {
    if constexpr (requires { typename Value::value_type; }) {
      return can_be_written<std::remove_const_t<typename Value::value_type>>();
    } else {
      return true;
    }
  } else {
    return ByMember<Value>;
  }
}

}  // namespace serialization

/// A type with a member or a free function `serialize`, or one that Boost supports; for a
/// container, its elements as well.
template <class Value>
concept Serializable = serialization::can_be_written<Value>();

}  // namespace kusabi::engine
