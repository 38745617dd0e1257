/// A browser without a window that shows one page and evaluates expressions in it.
///
/// Chromium is driven by its debugging protocol over a pipe: messages of JSON, each ended by a zero
/// byte. Rejected: `--dump-dom`, which ends before the page has coded a film, and a program of Node
/// between, which nobody has who only runs models.
#pragma once
#include <sys/types.h>

#include <dynamy/io/files/json_reader.hpp>
#include <filesystem>
#include <string>

#include "video/temporary_folder.hpp"

namespace dynamy::app {

class Browser {
 public:
  /// Starts Chromium or Chrome; `width`, `height`: of its window [px]. Throws FileError if there is
  /// none in PATH.
  Browser(int width, int height);
  ~Browser();
  Browser(const Browser&) = delete;
  Browser& operator=(const Browser&) = delete;

  /// Opens a page from disk; `part` follows "#" in its address.
  void open(const std::filesystem::path& page, const std::string& part);

  /// The text that an expression of JavaScript has as its value, or will have if it is a promise.
  /// Throws FileError with the error of the page, or if the browser does not answer.
  std::string evaluate(const std::string& expression);

 private:
  JsonValue call(const std::string& method, const std::string& parameters);
  void send(const std::string& message) const;
  std::string receive();

  TemporaryFolder profile_{"dynamy_browser"};
  std::filesystem::path page_;
  std::string session_, unread_;
  pid_t process_ = -1;
  int pipe_ = -1, calls_ = 0;
};

}  // namespace dynamy::app
