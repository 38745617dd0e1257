#include "video/browser.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <dynamy/io/files/file_error.hpp>
#include <dynamy/io/files/json_writer.hpp>
#include <sstream>
#include <vector>

#include "../processes.hpp"

namespace dynamy::app {
namespace fs = std::filesystem;
namespace {

constexpr int kLongestAnswer = 120'000;  // [ms]; pictures of 10 000 bodies take seconds

/// The first of these programs in PATH; "" if there is none.
std::string inPath(std::initializer_list<const char*> names) {
  const char* path = std::getenv("PATH");
  for (const char* name : names) {
    std::istringstream folders(path == nullptr ? "" : path);
    for (std::string folder; std::getline(folders, folder, ':');) {
      std::string file = folder + '/' + name;
      if (::access(file.c_str(), X_OK) == 0) return file;
    }
  }
  return {};
}

/// Becomes the browser, whose messages go through `pipe` as the descriptors 3 and 4.
[[noreturn]] void become(std::vector<std::string> words, int pipe) {
  const int kept = ::fcntl(pipe, F_DUPFD, 10), none = ::open("/dev/null", O_RDWR);
  for (const int to : {3, 4}) ::dup2(kept, to);
  for (const int to : {0, 1, 2}) ::dup2(none, to);
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  ::execv(arguments.front(), arguments.data());
  ::_exit(127);
}

std::string object(const std::vector<std::pair<std::string, std::string>>& texts) {
  std::string out;
  JsonWriter json(out);
  json.beginObject();
  for (const auto& [name, text] : texts) json.member(name, text);
  json.endObject();
  return out;
}

}  // namespace

Browser::Browser(int width, int height) {
  const std::string program =
      inPath({"chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome"});
  if (program.empty())
    throw FileError(
        "chromium",
        "a film needs Chromium or Chrome, and neither is in PATH; on Debian: sudo apt-get "
        "install chromium. scripts/animate draws a film without a browser");
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
    throw FileError(program, "no pipe to the browser");
  std::vector<std::string> words{
      program,
      "--headless=new",
      "--remote-debugging-pipe",
      "--user-data-dir=" + profile_.path().string(),
      fmt::format("--window-size={},{}", width, height),
      "--force-device-scale-factor=1",
      "--hide-scrollbars",
      "--no-first-run",
      "--disable-background-networking",
      "--disable-background-timer-throttling",
      "--disable-renderer-backgrounding",
      "--use-angle=swiftshader",  // WebGL on machines without a graphics card
      "--enable-unsafe-swiftshader"};
  if (::geteuid() == 0) words.emplace_back("--no-sandbox");  // Chromium refuses root otherwise
  process_ = startProcess([&]() -> int { become(words, ends[1]); });
  ::close(ends[1]);
  pipe_ = ends[0];
}

Browser::~Browser() {
  if (pipe_ >= 0) ::close(pipe_);  // Chromium ends when its pipe does
  if (process_ > 0) {
    ::kill(-process_, SIGTERM);  // a group of its own: its helpers end, too
    ::waitpid(process_, nullptr, 0);
  }
}

void Browser::send(const std::string& message) const {
  for (std::size_t at = 0; at <= message.size();) {  // with the zero byte at the end
    const ssize_t n = ::send(pipe_, message.c_str() + at, message.size() + 1 - at, MSG_NOSIGNAL);
    if (n <= 0 && errno != EINTR) throw FileError(page_.string(), "the browser ended");
    if (n > 0) at += static_cast<std::size_t>(n);
  }
}

std::string Browser::receive() {
  std::vector<char> bytes(1 << 16);
  for (std::size_t looked = 0;;) {
    const std::size_t end = unread_.find('\0', looked);
    if (end != std::string::npos) {
      std::string message = unread_.substr(0, end);
      unread_.erase(0, end + 1);
      return message;
    }
    looked = unread_.size();
    pollfd wait{.fd = pipe_, .events = POLLIN, .revents = 0};
    const int ready = ::poll(&wait, 1, kLongestAnswer);
    if (ready < 0 && errno == EINTR) continue;
    if (ready == 0) throw FileError(page_.string(), "the browser does not answer");
    const ssize_t n = ::recv(pipe_, bytes.data(), bytes.size(), 0);
    if (n <= 0) throw FileError(page_.string(), "the browser ended before the page was shown");
    unread_.append(bytes.data(), static_cast<std::size_t>(n));
  }
}

JsonValue Browser::call(const std::string& method, const std::string& parameters) {
  const int id = ++calls_;
  send(fmt::format(R"({{"id":{},"method":"{}",{}"params":{}}})", id, method,
                   session_.empty() ? "" : fmt::format(R"("sessionId":"{}",)", session_),
                   parameters));
  for (;;) {  // events of the page come in between
    JsonValue answer = readJson(receive(), "browser");
    if (answer["id"].value != id) continue;
    if (answer["error"]) throw FileError(page_.string(), answer["error"]["message"].text);
    return answer["result"];
  }
}

void Browser::open(const fs::path& page, const std::string& part) {
  page_ = page;
  std::string address = "file://";
  for (const char c : fs::absolute(page).lexically_normal().string()) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '/' || c == '.' ||
                       c == '_' || c == '-';
    address += plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  const JsonValue target = call("Target.createTarget", object({{"url", address + '#' + part}}));
  const JsonValue attached =
      call("Target.attachToTarget",
           fmt::format(R"({{"targetId":"{}","flatten":true}})", target["targetId"].text));
  session_ = attached["sessionId"].text;
}

std::string Browser::evaluate(const std::string& expression) {
  std::string text;
  JsonWriter json(text);
  json.beginObject().member("expression", "(async () => String(await (" + expression + ")))()");
  json.member("awaitPromise", true).member("returnByValue", true).endObject();
  const JsonValue answer = call("Runtime.evaluate", text);
  if (answer["exceptionDetails"]) {
    const JsonValue& details = answer["exceptionDetails"];
    std::string what = details["exception"]["description"].text;
    throw FileError(page_.string(), "in the browser: " + what.substr(0, what.find('\n')));
  }
  return answer["result"]["value"].text;
}

}  // namespace dynamy::app
