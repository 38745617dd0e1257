#include "live/loopback_server.hpp"

#include <fmt/format.h>
#include <sys/random.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <list>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <utility>

namespace dynamy::app {
namespace http = boost::beast::http;
using boost::asio::ip::tcp;

namespace {

constexpr std::size_t kMostConnections = 16;
constexpr std::uint32_t kMostHead = 8192;
constexpr std::uint64_t kMostBody = 4096;
constexpr std::chrono::seconds kMostWait{30};
/// The page may run the script that it contains and load nothing from elsewhere.
constexpr const char* kPolicy =
    "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data: "
    "blob:; connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

using HttpRequest = http::request<http::string_body>;

std::string randomToken() {
  std::array<unsigned char, 16> bytes{};
  if (::getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
    throw std::runtime_error("the system gives no random numbers");
  std::string out;
  for (const unsigned char b : bytes) out += fmt::format("{:02x}", b);
  return out;
}

/// Compares without a hint, by its duration, at how much of the token was right.
bool isSame(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  unsigned differs = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    differs |= static_cast<unsigned char>(a[i]) ^ static_cast<unsigned char>(b[i]);
  return differs == 0;
}

std::string_view textOf(boost::beast::string_view text) { return {text.data(), text.size()}; }

WebAnswer refusal(unsigned status, const std::string& text) {
  return {status, "text/plain; charset=utf-8", text + '\n'};
}

}  // namespace

std::string_view queryValue(std::string_view query, std::string_view name) {
  while (!query.empty()) {
    const std::size_t end = std::min(query.find('&'), query.size());
    const std::string_view part = query.substr(0, end);
    if (part.size() > name.size() && part.starts_with(name) && part[name.size()] == '=')
      return part.substr(name.size() + 1);
    query.remove_prefix(std::min(end + 1, query.size()));
  }
  return {};
}

struct LoopbackServer::Inside {
  std::function<WebAnswer(const WebRequest&)> answer;
  std::string token = randomToken(), address;
  std::array<std::string, 2> hosts;
  boost::asio::io_context accepting;
  tcp::acceptor acceptor{accepting};
  std::mutex guard;  // of the four below
  bool closing = false;
  std::list<int> sockets;
  std::list<std::thread> threads;  // of the connections
  std::thread ended;               // the one that ended last; the next one to end joins it
  std::thread listener;

