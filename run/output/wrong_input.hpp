// WrongInput: the error that ends the command with exit code 2.
#pragma once

#include <stdexcept>

namespace kusabi::run {

/// Error in the input or the call found on rank 0; thrown on every rank.
class WrongInput : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace kusabi::run
