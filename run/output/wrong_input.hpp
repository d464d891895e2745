// The error that ends the command with exit code 2.
#pragma once

#include <stdexcept>

namespace kusabi::run {

/// Something that rank 0 found wrong with the input or the call; thrown on every rank.
class WrongInput : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace kusabi::run
