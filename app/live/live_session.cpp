#include "live/live_session.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <dynamy/io/files/file_error.hpp>
#include <dynamy/io/files/json_reader.hpp>
#include <dynamy/io/files/json_writer.hpp>
#include <dynamy/io/files/output_file.hpp>
#include <fstream>

namespace dynamy::app {
namespace {

constexpr std::chrono::milliseconds kLongestPoll{400};
constexpr std::chrono::seconds kLongestAnswer{20};
constexpr std::uint64_t kMostBytes = 4'000'000;  // of a file in one answer
constexpr std::size_t kMostValues = 16, kMostCommands = 200;

/// Bytes of a file from `from` on, at most kMostBytes; nothing if it is not there.
std::string growthOf(const std::filesystem::path& file, std::uint64_t from) {
  std::error_code error;
  const std::uint64_t size = std::filesystem::file_size(file, error);
  if (error || size <= from) return {};
  std::ifstream in(file, std::ios::binary);
  in.seekg(static_cast<std::streamoff>(from));
  std::string out(std::min(size - from, kMostBytes), '\0');
  in.read(out.data(), static_cast<std::streamsize>(out.size()));
  out.resize(static_cast<std::size_t>(std::max<std::streamsize>(in.gcount(), 0)));
  return out;
}

std::uint64_t numberOf(std::string_view text) {
  return std::strtoull(std::string(text).c_str(), nullptr, 10);
}

void writeMap(JsonWriter& json, const char* name, const std::map<std::string, double>& map) {
  json.key(name).beginObject();
  for (const auto& [key, value] : map) json.member(key, value);
  json.endObject();
}

WebAnswer asJson(const std::string& error) {
  std::string out;
  JsonWriter json(out);
  json.beginObject().member("error", error).endObject();
  return {200, "application/json", out};
}

}  // namespace

WebAnswer LiveSession::answer(const WebRequest& request) {
  {
    const std::lock_guard lock(guard_);
    asked_ = Clock::now();
  }
  changed_.notify_all();
  if (request.post && request.path == "do") return order(request.body);
  if (request.post && request.path == "bye") {
    const std::lock_guard lock(guard_);
    done_ = true;
    return asJson("");
  }
  if (!request.post && request.path.empty()) return {200, "text/html; charset=utf-8", page_};
  if (!request.post && request.path == "feed") return feed(request.query);
  if (!request.post && request.path == "facts")
    return {200, "application/json", readWholeFile(folder_.facts())};
  return {404, "text/plain; charset=utf-8", "there is no such page\n"};
}

std::string LiveSession::stateText() const {
  std::string out;
  JsonWriter json(out);
  json.beginObject().member("number", number_).member("phase", state_.phase);
  json.member("t", state_.t).member("pace", state_.pace).member("steps", state_.steps);
  json.member("actions", state_.actions).member("end", state_.end);
  writeMap(json, "parameters", state_.parameters), writeMap(json, "inputs", state_.inputs);
  return out;  // the lengths of the files follow
}

/// u32 length of the JSON, the JSON with the length of each part, the parts.
WebAnswer LiveSession::feed(std::string_view query) {
  const std::uint64_t known = numberOf(queryValue(query, "number"));
  std::string text;
  {
    std::unique_lock lock(guard_);
    changed_.wait_for(lock, kLongestPoll, [&] { return number_ != known || closed_; });
    asked_ = Clock::now();
    text = stateText();
  }
  const std::pair<const char*, std::filesystem::path> files[] = {{"signals", folder_.signals()},
                                                                 {"events", folder_.events()},
                                                                 {"ledger", folder_.ledger()},
                                                                 {"frames", folder_.frames()}};
  std::string parts;
  for (const auto& [name, file] : files) {
    const std::string bytes = growthOf(file, numberOf(queryValue(query, name)));
    text += ",\"" + std::string(name) + "\":" + std::to_string(bytes.size());
    parts += bytes;
  }
  text += '}';
  std::string out(4, '\0');
  for (unsigned i = 0; i < 4; ++i) out[i] = static_cast<char>(text.size() >> (8 * i) & 0xff);
  return {200, "application/octet-stream", out + text + parts};
}

WebAnswer LiveSession::order(std::string_view body) {
  auto command = std::make_unique<LiveCommand>();
  try {
    const JsonValue value = readJson(body, "the command");
    command->what = value["do"].text, command->name = value["name"].text;
    for (const JsonValue& x : value["values"].items) command->values.push_back(x.value);
  } catch (const FileError& e) {
    return asJson(e.what());
  }
  if (command->what.empty() || command->values.size() > kMostValues ||
      !std::all_of(command->values.begin(), command->values.end(),
                   [](double x) { return std::isfinite(x); }))
    return asJson("the command is {\"do\": …, \"name\": …, \"values\": [finite numbers]}");
  std::future<std::string> answer = command->answer.get_future();
  {
    const std::lock_guard lock(guard_);
    if (closed_) return asJson("the run has ended");
    if (commands_.size() >= kMostCommands) return asJson("too many commands wait for a long step");
    commands_.push_back(std::move(command));
  }
  commanded_.notify_all();
  if (answer.wait_for(kLongestAnswer) != std::future_status::ready)
    return asJson("a step takes long; the command comes after it");
  return asJson(answer.get());
}

std::unique_ptr<LiveCommand> LiveSession::next(std::chrono::duration<double> wait) {
  std::unique_lock lock(guard_);
  commanded_.wait_for(lock, wait, [&] { return !commands_.empty(); });
  if (commands_.empty()) return nullptr;
  auto out = std::move(commands_.front());
  commands_.pop_front();
  return out;
}

void LiveSession::publish(LiveState state) {
  {
    const std::lock_guard lock(guard_);
    state_ = std::move(state), ++number_;
  }
  changed_.notify_all();
}

bool LiveSession::isWatched(double seconds) const {
  const std::lock_guard lock(guard_);
  return std::chrono::duration<double>(Clock::now() - asked_).count() < seconds;
}

bool LiveSession::isDone() const {
  const std::lock_guard lock(guard_);
  return done_;
}

void LiveSession::close() {
  const std::lock_guard lock(guard_);
  closed_ = true;
  for (const auto& c : commands_) c->answer.set_value("the run has ended");
  commands_.clear();
}

}  // namespace dynamy::app
