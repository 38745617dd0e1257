#pragma once
/// \file
/// What the HDF5 library takes on trust: that the free blocks of a heap of names are a list with an
/// end. A wrong bit can lead it back to itself; the library follows it until no memory is left.

#include <string_view>

namespace dynamy {

/// Does every list of free blocks in the bytes of an HDF5 file end? What is no HDF5 file, or leads out
/// of it, is left to the library, which refuses it. [HDF5 file format specification 3.0, II, III.D]
bool freeBlocksEnd(std::string_view file);

}  // namespace dynamy
