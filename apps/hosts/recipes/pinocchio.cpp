// Friction in the revolute joints of a Pinocchio model: a step of a mechanism
// whose joints slide, stop, hold and let go, with rates of exactly 0 at rest.
#include <Eigen/Cholesky>
#include <pinocchio/algorithm/aba.hpp>
#include <pinocchio/algorithm/crba.hpp>
#include <pinocchio/algorithm/joint-configuration.hpp>
#include <pinocchio/algorithm/rnea.hpp>
#include <pinocchio/multibody/data.hpp>
#include <pinocchio/multibody/model.hpp>
#include <vector>

#include "hosts/joint_handle.hpp"

namespace contact_hosts::pinocchio_recipe {

class HingeFriction {
 public:
  /// @param model  whose joints are all revolute about z of their frame
  /// @param files  joint files, one for each of its joints
  HingeFriction(const pinocchio::Model& model,
                const std::vector<std::string>& files)
      : model_(model), data_(model), steps_(files.size()) {
    for (const std::string& file : files) {
      joints_.push_back(read_joint(file, "HingeFriction", CONTACT_PIN));
      handles_.push_back(joints_.back().get());
    }
  }

  /// A step of positions q and rates v under torques tau, semi-implicit.
  void step(Eigen::VectorXd& q, Eigen::VectorXd& v, const Eigen::VectorXd& tau,
            double step) {
    const Eigen::VectorXd free =
        v + step * pinocchio::aba(model_, data_, q, v, tau);
    pinocchio::crba(model_, data_, q);
    Eigen::MatrixXd w = data_.M.selfadjointView<Eigen::Upper>();
    w /= step;
    std::vector<contact_step_start> starts(handles_.size());
    for (std::size_t i = 0; i < starts.size(); ++i) {
      // The first joint of a model is the universe.
      Eigen::Vector3d::Map(starts[i].reaction) = data_.f[i + 1].linear();
      set_z(starts[i].angular_velocity, v[i]);
      set_z(starts[i].free, free[i]);
      set_z(starts[i].axis, 1);
    }
    must(contact_joints_step(handles_.data(), handles_.size(), starts.data(),
                             w.data(), steps_.data(), nullptr));
    const Eigen::VectorXd before = v;
    for (std::size_t i = 0; i < starts.size(); ++i) {
      v[i] = steps_[i].angular_velocity[2];
    }
    // Reactions of this step, for the next.
    pinocchio::rnea(model_, data_, q, before, (v - before) / step);
    q = pinocchio::integrate(model_, q, v * step);
  }

  const contact_step& last(std::size_t joint) const { return steps_[joint]; }

 private:
  static void set_z(double (&vector)[3], double z) {
    Eigen::Vector3d::Map(vector) = z * Eigen::Vector3d::UnitZ();
  }

  const pinocchio::Model& model_;
  pinocchio::Data data_;
  std::vector<JointHandle> joints_;
  std::vector<const contact_joint*> handles_;
  std::vector<contact_step> steps_;
};

}  // namespace contact_hosts::pinocchio_recipe
