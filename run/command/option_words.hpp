// Words of an option and their values, for its choice in a call and its name in results.
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace kusabi::run {

template <class T>
using OptionWords = std::vector<std::pair<std::string, T>>;

/// @pre the value has a word
template <class T>
const std::string& word_of(const OptionWords<T>& words, const T& value) {
  return std::ranges::find(words, value, &std::pair<std::string, T>::second)->first;
}

}  // namespace kusabi::run
