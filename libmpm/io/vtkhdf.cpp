#include "libmpm/io/vtkhdf.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "libmpm/io/durable_file.hpp"
#include "libmpm/io/fields.hpp"
#include "libmpm/io/hdf5.hpp"

namespace mpm {
namespace {

using namespace hdf5;

/// Fields of /VTKHDF/PointData that are arrays of their own. Points and Velocity are vectors, and written
/// apart.
bool is_scalar(const Field& field) { return *field.dataset != '\0'; }
bool is_there(const Field& field, const Snapshot& s) { return s.has_depth() || !field.only_of_three_axes(); }

constexpr char type_name[] = "UnstructuredGrid";
constexpr std::size_t type_length = sizeof(type_name) - 1;
constexpr unsigned char vtk_vertex = 1;

// ---------------------------------------------------------------------------------------------- writing

template <class T>
void write_number_attribute(const Session& s, hid_t object, const char* name, std::span<const T> values) {
  const hsize_t size = values.size();
  const Handle space(s.check(size == 1 ? H5Screate(H5S_SCALAR) : H5Screate_simple(1, &size, nullptr), name),
                     H5Sclose);
  const Handle attribute(
      s.check(H5Acreate2(object, name, memory_type<T>(), space, H5P_DEFAULT, H5P_DEFAULT), name), H5Aclose);
  s.check(H5Awrite(attribute, memory_type<T>(), values.data()), name);
}

/// z = 0 where there is none.
std::vector<double> rows_of_three(const std::vector<double>& x, const std::vector<double>& y,
                                  const std::vector<double>& z) {
  std::vector<double> rows(3 * x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    rows[3 * i] = x[i];
    rows[3 * i + 1] = y[i];
    if (!z.empty()) rows[3 * i + 2] = z[i];
  }
  return rows;
}

/// One vertex cell a particle.
void write_cells(const Session& s, hid_t root, std::size_t particles) {
  const auto n = static_cast<std::int64_t>(particles);
  std::vector<std::int64_t> offsets(particles + 1);
  for (std::size_t i = 0; i <= particles; ++i) offsets[i] = static_cast<std::int64_t>(i);
  write_dataset(s, root, "Offsets", offsets, "1");
  offsets.pop_back();
  write_dataset(s, root, "Connectivity", offsets, "1");
  write_dataset(s, root, "Types", std::vector<unsigned char>(particles, vtk_vertex), "1");
  write_dataset(s, root, "NumberOfPoints", std::vector<std::int64_t>{n}, "1");
  write_dataset(s, root, "NumberOfCells", std::vector<std::int64_t>{n}, "1");
  write_dataset(s, root, "NumberOfConnectivityIds", std::vector<std::int64_t>{n}, "1");
}

void write_group(const Session& s, hid_t file, const Snapshot& snapshot) {
  const Handle root = create_group(s, file, "VTKHDF");
  const int version[] = {1, 0};
  write_number_attribute<int>(s, root, "Version", version);
  write_text_attribute(s, root, "Type", type_name);
  write_number_attribute<double>(s, root, "time", std::span(&snapshot.time, 1));
  write_text_attribute(s, root, "time_unit", "s");
  write_number_attribute<std::int64_t>(s, root, "step", std::span(&snapshot.step, 1));

  write_dataset(s, root, "Points", rows_of_three(snapshot.x, snapshot.y, snapshot.z), "m", 3);
  write_cells(s, root, snapshot.x.size());

  const Handle points = create_group(s, root, "PointData");
  write_dataset(s, points, "Velocity",
                rows_of_three(snapshot.velocity_x, snapshot.velocity_y, snapshot.velocity_z), "m/s", 3);
  for (const Field& field : fields())
    if (is_scalar(field) && is_there(field, snapshot))
      write_dataset(s, points, field.dataset, snapshot.*field.values, field.unit_in(snapshot));

  const Handle fields = create_group(s, root, "FieldData");
  write_dataset(s, fields, "Time", std::vector<double>{snapshot.time}, "s");
  write_dataset(s, fields, "Step", std::vector<std::int64_t>{snapshot.step}, "1");
}

void check_lengths(const std::filesystem::path& path, const Snapshot& snapshot) {
  const auto check = [&](std::string_view name, const std::vector<double>& column) {
    if (column.size() == snapshot.x.size()) return;
    throw std::invalid_argument(path.string() + ": snapshot has " + std::to_string(snapshot.x.size()) +
                                " particles, but " + std::to_string(column.size()) + " values of " +
                                std::string(name));
  };
  check("y", snapshot.y);
  if (snapshot.has_depth()) check("z", snapshot.z);
  for (const Field& field : fields())
    if (is_there(field, snapshot))
      check(is_scalar(field) ? field.dataset : field.name, snapshot.*field.values);
}

// ---------------------------------------------------------------------------------------------- reading

template <class T>
T read_number_attribute(const Session& s, hid_t object, const char* name) {
  const Handle attribute(s.check(H5Aopen(object, name, H5P_DEFAULT), name), H5Aclose);
  const Handle space(s.check(H5Aget_space(attribute), name), H5Sclose);
  if (H5Sget_simple_extent_npoints(space) != 1) s.fail(std::string(name) + ": is not one number");
  T value{};
  s.check(H5Aread(attribute, memory_type<T>(), &value), name);
  return value;
}

void check_type(const Session& s, hid_t root) {
  const Handle attribute(s.check(H5Aopen(root, "Type", H5P_DEFAULT), "Type"), H5Aclose);
  const Handle type(s.check(H5Aget_type(attribute), "Type"), H5Tclose);
  if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) > 0 || H5Tget_size(type) != type_length)
    s.fail("Type: is not the fixed-length text UnstructuredGrid");
  std::string text(type_length, ' ');
  s.check(H5Aread(attribute, type, text.data()), "Type");
  if (text != type_name) s.fail("Type: is " + text + ", not " + type_name);
}

