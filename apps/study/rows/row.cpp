#include "study/rows/row.hpp"

#include <boost/crc.hpp>
#include <cstring>

#include "libcontact/base/error.hpp"

namespace study {
namespace {

// In front of the rest, twice: one that is damaged is told from a row that was
// cut.
struct Size {
  std::uint32_t size;
  std::uint32_t complement;
};
// Behind it.
using Checksum = std::uint32_t;

template <class T>
void put(std::string& to, const T& value) {
  const auto* bytes = reinterpret_cast<const char*>(&value);
  to.append(bytes, sizeof value);
}

template <class T>
T take(std::string_view& from) {
  T value;
  std::memcpy(&value, from.data(), sizeof value);
  from.remove_prefix(sizeof value);
  return value;
}

Checksum checksum(std::string_view bytes) {
  boost::crc_32_type crc;
  crc.process_bytes(bytes.data(), bytes.size());
  return crc.checksum();
}

constexpr std::size_t least_size(std::size_t numbers) {
  return sizeof(Row::run) + numbers * sizeof(double);
}

[[noreturn]] void damaged() { throw contact::Error("a row is damaged"); }

// Of the row without size and checksum.
std::size_t size_of(std::string_view bytes, std::size_t numbers) {
  const auto [size, complement] = take<Size>(bytes);
  const std::size_t least = least_size(numbers);
  if (size != ~complement || size < least || size > least + longest_failure) {
    damaged();
  }
  return size;
}

}  // namespace

std::string to_bytes(const Row& row) {
  const std::string failure = row.failure.substr(0, longest_failure);
  std::string bytes;
  const auto size = static_cast<std::uint32_t>(least_size(row.numbers.size()) +
                                               failure.size());
  put(bytes, Size{size, ~size});
  put(bytes, row.run);
  for (const double number : row.numbers) put(bytes, number);
  bytes += failure;
  put(bytes, checksum(bytes));
  return bytes;
}

bool has_whole_row(std::string_view bytes, std::size_t numbers) {
  return bytes.size() >= sizeof(Size) &&
         bytes.size() >=
             sizeof(Size) + size_of(bytes, numbers) + sizeof(Checksum);
}

Row take_row(std::string_view& bytes, std::size_t numbers) {
  if (!has_whole_row(bytes, numbers)) damaged();
  std::string_view checked =
      bytes.substr(0, sizeof(Size) + size_of(bytes, numbers));
  bytes.remove_prefix(checked.size());
  if (take<Checksum>(bytes) != checksum(checked)) damaged();
  take<Size>(checked);
  Row row{take<std::uint64_t>(checked), {}, {}};
  for (std::size_t i = 0; i < numbers; ++i) {
    row.numbers.push_back(take<double>(checked));
  }
  row.failure = checked;
  return row;
}

}  // namespace study