  void open();
  void listen();
  void serve(int number);
  void leave();
  std::thread anyThread();
  bool exchange(boost::beast::tcp_stream& stream, boost::asio::io_context& io);
  WebAnswer answered(const HttpRequest& request) const;
};

void LoopbackServer::Inside::open() {
  const tcp::endpoint at(boost::asio::ip::address_v4::loopback(), 0);
  boost::system::error_code error;
  acceptor.open(at.protocol(), error);
  if (!error) acceptor.bind(at, error);
  if (!error) acceptor.listen(boost::asio::socket_base::max_listen_connections, error);
  if (error) throw std::runtime_error("cannot listen on 127.0.0.1: " + error.message());
  const std::string port = std::to_string(acceptor.local_endpoint().port());
  hosts = {"127.0.0.1:" + port, "localhost:" + port};
  address = "http://" + hosts[0] + '/' + token + '/';
  listener = std::thread([this] { listen(); });
}

void LoopbackServer::Inside::listen() {
  for (;;) {
    boost::system::error_code error;
    tcp::socket socket(accepting);
    acceptor.accept(socket, error);
    const std::lock_guard lock(guard);
    if (closing) return;
    if (error || sockets.size() >= kMostConnections) {
      if (error) std::this_thread::sleep_for(std::chrono::milliseconds(50));
      continue;  // closed by its destructor
    }
    const int number = ::dup(socket.native_handle());
    if (number < 0) continue;
    sockets.push_back(number);
    socket.close(error);
    threads.emplace_back([this, number] {
      serve(number);
      leave();
    });
  }
}

/// One connection, to its end.
void LoopbackServer::Inside::serve(int number) {
  boost::asio::io_context io;
  boost::system::error_code failed;
  boost::beast::tcp_stream stream(io);
  stream.socket().assign(tcp::v4(), number, failed);
  try {
    while (!failed && exchange(stream, io)) {
    }
  } catch (const std::exception&) {  // of one connection: the others go on
  }
  const std::lock_guard lock(guard);
  sockets.remove(number);
  stream.socket().close(failed);
}

/// The last call of a connection's thread, which cannot join itself: it joins the one that ended before
/// and waits for the next. So at most one ended thread keeps its stack, however long a run is watched.
void LoopbackServer::Inside::leave() {
  std::thread before;
  {
    const std::lock_guard lock(guard);
    const auto self = std::find_if(threads.begin(), threads.end(), [](const std::thread& t) {
      return t.get_id() == std::this_thread::get_id();
    });
    if (self == threads.end()) return;  // the destructor waits for this one
    before = std::exchange(ended, std::move(*self));
    threads.erase(self);
  }
  if (before.joinable()) before.join();
}

/// A thread that is to be joined; none: all are.
std::thread LoopbackServer::Inside::anyThread() {
  const std::lock_guard lock(guard);
  if (threads.empty()) return std::exchange(ended, std::thread());
  std::thread out = std::move(threads.front());
  threads.pop_front();
  return out;
}

/// Reads one request and answers it. False: the connection is at its end.
bool LoopbackServer::Inside::exchange(boost::beast::tcp_stream& stream,
                                      boost::asio::io_context& io) {
  boost::beast::flat_buffer buffer;
  http::request_parser<http::string_body> parser;
  parser.header_limit(kMostHead), parser.body_limit(kMostBody);
  boost::system::error_code error;
  const auto wait = [&] { io.restart(), io.run(); };
  stream.expires_after(kMostWait);
  http::async_read(stream, buffer, parser, [&](auto e, std::size_t) { error = e; });
  wait();
  if (error == http::error::end_of_stream || error == boost::beast::error::timeout) return false;
  const bool unread = static_cast<bool>(error);  // too long, or no HTTP
  WebAnswer a =
      unread ? refusal(400, "this is no request that dynamY reads") : answered(parser.get());
  http::response<http::string_body> response{static_cast<http::status>(a.status), 11};
  response.set(http::field::content_type, a.type);
  response.set(http::field::cache_control, "no-store");
  response.set("Content-Security-Policy", kPolicy);
  response.set("X-Content-Type-Options", "nosniff");
  response.set("X-Frame-Options", "DENY");
  response.set("Referrer-Policy", "no-referrer");
  response.set("Cross-Origin-Resource-Policy", "same-origin");
  response.body() = std::move(a.body);
  response.keep_alive(!unread && parser.get().keep_alive());
  response.prepare_payload();
  stream.expires_after(kMostWait);
  error = {};
  http::async_write(stream, response, [&](auto e, std::size_t) { error = e; });
  wait();
  return !error && response.keep_alive();
}

WebAnswer LoopbackServer::Inside::answered(const HttpRequest& request) const {
  const std::string_view host = textOf(request[http::field::host]);
  const std::string_view origin = textOf(request[http::field::origin]);
  const bool post = request.method() == http::verb::post;
  if (std::find(hosts.begin(), hosts.end(), host) == hosts.end())
    return refusal(403, "this server answers requests to 127.0.0.1 only");
  const bool ours = std::any_of(hosts.begin(), hosts.end(),
                                [&](const std::string& h) { return origin == "http://" + h; });
  if (origin.empty() ? post : !ours) return refusal(403, "this request comes from another page");
  if (!post && request.method() != http::verb::get) return refusal(405, "only GET and POST");
  std::string_view target = textOf(request.target());
  const std::size_t end = target.find('/', 1);
  if (!target.starts_with('/') || end == std::string_view::npos ||
      !isSame(target.substr(1, end - 1), token))
    return refusal(403, "the address lacks the token that dynamY printed");
  target.remove_prefix(end + 1);
  const std::size_t mark = std::min(target.find('?'), target.size());
  WebRequest asked;
  asked.post = post, asked.path = target.substr(0, mark);
  asked.query = target.substr(std::min(mark + 1, target.size()));
  asked.body = request.body();
  return answer(asked);
}

LoopbackServer::LoopbackServer(std::function<WebAnswer(const WebRequest&)> answer)
    : inside_(std::make_unique<Inside>()) {
  inside_->answer = std::move(answer);
  inside_->open();
}

LoopbackServer::~LoopbackServer() {
  {
    const std::lock_guard lock(inside_->guard);
    inside_->closing = true;
    for (const int socket : inside_->sockets)
      ::shutdown(socket, SHUT_RD);  // answers are still written
  }
  ::shutdown(inside_->acceptor.native_handle(), SHUT_RDWR);
  inside_->listener.join();
  for (std::thread t = inside_->anyThread(); t.joinable(); t = inside_->anyThread()) t.join();
}

const std::string& LoopbackServer::address() const { return inside_->address; }

}  // namespace dynamy::app
