// `bench kernel --json`: one object a row, with the names that others read.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>

TEST(BenchKernel, PrintsOneObjectARow) {
  FILE* pipe = popen(MPMSTUDY " bench kernel --json --particles 2000 --repetitions 1 --seconds 0.01", "r");
  std::array<char, 4096> line{};
  int rows = 0;
  while (fgets(line.data(), line.size(), pipe)) {
    const auto row = nlohmann::json::parse(line.data());
    ++rows;
    EXPECT_GT(row.at("million_particle_updates_per_s").get<double>(), 0);
    EXPECT_GT(row.at("ratio_to_reference").get<double>(), 0);
    EXPECT_GT(row.at("bytes_per_particle").get<double>(), 100);
    EXPECT_NEAR(row.at("particles").get<double>(), 2000, 300);
    EXPECT_EQ(row.at("precision"), "double");
    EXPECT_EQ(row.at("threads"), 1);
    EXPECT_TRUE(row.contains("scheme"));
  }
  EXPECT_EQ(pclose(pipe), 0);
  EXPECT_EQ(rows, 4);  // two schemes, fast and reference
}
