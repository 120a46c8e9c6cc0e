#include "separation/output/history_file.hpp"

#include <fmt/format.h>
#include <hdf5.h>

#include <array>
#include <string_view>
#include <utility>

#include "cli/output.hpp"
#include "libcontact/base/error.hpp"
#include "multibody/friction/hinge_friction.hpp"
#include "separation/output/file_name.hpp"

namespace separation {
namespace {

using multibody::HingeMode;

constexpr std::array<HingeMode, 4> modes = {
    HingeMode::sliding, HingeMode::resting, HingeMode::locked,
    HingeMode::released};

bool is_mode(const std::string& column) { return column.ends_with(".mode"); }

void write_csv(const Rows& rows, const cli::Table& table, cli::Output& output) {
  cli::TableWriter writer(output, table);
  cli::Text text;
  cli::RowWriter row(table, text);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t j = 0; j < rows.columns.size(); ++j) {
      const double value = rows.at(i, j);
      if (is_mode(rows.columns[j])) {
        row.text(to_string(static_cast<HingeMode>(static_cast<int>(value))));
      } else {
        row.number(value);
      }
    }
    row.end();
    writer.write(text.view());
    text.clear();
  }
  writer.finish();
}

// HDF5 answers with negative numbers.
template <class Answer>
Answer check(Answer answer) {
  if (answer < 0) throw contact::Error("the history: HDF5 failed");
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

// Column "BODY.QUANTITY_UNIT" as a path and its unit; the unit is what
// follows the quantity's name, which has no unit inside.
struct Place {
  std::string path;
  std::string unit;
};
Place place_of(std::string column) {
  static constexpr std::pair<std::string_view, std::string_view> units[] = {
      {"_deg_per_s2", "deg/s^2"},
      {"_deg_per_s", "deg/s"},
      {"_rad_per_s", "rad/s"},
      {"_m_per_s", "m/s"},
      {"_N_m", "N m"},
      {"_deg", "deg"},
      {"_Pa", "Pa"},
      {"_N", "N"},
      {"_J", "J"},
      {"_m", "m"},
      {"_s", "s"}};
  std::string unit;
  for (const auto& [ending, name] : units) {
    if (!column.ends_with(ending)) continue;
    unit = name;
    break;
  }
  for (char& c : column) {
    if (c == '.') c = '/';
  }
  return {std::move(column), std::move(unit)};
}

std::string mode_words() {
  std::string words;
  for (const HingeMode mode : modes) {
    if (!words.empty()) words += ", ";
    words += fmt::format("{} {}", static_cast<int>(mode), to_string(mode));
  }
  return words;
}

void write_columns(const Rows& rows, const std::vector<std::string>& names,
                   hid_t file) {
  const Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
  check(H5Pset_create_intermediate_group(links, 1));
  const hsize_t size = rows.size();
  const Handle space(H5Screate_simple(1, &size, nullptr), H5Sclose);
  std::vector<double> values(rows.size());
  for (const std::string& name : names) {
    const std::size_t j = rows.column(name);
    for (std::size_t i = 0; i < rows.size(); ++i) values[i] = rows.at(i, j);
    const bool mode = is_mode(name);
    const Place place = place_of(name);
    const Handle data(H5Dcreate2(file, place.path.c_str(),
                                 mode ? H5T_STD_I8LE : H5T_IEEE_F64LE, space,
                                 links, H5P_DEFAULT, H5P_DEFAULT),
                      H5Dclose);
    check(H5Dwrite(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT,
                   values.data()));
    if (!place.unit.empty()) write_attribute(data, "unit", place.unit);
    if (mode) write_attribute(data, "words", mode_words());
  }
}

// The file as bytes, made in memory and written by us: an HDF5 that cannot
// write crashes when it closes itself at the end of the program, and does not
// say why it cannot. It takes twice the memory of the rows, for a moment.
std::string hdf5_image(const Rows& rows,
                       const std::vector<std::string>& names) {
  // Its own messages would go to standard error.
  check(H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr));
  const Handle in_memory(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  constexpr std::size_t growth = 1 << 20;
  check(H5Pset_fapl_core(in_memory, growth, false));
  const Handle file(H5Fcreate("history", H5F_ACC_TRUNC, H5P_DEFAULT, in_memory),
                    H5Fclose);
  write_columns(rows, names, file);
  check(H5Fflush(file, H5F_SCOPE_GLOBAL));
  std::string image(check(H5Fget_file_image(file, nullptr, 0)), '\0');
  check(H5Fget_file_image(file, image.data(), image.size()));
  return image;
}

const std::string& checked(const std::string& name) {
  check_ending("--history", name, {".csv", ".h5", ".hdf5"},
               ".csv, .h5 or .hdf5; - for CSV on standard output");
  return name;
}

}  // namespace

HistoryFile::HistoryFile(const std::string& name, const cli::TableStyle& style,
                         const std::vector<std::string>& columns)
    : hdf5_(is_hdf5(name)), table_(style, columns), output_(checked(name)) {}

void HistoryFile::write(const Rows& rows) {
  if (hdf5_) {
    const auto& asked = table_.style().columns;
    output_.write(hdf5_image(rows, asked.empty() ? rows.columns : asked));
  } else {
    write_csv(rows, table_, output_);
  }
  output_.commit();
}

}  // namespace separation
