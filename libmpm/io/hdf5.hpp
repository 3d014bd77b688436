#pragma once
/// HDF5 for the sources of this folder, which alone include it: turns, handles that close themselves,
/// datasets.
#include <hdf5.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <mutex>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace mpm::hdf5 {

inline constexpr hsize_t chunk_rows = 1 << 16;

/// One at a time inside HDF5: Debian's is built without thread safety.
inline std::mutex turn;

/// The turn, with HDF5's own printing off; errors are read from its stack instead.
class Session {
 public:
  explicit Session(const std::filesystem::path& path) : path_(path), turn_(turn) {
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

/// Opens a file to read it, without a lock of the file system: files here are written under another name and
/// renamed, and some shares refuse locks.
inline Handle open_to_read(const Session& s, const std::filesystem::path& path) {
  const Handle access(s.check(H5Pcreate(H5P_FILE_ACCESS), "cannot open"), H5Pclose);
  s.check(H5Pset_file_locking(access, false, true), "cannot open");
  return Handle(s.check(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access), "cannot open"), H5Fclose);
}

template <class T>
hid_t memory_type() {
  if constexpr (std::is_same_v<T, double>) return H5T_NATIVE_DOUBLE;
  if constexpr (std::is_same_v<T, std::int64_t>) return H5T_NATIVE_INT64;
  if constexpr (std::is_same_v<T, int>) return H5T_NATIVE_INT;
  if constexpr (std::is_same_v<T, unsigned char>) return H5T_NATIVE_UCHAR;
}

inline void write_text_attribute(const Session& s, hid_t object, const char* name, const std::string& text) {
  const Handle type(s.check(H5Tcopy(H5T_C_S1), name), H5Tclose);
  s.check(H5Tset_size(type, text.size()), name);
  s.check(H5Tset_strpad(type, H5T_STR_NULLPAD), name);
  const Handle space(s.check(H5Screate(H5S_SCALAR), name), H5Sclose);
  const Handle attribute(s.check(H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT), name),
                         H5Aclose);
  s.check(H5Awrite(attribute, type, text.data()), name);
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

inline Handle create_group(const Session& s, hid_t parent, const char* name) {
  return {s.check(H5Gcreate2(parent, name, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), name), H5Gclose};
}

/// The whole file, made in memory: the disk, and what can go wrong with it, is left to write_durably().
std::vector<std::byte> file_image(const std::filesystem::path& path, const auto& write) {
  const Session s(path);
  const Handle access(s.check(H5Pcreate(H5P_FILE_ACCESS), "memory file"), H5Pclose);
  s.check(H5Pset_fapl_core(access, 1 << 22, false), "memory file");
  const Handle file(s.check(H5Fcreate("image", H5F_ACC_TRUNC, H5P_DEFAULT, access), "memory file"), H5Fclose);
  write(s, file);
  s.check(H5Fflush(file, H5F_SCOPE_GLOBAL), "flush");
  const ssize_t size = s.check(H5Fget_file_image(file, nullptr, 0), "image");
  std::vector<std::byte> image(static_cast<std::size_t>(size));
  s.check(H5Fget_file_image(file, image.data(), image.size()), "image");
  return image;
}

/// What write_dataset wrote.
template <class T>
std::vector<T> read_dataset(const Session& s, hid_t group, const char* name, hsize_t width = 1) {
  const Handle dataset(s.check(H5Dopen2(group, name, H5P_DEFAULT), name), H5Dclose);
  const Handle space(s.check(H5Dget_space(dataset), name), H5Sclose);
  const int rank = width == 1 ? 1 : 2;
  hsize_t shape[2] = {0, 1};
  if (H5Sget_simple_extent_ndims(space) != rank) s.fail(std::string(name) + ": has the wrong rank");
  s.check(H5Sget_simple_extent_dims(space, shape, nullptr), name);
  if (shape[1] != width) s.fail(std::string(name) + ": has the wrong number of columns");
  std::vector<T> values(shape[0] * width);
  if (!values.empty())
    s.check(H5Dread(dataset, memory_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), name);
  return values;
}

}  // namespace mpm::hdf5
