#pragma once

#include <string>
#include <string_view>

/// Text made safe for HTML; the markup is also well-formed XML.
namespace boxbeam::report::html {

/// Text in which everything can be seen: control characters and bytes that are not UTF-8 as
/// "\x07", marks of writing direction and the like as "\u202E". Line ends and tabs stay.
std::string visible(std::string_view text);

/// Any text, made visible, for content and quoted attributes.
std::string escaped(std::string_view text);

/// Source: RFC 4648, 4.
std::string base64(std::string_view bytes);

/// What a Content-Security-Policy names an inline script by: 'sha256-...'.
/// Source: W3C Content Security Policy Level 3, 2.3.1.
std::string policy_hash(std::string_view script);

}  // namespace boxbeam::report::html
