#include <dynamy/core/archive.hpp>
#include <dynamy/core/error.hpp>

namespace dynamy {

void Archive::word(std::uint64_t& bits) {
  if (!reading_) {
    for (int i = 0; i < 8; ++i) bytes_ += static_cast<char>((bits >> (8 * i)) & 0xffu);
    return;
  }
  if (bytes_.size() - at_ < 8) throw ModelError("the checkpoint is cut off");
  bits = 0;
  for (int i = 0; i < 8; ++i)
    bits |= static_cast<std::uint64_t>(static_cast<unsigned char>(bytes_[at_++])) << (8 * i);
}

std::size_t Archive::checkedSize(std::uint64_t n) const {
  // Every entry takes at least a word.
  if (n > (bytes_.size() - at_) / 8) throw ModelError("the checkpoint is cut off");
  return static_cast<std::size_t>(n);
}

void Archive::operator()(std::string& text) {
  std::uint64_t n = text.size();
  word(n);
  if (!reading_) {
    bytes_ += text;
    return;
  }
  if (n > bytes_.size() - at_) throw ModelError("the checkpoint is cut off");
  const auto size = static_cast<std::size_t>(n);
  text.assign(bytes_, at_, size);
  at_ += size;
}

void Archive::operator()(Eigen::VectorXd& v) {
  auto n = static_cast<std::uint64_t>(v.size());
  word(n);
  if (reading_) v.resize(static_cast<Eigen::Index>(checkedSize(n)));
  for (Eigen::Index i = 0; i < v.size(); ++i) (*this)(v[i]);
}

void Archive::section(const char* name) {
  std::string text = name;
  (*this)(text);
  if (text != name)
    throw ModelError("the checkpoint belongs to another model or version: found \"" + text +
                     "\" where \"" + name + "\" was expected");
}

}  // namespace dynamy
