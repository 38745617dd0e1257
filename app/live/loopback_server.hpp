/// LoopbackServer: HTTP for one browser of the same person on the same machine.
///
/// It listens on 127.0.0.1 only, at a port that the system chooses. A request is answered if
///   its path begins with the token, 128 random bits in hexadecimal digits;
///   its Host is 127.0.0.1:PORT or localhost:PORT, which keeps names away that an attacker binds to
///     127.0.0.1;
///   its Origin, which browsers add to requests of pages and which every POST must have, is that of
///     the server, which keeps pages of other sites away.
/// Heads are limited to 8 kB, bodies to 4 kB, connections to 16, a request to 30 s. Boost.Beast reads
/// and writes the messages. Rejected: a file or a pipe in the place of the token, which a browser
/// cannot read.
#pragma once
#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace dynamy::app {

struct WebRequest {
  bool post = false;
  std::string_view path;   ///< behind the token and its slash, without the query
  std::string_view query;  ///< behind the question mark
  std::string_view body;
};

struct WebAnswer {
  unsigned status = 200;
  std::string type = "application/octet-stream";
  std::string body;
};

class LoopbackServer {
 public:
  /// Calls of `answer` come from several threads. Throws std::runtime_error if no port is free.
  explicit LoopbackServer(std::function<WebAnswer(const WebRequest&)> answer);
  /// Ends all connections; calls of `answer` that are under way end first.
  ~LoopbackServer();
  LoopbackServer(const LoopbackServer&) = delete;
  LoopbackServer& operator=(const LoopbackServer&) = delete;
  /// "http://127.0.0.1:PORT/TOKEN/"
  const std::string& address() const;

 private:
  struct Inside;  // keeps Boost out of this header
  std::unique_ptr<Inside> inside_;
};

/// Value of a name in "a=1&b=2"; "": it is not there.
std::string_view queryValue(std::string_view query, std::string_view name);

}  // namespace dynamy::app
