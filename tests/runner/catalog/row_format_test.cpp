#include "runner/catalog/row_format.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include <bit>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "runner/catalog/catalog_error.hpp"
#include "runner/catalog/output_file.hpp"
#include "tests/runner/fakes.hpp"

namespace mpmstudy {
namespace {

std::string print(RowFormat format, const std::vector<std::string>& names,
                  const std::vector<std::vector<SqlValue>>& rows) {
  std::ostringstream out;
  const auto sink = make_row_sink(format, out);
  sink->columns(names);
  for (const auto& row : rows) sink->row(row);
  sink->end();
  return out.str();
}

TEST(RowFormat, csv_quotes_what_needs_it) {
  EXPECT_EQ(print(RowFormat::csv, {"a", "b,c"},
                  {{std::int64_t{1}, std::string("x \"y\"\nz")}, {SqlValue(), std::string()}, {0.1, -2.0}}),
            "a,\"b,c\"\r\n1,\"x \"\"y\"\"\nz\"\r\n,\"\"\r\n0.1,-2.0\r\n");
}

TEST(RowFormat, csv_quotes_texts_that_look_like_numbers) {
  std::string expected;
  std::vector<std::vector<SqlValue>> rows;
  for (const char* text : {"108e42971305", "012345678901", "123456789012", "12345.5", "-1", "inf", "NaN",
                           "NA", "true", "NULL", "0x1p3"}) {
    rows.push_back({std::string(text)});
    expected += "\"" + std::string(text) + "\"\r\n";
  }
  for (const char* text : {"1a2b3c4d5e6f", "collapsed", "12e", "none of them"}) {
    rows.push_back({std::string(text)});
    expected += std::string(text) + "\r\n";
  }
  EXPECT_EQ(print(RowFormat::csv, {"key"}, rows), "key\r\n" + expected);
  EXPECT_EQ(print(RowFormat::csv, {"x"}, {{INFINITY}, {-INFINITY}}), "x\r\ninf\r\n-inf\r\n");
}

TEST(RowFormat, json_has_infinity_as_a_text) {
  const auto json = nlohmann::json::parse(print(RowFormat::json, {"a"}, {{INFINITY}, {-INFINITY}}));
  EXPECT_EQ(json[0]["a"], "Infinity");
  EXPECT_EQ(json[1]["a"], "-Infinity");
}

TEST(RowFormat, json_is_json) {
  const auto text = print(RowFormat::json, {"a", "b"},
                          {{std::int64_t{1}, std::string("\"\n\x01 \xff")}, {SqlValue(), 0.5}, {NAN, 1e300}});
  const auto json = nlohmann::json::parse(text);
  EXPECT_EQ(json.size(), 3u);
  EXPECT_EQ(json[0]["a"], 1);
  EXPECT_TRUE(json[1]["a"].is_null());
  EXPECT_EQ(json[1]["b"], 0.5);
  EXPECT_TRUE(json[2]["a"].is_null());
  EXPECT_EQ(nlohmann::json::parse(print(RowFormat::json, {"a"}, {})), nlohmann::json::array());
}

TEST(RowFormat, table_is_aligned) {
  EXPECT_EQ(print(RowFormat::table, {"name", "n"},
                  {{std::string("a"), std::int64_t{10}}, {std::string("b\x1b[2J"), std::int64_t{5}}}),
            "name    n\n-----  --\na      10\nb [2J   5\n");
}

TEST(RowFormat, doubles_come_back_bit_for_bit) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 20000; ++i) {
    const double value = std::bit_cast<double>(random());
    if (std::isnan(value)) continue;
    EXPECT_EQ(std::bit_cast<std::uint64_t>(std::strtod(shortest(value).c_str(), nullptr)),
              std::bit_cast<std::uint64_t>(value));
  }
  EXPECT_EQ(shortest(5), "5.0");
  EXPECT_EQ(shortest(INFINITY), "inf");
}

// As root a file could take the place of a device, and `> /dev/full` would succeed from then on.
TEST(OutputFile, leaves_devices_pipes_links_and_folders_what_they_are) {
  const fakes::TemporaryFolder folder;
  const auto pipe = folder.path() / "pipe", target = folder.path() / "target", link = folder.path() / "link";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const int reader = open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
  {
    OutputFile file(pipe);
    file.stream() << "text";
    file.commit();
  }
  char text[5] = {};
  EXPECT_EQ(read(reader, text, 4), 4);
  close(reader);
  EXPECT_STREQ(text, "text");
  EXPECT_TRUE(std::filesystem::is_fifo(pipe));
  std::ofstream(target) << "old";
  std::filesystem::create_symlink(target, link);
  {
    OutputFile file(link);
    file.stream() << "new";
    file.commit();
  }
  EXPECT_TRUE(std::filesystem::is_symlink(link));
  std::ifstream in(target);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(in), {}), "new");
  EXPECT_THROW(OutputFile(folder.path()), CatalogError);
}

TEST(OutputFile, appears_when_it_is_whole) {
  const fakes::TemporaryFolder folder;
  const auto path = folder.path() / "new" / "a.csv";
  {
    OutputFile file(path);
    file.stream() << "half";
  }
  EXPECT_TRUE(std::filesystem::is_empty(path.parent_path()));
  OutputFile file(path);
  file.stream() << "whole";
  EXPECT_FALSE(std::filesystem::exists(path));
  file.commit();
  EXPECT_EQ(std::filesystem::file_size(path), 5u);
  EXPECT_THROW(OutputFile(path / "below-a-file"), CatalogError);
}

}  // namespace
}  // namespace mpmstudy
