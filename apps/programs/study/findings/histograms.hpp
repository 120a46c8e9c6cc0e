#pragma once

#include <string>

#include "programs/study/findings/findings.hpp"

/// gnuplot scripts that draw histograms.
namespace study {

/// "set title ..." and the labels of the axes.
std::string heading(const std::string& title, const std::string& x_label,
                    const std::string& y_label);

/// The histogram of a requirement with its limit and the percentile with its
/// bounds; "" if no run has the number.
/// @param place  index of the requirement in the plan
std::string histogram(const Study& study, const Journal& journal,
                      const Judgement& judgement, std::size_t place);

/// Number of pictures of the draws; each dispersion has a panel.
std::size_t count_input_pictures(const Study& study);
/// Name of such a picture, "inputs_1".
/// @param number  index of the picture, from 0
std::string input_picture(std::size_t number);
std::string input_histograms(const Study& study, const Journal& journal,
                             std::size_t number);

}  // namespace study
