// The FCLIB layout: three storages of a matrix, both forms, messages with the place in the file.
#include <gtest/gtest.h>

#include <dynamy/core/error.hpp>
#include <dynamy/io/fclib/fclib_file.hpp>
#include <dynamy/io/files/output_file.hpp>
#include <dynamy/io/hdf5/hdf5_file.hpp>
#include <functional>

#include "unit/io/files/scratch_folder.hpp"

namespace dynamy {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

class FclibFileTest : public ::testing::Test {
 protected:
  testing::ScratchFolder folder_;
  std::filesystem::path file_ = folder_.path() / "problem.hdf5";

  /// One contact in space, W in a storage of choice; `change` writes what is to be different.
  void writeLocal(const std::function<void(Hdf5File&)>& W) {
    Hdf5File f(file_, Hdf5File::Mode::create);
    f.write("/fclib_local/spacedim", std::vector<int>{3});
    W(f);
    f.write("/fclib_local/vectors/q", VectorXd(Eigen::Vector3d(-1.0, 2.0, 0.5)));
    f.write("/fclib_local/vectors/mu", VectorXd(VectorXd::Constant(1, 0.3)));
  }
  static void matrix(Hdf5File& f, int nz, const std::vector<int>& p, const std::vector<int>& i,
                     const std::vector<double>& x) {
    const std::string W = "/fclib_local/W";
    f.write(W + "/m", std::vector<int>{3}), f.write(W + "/n", std::vector<int>{3});
    f.write(W + "/nzmax", std::vector<int>{static_cast<int>(x.size())});
    f.write(W + "/nz", std::vector<int>{nz});
    f.write(W + "/p", p), f.write(W + "/i", i);
    f.write(W + "/x", VectorXd(VectorXd::Map(x.data(), static_cast<Eigen::Index>(x.size()))));
  }
  std::string message() const {
    try {
      readFclib(file_);
    } catch (const ModelError& e) {
      return e.diagnostics().front().text;
    }
    return "no error";
  }
};

/// W = [2 0 7; 0 3 0; 0 0 4].
const MatrixXd kW = (MatrixXd(3, 3) << 2, 0, 7, 0, 3, 0, 0, 0, 4).finished();

TEST_F(FclibFileTest, ReadsTripletsAndSumsRepeatedOnes) {
  writeLocal([](Hdf5File& f) { matrix(f, 5, {0, 2, 1, 2, 2}, {0, 0, 1, 2, 2}, {2, 7, 3, 1, 3}); });
  EXPECT_EQ(MatrixXd(readFclib(file_).W), kW);
}

TEST_F(FclibFileTest, ReadsCompressedColumns) {
  writeLocal([](Hdf5File& f) { matrix(f, -1, {0, 1, 2, 4}, {0, 1, 0, 2}, {2, 3, 7, 4}); });
  EXPECT_EQ(MatrixXd(readFclib(file_).W), kW);
}

TEST_F(FclibFileTest, ReadsCompressedRows) {
  writeLocal([](Hdf5File& f) { matrix(f, -2, {0, 2, 3, 4}, {0, 2, 1, 2}, {2, 7, 3, 4}); });
  const FclibProblem p = readFclib(file_);
  EXPECT_EQ(MatrixXd(p.W), kW);
  EXPECT_EQ(p.dim, 3);
  EXPECT_EQ(p.q, VectorXd(Eigen::Vector3d(-1.0, 2.0, 0.5)));
  EXPECT_EQ(p.mu[0], 0.3);
}

TEST_F(FclibFileTest, NamesTheMissingPart) {
  writeLocal([](Hdf5File& f) { f.write("/fclib_local/W/m", std::vector<int>{3}); });
  EXPECT_EQ(message(), "/fclib_local/W/n: not there");
}

TEST_F(FclibFileTest, NamesAnEntryOutsideOfTheMatrix) {
  writeLocal([](Hdf5File& f) { matrix(f, 1, {0}, {3}, {1}); });
  EXPECT_EQ(message(), "/fclib_local/W: entry 0 lies outside of the matrix");
}

TEST_F(FclibFileTest, RefusesPointersThatDoNotRise) {
  const auto pointers = [&](const std::vector<int>& p) {
    writeLocal([&](Hdf5File& f) { matrix(f, -1, p, {0, 1, 0, 2}, {2, 3, 7, 4}); });
    return message();
  };
  EXPECT_EQ(pointers({0, 2, 1, 4}), "/fclib_local/W/p: decreases at entry 2, from 2 to 1");
  EXPECT_EQ(pointers({1, 1, 2, 4}), "/fclib_local/W/p: begins with 1, not 0");
  EXPECT_EQ(pointers({0, 1, 2, 5}), "/fclib_local/W/p: points beyond the entries");
  EXPECT_EQ(pointers({0, 1, 4}), "/fclib_local/W/p: is too short");
  EXPECT_EQ(pointers({0, 1, 2, 3, 4}), "/fclib_local/W/p: has 5 entries, not 4");
}

TEST_F(FclibFileTest, RefusesPartsThatDisagree) {
  writeLocal([](Hdf5File& f) { matrix(f, -1, {0, 1, 2, 4}, {0, 1, 0}, {2, 3, 7, 4}); });
  EXPECT_EQ(message(), "/fclib_local/W/i: has 3 entries, but /fclib_local/W/x has 4");
  writeLocal([](Hdf5File& f) {
    matrix(f, -1, {0, 1, 2, 4}, {0, 1, 0, 2}, {2, 3, 7, 4});
    f.write("/fclib_local/vectors/mu_unused", VectorXd(VectorXd::Zero(1)));
  });
  EXPECT_EQ(message(), "no error");
}

TEST_F(FclibFileTest, RefusesAMatrixOfAnotherSizeThanTheVectors) {
  {
    Hdf5File f(file_, Hdf5File::Mode::create);
    f.write("/fclib_local/spacedim", std::vector<int>{3});
    matrix(f, 0, {}, {}, {});
    f.write("/fclib_local/vectors/q", VectorXd(VectorXd::Zero(6)));
    f.write("/fclib_local/vectors/mu", VectorXd(VectorXd::Zero(2)));
  }
  EXPECT_EQ(message(), "/fclib_local/W/m: is 3, but the vectors have 6 entries");
}

TEST_F(FclibFileTest, RefusesTextForNumbers) {
  {
    Hdf5File f(file_, Hdf5File::Mode::create);
    f.write("/lcp/q", std::string("1 2 3"));
  }
  EXPECT_EQ(message(), "/lcp/q: holds no numbers");
}

TEST_F(FclibFileTest, AGlobalProblemWithAMasslessVelocityIsRefused) {
  FclibProblem p;
  p.global = true;
  p.M = MatrixXd(Eigen::Vector3d(1.0, 0.0, 2.0).asDiagonal()).sparseView();
  p.H = MatrixXd(MatrixXd::Ones(3, 3)).sparseView();
  p.f = VectorXd::Ones(3), p.w = VectorXd::Ones(3), p.mu = VectorXd::Constant(1, 0.4);
  EXPECT_THROW(condensed(p), ModelError);
}

TEST_F(FclibFileTest, AGlobalProblemOfNothingIsALocalOneOfNothing) {
  FclibProblem p;
  p.global = true;
  p.M.resize(0, 0), p.H.resize(0, 0);
  const FclibProblem local = condensed(p);
  EXPECT_EQ(local.rows(), 0);
  writeFclib(file_, p);
  EXPECT_EQ(readFclib(file_).contacts(), 0);
}

TEST_F(FclibFileTest, NamesWrongSizes) {
  {
    Hdf5File f(file_, Hdf5File::Mode::create);
    f.write("/fclib_local/spacedim", std::vector<int>{3});
    matrix(f, -1, {0, 1, 2, 4}, {0, 1, 0, 2}, {2, 3, 7, 4});
    f.write("/fclib_local/vectors/q", VectorXd(VectorXd::Zero(3)));
    f.write("/fclib_local/vectors/mu", VectorXd(VectorXd::Zero(2)));
  }
  EXPECT_EQ(message(), "/fclib_local/vectors/mu: has 2 entries, not 1");
}

TEST_F(FclibFileTest, SaysThatAFileIsNoHdf5File) {
  writeWholeFile(file_, "text");
  EXPECT_EQ(message(), "not an HDF5 file");
}

TEST_F(FclibFileTest, KeepsALocalProblemOverWritingAndReading) {
  FclibProblem p;
  p.dim = 2, p.title = "two discs";
  p.W = MatrixXd(MatrixXd::Random(4, 4)).sparseView();
  p.q = VectorXd::Random(4), p.mu = VectorXd::Constant(2, 0.4);
  writeFclib(file_, p, {p.q, 2.0 * p.q, {}});
  const FclibProblem again = readFclib(file_);
  EXPECT_EQ(again.dim, 2);
  EXPECT_EQ(again.title, "two discs");
  EXPECT_EQ(MatrixXd(again.W), MatrixXd(p.W));
  EXPECT_EQ(again.q, p.q);
  EXPECT_EQ(again.mu, p.mu);
  EXPECT_EQ(Hdf5File(file_, Hdf5File::Mode::read).numbers("/solution/u"), VectorXd(2.0 * p.q));
}

TEST_F(FclibFileTest, KeepsAGlobalProblemAndCondensesIt) {
  FclibProblem p;
  p.global = true;
  const MatrixXd A = MatrixXd::Random(4, 4), M = A * A.transpose() + MatrixXd::Identity(4, 4),
                 H = MatrixXd::Random(4, 3);
  p.M = M.sparseView(), p.H = H.sparseView();
  p.f = VectorXd::Random(4), p.w = VectorXd::Random(3), p.mu = VectorXd::Constant(1, 0.4);
  writeFclib(file_, p);
  const FclibProblem again = readFclib(file_);
  EXPECT_TRUE(again.global);
  const FclibProblem local = condensed(again);
  // M is well conditioned: a few roundings of numbers of order one.
  EXPECT_LT((MatrixXd(local.W) - H.transpose() * M.inverse() * H).norm(), 1e-13);
  EXPECT_LT((local.q - H.transpose() * M.inverse() * p.f - p.w).norm(), 1e-13);
  const VectorXd r = VectorXd::Random(3);
  EXPECT_LT((H.transpose() * velocities(again, r) + p.w - MatrixXd(local.W) * r - local.q).norm(),
            1e-13);
}

}  // namespace
}  // namespace dynamy
