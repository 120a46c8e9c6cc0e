#pragma once

#include <dlfcn.h>
#include <libxml/parser.h>
#include <minizip/unzip.h>

#include <Eigen/Core>
#include <cmath>
#include <cstdarg>
#include <filesystem>
#include <fstream>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

/// A minimal importer of FMUs: unzips a file, reads its description and calls
/// its functions, independent of libcontact.
namespace contact::test {

namespace fs = std::filesystem;

/// A file in a zip file for each entry.
inline void unzip(const fs::path& zip, const fs::path& folder) {
  const unzFile file = unzOpen(zip.c_str());
  if (!file) throw std::runtime_error(zip.string() + " is no zip file");
  for (int more = unzGoToFirstFile(file); more == UNZ_OK;
       more = unzGoToNextFile(file)) {
    unz_file_info info;
    char name[512];
    unzGetCurrentFileInfo(file, &info, name, sizeof name, nullptr, 0, nullptr,
                          0);
    std::string content(info.uncompressed_size, '\0');
    unzOpenCurrentFile(file);
    unzReadCurrentFile(file, content.data(),
                       static_cast<unsigned>(content.size()));
    if (unzCloseCurrentFile(file) != UNZ_OK) {
      throw std::runtime_error(std::string(name) + " is damaged");
    }
    fs::create_directories((folder / name).parent_path());
    std::ofstream(folder / name) << content;
  }
  unzClose(file);
}

/// Attributes of an element, and its child elements.
struct Element {
  std::string name;
  std::map<std::string, std::string> attributes;
  std::vector<Element> inside;

  const Element& operator[](const std::string& child) const {
    for (const Element& e : inside) {
      if (e.name == child) return e;
    }
    throw std::runtime_error(name + " has no " + child);
  }
};

inline Element element_of(const xmlNode* node) {
  const auto text = [](const xmlChar* t) {
    return std::string(reinterpret_cast<const char*>(t));
  };
  Element e{text(node->name), {}, {}};
  for (const xmlAttr* a = node->properties; a; a = a->next) {
    e.attributes[text(a->name)] = a->children ? text(a->children->content) : "";
  }
  for (const xmlNode* child = node->children; child; child = child->next) {
    if (child->type == XML_ELEMENT_NODE) e.inside.push_back(element_of(child));
  }
  return e;
}

/// An unzipped FMU.
class Fmu {
 public:
  Fmu(const fs::path& file, const fs::path& folder) : folder_(folder) {
    fs::remove_all(folder);
    unzip(file, folder);
    const fs::path xml = folder / "modelDescription.xml";
    xmlDoc* const document = xmlReadFile(xml.c_str(), nullptr, 0);
    if (!document) throw std::runtime_error("the description is no XML");
    description_ = element_of(xmlDocGetRootElement(document));
    xmlFreeDoc(document);
    for (const Element& e : description_["ModelVariables"].inside) {
      references_[e.attributes.at("name")] =
          static_cast<unsigned>(std::stoul(e.attributes.at("valueReference")));
    }
    library_ = dlopen(binary().c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!library_) throw std::runtime_error(dlerror());
  }
  Fmu(Fmu&&) = delete;
  ~Fmu() { dlclose(library_); }

  const Element& description() const { return description_; }
  std::string resources() const { return folder_ / "resources"; }
  unsigned reference(const std::string& name) const {
    return references_.at(name);
  }
  std::string causality(const std::string& name) const {
    for (const Element& e : description_["ModelVariables"].inside) {
      if (e.attributes.at("name") == name) return e.attributes.at("causality");
    }
    return "";
  }
  fs::path binary() const {
    const std::string id =
        description_["CoSimulation"].attributes.at("modelIdentifier");
    const fs::path platforms = folder_ / "binaries";
    return fs::directory_iterator(platforms)->path() / (id + ".so");
  }
  /// A function of the FMU, of type int by default.
  template <class Result = int, class... Arguments>
  Result call(const char* name, Arguments... arguments) const {
    void* const function = dlsym(library_, name);
    if (!function) throw std::runtime_error(dlerror());
    return reinterpret_cast<Result (*)(Arguments...)>(function)(arguments...);
  }

