#include <array>
#include <dynamy/core/foreign_format.hpp>

namespace dynamy {
namespace {

struct FirstBytes {
  std::string_view bytes;
  ForeignFormat format;
};

using namespace std::string_view_literals;

constexpr std::string_view kPlainText = "a text file is needed";
constexpr auto kForeign = std::to_array<FirstBytes>({
    {"\x1F\x8B"sv, {"compressed by gzip", "unpack it: gunzip FILE.gz"}},
    {"BZh"sv, {"compressed by bzip2", "unpack it: bunzip2 FILE.bz2"}},
    {"\xFD"
     "7zXZ"sv,
     {"compressed by xz", "unpack it: unxz FILE.xz"}},
    {"\x28\xB5\x2F\xFD"sv, {"compressed by zstd", "unpack it: unzstd FILE.zst"}},
    {"PK\x03\x04"sv,
     {"a ZIP archive (also .xlsx, .docx, .fmu)", "unpack it, or export the table as CSV"}},
    {"\x89HDF"sv, {"in HDF5", "a text file is needed; dynamy run --signals csv writes one"}},
    {"\x89PNG"sv, {"a picture (PNG)", kPlainText}},
    {"\xFF\xD8\xFF"sv, {"a picture (JPEG)", kPlainText}},
    {"GIF8"sv, {"a picture (GIF)", kPlainText}},
    {"%PDF"sv, {"a PDF", kPlainText}},
    {"\x7F"
     "ELF"sv,
     {"a program or a library (ELF)", kPlainText}},
});

}  // namespace

ForeignFormat foreignFormat(std::string_view bytes) {
  for (const FirstBytes& row : kForeign)
    if (bytes.starts_with(row.bytes)) return row.format;
  return {};
}

}  // namespace dynamy
