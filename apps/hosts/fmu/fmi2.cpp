// The functions of FMI 2.0, for model exchange and co-simulation.
#include <algorithm>
#include <cstdlib>
#include <string_view>

#include "hosts/fmu/instance.hpp"

// NOLINTBEGIN(readability-identifier-naming)
namespace {

using namespace contact_hosts::fmu;

/// The struct of callbacks; unused members are declared as pointers.
struct Callbacks {
  void (*logger)(void* environment, const char* instance, int status,
                 const char* category, const char* message, ...);
  void* allocate;
  void* free;
  void* step_finished;
  void* environment;
};

/// Answer to the host at the end of an event.
struct EventInfo {
  int newDiscreteStatesNeeded;
  int terminateSimulation;
  int nominalsOfContinuousStatesChanged;
  int valuesOfContinuousStatesChanged;
  int nextEventTimeDefined;
  double nextEventTime;
};

// The folder of "file:///tmp/a%20b/resources".
std::string folder_of(std::string_view uri) {
  for (const std::string_view start :
       {"file://localhost", "file://", "file:"}) {
    if (uri.substr(0, start.size()) != start) continue;
    uri.remove_prefix(start.size());
    break;
  }
  std::string folder;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    if (uri[i] == '%' && i + 2 < uri.size()) {
      const std::string code(uri.substr(i + 1, 2));
      folder += static_cast<char>(std::strtol(code.c_str(), nullptr, 16));
      i += 2;
    } else {
      folder += uri[i];
    }
  }
  return folder;
}

}  // namespace

extern "C" {

const char* fmi2GetTypesPlatform() { return "default"; }
const char* fmi2GetVersion() { return "2.0"; }

void* fmi2Instantiate(const char* name, int type, const char* guid,
                      const char* resources, const Callbacks* callbacks,
                      int /*visible*/, int /*logging*/) {
  if (!name || !resources || !callbacks) return nullptr;
  const auto log = [c = *callbacks, name = std::string(name)](
                       Status status, const std::string& text) {
    if (!c.logger) return;
    c.logger(c.environment, name.c_str(), status, category_of(status), "%s",
             text.c_str());
  };
  return make_instance({folder_of(resources), nullptr, log, type == 0, 0},
                       guid);
}
void fmi2FreeInstance(void* c) { delete static_cast<Instance*>(c); }

int fmi2SetupExperiment(void* c, int /*has_tolerance*/, double /*tolerance*/,
                        double start, int /*has_stop*/, double /*stop*/) {
  return guarded(c, [=](Instance& i) { i.start_time = start; });
}
int fmi2EnterInitializationMode(void* c) {
  return guarded(
      c, [](Instance& i) { i.model->initialize(i.start_time, i.exchange); });
}
int fmi2ExitInitializationMode(void* c) {
  return guarded(c, [](Instance& i) { i.model->start(); });
}
int fmi2Reset(void* c) { return reset(c); }

int fmi2GetReal(void* c, const unsigned* vr, std::size_t n, double* values) {
  return get(c, vr, n, values);
}
int fmi2GetBoolean(void* c, const unsigned* vr, std::size_t n, int* values) {
  return get(c, vr, n, values);
}
int fmi2SetReal(void* c, const unsigned* vr, std::size_t n,
                const double* values) {
  return set(c, vr, n, values);
}
int fmi2SetBoolean(void* c, const unsigned* vr, std::size_t n,
                   const int* values) {
  return set(c, vr, n, values);
}

int fmi2GetFMUstate(void* c, void** state) { return get_state(c, state); }
int fmi2SetFMUstate(void* c, void* state) { return set_state(c, state); }
int fmi2FreeFMUstate(void* /*c*/, void** state) { return free_state(state); }
int fmi2SerializedFMUstateSize(void* c, void* state, std::size_t* size) {
  return serialized_size(c, state, size);
}
int fmi2SerializeFMUstate(void* c, void* state, char* bytes, std::size_t size) {
  return serialize(c, state, bytes, size);
}
int fmi2DeSerializeFMUstate(void* c, const char* bytes, std::size_t size,
                            void** state) {
  return deserialize(c, bytes, size, state);
}

int fmi2NewDiscreteStates(void* c, EventInfo* info) {
  *info = {};
  return guarded(c, [=](Instance& i) {
    info->newDiscreteStatesNeeded = i.model->settle();
  });
}
int fmi2CompletedIntegratorStep(void* c, int /*no_way_back*/,
                                int* enter_event_mode, int* terminate) {
  *terminate = 0;
  return guarded(c,
                 [=](Instance& i) { *enter_event_mode = i.model->accept(); });
}
int fmi2GetEventIndicators(void* c, double* to, std::size_t count) {
  return guarded(c, [=](Instance& i) {
    const auto all = i.model->indicators();
    if (count != all.size()) {
      throw std::runtime_error("event indicators must be " +
                               std::to_string(all.size()));
    }
    std::copy(all.begin(), all.end(), to);
  });
}
int fmi2DoStep(void* c, double time, double length, int /*no_way_back*/) {
  return guarded(c, [=](Instance& i) { i.model->advance(time, length); });
}

int fmi2Terminate(void* c) { return terminate(c); }

CONTACT_NOTHING(fmi2SetDebugLogging, ok)
CONTACT_NOTHING(fmi2EnterEventMode, ok)
CONTACT_NOTHING(fmi2EnterContinuousTimeMode, ok)
CONTACT_NOTHING(fmi2SetTime, ok)
// A joint has no continuous states.
CONTACT_NOTHING(fmi2SetContinuousStates, ok)
CONTACT_NOTHING(fmi2GetDerivatives, ok)
CONTACT_NOTHING(fmi2GetContinuousStates, ok)
CONTACT_NOTHING(fmi2GetNominalsOfContinuousStates, ok)
CONTACT_NOTHING(fmi2GetInteger, error)
CONTACT_NOTHING(fmi2GetString, error)
CONTACT_NOTHING(fmi2SetInteger, error)
CONTACT_NOTHING(fmi2SetString, error)
CONTACT_NOTHING(fmi2GetDirectionalDerivative, error)
CONTACT_NOTHING(fmi2SetRealInputDerivatives, error)
CONTACT_NOTHING(fmi2GetRealOutputDerivatives, error)
CONTACT_NOTHING(fmi2CancelStep, error)
CONTACT_NOTHING(fmi2GetStatus, discard)
CONTACT_NOTHING(fmi2GetRealStatus, discard)
CONTACT_NOTHING(fmi2GetIntegerStatus, discard)
CONTACT_NOTHING(fmi2GetBooleanStatus, discard)
CONTACT_NOTHING(fmi2GetStringStatus, discard)

}  // extern "C"
// NOLINTEND(readability-identifier-naming)
