// Detection of a class member by name: const or not, overloaded, a template, private, or a
// variable. A member of the wrong shape is thus distinguished from a missing one.
#pragma once

#include <type_traits>

namespace kusabi::engine {
namespace member_names {

// A class that inherits from `Class` and from this one has an ambiguous name if `Class` has it.
struct AmbiguousNames {
  int serialize;
  int objective;
  int bound;
  int tally;
  int maximises;
  int emit;
  int work_of_first_child;
  int seconds;
  int least_seconds;
};

template <class Class>
struct Both : Class, AmbiguousNames {};

template <class Class>
concept Inheritable = std::is_class_v<Class> && !std::is_final_v<Class>;

}  // namespace member_names

// For final classes only a public member without overloads is found.

template <class Class>
concept NamesSerialize = (member_names::Inheritable<Class> &&
                          !requires { &member_names::Both<Class>::serialize; }) ||
                         requires {
  &Class::serialize;
};

template <class Class>
concept NamesObjective = (member_names::Inheritable<Class> &&
                          !requires { &member_names::Both<Class>::objective; }) ||
                         requires {
  &Class::objective;
};

template <class Class>
concept NamesBound = (member_names::Inheritable<Class> &&
                      !requires { &member_names::Both<Class>::bound; }) ||
                     requires {
  &Class::bound;
};

template <class Class>
concept NamesTally = (member_names::Inheritable<Class> &&
                      !requires { &member_names::Both<Class>::tally; }) ||
                     requires {
  &Class::tally;
}
|| requires {
  typename Class::Tally;
};

template <class Class>
concept NamesMaximises = (member_names::Inheritable<Class> &&
                          !requires { &member_names::Both<Class>::maximises; }) ||
                         requires {
  &Class::maximises;
};

template <class Class>
concept NamesEmit = (member_names::Inheritable<Class> &&
                     !requires { &member_names::Both<Class>::emit; }) ||
                    requires {
  &Class::emit;
};

template <class Class>
concept NamesWorkOfFirstChild = (member_names::Inheritable<Class> &&
                                 !requires { &member_names::Both<Class>::work_of_first_child; }) ||
                                requires {
  &Class::work_of_first_child;
};

template <class Class>
concept NamesSeconds = (member_names::Inheritable<Class> &&
                        !requires { &member_names::Both<Class>::seconds; }) ||
                       requires {
  &Class::seconds;
};

template <class Class>
concept NamesLeastSeconds = (member_names::Inheritable<Class> &&
                             !requires { &member_names::Both<Class>::least_seconds; }) ||
                            requires {
  &Class::least_seconds;
};

}  // namespace kusabi::engine
