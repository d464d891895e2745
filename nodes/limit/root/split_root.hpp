// The worst-case load factor at the root by operator splitting: all static cuts at a time, for
// trusses on which one linear program a cut would take long. nodes/limit/splitting has the
// iterations; here is when which of them goes on, and what is made of it.
#pragma once

#include "nodes/limit/root/worst_case.hpp"
#include "nodes/limit/splitting/column_blocks.hpp"

namespace kusabi::limit {

/// closed: the ends meet; the cuts are one for each column of T. open: they were not made to meet;
/// the cuts are good ones for solve_root() to begin with, if there are any. Every rank makes the
/// same call, and all get the same.
/// @param alpha scaled, > 0
/// @param nominal the collapse without uncertainty, which `load_factor` has solved
RootResult split_root(const problems::LimitModel& model, double alpha, const Collapse& nominal,
                      LoadFactor& load_factor, const splitting::Sharing& sharing,
                      const RootControl& control = {});

}  // namespace kusabi::limit
