/// The command line, words separated by zero bytes: it is parsed, or refused with a
/// CLI::ParseError. No command is carried out. Each word is also read as a time, as an assignment
/// and as a scheme.
#include <CLI/CLI.hpp>
#include <commands.hpp>
#include <cstdint>
#include <string>
#include <vector>

namespace {

using namespace dynamy;

void doNothing(CLI::App& app) {
  for (CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; })) {
    sub->callback([] {});
    doNothing(*sub);
  }
}

void parse(std::vector<std::string> words) {
  dynamy::app::Program program;
  CLI::App app{"dynamY", "dynamy"};
  dynamy::app::addCommands(app, program);
  doNothing(app);
  try {
    std::reverse(words.begin(), words.end());  // as CLI11 wants a vector
    app.parse(words);
  } catch (const CLI::ParseError&) {
  }
}

template <class Call>
void tried(const Call& call) {
  try {
    call();
  } catch (const CLI::ParseError&) {
  } catch (const ModelError&) {
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string all(reinterpret_cast<const char*>(data), size);
  std::vector<std::string> words;
  for (std::size_t begin = 0; begin <= all.size();) {
    const std::size_t end = std::min(all.find('\0', begin), all.size());
    words.push_back(all.substr(begin, end - begin));
    begin = end + 1;
  }
  parse(words);
  static const Registry registry = [] {
    Registry r;
    registerFramework(r);
    return r;
  }();
  for (const std::string& word : words) {
    tried([&] { dynamy::app::seconds(word, "--until"); });
    tried([&] { dynamy::app::assignment(word); });
    tried([&] { dynamy::app::methodElement(registry, word, Kind::scheme); });
  }
  return 0;
}
