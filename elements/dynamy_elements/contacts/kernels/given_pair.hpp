/// Pairs that shapes of plug-ins bring (shape_pair.hpp), as kernels of the table.
#pragma once
#include <dynamy/system/shape_pair.hpp>
#include <dynamy_elements/contacts/kernels/pair_table.hpp>

namespace dynamy {

/// Adds the pairs of a family, which is borrowed. Throws ModelError if the table has one of them.
void addFamily(PairTable& table, const ShapeFamily& family);

}  // namespace dynamy
