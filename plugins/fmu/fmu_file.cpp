#include "fmu_file.hpp"

#include <unistd.h>
#include <zip.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <dynamy/io/xml/xml.hpp>
#include <fstream>
#include <map>
#include <mutex>
#include <stdexcept>
#include <tuple>

namespace dynamy {
namespace {

namespace fs = std::filesystem;

/// Nobody packs more into a controller; an archive that pretends to is refused [bytes].
constexpr zip_uint64_t kMostBytes = zip_uint64_t{1} << 32u;

[[noreturn]] void fail(const std::string& why) { throw std::runtime_error(why); }

struct Discard {
  void operator()(zip_t* archive) const { zip_discard(archive); }
};
struct CloseFile {
  void operator()(zip_file_t* file) const { zip_fclose(file); }
};

/// Writes file number `i` of the archive below `folder`; returns its size.
zip_uint64_t unpackOne(zip_t* archive, zip_uint64_t i, const fs::path& folder, zip_uint64_t most) {
  zip_stat_t about;
  if (zip_stat_index(archive, i, 0, &about) != 0) fail("the archive is damaged");
  const fs::path name = fs::path(about.name).lexically_normal();
  if (name.is_absolute() || name.empty() || *name.begin() == "..")
    fail("the archive holds a path that leaves its folder: " + std::string(about.name));
  const fs::path file = folder / name;
  if (about.name[std::char_traits<char>::length(about.name) - 1] == '/') {
    fs::create_directories(file);
    return 0;
  }
  fs::create_directories(file.parent_path());
  const std::unique_ptr<zip_file_t, CloseFile> in(zip_fopen_index(archive, i, 0));
  std::ofstream out(file, std::ios::binary);
  if (!in || !out) fail("cannot unpack " + std::string(about.name));
  std::array<char, 65536> bytes{};
  zip_uint64_t size = 0;
  while (true) {
    const zip_int64_t n = zip_fread(in.get(), bytes.data(), bytes.size());
    if (n < 0) fail("the archive is damaged at " + std::string(about.name));
    if (n == 0) break;
    size += static_cast<zip_uint64_t>(n);
    if (size > most) fail("the archive holds more than 4 GiB");
    out.write(bytes.data(), n);
  }
  if (!out.flush()) fail("cannot write " + file.string());
  return size;
}

void unpack(const fs::path& path, const fs::path& folder) {
  int code = 0;
  const std::unique_ptr<zip_t, Discard> archive(zip_open(path.c_str(), ZIP_RDONLY, &code));
  if (!archive) fail("it is no archive (zip)");
  zip_uint64_t left = kMostBytes;
  const zip_int64_t count = zip_get_num_entries(archive.get(), 0);
  for (zip_int64_t i = 0; i < count; ++i)
    left -= unpackOne(archive.get(), static_cast<zip_uint64_t>(i), folder, left);
}

fs::path newFolder() {
  std::string name = (fs::temp_directory_path() / "dynamy_fmu_XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) fail("cannot make a folder to unpack it");
  return name;
}

std::string text(const XmlNode& e, const char* name, const char* otherwise = "") {
  const XmlAttribute* found = e.attribute(name);
  return found != nullptr ? found->value : otherwise;
}

bool yes(const XmlNode& e, const char* name) {
  const std::string word = text(e, name);
  return word == "true" || word == "1";
}

template <class T>
T number(const XmlNode& e, const char* name, T otherwise) {
  const std::string word = text(e, name);
  T out = otherwise;
  std::from_chars(word.data(), word.data() + word.size(), out);
  return out;
}

const XmlNode* child(const XmlNode& e, std::string_view tag) {
  const auto at = std::find_if(e.children.begin(), e.children.end(),
                               [&](const XmlNode& c) { return c.tag == tag; });
  return at == e.children.end() ? nullptr : &*at;
}

/// The type of an element of FMI 3.0, or of the child of a ScalarVariable of FMI 2.0.
std::optional<FmuType> typeOf(std::string_view tag) {
  static const std::map<std::string_view, FmuType> kTypes{
      {"Real", FmuType::real},     {"Float64", FmuType::real},      {"Float32", FmuType::real32},
      {"Int8", FmuType::int8},     {"UInt8", FmuType::uint8},       {"Int16", FmuType::int16},
      {"UInt16", FmuType::uint16}, {"Int32", FmuType::int32},       {"Integer", FmuType::int32},
      {"UInt32", FmuType::uint32}, {"Int64", FmuType::int64},       {"UInt64", FmuType::uint64},
      {"Boolean", FmuType::flag},  {"Enumeration", FmuType::int64},
  };
  const auto at = kTypes.find(tag);
  return at == kTypes.end() ? std::nullopt : std::optional(at->second);
}

FmuClock clockOf(const XmlNode& e, std::uint32_t reference) {
  const double resolution = number(e, "resolution", 1.0);
  const auto time = [&](const char* decimal, const char* counter) {
    return number(e, decimal, number(e, counter, 0.0) / resolution);
  };
  return {reference, time("intervalDecimal", "intervalCounter"),
          time("shiftDecimal", "shiftCounter")};
}

fs::path libraryOf(const FmuFile& fmu) {
#if defined(__aarch64__)
  const char* const folders[] = {"linuxaarch64", "aarch64-linux"};
#else
  const char* const folders[] = {"linux64", "x86_64-linux"};
#endif
  return fmu.folder / "binaries" / folders[fmu.version == 3 ? 1 : 0] / (fmu.identifier + ".so");
}

XmlDocument described(const fs::path& file) {
  try {
    return XmlDocument::read(file);
  } catch (const ModelError& e) {
    const Diagnostic& first = e.diagnostics().front();
    fail("its modelDescription.xml, line " + std::to_string(first.place.line) + ": " + first.text);
  }
}

}  // namespace

std::shared_ptr<const FmuFile> FmuFile::open(const fs::path& path) {
  using Key = std::tuple<fs::path, std::uintmax_t, fs::file_time_type>;
  static std::mutex once;
  static std::map<Key, std::weak_ptr<const FmuFile>> known;
  const std::lock_guard<std::mutex> alone(once);
  const Key key{fs::canonical(path), fs::file_size(path), fs::last_write_time(path)};
  if (std::shared_ptr<const FmuFile> used = known[key].lock()) return used;
  const std::shared_ptr<FmuFile> out(new FmuFile);
  out->folder = newFolder();
  unpack(path, out->folder);
  out->read();
  known[key] = out;
  return out;
}

FmuFile::~FmuFile() {
  std::error_code ignored;
  if (!folder.empty()) fs::remove_all(folder, ignored);
}

void FmuFile::read() {
  const XmlDocument document = described(folder / "modelDescription.xml");
  const XmlNode& root = document.root();
  const std::string said = text(root, "fmiVersion");
  if (!said.starts_with("2.") && !said.starts_with("3."))
    fail("it is of FMI " + (said.empty() ? "of no version" : said) + ", not 2.0 or 3.0");
  version = said[0] - '0';
  const XmlNode* kind = child(root, "CoSimulation");
  if (kind == nullptr)
    fail("it is not for co-simulation; export it with its own solver (co-simulation)");
  identifier = text(*kind, "modelIdentifier");
  token = text(root, version == 3 ? "instantiationToken" : "guid");
  serializes = yes(*kind, version == 3 ? "canSerializeFMUState" : "canSerializeFMUstate") &&
               yes(*kind, version == 3 ? "canGetAndSetFMUState" : "canGetAndSetFMUstate");
  onlyOnce = yes(*kind, "canBeInstantiatedOnlyOncePerProcess");
  events = version == 3 && yes(*kind, "hasEventMode");
  if (yes(*kind, "needsExecutionTool")) fail("it needs the program that wrote it");
  if (const XmlNode* experiment = child(root, "DefaultExperiment"))
    stepSize = number(*experiment, "stepSize", 0.0);
  if (const XmlNode* list = child(root, "ModelVariables"))
    for (const XmlNode& e : list->children) add(e);
  library = libraryOf(*this);
  if (!fs::exists(library))
    fail("it has no library for this machine (" +
         library.lexically_relative(folder).generic_string() + ')');
}

void FmuFile::add(const XmlNode& e) {
  const XmlNode* typed = &e;
  if (version == 2) typed = e.children.empty() ? nullptr : &e.children.front();
  FmuVariable v{.name = text(e, "name"),
                .causality = text(e, "causality", "local"),
                .reference = number(e, "valueReference", std::uint32_t{0})};
  const std::string tag = typed != nullptr ? typed->tag : "";
  if (tag == "Clock") {
    // Others are triggered, by the FMU or by programs with clocks of their own.
    if (const std::string when = text(e, "intervalVariability");
        v.causality == "input" && (when == "constant" || when == "fixed"))
      clocks.push_back(clockOf(e, v.reference));
    return;
  }
  const std::optional<FmuType> type = typeOf(tag);
  if (type && child(e, "Dimension") == nullptr) {
    v.type = version == 2 && *type == FmuType::int64 ? FmuType::int32 : *type;
    variables.push_back(std::move(v));
  } else if (v.causality == "input" || v.causality == "output") {
    left.push_back(v.name);
  }
}

const FmuVariable* FmuFile::find(std::string_view name, std::string_view causality) const {
  const auto at = std::find_if(variables.begin(), variables.end(), [&](const FmuVariable& v) {
    return v.name == name && v.causality == causality;
  });
  return at == variables.end() ? nullptr : &*at;
}

std::vector<std::string> FmuFile::names(std::string_view causality) const {
  std::vector<std::string> out;
  for (const FmuVariable& v : variables)
    if (v.causality == causality) out.push_back(v.name);
  return out;
}

}  // namespace dynamy
