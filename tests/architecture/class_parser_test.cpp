// The reader of classes, on small texts.
#include "architecture/class_parser.hpp"

#include <gtest/gtest.h>

namespace dynamy::architecture {
namespace {

ClassSize only(std::string_view text) {
  const std::vector<ClassSize> all = classesIn(tokensOf(text));
  EXPECT_EQ(all.size(), 1u);
  return all.empty() ? ClassSize{} : all.front();
}

void expectSize(std::string_view text, int functions, int data) {
  const ClassSize c = only(text);
  EXPECT_EQ(c.functions, functions) << text;
  EXPECT_EQ(c.data, data) << text;
}

}  // namespace

TEST(ClassParser, ReadsWordsAndBrackets) {
  const std::vector<std::string> expected = {"a", "::", "b", "(", "1'000", ")", ";"};
  EXPECT_EQ(tokensOf("a::b(1'000);"), expected);
}

TEST(ClassParser, LeavesOutCommentsStringsAndThePreprocessor) {
  const std::vector<std::string> expected = {"x",    "=", "\"\"", ";", "y",    "=",
                                             "\"\"", ";", "z",    "=", "\"\"", ";"};
  EXPECT_EQ(
      tokensOf("#define A { \\\n {\n// {\nx = \"{\\\"\"; /* { */ y = '{';\nz = R\"a({)\")a\";"),
      expected);
}

TEST(ClassParser, CountsFunctionsAndData) {
  expectSize("class A { public: void f(); int g() const { return a_ > 0 ? 1 : 2; } int a_ = 1; };",
             2, 1);
}

TEST(ClassParser, CountsEachVariableOfADeclaration) {
  expectSize("struct A { int a = 0, b{1}, *c; std::map<int, double> d, e; double f[3] = {1, 2}; };",
             0, 6);
}

TEST(ClassParser, CountsConstructorsAndOperators) {
  expectSize(
      "class A { A() = default; explicit A(int n) : b_{n}, c_(n, n) {} ~A(); "
      "A& operator=(const A&) = delete; bool operator<(const A& o) const { return c_ < o.c_; } "
      "int operator()(int i) const { return i; } int b_, c_; };",
      6, 2);
}

TEST(ClassParser, TakesAFunctionAsMemberForData) {
  expectSize("struct A { std::function<void(int)> f; void (*g)(int); };", 0, 2);
}

TEST(ClassParser, CountsStaticFunctionsButNoStaticData) {
  expectSize("struct A { static constexpr int kMost = 3; static int f(int i = kMost); };", 1, 0);
}

TEST(ClassParser, CountsTemplatesAndLeavesOutTypesAndFriends) {
  expectSize(
      "struct A { using T = int; enum class E { a, b }; friend class B; class C; "
      "template <class F> void f(F&& f) { f(); } };",
      1, 0);
}

TEST(ClassParser, CountsWhatIsDeclaredWithItsType) {
  expectSize("class A { enum class E { a, b } e_ = E::a; };", 0, 1);
}

TEST(ClassParser, CountsAClassInAClassForItself) {
  const auto all = classesIn(tokensOf("class A { struct B { int a; void f(); }; B b_; };"));
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].name, "A");
  EXPECT_EQ(all[0].functions, 0);
  EXPECT_EQ(all[0].data, 1);
  EXPECT_EQ(all[1].name, "B");
  EXPECT_EQ(all[1].functions, 1);
}

TEST(ClassParser, ReadsBasesAndLeavesOutDeclarations) {
  EXPECT_EQ(only("class B; enum class E { a }; template <class T> void f(); "
                 "class alignas(64) A final : public B, private C<int, D> { void f(); };")
                .name,
            "A");
}

TEST(ClassParser, FindsFunctionsDefinedOutsideOfTheirClass) {
  const std::set<std::string> expected = {"A", "B", "C", "D"};
  EXPECT_EQ(classesDefinedOutside(tokensOf(
                "namespace n { namespace { int f(int i) { return X::g(i); } }\n"
                "A::A(int n) : a_(n), b_{n} {} B::~B() = default; bool C::operator<(int) {}\n"
                "std::vector<int> Outer::D::f() const { return {}; } void free() { Y::h(); } }")),
            expected);
}

}  // namespace dynamy::architecture
