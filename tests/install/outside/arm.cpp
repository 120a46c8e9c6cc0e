// An arm of MuJoCo with the friction of a joint file: arm MODEL JOINT
#include <cstdio>

#include "hosts/mujoco/hinge_friction.hpp"

int main(int /*count*/, char** argument) {
  char error[1000] = "";
  mjModel* const model = mj_loadXML(argument[1], nullptr, error, sizeof error);
  if (!model) return std::puts(error), 1;
  mjData* const data = mj_makeData(model);
  contact_hosts::mujoco::HingeFriction friction(model);
  friction.add("arm", argument[2]);
  while (data->time < 1) friction.step(data);
  std::printf("rate %g rad/s at %g rad\n", data->qvel[0], data->qpos[0]);
  mj_deleteData(data);
  mj_deleteModel(model);
}
