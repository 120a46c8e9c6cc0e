#pragma once

#include <functional>
#include <string>
#include <string_view>

/// Parts of pages that need no network.
namespace cli {

/// Escapes text for markup, also within double quotes.
std::string in_markup(std::string_view text);

/// Replaces every {{name}} of a text; does not search the inserted text again.
std::string fill_template(
    std::string_view text,
    const std::function<std::string_view(std::string_view name)>& of);

/// The nonce of a page's content security policy is a hash of the content, so
/// that equal runs give equal pages. A script smuggled in by the text of a case
/// would have to contain this hash.
std::string nonce_of(const std::string& content);

/// A page without scripts.
/// @param title  as text
/// @param body  as markup
std::string still_page(const std::string& title, const std::string& body);

}  // namespace cli
