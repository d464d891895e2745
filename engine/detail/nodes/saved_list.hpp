// SavedList and SavedBundle: lists that are written to a checkpoint element by element. A copy of
// them, such as a std::vector, would double the memory of a rank.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

#include <boost/serialization/binary_object.hpp>
#include <boost/serialization/collection_size_type.hpp>
#include <boost/serialization/item_version_type.hpp>
#include <boost/serialization/version.hpp>

#include "engine/detail/nodes/open_nodes.hpp"

namespace kusabi::engine {

/// List that is saved as a std::vector<Value>; only an output archive can serialise it.
template <class Value>
struct SavedList {
  using Look = std::function<void(const Value&)>;

  std::size_t size = 0;
  std::function<void(const Look&)> for_each;  ///< calls its argument for each element

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    const boost::serialization::collection_size_type count(size);
    const boost::serialization::item_version_type version(
        boost::serialization::version<Value>::value);
    archive << count << version;
    for_each([&](const Value& value) { archive << value; });
  }
};

/// Bundle that is saved as a Bundle<Node>.
template <class Node>
struct SavedBundle {
  std::span<const TrailStep> trail;
  SavedList<OpenNode<Node>> nodes;

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    const auto steps = static_cast<std::uint64_t>(trail.size());
    archive << steps << boost::serialization::make_binary_object(trail.data(), trail.size_bytes())
            << nodes;
  }
};

}  // namespace kusabi::engine

template <class Node>
struct boost::serialization::version<kusabi::engine::SavedBundle<Node>>
    : boost::serialization::version<kusabi::engine::Bundle<Node>> {};