 private:
  fs::path folder_;
  Element description_;
  std::map<std::string, unsigned> references_;
  void* library_;
};

/// The last message of an FMU.
inline std::string& last_message() {
  static std::string text;
  return text;
}
/// All messages.
inline std::vector<std::string>& messages() {
  static std::vector<std::string> all;
  return all;
}
inline void log_2(void*, const char*, int, const char*, const char* form, ...) {
  std::va_list arguments;
  va_start(arguments, form);
  last_message() = form == std::string("%s") ? va_arg(arguments, char*) : form;
  va_end(arguments);
  messages().push_back(last_message());
}
inline void log_3(void*, int, const char*, const char* text) {
  last_message() = text;
  messages().push_back(text);
}

/// An instance by FMI 2.0 or 3.0, as the FMU. Calls return FMI's status.
class FmuInstance {
 public:
  enum Use { steps, exchange };

  explicit FmuInstance(const Fmu& fmu, Use use = steps) : fmu_(fmu) {
    const auto& d = fmu.description().attributes;
    const void* const none = nullptr;
    if (d.at("fmiVersion") == "2.0") {
      static const void* const callbacks[] = {
          reinterpret_cast<const void*>(&log_2), none, none, none, none};
      prefix_ = "fmi2";
      std::string uri = "file://" + fmu.resources();
      for (std::size_t at; (at = uri.find(' ')) != uri.npos;) {
        uri.replace(at, 1, "%20");
      }
      c_ = fmu.call<void*>("fmi2Instantiate", "it", use == exchange ? 0 : 1,
                           d.at("guid").c_str(), uri.c_str(), callbacks, 0, 0);
    } else {
      prefix_ = "fmi3";
      c_ = fmu.call<void*>("fmi3InstantiateCoSimulation", "it",
                           d.at("instantiationToken").c_str(),
                           fmu.resources().c_str(), false, false, false, false,
                           none, std::size_t{0}, none, &log_3, none);
    }
    if (!c_) throw std::runtime_error("no instance: " + last_message());
  }
  FmuInstance(FmuInstance&&) = delete;
  ~FmuInstance() { fmu_.call<void>((prefix_ + "FreeInstance").c_str(), c_); }

  /// A function of this instance by its FMI 2.0 name without prefix. Some
  /// functions of 3.0 take a further argument.
  template <class... Arguments>
  int call(std::string name, Arguments... arguments) const {
    for (const auto& [old, now] : {std::pair("Real", "Float64"),
                                   {"FMUstate", "FMUState"},
                                   {"DeSerialize", "Deserialize"}}) {
      const std::size_t at = name.find(old);
      if (at == std::string::npos || prefix_ == "fmi2") continue;
      name.replace(at, std::string(old).size(), now);
    }
    return fmu_.call((prefix_ + name).c_str(), c_, arguments...);
  }

  /// Sets parameters, then the inputs at the start.
  int enter(double start = 0) const {
    if (prefix_ == "fmi3") {
      return call("EnterInitializationMode", false, 0.0, start, false, 0.0);
    }
    call("SetupExperiment", 0, 0.0, start, 0, 0.0);
    return call("EnterInitializationMode");
  }
  int start() const { return call("ExitInitializationMode"); }
  int step(double time, double length) const {
    bool flags[3];
    double last;
    return call("DoStep", time, length, 1, &flags[0], &flags[1], &flags[2],
                &last);
  }

  int set(const std::string& name, double value) const {
    const unsigned reference = fmu_.reference(name);
    return call("SetReal", &reference, one, &value, one);
  }
  double get(const std::string& name) const {
    const unsigned reference = fmu_.reference(name);
    double value = std::nan("");
    call("GetReal", &reference, one, &value, one);
    return value;
  }
  // A bool of FMI 3.0 is stored in the first byte of an int of 2.0.
  int set_flag(const std::string& name, int value) const {
    const unsigned reference = fmu_.reference(name);
    return call("SetBoolean", &reference, one, &value, one);
  }
  bool flag(const std::string& name) const {
    const unsigned reference = fmu_.reference(name);
    int value = 0;
    call("GetBoolean", &reference, one, &value, one);
    return value != 0;
  }
  void set(const std::string& name, const Eigen::Vector3d& v) const {
    for (int i = 0; i < 3; ++i) set(name + '_' + "xyz"[i], v[i]);
  }
  Eigen::Vector3d vector(const std::string& name) const {
    return {get(name + "_x"), get(name + "_y"), get(name + "_z")};
  }

 private:
  static constexpr std::size_t one = 1;
  const Fmu& fmu_;
  std::string prefix_;
  void* c_;
};

}  // namespace contact::test
