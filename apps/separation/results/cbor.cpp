#include "separation/results/cbor.hpp"

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <vector>

namespace separation {
namespace {

// "memory", bodies, a body, "release", "rates", and some to spare.
constexpr std::size_t most_levels = 16;

// A head of CBOR (RFC 8949, section 3): what follows, and its number.
struct Head {
  unsigned kind;
  std::uint64_t number;
};

std::optional<Head> take_head(std::string_view& bytes) {
  constexpr unsigned one_byte = 24, eight_bytes = 27;
  if (bytes.empty()) return {};
  const unsigned first = static_cast<unsigned char>(bytes.front());
  bytes.remove_prefix(1);
  Head head{first >> 5U, first & 31U};
  if (head.number < one_byte) return head;
  if (head.number > eight_bytes) return {};  // an unknown length
  const std::size_t width = std::size_t{1} << (head.number - one_byte);
  if (bytes.size() < width) return {};
  head.number = 0;
  for (const char byte : bytes.substr(0, width)) {
    head.number = head.number << 8U | static_cast<unsigned char>(byte);
  }
  bytes.remove_prefix(width);
  return head;
}

// Whether an item was taken off.
bool pass_item(std::string_view& bytes) {
  enum Kind : unsigned { positive, negative, binary, text, list, map, tag };
  std::vector<std::uint64_t> left = {1};  // items left in every open list
  while (!left.empty()) {
    if (left.back() == 0) {
      left.pop_back();
      continue;
    }
    --left.back();
    const auto head = take_head(bytes);
    if (!head || head->kind == binary || head->kind == tag) return false;
    const bool is_list = head->kind == list || head->kind == map;
    if (!is_list && head->kind != text) continue;
    // Every item of a list has a byte at least.
    if (head->number > bytes.size()) return false;
    if (head->kind == text) bytes.remove_prefix(head->number);
    if (!is_list) continue;
    if (left.size() == most_levels) return false;
    left.push_back(head->kind == map ? 2 * head->number : head->number);
  }
  return true;
}

}  // namespace

std::optional<nlohmann::json> take_cbor(std::string_view& bytes) {
  const std::string_view all = bytes;
  if (!pass_item(bytes)) return {};
  return nlohmann::json::from_cbor(all.substr(0, all.size() - bytes.size()));
}

}  // namespace separation
