#include <cstddef>
#include <cstdint>
#include <dynamy/io/hdf5/hdf5_heaps.hpp>
#include <optional>

namespace dynamy {
namespace {

/// Base of the addresses in the file, and the sizes of an address and of a length in bytes.
struct Layout {
  std::size_t base = 0, address = 0, length = 0;
};

/// The little-endian number of `bytes` bytes at `at`; none: beyond the end.
std::optional<std::uint64_t> numberAt(std::string_view file, std::uint64_t at, std::size_t bytes) {
  if (at > file.size() || bytes > file.size() - at) return {};
  std::uint64_t out = 0;
  for (std::size_t k = bytes; k-- > 0;)
    out = (out << 8) | static_cast<unsigned char>(file[static_cast<std::size_t>(at) + k]);
  return out;
}

/// Reads the layout from the superblock, which starts at 0, 512, 1024, 2048 …
std::optional<Layout> layoutOf(std::string_view file) {
  constexpr std::string_view kSignature("\x89HDF\r\n\x1a\n", 8);
  for (std::size_t base = 0; base < file.size(); base = base == 0 ? 512 : 2 * base) {
    if (file.substr(base, kSignature.size()) != kSignature) continue;
    const auto version = numberAt(file, base + 8, 1);
    const std::size_t sizes = base + (version.value_or(0) < 2 ? 13 : 9);
    const auto address = numberAt(file, sizes, 1), length = numberAt(file, sizes + 1, 1);
    // The library also supports sizes of 16 and 32 bytes, but no file needs them.
    const auto isKnown = [](std::uint64_t bytes) { return bytes == 2 || bytes == 4 || bytes == 8; };
    if (!address || !length || !isKnown(*address) || !isKnown(*length)) return {};
    return Layout{base, static_cast<std::size_t>(*address), static_cast<std::size_t>(*length)};
  }
  return {};
}

/// True if the list of free blocks ends in the heap with its signature at `at`. Each block holds
/// two lengths: the offset of the next block, and its own size. `blocks`: number of further blocks
/// that fit into the file; blocks do not overlap.
bool freeBlocksEndAt(std::string_view file, const Layout& layout, std::size_t at,
                     std::uint64_t& blocks) {
  constexpr std::uint64_t kNone = 1;
  const std::size_t fields = at + 8;
  const auto size = numberAt(file, fields, layout.length),
             head = numberAt(file, fields + layout.length, layout.length),
             begin = numberAt(file, fields + 2 * layout.length, layout.address);
  if (!size || !head || !begin) return true;
  for (std::uint64_t block = *head; block != kNone; --blocks) {
    if (block >= *size) return true;
    if (blocks == 0) return false;
    const auto next = numberAt(file, layout.base + *begin + block, layout.length);
    if (!next) return true;
    block = *next;
  }
  return true;
}

}  // namespace

bool freeBlocksEnd(std::string_view file) {
  constexpr std::string_view kHeap("HEAP\0", 5);  // version 0, the only one
  const std::optional<Layout> layout = layoutOf(file);
  if (!layout) return true;
  std::uint64_t blocks = file.size() / (2 * layout->length);
  for (std::size_t at = file.find(kHeap); at != std::string_view::npos;
       at = file.find(kHeap, at + 1))
    if (!freeBlocksEndAt(file, *layout, at, blocks)) return false;
  return true;
}

}  // namespace dynamy
