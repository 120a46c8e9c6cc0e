// Declarations of our own of what recipes/drake.cpp uses of Drake.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace drake {

template <class T>
class Value {};

namespace systems {

struct InputPortIndex {};
struct DependencyTicket {};

template <class T>
class VectorBase {
 public:
  const Eigen::VectorXd& value() const;
  void SetFromVector(const Eigen::VectorXd&);
};
template <class T>
class BasicVector : public VectorBase<T> {};

template <class T>
class DiscreteValues {
 public:
  void set_value(const Eigen::VectorXd&);
};

struct EventStatus {
  static EventStatus Succeeded();
};

template <class T>
class Context {
 public:
  const BasicVector<T>& get_discrete_state(int) const;
};

template <class T>
class InputPort {
 public:
  InputPortIndex get_index() const;
  const Eigen::VectorXd& Eval(const Context<T>&) const;
  template <class V>
  const V& Eval(const Context<T>&) const;
};

template <class T>
class LeafSystem {
 public:
  virtual ~LeafSystem() = default;
  const InputPort<T>& get_input_port(InputPortIndex) const;

 protected:
  InputPort<T>& DeclareVectorInputPort(const std::string&, int);
  template <class V>
  InputPort<T>& DeclareAbstractInputPort(const std::string&, const Value<V>&);
  void DeclareDiscreteState(int);
  template <class S>
  void DeclarePeriodicDiscreteUpdateEvent(double, double,
                                          EventStatus (S::*)(const Context<T>&,
                                                             DiscreteValues<T>*)
                                              const);
  template <class S>
  void DeclareVectorOutputPort(const std::string&, int,
                               void (S::*)(const Context<T>&, BasicVector<T>*)
                                   const,
                               std::vector<DependencyTicket>);
  static DependencyTicket input_port_ticket(InputPortIndex);
  static DependencyTicket xd_ticket();
};

}  // namespace systems
}  // namespace drake
