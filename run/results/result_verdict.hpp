// Verdict of a result file, from its key `verdict`.
#pragma once

#include "answer/verdict.hpp"
#include "run/results/result_reader.hpp"

namespace kusabi::run {

/// Sentences are made by run/verdict/words.hpp: they equal those of the run if it was of the same
/// version.
/// @throws WrongInput
answer::Verdict result_verdict(const ResultReader& reader);

}  // namespace kusabi::run
