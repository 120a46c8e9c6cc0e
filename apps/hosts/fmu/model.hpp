#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace contact_hosts::fmu {

enum class Role { parameter, input, output, time };

/// A number that an FMU exposes. Its index is FMI's value reference.
struct Variable {
  std::string name;
  Role role;
  std::string unit;  ///< "N.m"; "" if none, or if the name contains it
  std::string meaning;
  double start = 0;      ///< unused for outputs
  bool is_flag = false;  ///< a Boolean, 0 or 1
};

/// Thrown if a model has no solution for its inputs (a load beyond the laws); a
/// host may try other inputs.
struct NoValue : std::runtime_error {
  using runtime_error::runtime_error;
};

/// Behaviour of an FMU, independent of the version of FMI.
///
/// Functions throw std::runtime_error with a single-line message.
class Model {
 public:
  virtual ~Model() = default;

  const std::vector<Variable>& variables() const { return variables_; }
  /// The token of FMI that this model accepts.
  const std::string& token() const { return token_; }

  double get(std::size_t i);
  /// @throws std::runtime_error for outputs and the time, and for parameters
  ///   after initialize()
  void set(std::size_t i, double value);

  /// Applies the parameters.
  /// @param time      at the start, s
  /// @param exchange  true: model exchange; false: co-simulation
  void initialize(double time, bool exchange);
  /// Ends the initialization; outputs refer to the start.
  virtual void start() {}
  /// Advances a co-simulation from a time by a step, s.
  void advance(double time, double length);

  /// State on which all later results depend, as bytes for a model of the same
  /// FMU.
  std::string save();
  void restore(const std::string& bytes);

  /// Event indicators for model exchange: an event occurs where one crosses 0.
  virtual std::vector<double> indicators() { return {}; }
  /// Updates discrete states at an event.
  /// @return true if the host must find new inputs for them and call it again
  virtual bool settle() { return false; }
  /// Accepts a completed step of the host's integrator.
  /// @return true if the step ends in an event
  virtual bool accept() { return false; }
  /// Reports where the limits of the model were exceeded so far, one sentence
  /// per line.
  virtual std::string notes() { return {}; }

 protected:
  /// Appends to the variables the time and those numbers of the file that are
  /// parameters, from `resources`/keys.txt.
  Model(const std::string& resources, std::vector<Variable> variables);

  /// Keys whose parameters have been set, with their values as text.
  std::vector<std::pair<std::string, std::string>> settings() const;
  std::string file() const { return resources_ + "/model.toml"; }
  bool is_exchange() const { return exchange_; }
  double start_time() const { return start_time_; }

  virtual void make() = 0;
  virtual void step(double time, double length) = 0;
  /// Computes the outputs from the inputs.
  virtual void evaluate() = 0;
  virtual std::string state() = 0;
  virtual void set_state(const std::string& bytes) = 0;

  std::vector<double> values_;
  bool is_stale_ = true;  ///< outputs do not match the inputs yet

 private:
  std::string resources_;
  std::string token_;
  std::vector<Variable> variables_;
  std::size_t time_;  // indices
  std::size_t first_key_;
  double start_time_ = 0;
  bool exchange_ = false;
  bool made_ = false;
};

/// File in the FMU's resources that lists the model's parameters: the token,
/// then a line "START KEY" for each.
inline constexpr const char* keys_file = "/keys.txt";

/// Models for a joint file and for a case file, `resources`/model.toml.
std::unique_ptr<Model> joint_model(const std::string& resources);
std::unique_ptr<Model> case_model(const std::string& resources);

/// The one of these models that is linked into the shared object.
std::unique_ptr<Model> make_model(const std::string& resources);

}  // namespace contact_hosts::fmu
