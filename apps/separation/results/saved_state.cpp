#include "separation/results/saved_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/crc.hpp>
#include <cstddef>
#include <optional>
#include <utility>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/text.hpp"
#include "separation/case/identity.hpp"
#include "separation/results/cbor.hpp"
#include "separation/results/state_json.hpp"

namespace separation {
namespace {

using nlohmann::json;

constexpr std::string_view program_format = "hinge-separation checkpoint ";
constexpr std::string_view format_name = "hinge-separation checkpoint 16";
static_assert(format_name.starts_with(program_format));
constexpr std::size_t sum_size = 8;  // in hexadecimal digits
constexpr const char* source = "the saved state";

bool contains(std::string_view bytes, std::string_view text) {
  return bytes.find(text) != bytes.npos;
}

bool is_whole(const json& j) {
  return j.is_array() ? std::ranges::all_of(j, is_whole)
                      : j.is_number_integer();
}

// Fractions in the place of whole numbers are refused: their cast is undefined
// where they are large.
bool has_whole_numbers(const json& j) {
  constexpr std::array names = {"modes",  "spent",   "fault",
                                "blocks", "on_stop", "rests_on"};
  if (j.is_array()) return std::ranges::all_of(j, has_whole_numbers);
  if (!j.is_object()) return true;
  return std::ranges::all_of(j.items(), [&](const auto& item) {
    return std::ranges::count(names, item.key()) > 0
               ? is_whole(item.value())
               : has_whole_numbers(item.value());
  });
}

// The number of a format, at the beginning of the text after the words.
std::string_view number_in(std::string_view text) {
  return text.substr(0, text.find_first_not_of("0123456789"));
}

// Refuses a file of another version of the program.
[[noreturn]] void refuse_format(std::string_view bytes,
                                const std::string& name) {
  const auto after = bytes.find(program_format) + program_format.size();
  throw contact::Error(contact::detail::must_be(
      fmt::format("{}: format {} of the checkpoint", name,
                  number_in(bytes.substr(after))),
      fmt::format("{}, that of this version of hinge-separation",
                  number_in(format_name.substr(program_format.size())))));
}

std::string check_sum(std::string_view bytes) {
  boost::crc_32_type sum;
  sum.process_bytes(bytes.data(), bytes.size());
  return fmt::format("{:08x}", sum.checksum());
}

}  // namespace

std::string packed(json j) {
  j["format"] = format_name;
  std::string bytes = fmt::format("{}\n", format_name);
  json::to_cbor(j, bytes);
  return bytes + check_sum(bytes);
}

json unpacked(std::string_view bytes, const std::string& name) {
  if (!contains(bytes, program_format)) refuse_stranger(name);
  if (!contains(bytes, format_name)) {
    refuse_format(bytes, name);
  }
  const std::string_view content = bytes.substr(0, bytes.size() - sum_size);
  const std::string sum = check_sum(content);
  const std::string_view written = bytes.substr(content.size());
  if (sum != written) {
    throw contact::Error(
        fmt::format("{}: damaged: check sum {}, the file says {}", name, sum,
                    contact::detail::printable(written)));
  }
  std::string_view rest = content.substr(content.find('\n') + 1);
  std::optional<json> j = take_cbor(rest);
  if (!j || !rest.empty() || !has_whole_numbers(*j)) refuse_stranger(name);
  return std::move(*j);
}

void check_identity(const json& j, const std::string& identity,
                    const std::string& name) {
  if (j.at("identity") == identity) return;
  throw contact::Error(name +
                       ": the checkpoint must be one of this case file, these "
                       "joints and these options");
}

void refuse_stranger(const std::string& name) {
  throw contact::Error(name +
                       ": the file must be a checkpoint of hinge-separation");
}

std::string identity_of(const Case& c, const RunOptions& options) {
  return fmt::format("{}\n{}\n",
                     static_cast<int>(options.friction.value_or(c.friction)),
                     options.clearance) +
         identity(c);
}

std::string saved_bytes(const RunState& state, const std::string& identity) {
  const Recorder::Memory& memory = state.memory;
  return packed({{"identity", identity},
                 {"simulation", state.simulation},
                 {"memory", memory},
                 {"columns", memory.rows.columns},
                 {"numbers", memory.rows.numbers},
                 {"notes", memory.notes}});
}

RunState saved_state(std::string_view bytes, const std::string& identity) {
  try {
    const json j = unpacked(bytes, source);
    check_identity(j, identity, source);
    RunState state{j.at("simulation"), j.at("memory")};
    state.memory.rows = {j.at("columns"), j.at("numbers")};
    state.memory.notes = j.at("notes");
    return state;
  } catch (const json::exception&) {
    refuse_stranger(source);
  }
}

}  // namespace separation
