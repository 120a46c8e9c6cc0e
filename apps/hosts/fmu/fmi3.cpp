// The functions of FMI 3.0, for co-simulation.
#include "hosts/fmu/instance.hpp"

// NOLINTBEGIN(readability-identifier-naming)
namespace {

using namespace contact_hosts::fmu;

using Log = void (*)(void* environment, int status, const char* category,
                     const char* message);

}  // namespace

#define CONTACT_NO_TYPE(type)           \
  CONTACT_NOTHING(fmi3Get##type, error) \
  CONTACT_NOTHING(fmi3Set##type, error)

extern "C" {

const char* fmi3GetVersion() { return "3.0"; }

void* fmi3InstantiateCoSimulation(const char* /*name*/, const char* token,
                                  const char* resources, bool /*visible*/,
                                  bool /*logging*/, bool /*event_mode*/,
                                  bool /*early_return*/,
                                  const unsigned* /*intermediate*/,
                                  std::size_t /*intermediate_count*/,
                                  void* environment, Log log,
                                  void* /*intermediate_update*/) {
  if (!resources) return nullptr;
  const auto tell = [=](Status status, const std::string& text) {
    if (log) log(environment, status, category_of(status), text.c_str());
  };
  std::string folder = resources;
  while (folder.size() > 1 && folder.back() == '/') folder.pop_back();
  return make_instance({folder, nullptr, tell, false, 0}, token);
}
void* fmi3InstantiateModelExchange(const char*) { return nullptr; }
void* fmi3InstantiateScheduledExecution(const char*) { return nullptr; }
void fmi3FreeInstance(void* c) { delete static_cast<Instance*>(c); }

int fmi3EnterInitializationMode(void* c, bool /*has_tolerance*/,
                                double /*tolerance*/, double start,
                                bool /*has_stop*/, double /*stop*/) {
  return guarded(c, [=](Instance& i) { i.model->initialize(start, false); });
}
int fmi3ExitInitializationMode(void* c) {
  return guarded(c, [](Instance& i) { i.model->start(); });
}
int fmi3Reset(void* c) { return reset(c); }

int fmi3GetFloat64(void* c, const unsigned* vr, std::size_t n, double* values,
                   std::size_t /*count*/) {
  return get(c, vr, n, values);
}
int fmi3GetBoolean(void* c, const unsigned* vr, std::size_t n, bool* values,
                   std::size_t /*count*/) {
  return get(c, vr, n, values);
}
int fmi3SetFloat64(void* c, const unsigned* vr, std::size_t n,
                   const double* values, std::size_t /*count*/) {
  return set(c, vr, n, values);
}
int fmi3SetBoolean(void* c, const unsigned* vr, std::size_t n,
                   const bool* values, std::size_t /*count*/) {
  return set(c, vr, n, values);
}

int fmi3GetFMUState(void* c, void** state) { return get_state(c, state); }
int fmi3SetFMUState(void* c, void* state) { return set_state(c, state); }
int fmi3FreeFMUState(void* /*c*/, void** state) { return free_state(state); }
int fmi3SerializedFMUStateSize(void* c, void* state, std::size_t* size) {
  return serialized_size(c, state, size);
}
int fmi3SerializeFMUState(void* c, void* state, unsigned char* bytes,
                          std::size_t size) {
  return serialize(c, state, bytes, size);
}
int fmi3DeserializeFMUState(void* c, const unsigned char* bytes,
                            std::size_t size, void** state) {
  return deserialize(c, bytes, size, state);
}

int fmi3DoStep(void* c, double time, double length, bool /*no_way_back*/,
               bool* event, bool* terminate, bool* early, double* last_time) {
  *event = *terminate = *early = false;
  *last_time = time;
  return guarded(c, [=](Instance& i) {
    i.model->advance(time, length);
    *last_time = time + length;
  });
}

int fmi3Terminate(void* c) { return terminate(c); }
CONTACT_NOTHING(fmi3SetDebugLogging, ok)
CONTACT_NOTHING(fmi3EnterEventMode, error)
CONTACT_NOTHING(fmi3EnterStepMode, error)
CONTACT_NOTHING(fmi3EnterConfigurationMode, error)
CONTACT_NOTHING(fmi3ExitConfigurationMode, error)
CONTACT_NO_TYPE(Float32)
CONTACT_NO_TYPE(Int8)
CONTACT_NO_TYPE(UInt8)
CONTACT_NO_TYPE(Int16)
CONTACT_NO_TYPE(UInt16)
CONTACT_NO_TYPE(Int32)
CONTACT_NO_TYPE(UInt32)
CONTACT_NO_TYPE(Int64)
CONTACT_NO_TYPE(UInt64)
CONTACT_NO_TYPE(String)
CONTACT_NO_TYPE(Binary)
CONTACT_NO_TYPE(Clock)
CONTACT_NO_TYPE(IntervalDecimal)
CONTACT_NO_TYPE(IntervalFraction)
CONTACT_NO_TYPE(ShiftDecimal)
CONTACT_NO_TYPE(ShiftFraction)
CONTACT_NOTHING(fmi3GetNumberOfVariableDependencies, error)
CONTACT_NOTHING(fmi3GetVariableDependencies, error)
CONTACT_NOTHING(fmi3GetDirectionalDerivative, error)
CONTACT_NOTHING(fmi3GetAdjointDerivative, error)
CONTACT_NOTHING(fmi3GetOutputDerivatives, error)
CONTACT_NOTHING(fmi3EvaluateDiscreteStates, error)
CONTACT_NOTHING(fmi3UpdateDiscreteStates, error)
CONTACT_NOTHING(fmi3EnterContinuousTimeMode, error)
CONTACT_NOTHING(fmi3CompletedIntegratorStep, error)
CONTACT_NOTHING(fmi3SetTime, error)
CONTACT_NOTHING(fmi3SetContinuousStates, error)
CONTACT_NOTHING(fmi3GetContinuousStateDerivatives, error)
CONTACT_NOTHING(fmi3GetEventIndicators, error)
CONTACT_NOTHING(fmi3GetContinuousStates, error)
CONTACT_NOTHING(fmi3GetNominalsOfContinuousStates, error)
CONTACT_NOTHING(fmi3GetNumberOfEventIndicators, error)
CONTACT_NOTHING(fmi3GetNumberOfContinuousStates, error)
CONTACT_NOTHING(fmi3ActivateModelPartition, error)

}  // extern "C"
// NOLINTEND(readability-identifier-naming)
