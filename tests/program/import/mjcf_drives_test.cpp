/// Drives and keyframes of MJCF: motions in closed form.
#include <program/import/import_fixture.hpp>

namespace dynamy {
namespace {

using MjcfDrivesImport = ImportTest;

/// 1 kg that slides along x without gravity, with these drives and this key "k".
std::string slider(const std::string& drives, const std::string& key,
                   const std::string& classes = "") {
  return "<mujoco>\n<option gravity=\"0 0 0\"/>" + classes +
         "<worldbody><body name=\"b\"><joint name=\"s\" type=\"slide\" axis=\"1 0 0\"/>"
         "<geom size=\".1\" mass=\"1\"/></body></worldbody>\n<actuator>" +
         drives + "</actuator>\n<keyframe><key name=\"k\" " + key + "/></keyframe></mujoco>\n";
}

// Runs have the tolerance 1e-6 for each step; their errors stay below ten of them, because the
// motions last a few periods at most.
constexpr double kNear = 1e-5;

TEST_F(MjcfDrivesImport, APositionServoSwingsAboutItsTarget) {
  // x'' = g kp (u − g x) with g = 2, kp = 4, u = 0.5: about 1/4 with 4 rad/s, after a quarter of a
  // period x = 1/4, after half of it 1/2.
  ASSERT_EQ(import("m.xml",
                   slider("<position name=\"p\" joint=\"s\" kp=\"4\" gear=\"2\"/>", "ctrl=\"0.5\""),
                   "--key k"),
            0)
      << notes_;
  expectChecks();
  EXPECT_NEAR(atEnd("s.displacement", "--until 0.39269908169872414"), 0.25, kNear);
  EXPECT_NEAR(atEnd("s.displacement", "--until 0.78539816339744828"), 0.5, kNear);
}

TEST_F(MjcfDrivesImport, AVelocityServoApproachesItsTarget) {
  // x'' = g kv (u − g x') with g = 2, kv = 3, u = 1: x' = (1 − exp(−12 t))/2.
  ASSERT_EQ(import("m.xml", slider("<velocity joint=\"s\" kv=\"3\" gear=\"2\"/>", "ctrl=\"1\""),
                   "--key k"),
            0)
      << notes_;
  expectChecks();
  const double t = 0.25;
  EXPECT_NEAR(atEnd("s.displacement", "--until 0.25"), 0.5 * t - (1.0 - std::exp(-12.0 * t)) / 24.0,
              kNear);
}

TEST_F(MjcfDrivesImport, KeepsBoundsOfInputsAndForces) {
  // The input 5 is bounded by 2, the force by 1.5 before the gear of 2: x = 3 t²/2. With the bound of
  // the input alone x = 4 t²/2. The bounds come from a class, in the name of another kind of drive.
  const std::string classes =
      "<default><general ctrlrange=\"-2 2\"/><motor gear=\"2\"/></default>\n";
  ASSERT_EQ(
      import("m.xml", slider("<motor joint=\"s\" forcerange=\"-1.5 1.5\"/>", "ctrl=\"5\"", classes),
             "--key k"),
      0)
      << notes_;
  expectChecks();
  EXPECT_NEAR(atEnd("s.displacement", "--until 1"), 1.5, kNear);
  ASSERT_EQ(import("m.xml", slider("<motor joint=\"s\"/>", "ctrl=\"5\"", classes), "--key k"), 0);
  EXPECT_NEAR(atEnd("s.displacement", "--until 1"), 2.0, kNear);
}

TEST_F(MjcfDrivesImport, AGeneralDriveIsAffine) {
  // x'' = 3 u + 2 − 4 x with u = 2: about 2 with 2 rad/s, after half of a period x = 4.
  ASSERT_EQ(import("m.xml",
                   slider("<general joint=\"s\" gainprm=\"3\" biastype=\"affine\" "
                          "biasprm=\"2 -4 0\"/>",
                          "ctrl=\"2\""),
                   "--key k"),
            0)
      << notes_;
  EXPECT_NEAR(atEnd("s.displacement", "--until 1.5707963267948966"), 4.0, kNear);
}

TEST_F(MjcfDrivesImport, StartsInThePoseOfAKey) {
  // A free body at (1, 2, 3), turned by 90 degrees about z, carries an arm along x that turns by 90
  // degrees about z, too: its tip, 1 m away, points to −x.
  const std::string file =
      "<mujoco><worldbody><body name=\"base\" pos=\"0 0 5\"><freejoint/><geom size=\".1\"/>"
      "<body name=\"arm\"><joint name=\"j\" axis=\"0 0 1\"/><geom size=\".1\" pos=\"1 0 0\"/>"
      "</body></body></worldbody><keyframe><key name=\"rest\"/><key name=\"home\" qpos=\"1 2 3 "
      "0.7071067811865476 0 0 0.7071067811865476 1.5707963267948966\"/></keyframe></mujoco>\n";
  ASSERT_EQ(import("m.xml", file, "--key home"), 0) << notes_;
  expectChecks();
  EXPECT_NE(line("<RigidBody name=\"base\"").find("position=\"1 2 3\""), std::string::npos)
      << line("<RigidBody name=\"base\"");
  EXPECT_NE(line("<RigidBody name=\"arm\"").find("position=\"0 2 3\""), std::string::npos)
      << line("<RigidBody name=\"arm\"");
  ASSERT_EQ(import("m.xml", file), 0);
  EXPECT_NE(line("<RigidBody name=\"arm\"").find("position=\"1 0 5\""), std::string::npos);
  EXPECT_NE(notes_.find("is not the start; it is with --key home"), std::string::npos) << notes_;
}

TEST_F(MjcfDrivesImport, NamesMistakesOfKeysAndListsOtherDrives) {
  const std::string file = slider("<cylinder joint=\"s\"/><motor joint=\"t\"/>", "qpos=\"1 2\"");
  EXPECT_EQ(import("m.xml", file, "--key K"), 2);
  EXPECT_NE(notes_.find("there is no key \"K\" — did you mean \"k\"?"), std::string::npos)
      << notes_;
  EXPECT_EQ(import("m.xml", file, "--key k"), 2);
  EXPECT_NE(notes_.find("qpos has 2 numbers, the machine 1"), std::string::npos) << notes_;
  EXPECT_EQ(import("m.xml", file), 0);
  EXPECT_NE(notes_.find("drives of this kind are left out"), std::string::npos) << notes_;
  EXPECT_NE(notes_.find("\"t\" is no hinge and no slide"), std::string::npos) << notes_;
  EXPECT_NE(import("m.urdf", "<robot name=\"r\"><link name=\"a\"/></robot>", "--key k"), 0);
  EXPECT_NE(notes_.find("only files of MJCF have keyframes"), std::string::npos) << notes_;
}

}  // namespace
}  // namespace dynamy
