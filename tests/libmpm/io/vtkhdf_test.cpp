#include "libmpm/io/vtkhdf.hpp"
#include "libmpm/io/durable_file.hpp"
#include "tests/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <future>
#include <limits>
#include <sstream>
#include <thread>

namespace {

using testing::HasSubstr;

/// A folder of its own for every test; removed at the end.
class VtkhdfTest : public testing::Test {
 protected:
  TemporaryFolder own_;
  const std::filesystem::path folder_ = own_.path();
};

/// Numbers that no rounding survives: different in every column and particle.
mpm::Snapshot make_snapshot(std::size_t particles, double seed = 0.1) {
  mpm::Snapshot s;
  s.time = 1.62e-9;
  s.step = 12345678901;
  double next = seed;
  for (auto column :
       {&mpm::Snapshot::x, &mpm::Snapshot::y, &mpm::Snapshot::velocity_x, &mpm::Snapshot::velocity_y,
        &mpm::Snapshot::mass, &mpm::Snapshot::density, &mpm::Snapshot::pressure, &mpm::Snapshot::stress_xx,
        &mpm::Snapshot::stress_yy, &mpm::Snapshot::stress_xy, &mpm::Snapshot::stress_zz,
        &mpm::Snapshot::von_mises, &mpm::Snapshot::equivalent_plastic_strain, &mpm::Snapshot::plastic_work,
        &mpm::Snapshot::specific_internal_energy, &mpm::Snapshot::temperature})
    for (std::size_t i = 0; i < particles; ++i) (s.*column).push_back(std::sin(next += 1) / 3);
  return s;
}

void expect_same_bits(const mpm::Snapshot& a, const mpm::Snapshot& b) {
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.step, b.step);
  EXPECT_EQ(a.x, b.x);
  EXPECT_EQ(a.y, b.y);
  EXPECT_EQ(a.velocity_x, b.velocity_x);
  EXPECT_EQ(a.velocity_y, b.velocity_y);
  EXPECT_EQ(a.mass, b.mass);
  EXPECT_EQ(a.density, b.density);
  EXPECT_EQ(a.pressure, b.pressure);
  EXPECT_EQ(a.stress_xx, b.stress_xx);
  EXPECT_EQ(a.stress_yy, b.stress_yy);
  EXPECT_EQ(a.stress_xy, b.stress_xy);
  EXPECT_EQ(a.stress_zz, b.stress_zz);
  EXPECT_EQ(a.von_mises, b.von_mises);
  EXPECT_EQ(a.equivalent_plastic_strain, b.equivalent_plastic_strain);
  EXPECT_EQ(a.plastic_work, b.plastic_work);
  EXPECT_EQ(a.specific_internal_energy, b.specific_internal_energy);
  EXPECT_EQ(a.temperature, b.temperature);
}

