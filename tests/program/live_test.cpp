/// dynamy run --live: whom its server answers, what it records, and that --repeat gives the same
/// motion.
#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <dynamy/io/files/json_reader.hpp>
#include <dynamy/io/run_files/signals_file.hpp>
#include <fstream>
#include <program/started_program.hpp>
#include <regex>

namespace dynamy {
namespace {

/// A block that slides on a floor, is pushed by an input, and hangs on a spring.
constexpr const char* kPushedBlock = R"(<dynamy version="1">
  <parameter name="mu" value="0.2"/><parameter name="c" value="50"/><parameter name="n" value="1"/>
  <systems><PlanarBody name="block" position="0 0 0.1"><Box size="0.2 0.2 0.2" mass="1" material="wood"/></PlanarBody>
    <Ground name="world"><HalfSpace normal="0 0 1" material="wood"/></Ground></systems>
  <forces><Gravity/><Input name="push"/><ForceInput on="block" force="push.out; 0; 0"/>
    <SpringDamper between="world block" pointA="-1 0 0.1" stiffness="{c}" length="1"/></forces>
  <elements><Contact between="wood wood"><UnilateralCoulomb mu="{mu}"/></Contact></elements>
  <simulation until="0.4" step="1e-3"/><record signals="block.x block.vx" every="5ms" frames="60Hz"/>
</dynamy>)";

class Live : public StartedProgramTest {
 protected:
  void TearDown() override {
    if (child_ > 0) ::kill(child_, SIGKILL), ended(child_);
    StartedProgramTest::TearDown();
  }
  void startLive(const std::string& model = kPushedBlock) {
    write("block.xml", model);
    child_ = start({"run", "block.xml", "--live", "--no-browser", "--out", "o"});
    std::smatch found;
    for (int i = 0; i < 3000 && port_ == 0 && ::waitpid(child_, nullptr, WNOHANG) == 0; ++i) {
      const std::string said = std::filesystem::exists(path("out")) ? out() : "";
      if (std::regex_search(said, found, std::regex("http://127\\.0\\.0\\.1:(\\d+)/(\\w{32})/")))
        port_ = std::stoi(found[1]), token_ = found[2];
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    ASSERT_NE(port_, 0) << err();
    host_ = "127.0.0.1:" + std::to_string(port_);
  }
  /// What the server says to these bytes; it closes the connection afterwards.
  std::string send(const std::string& bytes) const {
    const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in to{};
    to.sin_family = AF_INET, to.sin_port = htons(static_cast<std::uint16_t>(port_));
    to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    std::string answer;
    if (::connect(socket, reinterpret_cast<sockaddr*>(&to), sizeof to) == 0) {
      ::send(socket, bytes.data(), bytes.size(), MSG_NOSIGNAL);
      char part[4096];
      for (ssize_t n = 0; (n = ::recv(socket, part, sizeof part, 0)) > 0;)
        answer.append(part, static_cast<std::size_t>(n));
    }
    ::close(socket);
    return answer;
  }
  std::string get(const std::string& target, const std::string& host,
                  const std::string& more) const {
    return send("GET " + target + " HTTP/1.1\r\nHost: " + host + "\r\nConnection: close\r\n" +
                more + "\r\n");
  }
  std::string post(const std::string& body, const std::string& origin) const {
    return send("POST /" + token_ + "/do HTTP/1.1\r\nHost: " + host_ + "\r\nConnection: close\r\n" +
                (origin.empty() ? "" : "Origin: " + origin + "\r\n") +
                "Content-Length: " + std::to_string(body.size()) + "\r\n\r\n" + body);
  }
  /// The error of a command; "" if it was carried out.
  std::string command(const std::string& body) const {
    const std::string answer = post(body, "http://" + host_);
    const std::size_t at = answer.find("\r\n\r\n");
    return at == std::string::npos ? answer
                                   : readJson(answer.substr(at + 4), "answer")["error"].text;
  }
  /// Looks at the run until it has ended.
  void watchToTheEnd() const {
    for (int i = 0; i < 3000; ++i)
      if (get("/" + token_ + "/feed?number=0", host_, "").find("\"phase\":\"ended\"") !=
          std::string::npos) {
        send("POST /" + token_ + "/bye HTTP/1.1\r\nHost: " + host_ + "\r\nOrigin: http://" + host_ +
             "\r\nConnection: close\r\nContent-Length: 0\r\n\r\n");
        return;
      }
    FAIL() << "the run does not end";
  }
  JsonValue facts(const std::string& folder) const {
    return readJson(readWholeFile(path(folder + "/run.json")), folder);
  }
  pid_t child_ = -1;
  int port_ = 0;
  std::string token_, host_;
};

bool is(const std::string& answer, int status) {
  return answer.starts_with("HTTP/1.1 " + std::to_string(status));
}

TEST_F(Live, TheServerAnswersOnlyThePageOfItsOwnAddress) {
  startLive();
  EXPECT_EQ(command("{\"do\":\"pause\"}"), "");
  const std::string page = "/" + token_ + "/";
  std::string wrong = token_;
  wrong[31] = wrong[31] == '0' ? '1' : '0';
  EXPECT_TRUE(is(get(page, host_, ""), 200));
  EXPECT_TRUE(is(get(page, "localhost:" + std::to_string(port_), ""), 200));
  EXPECT_TRUE(is(get("/" + wrong + "/", host_, ""), 403));
  EXPECT_TRUE(is(get("/", host_, ""), 403));
  EXPECT_TRUE(is(get("/" + token_, host_, ""), 403));
  EXPECT_TRUE(is(get(page, "evil.example:" + std::to_string(port_), ""), 403));
  EXPECT_TRUE(is(get(page, "127.0.0.1", ""), 403)) << "without the port";
  EXPECT_TRUE(is(get(page, host_, "Origin: https://evil.example\r\n"), 403));
  EXPECT_TRUE(is(get(page, host_, "Origin: null\r\n"), 403));
  EXPECT_TRUE(is(get(page, host_, "Origin: http://" + host_ + "\r\n"), 200));
  EXPECT_TRUE(is(post("{\"do\":\"pause\"}", ""), 403)) << "no page wrote it";
  EXPECT_TRUE(is(post("{\"do\":\"pause\"}", "http://127.0.0.1:1"), 403));
  EXPECT_TRUE(is(post("{\"do\":\"pause\"}", "http://" + host_), 200));
  EXPECT_TRUE(is(get(page + "../run.json", host_, ""), 404));
  EXPECT_TRUE(is(
      send("PUT " + page + " HTTP/1.1\r\nHost: " + host_ + "\r\nConnection: close\r\n\r\n"), 405));
  EXPECT_TRUE(is(post(std::string(5000, ' '), "http://" + host_), 400)) << "too long";
  EXPECT_TRUE(is(send("no HTTP\r\n\r\n"), 400));
  const std::string answer = get(page, host_, "");
  EXPECT_NE(answer.find("Content-Security-Policy: default-src 'none'"), std::string::npos);
  EXPECT_NE(answer.find("Cache-Control: no-store"), std::string::npos);
  // The address for the browser lies in a file that only its owner may read.
  EXPECT_EQ(std::filesystem::status(path("o/live.html")).permissions(),
            std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
}

/// Size of the address space of a process [kB].
long addressSpace(pid_t process) {
  std::ifstream status("/proc/" + std::to_string(process) + "/status");
  for (std::string word; status >> word;)
    if (long size = 0; word == "VmSize:" && status >> size) return size;
  return 0;
}

TEST_F(Live, ConnectionsThatEndedLeaveNoThreadBehind) {
  startLive();
  EXPECT_EQ(command("{\"do\":\"pause\"}"), "");
  const std::string page = "/" + token_ + "/nothing";
  for (int i = 0; i < 50; ++i) get(page, host_, "");
  const long before = addressSpace(child_);
  for (int i = 0; i < 200; ++i) get(page, host_, "");
  // A thread that nobody joined keeps its stack of 8 MB: 200 of them 1.6 GB. Joined ones are used again;
  // 16 connections at a time, and an arena of 64 MB for one of them, may still come.
  EXPECT_GT(before, 0);
  EXPECT_LT(addressSpace(child_) - before, 400'000);
}

TEST_F(Live, CommandsAreCheckedAndRefusedWithAReason) {
  startLive();
  EXPECT_EQ(command("{\"do\":\"pause\"}"), "");
  EXPECT_NE(command("{\"do\":\"fly\"}").find("there is no command \"fly\""), std::string::npos);
  EXPECT_NE(command("[1,").find("the command:1"), std::string::npos);
  EXPECT_NE(command("{\"do\":\"set\",\"name\":\"mu\",\"values\":[null]}").find("finite"),
            std::string::npos);
  EXPECT_NE(command("{\"do\":\"set\",\"name\":\"muh\",\"values\":[1]}").find("mu"),
            std::string::npos);
  EXPECT_NE(command("{\"do\":\"set\",\"name\":\"c\",\"values\":[-1]}").find("stiffness"),
            std::string::npos);
  EXPECT_NE(
      command("{\"do\":\"input\",\"name\":\"pull\",\"values\":[1]}").find("no input is named"),
      std::string::npos);
  EXPECT_NE(command("{\"do\":\"move\",\"values\":[0,0,0]}").find("nothing is held"),
            std::string::npos);
  EXPECT_NE(command("{\"do\":\"grab\",\"values\":[7,0,0,0,0,0,0,1]}").find("does not move"),
            std::string::npos);
  write("block.xml", std::string(kPushedBlock) + "\n");
  EXPECT_NE(command("{\"do\":\"set\",\"name\":\"mu\",\"values\":[0.5]}").find("has changed"),
            std::string::npos);
  EXPECT_NE(command("{\"do\":\"pace\",\"values\":[-1]}").find("0 or above"), std::string::npos);
}

TEST_F(Live, WhatWasDoneIsRecordedAndRepeatedWithTheSameHash) {
  startLive();
  EXPECT_EQ(command("{\"do\":\"pause\"}"), "");
  for (int i = 0; i < 20; ++i) EXPECT_EQ(command("{\"do\":\"step\"}"), "");
  EXPECT_EQ(command("{\"do\":\"input\",\"name\":\"push\",\"values\":[8]}"), "");
  EXPECT_EQ(command("{\"do\":\"set\",\"name\":\"mu\",\"values\":[0.05]}"), "");
  EXPECT_EQ(command("{\"do\":\"set\",\"name\":\"c\",\"values\":[200]}"), "");
  EXPECT_EQ(command("{\"do\":\"grab\",\"values\":[0,0.1,0,0.1,0.1,0,0.2,1]}"), "");
  EXPECT_EQ(command("{\"do\":\"move\",\"values\":[0.4,0,0.6]}"), "");
  EXPECT_EQ(command("{\"do\":\"pace\",\"values\":[0]}"), "");
  EXPECT_EQ(command("{\"do\":\"go\"}"), "");
  watchToTheEnd();
  EXPECT_EQ(ended(std::exchange(child_, -1)), 0) << err();
  EXPECT_FALSE(std::filesystem::exists(path("o/live.html")));
  const JsonValue first = facts("o");
  EXPECT_EQ(first["state"].text, "finished");
  EXPECT_EQ(first["live"]["actions"].value, 5.0);
  // The new stiffness changes V by ½ Δc x², which no force does: it is work of the boundaries. The
  // rest of the ledger is the scheme's own error, of the order of the step.
  EXPECT_LT(std::abs(first["energy"]["discretisation"].value),
            0.02 * first["energy"]["nonPotential"].value);
  EXPECT_EQ(call("run --repeat o"), 0) << err();
  EXPECT_NE(out().find("the same motion as o"), std::string::npos);
  EXPECT_EQ(err().find("another build"), std::string::npos) << err();
  EXPECT_EQ(facts("o_repeated")["hash"].text, first["hash"].text);
  EXPECT_EQ(readWholeFile(path("o_repeated/inputs.csv")), readWholeFile(path("o/inputs.csv")));
  EXPECT_EQ(readWholeFile(path("o_repeated/signals.csv")), readWholeFile(path("o/signals.csv")));

  // Another number at one place is another motion.
  std::string inputs = readWholeFile(path("o/inputs.csv"));
  const std::size_t push = inputs.find("push,8");
  ASSERT_NE(push, std::string::npos) << inputs;
  write("o/inputs.csv", inputs.replace(push, 6, "push,9"));
  EXPECT_EQ(call("run --repeat o --out other"), 1);
  EXPECT_NE(err().find("the motion is not that of o"), std::string::npos);
  // A list for other steps is refused at its line.
  const std::size_t t = inputs.find(",input,");
  write("o/inputs.csv", inputs.replace(t, 7, "1,input,"));
  EXPECT_EQ(call("run --repeat o --out other"), 2);
  EXPECT_NE(err().find("o/inputs.csv:2"), std::string::npos) << err();
}

TEST_F(Live, ARunToAToleranceIsRepeatedAsWell) {
  std::string model = kPushedBlock;
  const std::string step = "step=\"1e-3\"";
  startLive(model.replace(model.find(step), step.size(), "tolerance=\"1e-6\""));
  EXPECT_EQ(command("{\"do\":\"pause\"}"), "");
  for (int i = 0; i < 5; ++i) EXPECT_EQ(command("{\"do\":\"step\"}"), "");
  EXPECT_EQ(command("{\"do\":\"set\",\"name\":\"mu\",\"values\":[0.05]}"), "");
  EXPECT_EQ(command("{\"do\":\"grab\",\"values\":[0,0,0,0,0.3,0,0.1,1]}"), "");
  EXPECT_EQ(command("{\"do\":\"pace\",\"values\":[0]}"), "");
  EXPECT_EQ(command("{\"do\":\"go\"}"), "");
  watchToTheEnd();
  EXPECT_EQ(ended(std::exchange(child_, -1)), 0) << err();
  EXPECT_EQ(call("run --repeat o"), 0) << err();
  EXPECT_EQ(facts("o_repeated")["hash"].text, facts("o")["hash"].text);
}

TEST_F(Live, OtherRunsAreNotRepeatedAndOptionsExcludeEachOther) {
  write("block.xml", kPushedBlock);
  EXPECT_EQ(call("run block.xml --quiet --out plain"), 0);
  EXPECT_EQ(call("run --repeat plain"), 2);
  EXPECT_NE(err().find("dynamy run --live"), std::string::npos) << err();
  EXPECT_EQ(call("run"), 64);
  EXPECT_EQ(call("run block.xml --repeat plain"), 64);
  EXPECT_EQ(call("run block.xml --live --watch"), 64);
  EXPECT_EQ(call("run block.xml --no-browser"), 64);
}

}  // namespace
}  // namespace dynamy
