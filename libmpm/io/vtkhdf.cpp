#include "libmpm/io/vtkhdf.hpp"

#include <hdf5.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "libmpm/io/durable_file.hpp"

namespace mpm {
namespace {

/// One at a time inside HDF5; see the header.
std::mutex hdf5_turn;

struct ScalarColumn {
  const char* dataset;
  const char* unit;
  std::vector<double> Snapshot::*values;
};

/// The scalar arrays of /VTKHDF/PointData. Points and Velocity are vectors, and written apart.
constexpr std::array<ScalarColumn, 12> scalar_columns = {{
    {"Density", "kg/m^3", &Snapshot::density},
    {"Pressure", "Pa", &Snapshot::pressure},
    {"VonMises", "Pa", &Snapshot::von_mises},
    {"StressXX", "Pa", &Snapshot::stress_xx},
    {"StressYY", "Pa", &Snapshot::stress_yy},
    {"StressXY", "Pa", &Snapshot::stress_xy},
    {"StressZZ", "Pa", &Snapshot::stress_zz},
    {"PlasticStrain", "1", &Snapshot::equivalent_plastic_strain},
    {"PlasticWork", "J/m^3", &Snapshot::plastic_work},
    {"InternalEnergy", "J/kg", &Snapshot::specific_internal_energy},
    {"Temperature", "K", &Snapshot::temperature},
    {"Mass", "kg/m", &Snapshot::mass},
}};

constexpr char type_name[] = "UnstructuredGrid";
constexpr std::size_t type_length = sizeof(type_name) - 1;
constexpr unsigned char vtk_vertex = 1;
constexpr hsize_t chunk_rows = 1 << 16;

/// The turn, with HDF5's own printing off; errors are read from its stack instead.
class Session {
 public:
  explicit Session(const std::filesystem::path& path) : path_(path), turn_(hdf5_turn) {
    H5Eget_auto2(H5E_DEFAULT, &printer_, &printer_data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
  ~Session() { H5Eset_auto2(H5E_DEFAULT, printer_, printer_data_); }

  /// Passes a result of HDF5 on, unless it says failure.
  template <class Result>
  Result check(Result result, const std::string& what) const {
    if (result < 0) fail(what + ": " + innermost_error());
    return result;
  }
  [[noreturn]] void fail(const std::string& why) const {
    throw std::runtime_error(path_.string() + ": " + why);
  }

 private:
  static std::string innermost_error() {
    std::string text = "unknown HDF5 error";
    const auto first = [](unsigned n, const H5E_error2_t* error, void* out) -> herr_t {
      if (n == 0 && error->desc) *static_cast<std::string*>(out) = error->desc;
      return 0;
    };
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, first, &text);
    return text;
  }

  const std::filesystem::path& path_;
  std::lock_guard<std::mutex> turn_;
  H5E_auto2_t printer_ = nullptr;
  void* printer_data_ = nullptr;
};

/// An HDF5 identifier that closes itself.
class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, H5I_INVALID_HID)), close_(other.close_) {}
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

template <class T>
hid_t memory_type() {
  if constexpr (std::is_same_v<T, double>) return H5T_NATIVE_DOUBLE;
  if constexpr (std::is_same_v<T, std::int64_t>) return H5T_NATIVE_INT64;
  if constexpr (std::is_same_v<T, int>) return H5T_NATIVE_INT;
  if constexpr (std::is_same_v<T, unsigned char>) return H5T_NATIVE_UCHAR;
}

// ---------------------------------------------------------------------------------------------- writing

void write_text_attribute(const Session& s, hid_t object, const char* name, const std::string& text) {
  const Handle type(s.check(H5Tcopy(H5T_C_S1), name), H5Tclose);
  s.check(H5Tset_size(type, text.size()), name);
  s.check(H5Tset_strpad(type, H5T_STR_NULLPAD), name);
  const Handle space(s.check(H5Screate(H5S_SCALAR), name), H5Sclose);
  const Handle attribute(s.check(H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT), name),
                         H5Aclose);
  s.check(H5Awrite(attribute, type, text.data()), name);
}

template <class T>
void write_number_attribute(const Session& s, hid_t object, const char* name, std::span<const T> values) {
  const hsize_t size = values.size();
  const Handle space(s.check(size == 1 ? H5Screate(H5S_SCALAR) : H5Screate_simple(1, &size, nullptr), name),
                     H5Sclose);
  const Handle attribute(
      s.check(H5Acreate2(object, name, memory_type<T>(), space, H5P_DEFAULT, H5P_DEFAULT), name), H5Aclose);
  s.check(H5Awrite(attribute, memory_type<T>(), values.data()), name);
}

/// `width` numbers a row; 1 gives a dataset of rank one.
template <class T>
void write_dataset(const Session& s, hid_t group, const char* name, const std::vector<T>& values,
                   const char* unit, hsize_t width = 1) {
  const hsize_t rows = values.size() / width;
  const int rank = width == 1 ? 1 : 2;
  const hsize_t shape[2] = {rows, width};
  const hsize_t chunk[2] = {std::min(rows, chunk_rows), width};
  const Handle space(s.check(H5Screate_simple(rank, shape, nullptr), name), H5Sclose);
  const Handle layout(s.check(H5Pcreate(H5P_DATASET_CREATE), name), H5Pclose);
  s.check(H5Pset_obj_track_times(layout, false), name);
  if (rows > 1) {
    s.check(H5Pset_chunk(layout, rank, chunk), name);
    s.check(H5Pset_shuffle(layout), name);
    s.check(H5Pset_deflate(layout, 1), name);
  }
  const Handle dataset(
      s.check(H5Dcreate2(group, name, memory_type<T>(), space, H5P_DEFAULT, layout, H5P_DEFAULT), name),
      H5Dclose);
  if (rows > 0)
    s.check(H5Dwrite(dataset, memory_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), name);
  write_text_attribute(s, dataset, "unit", unit);
}

