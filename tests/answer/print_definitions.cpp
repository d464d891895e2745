// Prints the parts of docs/result.schema.json that follow from the lists of fields.
#include <iostream>

#include "answer/verdict_json.hpp"

int main() {
  std::cout << kusabi::answer::answer_definitions().dump(2) << '\n';
}
