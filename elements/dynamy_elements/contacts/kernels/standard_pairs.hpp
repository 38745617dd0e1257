/// The pairs of the standard shapes: one file and its name below for each family.
#pragma once
#include <dynamy_elements/contacts/kernels/pair_table.hpp>

namespace dynamy {

void addHalfSpacePairs(PairTable& table);
void addBallPairs(PairTable& table);
void addCapsulePairs(PairTable& table);
void addSmoothPairs(PairTable& table);
void addDiscPairs(PairTable& table);
void addFacetedPairs(PairTable& table);
void addSurfacePairs(PairTable& table);
void addPlanePairs(PairTable& table);
void addBorePairs(PairTable& table);

/// Adds all of them.
inline void addStandardPairs(PairTable& table) {
  for (const auto add :
       {addHalfSpacePairs, addBallPairs, addCapsulePairs, addSmoothPairs, addDiscPairs,
        addFacetedPairs, addSurfacePairs, addPlanePairs, addBorePairs})
    add(table);
}

}  // namespace dynamy
