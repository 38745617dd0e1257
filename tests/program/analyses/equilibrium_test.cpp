// dynamy equilibrium: text, file, ranges, messages.
#include <program/program_fixture.hpp>

namespace dynamy {
namespace {

using EquilibriumCommand = ProgramTest;

const char* const kBlock = R"x(<dynamy version="1">
  <parameter name="mu" value="0.5"/>
  <parameter name="v" value="0"/>
  <systems>
    <PointMass name="block" plane="xz" mass="2" velocity="{v} 0 0"><Point material="block"/></PointMass>
    <Ground name="hill"><HalfSpace normal="{-sin(20deg)} 0 {cos(20deg)}" material="slope"/></Ground>
  </systems>
  <forces><Gravity/></forces>
  <elements><Contact between="block slope"><UnilateralCoulomb mu="{mu}"/></Contact></elements>
  <simulation until="1" step="1e-3"/>
</dynamy>
)x";

TEST_F(EquilibriumCommand, PrintsAndWritesTheRestAndItsRange) {
  write("m.xml", kBlock);
  ASSERT_EQ(call("equilibrium m.xml --range mu=0.1:0.9"), 0) << err();
  for (const char* text :
       {"m.xml: rest, u' = 0", "at the start of the model", "block.x", "sticks, force 18.4367",
        "rests for mu from 0.36397023", "to 0.9\n", "below: ", "at the bound of its law"})
    EXPECT_NE(out().find(text), std::string::npos) << text << '\n' << out();
  const std::string file = readWholeFile(path("runs/m.equilibrium/equilibrium.json"));
  for (const char* text : {"\"kind\": \"rest\"", "\"block.x\"", "\"status\": \"sticks\"",
                           "\"parameter\": \"mu\"", "\"endsTo\": \"\""})
    EXPECT_NE(file.find(text), std::string::npos) << text << '\n' << file;
}

TEST_F(EquilibriumCommand, TellsWhyThereIsNoneAndWhereThereWouldBe) {
  write("m.xml", kBlock);
  EXPECT_EQ(call("equilibrium m.xml --set mu=0.2"), 2);
  for (const char* text : {"no rest found: at the start block-hill", "N beyond its law"})
    EXPECT_NE(err().find(text), std::string::npos) << text << '\n' << err();
  ASSERT_EQ(call("equilibrium m.xml --set mu=0.2 --range mu=0.1:0.9"), 0) << err();
  EXPECT_NE(out().find("no rest with the model's own values"), std::string::npos) << out();
  EXPECT_NE(out().find("rests for mu from 0.36397"), std::string::npos) << out();
  EXPECT_EQ(call("equilibrium m.xml --range mu=0.01:0.05"), 0) << err();
  EXPECT_NE(out().find("no rest at the start of the model for mu from 0.01"), std::string::npos)
      << out();
  EXPECT_EQ(call("equilibrium m.xml --range my=0.1:0.9"), 2);
  EXPECT_NE(err().find("mu"), std::string::npos) << err();
}

TEST_F(EquilibriumCommand, ARestIsSoughtFromAMotionOnlyIfItIsAskedFor) {
  write("m.xml", kBlock);
  EXPECT_EQ(call("equilibrium m.xml --set v=0.3"), 2);
  EXPECT_NE(err().find("no steady motion near the start"), std::string::npos) << err();
  EXPECT_EQ(call("equilibrium m.xml --set v=0.3 --rest"), 0) << err();
}

}  // namespace
}  // namespace dynamy
