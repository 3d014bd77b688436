// `bench kernel --json`: one object per row, with the names that others read.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

TEST(BenchKernel, PrintsOneObjectARow) {
  FILE* pipe = popen(
      MPMSTUDY " bench kernel --json --particles 2000 --threads 1 2 --repetitions 1 --seconds 0.01", "r");
  std::array<char, 4096> line{};
  int rows = 0, single = 0, threads = 0;
  std::map<std::string, int> of_space;
  while (fgets(line.data(), line.size(), pipe)) {
    const auto row = nlohmann::json::parse(line.data());
    ++rows;
    EXPECT_GT(row.at("million_particle_updates_per_s").get<double>(), 0);
    EXPECT_GT(row.at("ratio_to_reference").get<double>(), 0);
    EXPECT_GT(row.at("bytes_per_particle").get<double>(), 50);
    const std::string space = row.at("space");
    ++of_space[space];
    // in three dimensions a cell more or less across is a tenth of the volume
    EXPECT_NEAR(row.at("particles").get<double>(), 2000, space == "three-d" ? 700 : 300);
    for (const char* measured : {"gigaflops_double", "gigaflops_float", "gigabytes_per_second"})
      EXPECT_GT(row.at(measured).get<double>(), 0) << measured;
    if (row.at("kernel") == "fast") {
      EXPECT_EQ(row.at("roofline_share").get<double>() > 0, row.at("threads") == 1);
      // no upper bound: particles that stay in the caches pass the roofline of a slow memory
      EXPECT_TRUE(std::isfinite(row.at("roofline_share").get<double>()));
      EXPECT_GT(row.at("particles_share").get<double>(), 0);
      single += row.at("precision") == "float";
    }
    threads += row.at("threads").get<int>();
    EXPECT_TRUE(row.contains("scheme"));
  }
  EXPECT_EQ(pclose(pipe), 0);
  EXPECT_EQ(rows, 3 * 10);  // two schemes, fast in two precisions with one and two threads, and reference
  for (const char* space : {"plane-strain", "axisymmetric", "three-d"})
    EXPECT_EQ(of_space[space], 10) << space;
  EXPECT_EQ(single, 3 * 4);
  EXPECT_EQ(threads, 3 * (4 * 1 + 4 * 2 + 2));
}

TEST(BenchKernel, FollowsAWholeRunByTenths) {
  FILE* pipe =
      popen(MPMSTUDY " bench kernel --json --whole-run --space plane-strain three-d --particles 1000", "r");
  std::array<char, 4096> line{};
  int rows = 0;
  while (fgets(line.data(), line.size(), pipe)) {
    const auto row = nlohmann::json::parse(line.data());
    ++rows;
    const auto& rates = row.at("million_particle_updates_per_s");
    ASSERT_EQ(rates.size(), 10u);
    for (const auto& rate : rates) EXPECT_GT(rate.get<double>(), 0);
  }
  EXPECT_EQ(pclose(pipe), 0);
  EXPECT_EQ(rows, 8);  // two spaces, two schemes, two precisions
}
