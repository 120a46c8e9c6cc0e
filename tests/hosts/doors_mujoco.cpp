#include <Eigen/Geometry>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <random>
#include <stdexcept>

#include "hosts/doors.hpp"
#include "hosts/mujoco/hinge_friction.hpp"

namespace contact::test {

using Eigen::Vector3d;

std::vector<DoorRow> mujoco_rows(const std::string& file, bool pin, int count) {
  const std::string xml =
      std::filesystem::temp_directory_path() /
      (std::string("contact_doors_") + (pin ? "pin" : "ball") + ".xml");
  std::ofstream(xml)
      << "<mujoco><option gravity='1 2 -9.81'/><worldbody><body><joint name='0'"
      << (pin ? " type='hinge' axis='.36 .48 .8'" : " type='ball'")
      << "/><inertial mass='5' pos='0.1 0 -.4' diaginertia='.1 .1 .02'/>"
         "</body></worldbody></mujoco>";
  char error[500] = "";
  mjModel* const model = mj_loadXML(xml.c_str(), nullptr, error, sizeof error);
  if (!model) throw std::runtime_error(error);
  mjData* const d = mj_makeData(model);
  contact_hosts::mujoco::HingeFriction friction(model);
  friction.add("0", file);
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  std::vector<DoorRow> rows(count);
  for (DoorRow& row : rows) {
    for (int k = 0; k < model->nq; ++k) d->qpos[k] = normal(random);
    if (!pin) mju_normalize4(d->qpos);
    for (int k = 0; k < model->nv; ++k) d->qvel[k] = normal(random);
    mj_forward(model, d);
    friction.note_reactions(d);
    mju_zero(d->qfrc_passive, model->nv);
    friction.add_torque(d);
    const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> axes(
        d->xmat + 9);
    const Vector3d axis = pin ? Vector3d(d->xaxis) : Vector3d::Zero();
    std::copy_n(d->cfrc_int + 9, 3, row.reaction.data());
    Vector3d::Map(row.axis.data()) = axis;
    Vector3d::Map(row.rate.data()) =
        pin ? Vector3d(d->qvel[0] * axis) : axes * Vector3d(d->qvel);
    Vector3d::Map(row.moment.data()) = pin ? Vector3d(d->qfrc_passive[0] * axis)
                                           : axes * Vector3d(d->qfrc_passive);
  }
  mj_deleteData(d);
  mj_deleteModel(model);
  std::filesystem::remove(xml);
  return rows;
}

}  // namespace contact::test
