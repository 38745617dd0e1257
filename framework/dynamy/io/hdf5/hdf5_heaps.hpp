#pragma once
/// \file
/// A check that the HDF5 library does not make: the list of free blocks in a heap of names must
/// have an end. A wrong bit can make the list circular; the library would follow it until no memory
/// is left.

#include <string_view>

namespace dynamy {

/// True if every list of free blocks in the bytes of an HDF5 file ends. Bytes that are no HDF5
/// file, and lists that lead out of it, also give true: the library refuses them. [HDF5 file format
/// specification 3.0, II, III.D]
bool freeBlocksEnd(std::string_view file);

}  // namespace dynamy
