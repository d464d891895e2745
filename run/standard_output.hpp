// The last words of a command: its answer is out, and the files that it has written are named.
#pragma once

#include <initializer_list>
#include <string>

namespace kusabi::run {

/// @throws std::runtime_error if not all that was printed has got through: the disk is full, say
void flush_standard_output();

/// One line for each of `files`, but those without a name, on standard error.
void tell_written(std::initializer_list<std::string> files);

}  // namespace kusabi::run
