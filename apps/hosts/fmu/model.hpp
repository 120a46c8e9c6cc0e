#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace contact_hosts::fmu {

enum class Role { parameter, input, output, time };

/// A number that an FMU shows. Its place among the others is FMI's value
/// reference.
struct Variable {
  std::string name;
  Role role;
  std::string unit;  ///< "N.m"; "" if there is none or the name has it
  std::string meaning;
  double start = 0;      ///< without meaning for an output
  bool is_flag = false;  ///< a Boolean, 0 or 1
};

/// Thrown where a model has no value for its inputs (a load beyond the laws):
/// a host may try others.
struct NoValue : std::runtime_error {
  using runtime_error::runtime_error;
};

/// Behaviour of an FMU, behind the functions of any version of FMI.
///
/// Functions throw std::runtime_error with one line.
class Model {
 public:
  virtual ~Model() = default;

  const std::vector<Variable>& variables() const { return variables_; }
  /// Value of FMI's token that this model accepts.
  const std::string& token() const { return token_; }

  double get(std::size_t i);
  /// @throws std::runtime_error for an output, for the time, and for a
  /// parameter
  ///   after initialize()
  void set(std::size_t i, double value);

  /// Takes over the parameters.
  /// @param time  at the start, s
  /// @param exchange  model exchange, in place of co-simulation
  void initialize(double time, bool exchange);
  /// The end of the initialization: outputs belong to the start.
  virtual void start() {}
  /// Co-simulation from a time over a step, s.
  void advance(double time, double length);

  /// All that makes what follows, as bytes for a model of the same FMU.
  std::string save();
  void restore(const std::string& bytes);

  /// Model exchange: an event is where one of these passes 0.
  virtual std::vector<double> indicators() { return {}; }
  /// At an event: discrete states anew.
  /// @return whether inputs have to be found for them and this be called again
  virtual bool settle() { return false; }
  /// A step of the host's integrator is done.
  /// @return whether it is an event
  virtual bool accept() { return false; }
  /// Sentences on what has left the model so far, one per line.
  virtual std::string notes() { return {}; }

 protected:
  /// The variables, and behind them the time and the numbers of the file that
  /// are parameters, from `resources`/keys.txt.
  Model(const std::string& resources, std::vector<Variable> variables);

  /// Settings of the keys whose parameters have been set, as "KEY", "VALUE".
  std::vector<std::pair<std::string, std::string>> settings() const;
  std::string file() const { return resources_ + "/model.toml"; }
  bool is_exchange() const { return exchange_; }
  double start_time() const { return start_time_; }

  virtual void make() = 0;
  virtual void step(double time, double length) = 0;
  /// Outputs from inputs.
  virtual void evaluate() = 0;
  virtual std::string state() = 0;
  virtual void set_state(const std::string& bytes) = 0;

  std::vector<double> values_;
  bool is_stale_ = true;  ///< outputs are not yet those of the inputs

 private:
  std::string resources_;
  std::string token_;
  std::vector<Variable> variables_;
  std::size_t time_;  // places
  std::size_t first_key_;
  double start_time_ = 0;
  bool exchange_ = false;
  bool made_ = false;
};

/// File of the model's parameters in the FMU's resources: the token, then a
/// line "START KEY" for each.
inline constexpr const char* keys_file = "/keys.txt";

/// Models of a joint file and of a case file `resources`/model.toml.
std::unique_ptr<Model> joint_model(const std::string& resources);
std::unique_ptr<Model> case_model(const std::string& resources);

/// The one of the two that a shared object has.
std::unique_ptr<Model> make_model(const std::string& resources);

}  // namespace contact_hosts::fmu
