/// Mutator: wrong models made of right ones. The mutant i of a seed is always the same, so that a
/// campaign can be cut into parts and one mutant be made again.
#pragma once
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace dynamy::fuzz {

class Mutator {
 public:
  /// `texts`: the right models; their names, tags and values are mixed.
  explicit Mutator(const std::vector<std::string>& texts);
  /// `text` with one to three mutations.
  std::string mutate(const std::string& text, std::uint64_t seed, std::uint64_t index);

 private:
  struct Range {
    std::size_t begin = 0, size = 0;
  };
  std::size_t below(std::size_t n);
  const std::string& oneOf(const std::vector<std::string>& all) { return all[below(all.size())]; }
  void mutateOnce(std::string& text);
  void bytes(std::string& text);
  void structure(std::string& text);
  void values(std::string& text);
  Range piece(const std::string& text, const char* first, const char* last);
  Range number(const std::string& text);
  Range name(const std::string& text);
  Range attribute(const std::string& text);
  Range element(const std::string& text);

  std::vector<std::string> words_, tags_;
  std::mt19937_64 random_;
};

}  // namespace dynamy::fuzz
