#include "fmu/fmu_contents.hpp"

#include <array>
#include <dynamy/io/files/file_error.hpp>
#include <dynamy/io/files/json_reader.hpp>
#include <dynamy/io/files/json_writer.hpp>
#include <dynamy/io/files/output_file.hpp>
#include <dynamy/law/set_valued_force_law.hpp>
#include <string_view>

namespace dynamy::fmu {
namespace {

constexpr std::array<std::string_view, 5> kRoles{"time", "parameter", "input", "output", "status"};

Role roleOf(const std::string& word, const std::string& file) {
  for (std::size_t i = 0; i < kRoles.size(); ++i)
    if (word == kRoles[i]) return static_cast<Role>(i);
  throw FileError(file, "\"" + word + "\" is no role of a variable");
}

}  // namespace

std::string FmuContents::json() const {
  std::string out;
  JsonWriter j(out, 2);
  j.beginObject().member("model", model).member("token", token).key("set").beginArray();
  for (const auto& [name, value] : set)
    j.beginObject().member("name", name).member("value", value).endObject();
  j.endArray().key("variables").beginArray();
  for (const Variable& v : variables) {
    j.beginObject().member("role", kRoles[static_cast<std::size_t>(v.role)]);
    j.member("name", v.name).member("source", v.source).member("unit", v.unit);
    j.member("text", v.text).member("start", v.start).endObject();
  }
  j.endArray().endObject();
  return out + '\n';
}

FmuContents FmuContents::read(const std::string& file) {
  const JsonValue json = readJson(readWholeFile(file), file);
  FmuContents out;
  out.model = json["model"].text, out.token = json["token"].text;
  for (const JsonValue& s : json["set"].items)
    out.set.emplace_back(s["name"].text, s["value"].text);
  for (const JsonValue& v : json["variables"].items)
    out.variables.push_back({roleOf(v["role"].text, file), v["name"].text, v["source"].text,
                             v["unit"].text, v["text"].text, v["start"].value});
  if (out.model.empty() || out.variables.empty())
    throw FileError(file, "names no model or no variable");
  return out;
}

bool isStatus(const NamedSignal& signal) {
  return signal.contact >= 0 && signal.name.ends_with(".status");
}

const std::vector<std::string>& statusNames() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (Status s = Status::open; s <= Status::locked;
         s = static_cast<Status>(static_cast<int>(s) + 1))
      all.emplace_back(statusText(s));
    return all;
  }();
  return names;
}

}  // namespace dynamy::fmu
