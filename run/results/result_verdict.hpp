// Verdict of a result file; for files of older versions, derived from other keys.
#pragma once

#include "run/results/result_reader.hpp"
#include "run/verdict/verdict.hpp"

namespace kusabi::run {

/// Sentences are made by run/verdict/words.hpp: they equal those of the run if it was of the same
/// version.
/// @throws WrongInput
Verdict result_verdict(const ResultReader& reader);

/// Verdict of a file without the key `verdict`, which version 0.1 does not write.
/// @throws WrongInput
Verdict older_verdict(const ResultReader& reader);

/// Bounds of the least factor that is carried under all admissible loads, from the last point of
/// `sweep --alpha`: versions that write it there may have no such key in their verdict.
/// @throws WrongInput
Bracket min_factor_of_last_point(const ResultReader& reader);

/// End of the search by the key `status`. @throws WrongInput
engine::Status ended_as(const ResultReader& reader, const std::string& status);

}  // namespace kusabi::run