std::string read_bytes(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::vector<std::string> names_in(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    names.push_back(entry.path().filename().string());
  return names;
}

std::string error_of(auto&& call) {
  try {
    call();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "no error";
}

TEST_F(VtkhdfTest, GivesBackEveryBit) {
  mpm::Snapshot written = make_snapshot(70000);  // more than one chunk
  written.pressure[0] = -0.0;
  written.pressure[1] = std::numeric_limits<double>::infinity();
  written.pressure[2] = std::numeric_limits<double>::denorm_min();
  mpm::write_vtkhdf(folder_ / "a.h5", written);
  const mpm::Snapshot read = mpm::read_vtkhdf(folder_ / "a.h5");
  expect_same_bits(read, written);
  EXPECT_TRUE(std::signbit(read.pressure[0]));
  EXPECT_EQ(names_in(folder_), std::vector<std::string>{"a.h5"});
}

TEST_F(VtkhdfTest, GivesBackWhatThreeAxesHave) {
  mpm::Snapshot written = make_snapshot(3);
  EXPECT_FALSE(written.has_depth());
  double next = 0.7;
  for (auto column :
       {&mpm::Snapshot::z, &mpm::Snapshot::velocity_z, &mpm::Snapshot::stress_xz, &mpm::Snapshot::stress_yz})
    for (int i = 0; i < 3; ++i) (written.*column).push_back(std::sin(next += 1) / 3);
  mpm::write_vtkhdf(folder_ / "a.h5", written);
  const mpm::Snapshot read = mpm::read_vtkhdf(folder_ / "a.h5");
  expect_same_bits(read, written);
  EXPECT_EQ(read.z, written.z);
  EXPECT_EQ(read.velocity_z, written.velocity_z);
  EXPECT_EQ(read.stress_xz, written.stress_xz);
  EXPECT_EQ(read.stress_yz, written.stress_yz);
  written.stress_yz.pop_back();
  EXPECT_THAT(error_of([&] { mpm::write_vtkhdf(folder_ / "b.h5", written); }), HasSubstr("StressYZ"));
}

TEST_F(VtkhdfTest, KeepsAnEmptySnapshotAndASingleParticle) {
  for (std::size_t particles : {0, 1}) {
    const mpm::Snapshot written = make_snapshot(particles);
    mpm::write_vtkhdf(folder_ / "a.h5", written);
    expect_same_bits(mpm::read_vtkhdf(folder_ / "a.h5"), written);
  }
}

TEST_F(VtkhdfTest, EqualSnapshotsGiveEqualFiles) {
  mpm::write_vtkhdf(folder_ / "a.h5", make_snapshot(100));
  mpm::write_vtkhdf(folder_ / "b.h5", make_snapshot(100));
  EXPECT_EQ(read_bytes(folder_ / "a.h5"), read_bytes(folder_ / "b.h5"));
}

TEST_F(VtkhdfTest, ManyThreadsMayWriteAtOnce) {
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([&, t] {
      for (int i = 0; i < 5; ++i)
        mpm::write_vtkhdf(folder_ / (std::to_string(t) + ".h5"), make_snapshot(2000, t + 0.25 * i));
    });
  for (std::thread& thread : threads) thread.join();
  for (int t = 0; t < 4; ++t)
    expect_same_bits(mpm::read_vtkhdf(folder_ / (std::to_string(t) + ".h5")), make_snapshot(2000, t + 1.0));
}

TEST_F(VtkhdfTest, SaysWhatIsWrongAndPrintsNothing) {
  testing::internal::CaptureStderr();
  EXPECT_THAT(error_of([&] { mpm::write_vtkhdf(folder_ / "none" / "a.h5", make_snapshot(3)); }),
              testing::AllOf(HasSubstr("none/a.h5"), HasSubstr("No such file")));
  EXPECT_THAT(error_of([&] { mpm::read_vtkhdf(folder_ / "absent.h5"); }),
              testing::AllOf(HasSubstr("absent.h5"), HasSubstr("No such file")));
  std::ofstream(folder_ / "text.h5") << "no HDF5 in here";
  EXPECT_THAT(error_of([&] { mpm::read_vtkhdf(folder_ / "text.h5"); }),
              testing::AllOf(HasSubstr("text.h5"), HasSubstr("signature")));
  mpm::Snapshot uneven = make_snapshot(3);
  uneven.temperature.pop_back();
  EXPECT_THAT(error_of([&] { mpm::write_vtkhdf(folder_ / "uneven.h5", uneven); }),
              testing::AllOf(HasSubstr("3 particles"), HasSubstr("2 values of Temperature")));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "uneven.h5"));
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_F(VtkhdfTest, AFileCutShortIsAnError) {
  mpm::write_vtkhdf(folder_ / "a.h5", make_snapshot(1000));
  std::filesystem::resize_file(folder_ / "a.h5", std::filesystem::file_size(folder_ / "a.h5") / 2);
  EXPECT_THROW(mpm::read_vtkhdf(folder_ / "a.h5"), std::runtime_error);
}

TEST_F(VtkhdfTest, AFailedWriteLeavesTheOldFile) {
  mpm::write_vtkhdf(folder_ / "a.h5", make_snapshot(10));
  const std::string before = read_bytes(folder_ / "a.h5");
  rlimit usual{};
  getrlimit(RLIMIT_FSIZE, &usual);
  const rlimit low{1000, usual.rlim_max};  // as if the disk were full
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  setrlimit(RLIMIT_FSIZE, &low);
  EXPECT_THROW(mpm::write_vtkhdf(folder_ / "a.h5", make_snapshot(20)), std::runtime_error);
  setrlimit(RLIMIT_FSIZE, &usual);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(read_bytes(folder_ / "a.h5"), before);
  EXPECT_EQ(names_in(folder_), std::vector<std::string>{"a.h5"});
}

// Two processes that run one job write one checkpoint: neither takes the other's half.
TEST_F(VtkhdfTest, TwoMayWriteOneFileAtOnce) {
  const auto write = [&](std::byte value) {
    const std::vector<std::byte> bytes(100'000, value);
    for (int i = 0; i < 50; ++i) mpm::write_durably(folder_ / "a", bytes);
  };
  auto other = std::async(std::launch::async, write, std::byte{'b'});
  EXPECT_NO_THROW(write(std::byte{'a'}));
  EXPECT_NO_THROW(other.get());
  const std::string bytes = read_bytes(folder_ / "a");
  EXPECT_EQ(bytes, std::string(100'000, bytes[0]));
  EXPECT_EQ(names_in(folder_), std::vector<std::string>{"a"});
}

/// The numbers of the first line that starts so; hexadecimal floating point loses no bit.
std::vector<double> numbers_after(const std::string& text, const std::string& start) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with(start + " ")) continue;
    std::istringstream words(line.substr(start.size()));
    std::vector<double> numbers;
    for (std::string word; words >> word;) numbers.push_back(std::strtod(word.c_str(), nullptr));
    return numbers;
  }
  return {};
}

std::vector<double> with_components(double components, const std::vector<double>& values) {
  std::vector<double> all = {components};
  all.insert(all.end(), values.begin(), values.end());
  return all;
}

/// ParaView reads by the same class.
TEST_F(VtkhdfTest, VtkReadsIt) {
  const mpm::Snapshot s = make_snapshot(5);
  mpm::write_vtkhdf(folder_ / "a.h5", s);
  const std::string command = std::string(DEBIAN_PYTHON3) +
                              " '" SOURCE_DIR "/tests/libmpm/io/read_with_vtk.py' '" +
                              (folder_ / "a.h5").string() + "' > '" + (folder_ / "out").string() + "' 2>&1";
  const int status = std::system(command.c_str());
  const std::string out = read_bytes(folder_ / "out");
  ASSERT_EQ(status, 0) << out;
  EXPECT_THAT(out, HasSubstr("class vtkUnstructuredGrid\npoints 5\ncells 5\n"));
  EXPECT_THAT(out, testing::Not(HasSubstr("ERR")));
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(numbers_after(out, "point " + std::to_string(i)), (std::vector<double>{s.x[i], s.y[i], 0}));
    EXPECT_EQ(numbers_after(out, "cell " + std::to_string(i)), (std::vector<double>{1, double(i)}));
  }
  const auto vector = numbers_after(out, "point_array Velocity");
  ASSERT_EQ(vector.size(), 16u) << out;
  EXPECT_EQ(vector[0], 3);
  EXPECT_EQ(vector[4], s.velocity_x[1]);
  EXPECT_EQ(vector[5], s.velocity_y[1]);
  EXPECT_EQ(vector[6], 0);
  EXPECT_EQ(numbers_after(out, "point_array Density"), with_components(1, s.density));
  EXPECT_EQ(numbers_after(out, "point_array Pressure"), with_components(1, s.pressure));
  EXPECT_EQ(numbers_after(out, "point_array VonMises"), with_components(1, s.von_mises));
  EXPECT_EQ(numbers_after(out, "point_array StressXX"), with_components(1, s.stress_xx));
  EXPECT_EQ(numbers_after(out, "point_array StressYY"), with_components(1, s.stress_yy));
  EXPECT_EQ(numbers_after(out, "point_array StressXY"), with_components(1, s.stress_xy));
  EXPECT_EQ(numbers_after(out, "point_array StressZZ"), with_components(1, s.stress_zz));
  EXPECT_EQ(numbers_after(out, "point_array PlasticStrain"), with_components(1, s.equivalent_plastic_strain));
  EXPECT_EQ(numbers_after(out, "point_array PlasticWork"), with_components(1, s.plastic_work));
  EXPECT_EQ(numbers_after(out, "point_array InternalEnergy"), with_components(1, s.specific_internal_energy));
  EXPECT_EQ(numbers_after(out, "point_array Temperature"), with_components(1, s.temperature));
  EXPECT_EQ(numbers_after(out, "point_array Mass"), with_components(1, s.mass));
  EXPECT_EQ(numbers_after(out, "field_array Time"), (std::vector<double>{1, s.time}));
  EXPECT_EQ(numbers_after(out, "field_array Step"), (std::vector<double>{1, double(s.step)}));
}

}  // namespace
