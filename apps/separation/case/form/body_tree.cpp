#include "separation/case/form/body_tree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include "libcontact/base/complaint.hpp"
#include "separation/case/case_names.hpp"
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
  int parent = -1;      // the entry that it hangs on
  int copy = -1;        // the copy of that one; -1: each copy has one of these
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
    for (Entry& entry : entries_) {
      if (!entry.on.empty()) entry.parent = parent_of(entry);
    }
    refuse_circles();
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
    if (!entry.copies.empty()) return;
    if (entry.parent >= 0) {
      read(entry.parent);
      find_copy(entry);
    }
    const RigidBody* parent = &carrier_;
    if (entry.parent >= 0) {
      parent = &entries_[entry.parent].copies[std::max(entry.copy, 0)].rigid;
    }
    const Body body = read_body(entry.table, *parent, laws_, made_);
    const Pattern pattern = read_pattern(entry.table);
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

  [[noreturn]] void refuse_unknown(const Entry& entry) const {
    std::vector<std::string> names = {carrier_.name};
    for (const Entry& other : entries_) {
      if (&other != &entry) names.push_back(other.name);
    }
    hinge_of(entry).fail("on",
                         contact::detail::unknown("body", entry.on, names));
  }

  // The body of that name, or the one of whose copies it may be the name.
  int parent_of(const Entry& entry) const {
    int found = -1;
    for (int j = 0; j < size(); ++j) {
      const std::string& name = entries_[j].name;
      if (entry.on == name) {
        if (&entries_[j] == &entry)
          hinge_of(entry).must_be("on", "another body");
        return j;
      }
      if (!entry.on.starts_with(name + " ")) continue;
      if (found < 0 || name.size() > entries_[found].name.size()) found = j;
    }
    if (found < 0) refuse_unknown(entry);
    return found;
  }

  // In the body that it hangs on, which is read.
  void find_copy(Entry& entry) const {
    const Entry& parent = entries_[entry.parent];
    if (entry.on == parent.name) return;
    const auto found = std::ranges::find(
        parent.copies, entry.on,
        [](const Body& body) -> const std::string& { return body.rigid.name; });
    if (found == parent.copies.end()) refuse_unknown(entry);
    entry.copy = static_cast<int>(found - parent.copies.begin());
  }

  void refuse_circles() const {
    std::vector<std::string> names;
    std::vector<int> parents;
    for (const Entry& entry : entries_) {
      names.push_back(entry.name);
      parents.push_back(entry.parent);
    }
    for (int i = size() - 1; i >= 0; --i) {
      const std::string circle = circle_of(names, parents, i, "on");
      if (circle.empty()) continue;
      hinge_of(entries_[i])
          .must_be("on", "a body that does not hang on this one: " + circle);
    }
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
