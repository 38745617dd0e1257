/// dynamy view DIR: writes replay.html of a run folder anew and opens it in the browser, or makes a
/// film of it.
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cstdio>
#include <cstdlib>
#include <dynamy/io/files/file_error.hpp>
#include <dynamy/io/replay/replay_page.hpp>
#include <dynamy/io/run_files/run_folder.hpp>
#include <filesystem>
#include <memory>

#include "numbers.hpp"
#include "program.hpp"
#include "run/run_text.hpp"
#include "shell_text.hpp"
#include "video/video.hpp"

namespace dynamy::app {
namespace {

struct ViewOptions {
  std::string folder;
  bool noBrowser = false;
  std::string other;
  bool beside = false;
  VideoChoice video;
  std::string size;
};

int view(const ViewOptions& options) {
  const RunFolder folder = RunFolder::existing(options.folder);
  const ReplaySize size = writeReplay(
      folder.path(),
      options.other.empty() ? std::filesystem::path() : RunFolder::existing(options.other).path(),
      options.beside);
  const std::string page = std::filesystem::absolute(folder.replay()).lexically_normal().string();
  fmt::print("{}\n", page);
  fmt::print(stderr, "{}", thinningText(size));
  if (!options.video.file.empty()) {
    VideoChoice choice = options.video;
    if (std::sscanf(options.size.c_str(), "%dx%d", &choice.width, &choice.height) != 2 ||
        choice.width < 16 || choice.height < 16)
      throw CLI::ValidationError("--size", "expects WIDTHxHEIGHT in pixels, is " + options.size);
    choice.width -= choice.width % 2, choice.height -= choice.height % 2;
    writeVideo(folder.replay(), choice);
    if (!options.other.empty()) writeReplay(folder.path());  // a film leaves the page of the run
    fmt::print("{}\n", std::filesystem::absolute(choice.file).lexically_normal().string());
    return kOk;
  }
  if (options.noBrowser) return kOk;
  const std::string command = "xdg-open " + shellQuoted(page) + " >/dev/null 2>&1";
  if (std::system(command.c_str()) != 0)
    fmt::print(stderr, "dynamy: no browser was found; open the page by hand\n");
  return kOk;
}

}  // namespace

void addView(CLI::App& app, Program& program) {
  auto options = std::make_shared<ViewOptions>();
  CLI::App* sub =
      app.add_subcommand("view", "rebuild replay.html of a run and open it; make a film");
  sub->add_option("DIR", options->folder, "run folder, e.g. runs/ball")->required();
  sub->add_flag("--no-browser", options->noBrowser, "only write the page");
  CLI::Option* with = sub->add_option("--with", options->other,
                                      "lay another run over this one, its bodies transparent and "
                                      "its curves dashed")
                          ->type_name("DIR");
  sub->add_flag("--beside", options->beside, "show that run in a picture beside this one")
      ->needs(with);
  VideoChoice& video = options->video;
  CLI::Option* film = sub->add_option("--video", video.file,
                                      "make a film instead: .webm, .gif, .mp4 (by ffmpeg), or a "
                                      "folder of PNG pictures; by Chromium without a window")
                          ->type_name("FILE");
  const auto ofFilm = [&](const std::string& name, auto& value, const std::string& text) {
    return sub->add_option(name, value, text)->needs(film);
  };
  options->size = "960x720";
  ofFilm("--size", options->size, "of the film [px]; default: 960x720")->type_name("WIDTHxHEIGHT");
  ofFilm("--fps", video.fps, "pictures a second; default: 25")
      ->type_name("NUMBER")
      ->check(numberBetween(1.0, 120.0));
  ofFilm("--slower", video.slower, "how many times slower than the mechanism; default: as the page")
      ->type_name("NUMBER")
      ->check(positiveNumber());
  const auto ofRun = [&](const std::string& name, std::optional<double>& value,
                         const std::string& text) {
    sub->add_option_function<std::string>(
           name, [name, &value](const std::string& given) { value = instant(given, name); }, text)
        ->needs(film)
        ->type_name("TIME");
  };
  ofRun("--from", video.from, "start of the film in the run [s]");
  ofRun("--to", video.to, "end of the film in the run [s]");
  ofFilm("--look", video.look, "as behind # in the address of the page: \"view=xz&theme=dark\"")
      ->type_name("TEXT");
  sub->callback([options, &program] {
    if (!options->video.file.empty()) checkVideo(options->video);
    program.exitCode = view(*options);
  });
}

}  // namespace dynamy::app
