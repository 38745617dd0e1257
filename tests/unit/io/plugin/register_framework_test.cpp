#include <gtest/gtest.h>

#include <dynamy/io/model/model_loader.hpp>

namespace dynamy {
namespace {

Registry framework() {
  Registry r;
  registerFramework(r);
  return r;
}

TEST(FrameworkTypes, HaveTextsAndDefaultsThatFitTheirDeclarations) {
  const Registry registry = framework();
  for (const RegisteredType* type : registry.types()) {
    EXPECT_FALSE(type->attributes.aboutText().empty()) << type->name;
    for (const Attribute& a : type->attributes.list()) {
      EXPECT_FALSE(a.text.empty()) << type->name << '.' << a.name;
      if (!a.defaultValue) continue;
      ParameterValue value;
      value.declaration = &a;
      value.text = *a.defaultValue;
      EXPECT_FALSE(readValue(a, value)) << type->name << '.' << a.name;
    }
  }
}

TEST(FrameworkTypes, HaveExamplesThatLoad) {
  Registry registry = framework();
  PluginLoader plugins((std::vector<std::filesystem::path>()));
  for (const RegisteredType* type : registry.types()) {
    const std::string& example = type->attributes.exampleText();
    EXPECT_FALSE(example.empty()) << type->name;
    EXPECT_NO_THROW(
        loadModelText("<dynamy>" + example + "</dynamy>", type->name, registry, plugins))
        << type->name;
  }
}

}  // namespace
}  // namespace dynamy
