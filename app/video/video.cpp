#include "video/video.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/io/files/file_error.hpp>
#include <dynamy/io/files/output_file.hpp>
#include <map>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "run/progress.hpp"
#include "shell_text.hpp"
#include "video/browser.hpp"
#include "video/temporary_folder.hpp"

namespace dynamy::app {
namespace fs = std::filesystem;
namespace {

std::string endingOf(const VideoChoice& choice) {
  return fs::path(choice.file).extension().string();
}

std::string fromBase64(std::string_view text) {
  std::string out;
  unsigned held = 0, bits = 0;
  for (const char c : text) {
    const std::size_t x =
        std::string_view("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/")
            .find(c);
    if (x == std::string_view::npos) continue;
    held = held << 6 | static_cast<unsigned>(x), bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    out += static_cast<char>(held >> bits & 0xff);
  }
  return out;
}

/// The share of the film that is done, and how long the rest takes.
class Making {
 public:
  void tell(double share) {
    if (!line_.due()) return;
    const double passed = line_.seconds();
    line_.show(share,
               fmt::format("of the film{}",
                           share > 0 ? ", " + durationText(passed / share - passed) + " to go"
                                     : std::string()));
  }
  void end() { line_.end(); }

 private:
  StatusLine line_{false};
};

/// Shows the page until its script has read the run.
void openReplay(Browser& browser, const fs::path& replay, const std::string& look) {
  using namespace std::chrono_literals;
  constexpr int kMostLooks = 1200;  // a minute
  browser.open(replay, look);
  for (int i = 0; i < kMostLooks; ++i) {
    const std::string state = browser.evaluate(
        "window.replay ? 'ready' : document.getElementById('wait')?.textContent ?? ''");
    if (state == "ready") return;
    if (state.starts_with("This page cannot")) throw FileError(replay.string(), state);
    std::this_thread::sleep_for(50ms);
  }
  throw FileError(replay.string(), "the page was not shown within a minute");
}

/// Begins a film; the number of its pictures. Throws CLI::ValidationError for times beyond the run.
int begin(Browser& browser, const VideoChoice& choice) {
  const double first = std::atof(browser.evaluate("String(window.replay.begin)").c_str());
  const double last = std::atof(browser.evaluate("String(window.replay.end)").c_str());
  const double hair = 1e-9 * last;  // of times that are written in a few digits
  for (const auto& [name, t] : {std::pair("--from", choice.from), {"--to", choice.to}})
    if (t && !(*t >= first - hair && *t <= last + hair))
      throw CLI::ValidationError(
          name, fmt::format("the run shows {:g} to {:g} s, and not {:g} s", first, last, *t));
  if (choice.from.value_or(first) > choice.to.value_or(last))
    throw CLI::ValidationError("--from", "the film would end before it begins");
  std::string what =
      fmt::format("width: {}, height: {}, fps: {}", choice.width, choice.height, choice.fps);
  if (choice.slower) what += fmt::format(", slower: {}", *choice.slower);
  if (choice.from) what += fmt::format(", from: {}", *choice.from);
  if (choice.to) what += fmt::format(", to: {}", *choice.to);
  return std::atoi(browser.evaluate("window.replay.studio.begin({" + what + "})").c_str());
}

/// A film that the page codes by itself.
std::string coded(Browser& browser, const std::string& kind, Making& making) {
  using namespace std::chrono_literals;
  constexpr std::size_t kSlice = 8'000'000;
  browser.evaluate("void (window.made = null, window.wrong = '', window.replay.studio.file('" +
                   kind +
                   "').then(x => { window.made = x; }, e => { window.wrong = String(e); }))");
  for (;;) {
    const std::string state = browser.evaluate(
        "window.wrong || (window.made === null ? String(window.replay.studio.share) : 'made')");
    if (state == "made") break;
    char* end = nullptr;
    const double share = std::strtod(state.c_str(), &end);
    if (*end != '\0') throw FileError(kind, "the browser cannot make the film: " + state);
    making.tell(share);
    std::this_thread::sleep_for(100ms);
  }
  std::string out;
  for (std::size_t at = 0;; at += kSlice) {
    const std::string part =
        browser.evaluate(fmt::format("window.made.slice({}, {})", at, at + kSlice));
    if (part.empty()) return fromBase64(out);
    out += part;
  }
}

std::string pictureName(int number) { return fmt::format("{:05d}.png", number); }

/// The pictures as PNG files in a folder that is there.
void writePictures(Browser& browser, int count, const fs::path& folder, Making& making) {
  for (int i = 0; i < count; ++i) {
    writeWholeFile(folder / pictureName(i + 1),
                   fromBase64(browser.evaluate(fmt::format("window.replay.studio.take({})", i))));
    making.tell((i + 1.0) / count);
  }
}

/// Lets ffmpeg make an MP4 of pictures in a temporary folder.
void writeMp4(Browser& browser, int count, const VideoChoice& choice, Making& making) {
  const TemporaryFolder pictures("dynamy_pictures");
  writePictures(browser, count, pictures.path(), making);
  const std::string command = fmt::format(
      "ffmpeg -y -nostdin -loglevel error -framerate {} -i {} -c:v libx264 -pix_fmt yuv420p "
      "-crf 20 {}",
      choice.fps, shellQuoted((pictures.path() / "%05d.png").string()),
      shellQuoted(fs::absolute(choice.file).string()));
  if (std::system(command.c_str()) != 0)
    throw FileError(choice.file, "ffmpeg failed; a .webm or .gif is made without it");
}

/// Makes the folder of the film, or of its pictures. Throws if the film cannot get there: now, and
/// not after minutes.
void prepare(const VideoChoice& choice) {
  const bool pictures = endingOf(choice).empty();
  const fs::path file = choice.file, folder = pictures ? file : file.parent_path();
  std::error_code error;
  if (!pictures && fs::is_directory(file, error))
    throw FileError(file.string(), "is a folder, the film is to be a file; nothing was touched");
  if (pictures && fs::exists(file / pictureName(1), error))
    throw FileError(file.string(), "holds pictures already, " + pictureName(1) +
                                       " and maybe more; nothing was touched: remove them or "
                                       "name another folder");
  if (endingOf(choice) == ".mp4" && std::system("command -v ffmpeg >/dev/null 2>&1") != 0)
    throw FileError(file.string(),
                    "an MP4 needs ffmpeg (on Debian: sudo apt-get install ffmpeg); a .webm or "
                    ".gif needs nothing");
  error.clear();  // of files that are not there
  if (!folder.empty()) fs::create_directories(folder, error);
  if (error) throw WriteError(folder.string(), "cannot create the folder: " + error.message());
}

/// Throws unless the text is a number, of an angle or a time.
void checkNumber(const std::string& name, const std::string& value) {
  char* end = nullptr;
  const double x = std::strtod(value.c_str(), &end);
  if (value.empty() || *end != '\0' || !std::isfinite(x) || (name == "arrows" && x <= 0))
    throw CLI::ValidationError("--look", name + " is a " + (name == "arrows" ? "positive " : "") +
                                             "number, not \"" + value + '"');
}

/// The parts of the address that the page reads, and what some of them may be.
void checkLook(const std::string& look) {
  static const std::map<std::string, std::vector<std::string>> known = {
      {"view", {"xz", "xy", "yz", "iso"}},
      {"theme", {"dark", "light"}},
      {"azimuth", {}},
      {"elevation", {}},
      {"contacts", {"0", "1"}},
      {"arrows", {}},
      {"names", {}},
      {"hide", {}},
      {"trails", {"0", "1"}},
      {"open", {}},
      {"select", {}},
      {"t", {}},
      {"beside", {"0", "1"}},
      {"play", {"0", "1"}},
      {"webgl", {}}};
  for (std::size_t at = 0; at < look.size();) {
    const std::size_t end = std::min(look.find('&', at), look.size());
    const std::string part = look.substr(at, end - at), name = part.substr(0, part.find('='));
    const std::string value = name.size() < part.size() ? part.substr(name.size() + 1) : "";
    std::vector<std::string> names;
    for (const auto& [k, v] : known) names.push_back(k);
    const auto found = known.find(name);
    if (found == known.end())
      throw CLI::ValidationError("--look", "the page has no \"" + name +
                                               "\": " + fmt::format("{}", fmt::join(names, ", ")));
    if (const auto& values = found->second;
        !values.empty() && std::find(values.begin(), values.end(), value) == values.end())
      throw CLI::ValidationError("--look", name + " is one of " +
                                               fmt::format("{}", fmt::join(values, ", ")) +
                                               ", not \"" + value + '"');
    for (const char* number : {"azimuth", "elevation", "t", "arrows"})
      if (name == number) checkNumber(name, value);
    at = end + 1;
  }
}

/// Throws CLI::ValidationError if `look` names a body that the run has not.
void checkBodies(Browser& browser) {
  const std::string unknown = browser.evaluate("window.replay.tools.unknown[0] ?? ''");
  if (unknown.empty()) return;
  std::istringstream names(browser.evaluate("window.replay.tools.names.join('\\n')"));
  std::vector<std::string> known;
  for (std::string name; std::getline(names, name);) known.push_back(name);
  throw CLI::ValidationError(
      "--look", "no body \"" + unknown + "\" in this run — " + unknownNameHint(unknown, known));
}

}  // namespace

void checkVideo(const VideoChoice& choice) {
  checkLook(choice.look);
  const std::string ending = endingOf(choice);
  for (const char* known : {".gif", ".webm", ".mp4", ""})
    if (ending == known) return;
  throw CLI::ValidationError("--video", "no film has the ending \"" + ending +
                                            "\": take .webm, .gif, .mp4, or a folder for pictures "
                                            "(one picture: --from and --to the same time)");
}

void writeVideo(const fs::path& replay, const VideoChoice& choice) {
  const std::string ending = endingOf(choice);
  prepare(choice);
  Browser browser(choice.width, choice.height);
  openReplay(browser, replay, choice.look);
  checkBodies(browser);
  const int count = begin(browser, choice);
  Making making;
  if (ending == ".gif" || ending == ".webm")
    writeWholeFile(choice.file, coded(browser, ending.substr(1), making));
  else if (ending == ".mp4")
    writeMp4(browser, count, choice, making);
  else
    writePictures(browser, count, choice.file, making);
  making.end();
}

}  // namespace dynamy::app
