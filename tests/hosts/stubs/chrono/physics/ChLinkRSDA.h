// Declarations of our own of what recipes/chrono.cpp uses of Chrono.
#pragma once

namespace chrono {

class ChLinkRSDA {
 public:
  class TorqueFunctor {
   public:
    virtual ~TorqueFunctor() = default;
    virtual double evaluate(double time, double rest_angle, double angle,
                            double vel, const ChLinkRSDA& link) = 0;
  };
};

}  // namespace chrono
