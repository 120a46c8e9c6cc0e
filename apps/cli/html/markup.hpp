#pragma once

#include <functional>
#include <string>
#include <string_view>

/// Parts of pages that need no network.
namespace cli {

/// Text as it stands in markup, not within quotes.
std::string in_markup(std::string_view text);

/// A text with every {{name}} replaced; what is put in is not looked at again.
std::string fill_template(
    std::string_view text,
    const std::function<std::string_view(std::string_view name)>& of);

/// The nonce of a page's content security policy: a hash of the content, so
/// that the same run gives the same page. Text of a case that wanted to bring
/// in a script would have to know it.
std::string nonce_of(const std::string& content);

/// A page without scripts.
/// @param title  as text
/// @param body  as markup
std::string still_page(const std::string& title, const std::string& body);

}  // namespace cli
