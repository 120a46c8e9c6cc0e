// Joints from one text with arrays of numbers for some keys.
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <memory>
#include <span>

#include "libcontact/files/joint_form.hpp"
#include "python/file_joint.hpp"
#include "python/interpreter_lock.hpp"

namespace contact_python {
namespace {

class FileJoints : public JointSet {
 public:
  FileJoints(JointSet joints, std::size_t laws)
      : JointSet(std::move(joints)), laws_(laws) {}
  std::size_t laws() const { return laws_; }

 private:
  std::size_t laws_;
};

// @param numbers  of the keys, (..., n)
std::unique_ptr<FileJoints> make_joints(
    const std::string& text, const std::string& source,
    const std::filesystem::path& folder, const Settings& settings,
    const std::vector<std::string>& keys, const Numbers& numbers,
    bool without_seat, bool without_relief) {
  const Shape shape(numbers.shape(), numbers.shape() + numbers.ndim() - 1);
  std::span<const double> rest(numbers.data(),
                               static_cast<std::size_t>(numbers.size()));
  const LeftOut left_out{without_seat, without_relief};
  const Unlocked unlocked;
  contact::JointForm form(text, source, folder, key_settings(settings), keys);
  contact::SharedLaws laws;
  std::vector<contact::Joint> all;
  all.reserve(rest.size() / keys.size());
  std::string refusal;
  for (; !rest.empty(); rest = rest.subspan(keys.size())) {
    const contact::JointSpec spec = form.with(rest.first(keys.size()));
    AnyJoint one = any_joint(left_out.of(spec), laws);
    all.push_back(std::move(one.joint));
    if (refusal.empty()) refusal = std::move(one.refusal);
  }
  return std::make_unique<FileJoints>(
      JointSet(shape, std::move(all), std::move(refusal)), laws.size());
}

}  // namespace

void bind_joints(py::module_& m) {
  py::class_<FileJoints, JointSet>(m, "Joints")
      .def(py::init(&make_joints), py::arg("text"), py::arg("source"),
           py::arg("folder"), py::arg("settings"), py::arg("keys"),
           py::arg("numbers"), py::arg("without_seat"),
           py::arg("without_relief"))
      .def_property_readonly(
          "laws", &FileJoints::laws,
          "How many laws of half-angle and pressure were made for all of "
          "them.");
}

}  // namespace contact_python
