#pragma once

#include <functional>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

#include "hosts/fmu/model.hpp"
#include "libcontact/c/float_environment.hpp"
#include "libcontact/c/status.h"

/// Parts of FMI's functions that do not depend on its version.
namespace contact_hosts::fmu {

/// Escapes text for a host's log, so that names of bodies cannot control its
/// terminal.
inline std::string shown(const char* text) {
  contact_report(CONTACT_FAILURE, text);
  return contact_last_message();
}

/// FMI's status codes.
enum Status { ok = 0, warning = 1, discard = 2, error = 3 };

/// An FMU instance created by a host.
struct Instance {
  std::string resources;
  std::unique_ptr<Model> model;
  /// Sends a line to the host.
  std::function<void(Status, const std::string&)> log;
  bool exchange = false;
  double start_time = 0;  // FMI 2.0 gives it before the initialization
};

/// Runs the body of an FMI function; reports exceptions to the host and
/// preserves its floating-point environment.
template <class Work>
Status guarded(void* instance, const Work& work) noexcept {
  if (!instance) return error;
  auto& i = *static_cast<Instance*>(instance);
  const auto tell = [&i](Status status, const char* why) {
    if (i.log) i.log(status, shown(why));
    return status;
  };
  try {
    const contact::c::FloatEnvironment ours;
    work(i);
    return ok;
  } catch (const NoValue& none) {
    return tell(discard, none.what());
  } catch (const std::exception& wrong) {
    return tell(error, wrong.what());
  }
}

/// @param token  read by the host from modelDescription.xml
/// @return null if it cannot be made; the log tells why
inline Instance* make_instance(Instance parts, const char* token) noexcept {
  try {
    const contact::c::FloatEnvironment ours;
    parts.model = make_model(parts.resources);
    if (!token || parts.model->token() != token) {
      throw std::runtime_error(
          "guid, or instantiation token, must be that of "
          "modelDescription.xml");
    }
    return std::make_unique<Instance>(std::move(parts)).release();
  } catch (const std::exception& wrong) {
    if (parts.log) parts.log(error, shown(wrong.what()));
    return nullptr;
  }
}

/// A number, or a Boolean as 0 or 1.
/// @throws std::runtime_error for a variable of another type
template <class Value>
std::size_t place_of(const Model& model, std::size_t reference) {
  const auto& all = model.variables();
  if (reference >= all.size() ||
      all[reference].is_flag == std::is_same_v<Value, double>) {
    throw std::runtime_error("value reference " + std::to_string(reference) +
                             " must be that of a variable of this type");
  }
  return reference;
}

template <class Value>
Status get(void* instance, const unsigned* references, std::size_t count,
           Value* values) noexcept {
  return guarded(instance, [=](Instance& i) {
    for (std::size_t k = 0; k < count; ++k) {
      values[k] = static_cast<Value>(
          i.model->get(place_of<Value>(*i.model, references[k])));
    }
  });
}

template <class Value>
Status set(void* instance, const unsigned* references, std::size_t count,
           const Value* values) noexcept {
  return guarded(instance, [=](Instance& i) {
    for (std::size_t k = 0; k < count; ++k) {
      i.model->set(place_of<Value>(*i.model, references[k]),
                   std::is_same_v<Value, double>
                       ? static_cast<double>(values[k])
                       : static_cast<double>(values[k] != 0));
    }
  });
}

/// Reports to the host where the simulation exceeded the model's limits.
inline Status terminate(void* instance) noexcept {
  return guarded(instance, [](Instance& i) {
    std::istringstream lines(i.log ? i.model->notes() : "");
    for (std::string line; std::getline(lines, line);) i.log(warning, line);
  });
}

/// FMI's category of a log message.
inline const char* category_of(Status status) {
  return status == warning ? "logStatusWarning" : "logStatusError";
}

/// Resets to the state of a new instance.
inline Status reset(void* instance) noexcept {
  return guarded(instance,
                 [](Instance& i) { i.model = make_model(i.resources); });
}

// FMI passes states of an instance as pointers; here they point to texts of
// Model::save().

/// @param state  a state to overwrite, or null for a new one
inline Status get_state(void* instance, void** state) noexcept {
  return guarded(instance, [=](Instance& i) {
    std::string bytes = i.model->save();
    if (!*state) *state = std::make_unique<std::string>().release();
    *static_cast<std::string*>(*state) = std::move(bytes);
  });
}
/// @throws std::runtime_error if it is null
inline const std::string& bytes_of(void* state) {
  if (!state) throw std::runtime_error("state must be other than null");
  return *static_cast<std::string*>(state);
}
inline Status set_state(void* instance, void* state) noexcept {
  return guarded(instance,
                 [=](Instance& i) { i.model->restore(bytes_of(state)); });
}
inline Status free_state(void** state) noexcept {
  if (!state) return ok;
  delete static_cast<std::string*>(*state);
  *state = nullptr;
  return ok;
}
inline Status serialized_size(void* instance, void* state,
                              std::size_t* size) noexcept {
  return guarded(instance, [=](Instance&) { *size = bytes_of(state).size(); });
}
inline Status serialize(void* instance, void* state, void* bytes,
                        std::size_t size) noexcept {
  return guarded(instance, [=](Instance&) {
    const std::string& text = bytes_of(state);
    if (size < text.size()) throw std::runtime_error("size is too small");
    text.copy(static_cast<char*>(bytes), text.size());
  });
}
inline Status deserialize(void* instance, const void* bytes, std::size_t size,
                          void** state) noexcept {
  return guarded(instance, [=](Instance&) {
    *state =
        std::make_unique<std::string>(static_cast<const char*>(bytes), size)
            .release();
  });
}

}  // namespace contact_hosts::fmu

/// Defines a function of FMI that a host may call although this FMU has no such
/// feature. Further arguments of callers are ignored.
#define CONTACT_NOTHING(name, status) \
  int name(void*) { return status; }
