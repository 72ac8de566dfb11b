#pragma once

// The names of CLI11 that our headers use. Its headers take the compiler seconds in every file: <CLI/App.hpp> is for the
// files that add or read options. <CLI/CLI.hpp>, which doubles that again with the bodies of its help and its
// configuration files, is for main.cc alone; the linker finds those there.
namespace CLI {
class App;
class Option;
class ParseError;
class Validator;
}  // namespace CLI
