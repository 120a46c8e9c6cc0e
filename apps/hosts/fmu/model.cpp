#include "hosts/fmu/model.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>
#include <locale>
#include <utility>

namespace contact_hosts::fmu {
namespace {

// The shortest text that parses as the same number.
std::string text_of(double value) {
  std::array<char, 32> text{};
  return {text.data(),
          std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

}  // namespace

Model::Model(const std::string& resources, std::vector<Variable> variables)
    : resources_(resources),
      variables_(std::move(variables)),
      time_(variables_.size()),
      first_key_(time_ + 1) {
  variables_.push_back({"time", Role::time, "s", "of the host"});
  std::ifstream keys(resources + keys_file);
  if (!std::getline(keys, token_)) {
    throw std::runtime_error(resources + keys_file + ": cannot be read");
  }
  Variable key{"", Role::parameter, "", "key of the file, in its own unit"};
  keys.imbue(std::locale::classic());  // the host may use another locale
  while (keys >> key.start && std::getline(keys >> std::ws, key.name)) {
    variables_.push_back(key);
  }
  if (!keys.eof()) {
    throw std::runtime_error(resources + keys_file +
                             ": must be numbers, each "
                             "with the name of its key");
  }
  for (const Variable& v : variables_) values_.push_back(v.start);
}

double Model::get(std::size_t i) {
  if (is_stale_ && made_ && variables_.at(i).role == Role::output) {
    evaluate();
    is_stale_ = false;
  }
  return values_.at(i);
}

void Model::set(std::size_t i, double value) {
  const Variable& v = variables_.at(i);
  if (v.role == Role::output || v.role == Role::time) {
    throw std::runtime_error(v.name + " must be left to the FMU");
  }
  if (v.role == Role::parameter && made_) {
    throw std::runtime_error(v.name + " must be set before the initialization");
  }
  if (values_[i] == value) return;
  values_[i] = value;
  is_stale_ = true;
}

void Model::initialize(double time, bool exchange) {
  values_[time_] = start_time_ = time;
  exchange_ = exchange;
  make();
  made_ = is_stale_ = true;
}

void Model::advance(double time, double length) {
  if (!(length >= 0) || !std::isfinite(time + length)) {
    throw std::runtime_error("a step of " + text_of(length) + " s from " +
                             text_of(time) +
                             " s must have a length of 0 or more");
  }
  step(time, length);
  values_[time_] = time + length;
}

std::vector<std::pair<std::string, std::string>> Model::settings() const {
  std::vector<std::pair<std::string, std::string>> all;
  for (std::size_t i = first_key_; i < variables_.size(); ++i) {
    if (values_[i] == variables_[i].start) continue;
    all.emplace_back(variables_[i].name, text_of(values_[i]));
  }
  return all;
}

std::string Model::save() {
  std::string bytes(reinterpret_cast<const char*>(values_.data()),
                    values_.size() * sizeof(double));
  bytes.append(reinterpret_cast<const char*>(&start_time_), sizeof start_time_);
  bytes += exchange_ ? '1' : '0';
  bytes += is_stale_ ? '1' : '0';
  return made_ ? bytes + state() : bytes;
}

// A model whose parameters differ from the state's is built again.
void Model::restore(const std::string& bytes) {
  const std::size_t numbers = values_.size() * sizeof(double);
  const std::size_t head = numbers + sizeof start_time_ + 2;
  if (bytes.size() < head) {
    throw std::runtime_error("state must be one of this FMU");
  }
  const auto before = settings();
  std::memcpy(values_.data(), bytes.data(), numbers);
  std::memcpy(&start_time_, &bytes[numbers], sizeof start_time_);
  exchange_ = bytes[head - 2] == '1';
  const bool is_made = bytes.size() > head;
  if (is_made && (!made_ || settings() != before)) make();
  made_ = is_made;
  if (made_) set_state(bytes.substr(head));
  is_stale_ = bytes[head - 1] == '1';
}

}  // namespace contact_hosts::fmu
