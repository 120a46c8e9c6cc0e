#include <algorithm>

#include "hosts/fmu/model.hpp"
#include "hosts/joint_handle.hpp"
#include "separation/c/run.h"

namespace contact_hosts::fmu {
namespace {

using RunHandle = std::unique_ptr<contact_run, void (*)(contact_run*)>;

RunHandle open_run(const std::string& file, const Settings& keys) {
  const std::vector<contact_setting> given = c_settings(keys);
  contact_run* run = nullptr;
  must(contact_run_open(file.c_str(), given.data(), given.size(), &run));
  return {run, contact_run_free};
}

std::vector<Variable> variables_of(const contact_run* run) {
  std::vector<Variable> all;
  for (std::size_t i = 0; i < contact_run_column_count(run); ++i) {
    all.push_back({contact_run_column(run, i), Role::output, "",
                   "column of the history"});
  }
  for (std::size_t i = 0; i < contact_run_input_count(run); ++i) {
    all.push_back({contact_run_input(run, i), Role::input, "",
                   "load from outside, constant over a step"});
  }
  return all;
}

// The parameters of a case's keys follow its variables.
class CaseModel : public Model {
 public:
  explicit CaseModel(const std::string& resources)
      : CaseModel(resources, open_run(resources + "/model.toml", {})) {}

 private:
  CaseModel(const std::string& resources, RunHandle run)
      : Model(resources, variables_of(run.get())), run_(std::move(run)) {
    count_ = contact_run_column_count(run_.get());
    evaluate();
  }

  void make() override {
    if (is_exchange()) {
      throw std::runtime_error("a case must be run by co-simulation");
    }
    run_ = open_run(file(), settings());
    bool same = contact_run_column_count(run_.get()) == count_;
    for (std::size_t i = 0; same && i < count_; ++i) {
      same = variables()[i].name == contact_run_column(run_.get(), i);
    }
    if (!same) {
      throw std::runtime_error(
          "parameters must be such that the bodies of the case stay");
    }
  }
  void step(double time, double length) override {
    const double to = time + length - start_time();
    must(contact_run_set_inputs(run_.get(), values_.data() + count_,
                                contact_run_input_count(run_.get())));
    const contact_status status = contact_run_advance(run_.get(), to);
    is_stale_ = true;
    if (status == CONTACT_RUN_FAILED) throw NoValue(contact_last_message());
    must(status);
    const double end = contact_run_end_time(run_.get());
    if (to > end * (1 + 1e-12)) {
      throw NoValue("the case ends at " + std::to_string(end) + " s");
    }
  }
  std::string notes() override {
    return text_of([this](char* text, std::size_t size) {
      return contact_run_notes(run_.get(), text, size);
    });
  }
  void evaluate() override {
    must(contact_run_values(run_.get(), values_.data(), count_));
  }
  std::string state() override {
    void* bytes = nullptr;
    std::size_t size = 0;
    must(contact_run_save(run_.get(), &bytes, &size));
    std::string copy(static_cast<const char*>(bytes), size);
    contact_free(bytes);
    return copy;
  }
  void set_state(const std::string& bytes) override {
    must(contact_run_restore(run_.get(), bytes.data(), bytes.size()));
  }

  RunHandle run_;
  std::size_t count_ = 0;
};

}  // namespace

std::unique_ptr<Model> case_model(const std::string& resources) {
  return std::make_unique<CaseModel>(resources);
}

}  // namespace contact_hosts::fmu
