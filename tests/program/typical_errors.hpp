#pragma once
/// \file
/// A small model, changes that make it wrong, and calls that are wrong: each message has to begin
/// with the place and to hold the words of cause and remedy.
#include <gtest/gtest.h>

#include <program/program_fixture.hpp>
#include <string>
#include <vector>

namespace dynamy {

inline const std::string kTypicalModel =
    R"(<dynamy version="1">
  <parameter name="mu" value="0.3" min="0"/>
  <systems>
    <Ground name="floor"><HalfSpace name="plane" normal="0 0 1" material="steel"/></Ground>
    <RigidBody name="block" position="0 0 0.5">
      <Box size="1 1 1" mass="2" material="steel"/>
    </RigidBody>
  </systems>
  <forces><Gravity acceleration="0 0 -9.81"/></forces>
  <elements>
    <Contact between="steel steel"><UnilateralCoulomb epsilonN="0" mu="{mu}"/></Contact>
  </elements>
  <simulation until="0.1" step="1e-3"/>
  <record signals="block.z" every="10ms"/>
</dynamy>
)";

/// A change of the model, the place of its error and words of the message.
struct WrongModel {
  std::string from, to, place, cause, remedy;
};

/// A call of the program, its status and words of the message.
struct WrongCall {
  std::string words;
  int status;
  std::string cause, remedy;
};

class TypicalErrorsTest : public ProgramTest {
 protected:
  void expectRefused(const std::vector<WrongModel>& models) {
    for (const WrongModel& wrong : models) {
      std::string model = kTypicalModel;
      const std::size_t at = model.find(wrong.from);
      ASSERT_NE(at, std::string::npos) << wrong.from;
      model.replace(at, wrong.from.size(), wrong.to);
      if (wrong.to.find("<Body ") == 0) model.replace(model.find("</RigidBody>"), 12, "</Body>");
      if (wrong.to.ends_with("<!--")) model += "-->";
      write("m.xml", model);
      EXPECT_EQ(call("check m.xml"), 2) << wrong.to;
      const std::string message = err();
      EXPECT_TRUE(message.starts_with("m.xml:" + wrong.place + ": error: ")) << wrong.place << '\n'
                                                                             << message;
      EXPECT_NE(message.find(wrong.cause), std::string::npos) << wrong.cause << '\n' << message;
      EXPECT_NE(message.find(wrong.remedy), std::string::npos) << wrong.remedy << '\n' << message;
    }
  }

  void expectRefused(const std::vector<WrongCall>& calls) {
    for (const WrongCall& wrong : calls) {
      EXPECT_EQ(call(wrong.words), wrong.status) << wrong.words;
      const std::string message = err() + out();
      EXPECT_NE(message.find(wrong.cause), std::string::npos) << wrong.words << '\n' << message;
      EXPECT_NE(message.find(wrong.remedy), std::string::npos) << wrong.words << '\n' << message;
    }
  }
};

}  // namespace dynamy