/// Those along z only `with_depth`.
void split_rows_of_three(const std::vector<double>& rows, bool with_depth, std::vector<double>& x,
                         std::vector<double>& y, std::vector<double>& z) {
  x.resize(rows.size() / 3);
  y.resize(rows.size() / 3);
  z.resize(with_depth ? rows.size() / 3 : 0);
  for (std::size_t i = 0; i < x.size(); ++i) {
    x[i] = rows[3 * i];
    y[i] = rows[3 * i + 1];
    if (with_depth) z[i] = rows[3 * i + 2];
  }
}

/// Whether the file has what only snapshots of three axes have.
bool has_depth(const Session& s, hid_t points) {
  const auto field =
      std::ranges::find_if(fields(), [](const Field& f) { return is_scalar(f) && f.only_of_three_axes(); });
  return s.check(H5Lexists(points, field->dataset, H5P_DEFAULT), field->dataset) > 0;
}

Snapshot read_group(const std::filesystem::path& path) {
  const Session s(path);
  const Handle file = open_to_read(s, path);
  const Handle root(s.check(H5Gopen2(file, "VTKHDF", H5P_DEFAULT), "VTKHDF"), H5Gclose);
  check_type(s, root);
  Snapshot snapshot;
  snapshot.time = read_number_attribute<double>(s, root, "time");
  snapshot.step = read_number_attribute<std::int64_t>(s, root, "step");
  const Handle points(s.check(H5Gopen2(root, "PointData", H5P_DEFAULT), "PointData"), H5Gclose);
  const bool depth = has_depth(s, points);
  split_rows_of_three(read_dataset<double>(s, root, "Points", 3), depth, snapshot.x, snapshot.y, snapshot.z);
  split_rows_of_three(read_dataset<double>(s, points, "Velocity", 3), depth, snapshot.velocity_x,
                      snapshot.velocity_y, snapshot.velocity_z);
  for (const Field& field : fields())
    if (is_scalar(field) && (depth || !field.only_of_three_axes()))
      snapshot.*field.values = read_dataset<double>(s, points, field.dataset);
  return snapshot;
}

}  // namespace

void write_vtkhdf(const std::filesystem::path& path, const Snapshot& snapshot) {
  check_lengths(path, snapshot);
  write_durably(path,
                file_image(path, [&](const Session& s, hid_t file) { write_group(s, file, snapshot); }));
}

Snapshot read_vtkhdf(const std::filesystem::path& path) {
  Snapshot snapshot = read_group(path);
  try {
    check_lengths(path, snapshot);
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(error.what());
  }
  return snapshot;
}

}  // namespace mpm
