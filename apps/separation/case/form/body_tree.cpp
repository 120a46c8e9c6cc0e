#include "separation/case/form/body_tree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include "libcontact/base/complaint.hpp"
#include "separation/case/form/case_parts.hpp"

namespace separation {
namespace {

using contact::TomlTable;
using Eigen::Matrix3d;

// A [[body]] while it is read.
struct Entry {
  TomlTable table;
  std::string name;
  std::string on = {};  // "": the carrier
  enum class Reading { waits, goes_on, done } reading = Reading::waits;
  int parent = -1;  // the entry that it hangs on
  int copy = -1;    // the copy of that one; -1: each copy has one of these
  std::vector<Body> copies = {};
  std::vector<Matrix3d> turns = {};
};

class Reader {
 public:
  Reader(const TomlTable& file, const RigidBody& carrier, const JointLaws& laws,
         contact::SharedLaws& made)
      : carrier_(carrier), laws_(laws), made_(made) {
    for (const TomlTable& table : file.tables("body")) {
      Entry entry{table, table.text("name")};
      if (const auto hinge = table.optional_table("hinge")) {
        entry.on = hinge->optional_text("on").value_or("");
      }
      if (entry.on == carrier.name) entry.on.clear();
      entries_.push_back(std::move(entry));
    }
  }

  BodyTree read() {
    for (int i = 0; i < size(); ++i) read(i);
    BodyTree tree;
    std::vector<int> first;
    int count = 0;
    for (const Entry& entry : entries_) {
      first.push_back(count);
      tree.counts.push_back(static_cast<int>(entry.copies.size()));
      count += tree.counts.back();
    }
    for (Entry& entry : entries_) {
      for (int copy = 0; copy < static_cast<int>(entry.copies.size()); ++copy) {
        Body& body = entry.copies[copy];
        if (entry.parent >= 0) {
          body.hinge.on = 1 + first[entry.parent] + parent_copy(entry, copy);
        }
        tree.bodies.push_back(std::move(body));
        tree.turns.push_back(entry.turns[copy]);
      }
    }
    return tree;
  }

 private:
  int size() const { return static_cast<int>(entries_.size()); }
  TomlTable hinge_of(const Entry& entry) const {
    return *entry.table.optional_table("hinge");
  }

  void read(int i) {
    Entry& entry = entries_[i];
    if (entry.reading == Entry::Reading::done) return;
    entry.reading = Entry::Reading::goes_on;
    if (!entry.on.empty()) find_parent(i);
    const RigidBody* parent = &carrier_;
    if (entry.parent >= 0) {
      parent = &entries_[entry.parent].copies[std::max(entry.copy, 0)].rigid;
    }
    const Body body = read_body(entry.table, *parent, laws_, made_);
    const Pattern pattern = read_pattern(entry.table, body.hinge);
    if (pattern.count > 1 && carried_copies(entry) > 1) {
      entry.table.must_be(
          "pattern",
          fmt::format("left out: each copy of \"{}\" has one", entry.on));
    }
    const int count = pattern.count * carried_copies(entry);
    for (int copy = 0; copy < count; ++copy) {
      entry.copies.push_back(pattern.copy_of(body, copy, parent->com));
      if (count > 1) name_copy(entry.copies.back(), copy);
      entry.turns.push_back(turn_of(entry, pattern, copy));
    }
    entry.reading = Entry::Reading::done;
  }

  // How many it has since what it hangs on has them.
  int carried_copies(const Entry& entry) const {
    return entry.parent < 0 || entry.copy >= 0
               ? 1
               : static_cast<int>(entries_[entry.parent].copies.size());
  }

  // The copy of that on which this copy hangs.
  int parent_copy(const Entry& entry, int copy) const {
    if (entry.copy >= 0) return entry.copy;
    return carried_copies(entry) > 1 ? copy : 0;
  }

  Matrix3d turn_of(const Entry& entry, const Pattern& pattern, int copy) const {
    if (entry.parent < 0) return pattern.turn(copy);
    return entries_[entry.parent].turns[parent_copy(entry, copy)];
  }

  // Reads what it hangs on, and finds that.
  void find_parent(int i) {
    Entry& entry = entries_[i];
    for (int j = 0; j < size(); ++j) {
      const std::string& name = entries_[j].name;
      if (entry.on != name && !entry.on.starts_with(name + " ")) continue;
      if (j == i) hinge_of(entry).must_be("on", "another body");
      if (entries_[j].reading == Entry::Reading::goes_on) {
        refuse_circle(i, j);
      }
      entry.parent = j;
      read(j);
      if (entry.on == name) return;
      const auto& copies = entries_[j].copies;
      const auto is_it = [&](const Body& body) {
        return body.rigid.name == entry.on;
      };
      const auto found = std::ranges::find_if(copies, is_it);
      if (found == copies.end()) continue;
      entry.copy = static_cast<int>(found - copies.begin());
      return;
    }
    std::vector<std::string> names = {carrier_.name};
    for (const Entry& other : entries_) {
      if (&other != &entry) names.push_back(other.name);
    }
    hinge_of(entry).fail("on",
                         contact::detail::unknown("body", entry.on, names));
  }

  // `i` hangs on `j`, which hangs on it by way of others.
  [[noreturn]] void refuse_circle(int i, int j) const {
    std::string text = entries_[i].name;
    for (int k = j; k != i; k = entries_[k].parent) {
      text += " on " + entries_[k].name;
    }
    hinge_of(entries_[i])
        .must_be("on", fmt::format("a body that does not hang on this one: {} "
                                   "on {}",
                                   text, entries_[i].name));
  }

  const RigidBody& carrier_;
  const JointLaws& laws_;
  contact::SharedLaws& made_;
  std::vector<Entry> entries_;
};

}  // namespace

BodyTree read_bodies(const TomlTable& file, const RigidBody& carrier,
                     const JointLaws& laws, contact::SharedLaws& made) {
  return Reader(file, carrier, laws, made).read();
}

}  // namespace separation
