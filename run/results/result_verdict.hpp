// The verdict that a result file holds; of files of older versions, made from the facts in them.
#pragma once

#include "run/results/result_reader.hpp"
#include "run/verdict/verdict.hpp"

namespace kusabi::run {

/// Its sentences are those of run/verdict/words.hpp: the same as those of the run, if its version
/// was this one. @throws WrongInput
Verdict result_verdict(const ResultReader& reader);

/// Of a file without the key `verdict`, which version 0.1 does not write. @throws WrongInput
Verdict older_verdict(const ResultReader& reader);

/// What `status` says of the end of the search. @throws WrongInput
engine::Status ended_as(const ResultReader& reader, const std::string& status);

}  // namespace kusabi::run
