// Which systems elements act on.
#include <gtest/gtest.h>

#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/system/connections.hpp>

namespace dynamy {
namespace {

class Link final : public Element {
 public:
  explicit Link(const std::string& name) : Element(Parameters::of<Link>("Link", name, {})) {}
  static void declare(Attributes&) {}
};

struct Linked {
  Linked() {
    connections.begin(&ab), connections.note(1), connections.note(0), connections.note(1);
    connections.begin(&bc), connections.note(1), connections.note(2);
    connections.begin(&shapes), connections.noteShapes();
    connections.begin(nullptr), connections.note(2), connections.noteShapes();
  }
  Link ab{"ab"}, bc{"bc"}, shapes{"shapes"};
  Connections connections;
};

TEST(Connections, NotesEachSystemOnceAndOnlyForTheElementThatIsConnected) {
  const Linked s;
  ASSERT_EQ(s.connections.list().size(), 3u);
  EXPECT_EQ(s.connections.list()[0].element, &s.ab);
  EXPECT_EQ(s.connections.list()[0].systems, (std::vector<int>{0, 1}));
  EXPECT_EQ(s.connections.list()[1].systems, (std::vector<int>{1, 2}));
  EXPECT_FALSE(s.connections.list()[1].shapes);
  EXPECT_TRUE(s.connections.list()[2].shapes);
}

}  // namespace
}  // namespace dynamy
