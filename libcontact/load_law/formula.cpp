#include "libcontact/load_law/formula.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <regex>

namespace contact::detail {
namespace {

template <class... Parts>
std::string filled_in(std::string_view form, const Parts&... parts) {
  return fmt::format(fmt::runtime(form), parts...);
}

std::string polynomial(const std::vector<double>& c, std::string_view x,
                       const Notation& in) {
  std::string text = filled_in(in.real, real_text(c.back()));
  for (std::size_t i = c.size() - 1; i-- > 0;) {
    text = fmt::format("({}) * {} {} {}", text, x, c[i] < 0 ? '-' : '+',
                       filled_in(in.real, real_text(std::abs(c[i]))));
  }
  return '(' + text + ')';
}

// A name, number or call of a polynomial.
std::string word(const std::smatch& found, const Constants& constants,
                 const Notation& in) {
  const std::string name = found[1];
  if (found[2].matched) return filled_in(in.component, name, found[2].str());
  if (name.find_first_not_of("0123456789") == name.npos) {
    return filled_in(in.whole, name);
  }
  const auto number = constants.numbers.find(name);
  if (number != constants.numbers.end()) {
    return filled_in(in.real, real_text(number->second));
  }
  const auto c = constants.polynomials.find(name);
  if (c != constants.polynomials.end()) {
    return polynomial(c->second, found[3].str(), in);
  }
  constexpr std::string_view known[] = {"sqrt", "log", "abs", "exp", "poly"};
  const auto at = std::ranges::find(known, name) - std::begin(known);
  return (at < 5 ? std::string(in.functions[at]) : name) +
         (found[3].matched ? '(' + found[3].str() + ')' : "");
}

std::string expression(const std::string& text, const Constants& constants,
                       const Notation& in) {
  static const std::regex& words =
      *new std::regex(R"((\w+)(?:\[(\d)\]|\((\w+)\))?)");
  std::string out;
  auto rest = text.cbegin();
  for (std::sregex_iterator i(text.begin(), text.end(), words), end; i != end;
       ++i) {
    out.append(rest, (*i)[0].first).append(word(*i, constants, in));
    rest = (*i)[0].second;
  }
  return out.append(rest, text.cend());
}

}  // namespace

std::string printed(std::string_view formula, const Constants& constants,
                    const Language& language) {
  static const std::regex& statement = *new std::regex(
      R"(\s*(?:for \(int (\w) = 0; \w < (\w+); \+\+\w\) \{|(\})|)"
      R"(if \(([^;]+)\) break;|(\w+) = ([^;?]+?)(?: \? ([^;:]+) : ([^;]+))?;))");
  const Notation& in = language.notation;
  const auto of = [&](const auto& part) {
    return expression(part.str(), constants, in);
  };
  std::vector<std::string> names;
  std::string out;
  std::string margin(language.indent);
  const std::string text(formula);
  for (std::sregex_iterator i(text.begin(), text.end(), statement), end;
       i != end; ++i) {
    const std::smatch& part = *i;
    std::string line;
    if (part[1].matched) {
      line = filled_in(in.loop, part[1].str(),
                       constants.numbers.at(part[2].str()));
    } else if (part[3].matched) {
      margin.resize(margin.size() - language.indent.size());
      line = in.end;
    } else if (part[4].matched) {
      line = filled_in(in.leave, of(part[4]));
    } else {
      const std::string name = part[5];
      if (!std::ranges::count(names, name)) names.push_back(name);
      line = filled_in(in.assigned, name,
                       part[7].matched ? filled_in(in.choice, of(part[6]),
                                                   of(part[7]), of(part[8]))
                                       : of(part[6]));
    }
    if (!line.empty()) out += margin + line + '\n';
    if (part[1].matched) margin += language.indent;
  }
  if (in.declared.empty()) return out;
  return fmt::format("{}{}\n{}", language.indent,
                     filled_in(in.declared, fmt::join(names, ", ")), out);
}

std::string real_text(double x) {
  std::string text = fmt::format("{}", x);
  if (text.find('.') != text.npos) return text;
  return text.insert(std::min(text.size(), text.find('e')), ".0");
}

std::string replaced(std::string text, std::string_view word,
                     std::string_view by) {
  for (std::size_t at = 0; (at = text.find(word, at)) != text.npos;
       at += by.size()) {
    text.replace(at, word.size(), by);
  }
  return text;
}

}  // namespace contact::detail
