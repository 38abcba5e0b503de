#pragma once

#include <string>
#include <string_view>

/// Text made safe for HTML; the markup is also well-formed XML.
namespace boxbeam::report::html {

/// Any text for content and quoted attributes: what is hidden is shown, but line ends and tabs.
std::string escaped(std::string_view text);

/// Source: RFC 4648, 4.
std::string base64(std::string_view bytes);

/// JSON that neither ends the element it stands in nor is markup to an XML reader.
std::string harmless(const std::string& json);

/// What a Content-Security-Policy names an inline script by: 'sha256-...'.
/// Source: W3C Content Security Policy Level 3, 2.3.1.
std::string policy_hash(std::string_view script);

}  // namespace boxbeam::report::html
