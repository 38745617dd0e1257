#pragma once
/// \file
/// Little-endian numbers, CRC-32 and base64, of which the binary parts of a run folder consist.
/// Structs are never written as they lie in memory, because padding and byte order would then be
/// part of the format.

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>

namespace dynamy {

namespace detail {
/// Bytes of `value` in little-endian order; the function is its own inverse.
template <class T>
std::array<char, sizeof(T)> littleEndian(T value) {
  static_assert(std::is_arithmetic_v<T>);
  auto bytes = std::bit_cast<std::array<char, sizeof(T)>>(value);
  if constexpr (std::endian::native == std::endian::big) {
    for (std::size_t i = 0; i < sizeof(T) / 2; ++i) std::swap(bytes[i], bytes[sizeof(T) - 1 - i]);
  }
  return bytes;
}
}  // namespace detail

/// Appends `value` to `out`, little-endian.
template <class T>
void appendBytes(std::string& out, T value) {
  const auto bytes = detail::littleEndian(value);
  out.append(bytes.data(), bytes.size());
}

/// Reads a little-endian T from `at`; the caller has checked that sizeof(T) bytes are there.
template <class T>
T readBytes(const char* at) {
  std::array<char, sizeof(T)> bytes;
  std::memcpy(bytes.data(), at, sizeof(T));
  return std::bit_cast<T>(detail::littleEndian(std::bit_cast<T>(bytes)));
}

/// CRC-32 (polynomial 0xEDB88320 reflected, start and final xor 0xFFFFFFFF, as in zip and PNG) of
/// `bytes`; `before` continues an earlier result: crc32(b, crc32(a)) = crc32(ab).
std::uint32_t crc32(std::string_view bytes, std::uint32_t before = 0);

/// Appends the base64 text of `bytes` (alphabet A–Z a–z 0–9 + /, padded with =) to `out`.
void appendBase64(std::string& out, std::string_view bytes);

}  // namespace dynamy
