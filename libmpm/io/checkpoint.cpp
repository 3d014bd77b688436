#include "libmpm/io/checkpoint.hpp"

#include "libmpm/io/durable_file.hpp"
#include "libmpm/io/hdf5.hpp"

namespace mpm {
namespace {

using namespace hdf5;

constexpr char format[] = "mpm-checkpoint-1";

/// Names hold slashes, which are groups in HDF5: here they are one flat list.
std::string flat(std::string name) {
  std::ranges::replace(name, '/', '.');
  return name;
}
std::string deep(std::string name) {
  std::ranges::replace(name, '.', '/');
  return name;
}

template <class T>
void write_columns(const Session& s, hid_t file, const char* group,
                   const std::map<std::string, std::vector<T>>& columns) {
  const Handle root = create_group(s, file, group);
  for (const auto& [name, column] : columns) write_dataset(s, root, flat(name).c_str(), column, "1");
}

template <class T>
void read_columns(const Session& s, hid_t file, const char* group,
                  std::map<std::string, std::vector<T>>& columns) {
  const Handle root(s.check(H5Gopen2(file, group, H5P_DEFAULT), group), H5Gclose);
  H5G_info_t info{};
  s.check(H5Gget_info(root, &info), group);
  for (hsize_t i = 0; i < info.nlinks; ++i) {
    char name[256];
    s.check(H5Lget_name_by_idx(root, ".", H5_INDEX_NAME, H5_ITER_INC, i, name, sizeof name, H5P_DEFAULT),
            group);
    columns[deep(name)] = read_dataset<T>(s, root, name);
  }
}

}  // namespace

void write_checkpoint(const std::filesystem::path& path, const Record& record) {
  write_durably(path, file_image(path, [&](const Session& s, hid_t file) {
                  write_text_attribute(s, file, "format", format);
                  write_columns(s, file, "numbers", record.numbers);
                  write_columns(s, file, "integers", record.integers);
                }));
}

Record read_checkpoint(const std::filesystem::path& path) {
  const Session s(path);
  const Handle file = open_to_read(s, path);
  const Handle attribute(s.check(H5Aopen(file, "format", H5P_DEFAULT), "format"), H5Aclose);
  const Handle type(s.check(H5Aget_type(attribute), "format"), H5Tclose);
  std::string text(H5Tget_size(type), ' ');
  s.check(H5Aread(attribute, type, text.data()), "format");
  if (text != format) s.fail("format: is " + text + ", not " + format);
  Record record;
  read_columns(s, file, "numbers", record.numbers);
  read_columns(s, file, "integers", record.integers);
  return record;
}

}  // namespace mpm
