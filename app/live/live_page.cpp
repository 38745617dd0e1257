#include "live/live_page.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <dynamy/io/files/file_error.hpp>
#include <dynamy/io/replay/replay_page.hpp>
#include <dynamy/io/run_files/model_scene.hpp>

#include "shell_text.hpp"

namespace dynamy::app {

std::string livePage(const DrivenRun& run) {
  Frames frames;
  JsonWriter json(frames.scene);
  const Scene scene = modelScene(run.model());
  write(json, scene);
  frames.poses = scene.frames.size();
  SignalTable signals;
  for (const SignalName& s : recordedSignals(run.model()))
    signals.signals.push_back(s), signals.columns.emplace_back();
  ReplayText text;
  text.title = run.model().title;
  text.modelName = "model.xml", text.modelText = run.model().file.text;
  std::string page = replayPage(frames, signals, text);
  const std::string body = "<body";
  page.insert(page.find(body) + body.size(),
              fmt::format(" data-until=\"{}\" data-live=\"feed\"", run.choice().until));
  return page;
}

LiveDoor::LiveDoor(const RunFolder& folder, const std::string& address)
    : file_(folder.path() / "live.html") {
  std::error_code ignored;
  std::filesystem::remove(file_, ignored);
  const int file = ::open(file_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  const std::string text =
      "<!DOCTYPE html><meta charset=\"utf-8\"><meta name=\"referrer\" "
      "content=\"no-referrer\"><meta http-equiv=\"refresh\" content=\"0;url=" +
      address + "\"><title>dynamY</title>\n";
  const bool written =
      file >= 0 && ::write(file, text.data(), text.size()) == static_cast<ssize_t>(text.size());
  if (file >= 0) ::close(file);
  if (!written) throw WriteError(file_.string(), "cannot be written");
}

LiveDoor::~LiveDoor() {
  std::error_code ignored;
  std::filesystem::remove(file_, ignored);
}

bool LiveDoor::open() const {
  const std::string page = std::filesystem::absolute(file_).lexically_normal().string();
  const std::string command = "xdg-open " + shellQuoted(page) + " >/dev/null 2>&1";
  return std::system(command.c_str()) == 0;
}

}  // namespace dynamy::app
