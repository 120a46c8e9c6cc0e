#include "cli/hdf5/columns.hpp"

#include <hdf5.h>

#include "libcontact/base/error.hpp"

namespace cli {
namespace {

// HDF5 reports errors by negative numbers.
template <class Answer>
Answer check(Answer answer) {
  if (answer < 0) throw contact::Error("HDF5 failed");
  return answer;
}

// An HDF5 object that closes itself.
class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {
    check(id);
  }
  ~Handle() { close_(id_); }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

void write_attribute(hid_t object, const char* name, const std::string& text) {
  const Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  check(H5Tset_size(type, text.size() + 1));
  check(H5Tset_cset(type, H5T_CSET_UTF8));
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Handle attribute(
      H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT),
      H5Aclose);
  check(H5Awrite(attribute, type, text.c_str()));
}

void write(const Hdf5Column& column, hid_t file, hid_t space, hid_t links,
           hid_t creation, const std::vector<double>& values) {
  const bool words = !column.words.empty();
  const Handle data(H5Dcreate2(file, column.path.c_str(),
                               words ? H5T_STD_I8LE : H5T_IEEE_F64LE, space,
                               links, creation, H5P_DEFAULT),
                    H5Dclose);
  check(H5Dwrite(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT,
                 values.data()));
  if (!column.unit.empty()) write_attribute(data, "unit", column.unit);
  if (words) write_attribute(data, "words", column.words);
}

}  // namespace

std::string hdf5_image(const std::vector<Hdf5Column>& columns, std::size_t rows,
                       const std::function<void(std::size_t, double*)>& fill) {
  // HDF5 would print messages of its own to standard error.
  check(H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr));
  const Handle in_memory(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  constexpr std::size_t growth = 1 << 20;
  check(H5Pset_fapl_core(in_memory, growth, false));
  const Handle file(H5Fcreate("columns", H5F_ACC_TRUNC, H5P_DEFAULT, in_memory),
                    H5Fclose);
  const Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
  check(H5Pset_create_intermediate_group(links, 1));
  // Equal columns give equal bytes, independent of the time.
  const Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  check(H5Pset_obj_track_times(creation, false));
  const hsize_t size = rows;
  const Handle space(H5Screate_simple(1, &size, nullptr), H5Sclose);
  std::vector<double> values(rows);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    fill(i, values.data());
    write(columns[i], file, space, links, creation, values);
  }
  check(H5Fflush(file, H5F_SCOPE_GLOBAL));
  std::string image(check(H5Fget_file_image(file, nullptr, 0)), '\0');
  check(H5Fget_file_image(file, image.data(), image.size()));
  return image;
}

}  // namespace cli
