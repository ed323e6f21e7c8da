// Options whose value is one of a few words.
#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <map>
#include <string>

namespace quadloom::app {

template <typename Enum>
std::string find_name(const std::map<std::string, Enum>& names, Enum value) {
  for (const auto& [name, v] : names) {
    if (v == value) return name;
  }
  return "?";
}

template <typename Enum>
std::string all_words(const std::map<std::string, Enum>& names) {
  std::string words;
  for (const auto& entry : names) words += (words.empty() ? "" : "|") + entry.first;
  return words;
}

// An option whose value is one of a few words; the error names them.
template <typename Enum>
CLI::Option* add_choice(CLI::App& verb, const std::string& flag, Enum& value,
                        const std::map<std::string, Enum>& names, const std::string& help) {
  const std::string words = all_words(names);
  return verb
      .add_option_function<std::string>(
          flag,
          [&value, &names, flag, words](const std::string& word) {
            const auto found = names.find(word);
            if (found == names.end()) {
              throw CLI::ValidationError(flag, fmt::format("'{}' is none of {}", word, words));
            }
            value = found->second;
          },
          help)
      ->type_name(words)
      ->default_str(find_name(names, value));
}

}  // namespace quadloom::app