Handle create_group(const Session& s, hid_t parent, const char* name) {
  return {s.check(H5Gcreate2(parent, name, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), name), H5Gclose};
}

std::vector<double> rows_of_three(const std::vector<double>& x, const std::vector<double>& y) {
  std::vector<double> rows(3 * x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    rows[3 * i] = x[i];
    rows[3 * i + 1] = y[i];
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

  write_dataset(s, root, "Points", rows_of_three(snapshot.x, snapshot.y), "m", 3);
  write_cells(s, root, snapshot.x.size());

  const Handle points = create_group(s, root, "PointData");
  write_dataset(s, points, "Velocity", rows_of_three(snapshot.velocity_x, snapshot.velocity_y), "m/s", 3);
  for (const ScalarColumn& column : scalar_columns)
    write_dataset(s, points, column.dataset, snapshot.*column.values, column.unit);

  const Handle fields = create_group(s, root, "FieldData");
  write_dataset(s, fields, "Time", std::vector<double>{snapshot.time}, "s");
  write_dataset(s, fields, "Step", std::vector<std::int64_t>{snapshot.step}, "1");
}

/// The whole file, made in memory: the disk, and what can go wrong with it, is left to write_durably().
std::vector<std::byte> file_image(const std::filesystem::path& path, const Snapshot& snapshot) {
  const Session s(path);
  const Handle access(s.check(H5Pcreate(H5P_FILE_ACCESS), "memory file"), H5Pclose);
  s.check(H5Pset_fapl_core(access, 1 << 22, false), "memory file");
  const Handle file(s.check(H5Fcreate("snapshot", H5F_ACC_TRUNC, H5P_DEFAULT, access), "memory file"),
                    H5Fclose);
  write_group(s, file, snapshot);
  s.check(H5Fflush(file, H5F_SCOPE_GLOBAL), "flush");
  const ssize_t size = s.check(H5Fget_file_image(file, nullptr, 0), "image");
  std::vector<std::byte> image(static_cast<std::size_t>(size));
  s.check(H5Fget_file_image(file, image.data(), image.size()), "image");
  return image;
}

void check_lengths(const std::filesystem::path& path, const Snapshot& snapshot) {
  const auto check = [&](const char* name, const std::vector<double>& column) {
    if (column.size() == snapshot.x.size()) return;
    throw std::invalid_argument(path.string() + ": snapshot has " + std::to_string(snapshot.x.size()) +
                                " particles, but " + std::to_string(column.size()) + " values of " + name);
  };
  check("y", snapshot.y);
  check("velocity_x", snapshot.velocity_x);
  check("velocity_y", snapshot.velocity_y);
  for (const ScalarColumn& column : scalar_columns) check(column.dataset, snapshot.*column.values);
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

std::vector<double> read_dataset(const Session& s, hid_t group, const char* name, hsize_t width) {
  const Handle dataset(s.check(H5Dopen2(group, name, H5P_DEFAULT), name), H5Dclose);
  const Handle space(s.check(H5Dget_space(dataset), name), H5Sclose);
  const int rank = width == 1 ? 1 : 2;
  hsize_t shape[2] = {0, 1};
  if (H5Sget_simple_extent_ndims(space) != rank) s.fail(std::string(name) + ": has the wrong rank");
  s.check(H5Sget_simple_extent_dims(space, shape, nullptr), name);
  if (shape[1] != width) s.fail(std::string(name) + ": has the wrong number of columns");
  std::vector<double> values(shape[0] * width);
  if (!values.empty())
    s.check(H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), name);
  return values;
}

void split_rows_of_three(const std::vector<double>& rows, std::vector<double>& x, std::vector<double>& y) {
  x.resize(rows.size() / 3);
  y.resize(rows.size() / 3);
  for (std::size_t i = 0; i < x.size(); ++i) {
    x[i] = rows[3 * i];
    y[i] = rows[3 * i + 1];
  }
}

Snapshot read_group(const std::filesystem::path& path) {
  const Session s(path);
  const Handle file(s.check(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), "cannot open"), H5Fclose);
  const Handle root(s.check(H5Gopen2(file, "VTKHDF", H5P_DEFAULT), "VTKHDF"), H5Gclose);
  check_type(s, root);
  Snapshot snapshot;
  snapshot.time = read_number_attribute<double>(s, root, "time");
  snapshot.step = read_number_attribute<std::int64_t>(s, root, "step");
  split_rows_of_three(read_dataset(s, root, "Points", 3), snapshot.x, snapshot.y);
  const Handle points(s.check(H5Gopen2(root, "PointData", H5P_DEFAULT), "PointData"), H5Gclose);
  split_rows_of_three(read_dataset(s, points, "Velocity", 3), snapshot.velocity_x, snapshot.velocity_y);
  for (const ScalarColumn& column : scalar_columns)
    snapshot.*column.values = read_dataset(s, points, column.dataset, 1);
  return snapshot;
}

}  // namespace

void write_vtkhdf(const std::filesystem::path& path, const Snapshot& snapshot) {
  check_lengths(path, snapshot);
  const std::vector<std::byte> image = file_image(path, snapshot);
  write_durably(path, image);
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
