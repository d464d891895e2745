// Worst-case load factor at the root by operator splitting: all static cuts at once, for trusses on
// which one linear program for each cut would take long. nodes/limit/splitting has the iterations;
// this file alternates between them and uses their results.
#pragma once

#include "nodes/limit/root/worst_case.hpp"
#include "nodes/limit/splitting/column_blocks.hpp"

namespace kusabi::limit {

/// closed: the bounds meet, with one cut for each column of T. open: they do not; the cuts, if any,
/// are good initial ones for solve_root(). Every rank makes the same call, and all get the same.
/// @param alpha scaled, > 0
/// @param nominal the collapse without uncertainty, which `load_factor` has solved
RootResult split_root(const problems::LimitModel& model, double alpha, const Collapse& nominal,
                      LoadFactor& load_factor, const splitting::Sharing& sharing,
                      const RootControl& control = {});

}  // namespace kusabi::limit
