package org.pendant.script.value;

import java.util.Optional;

/** Assignment: what a variable, list element or struct member contains after it. */
final class Assignment {
  private Assignment() {}

  /** As {@link Operators#assign}. */
  static Value assign(Value current, Value incoming) throws ScriptError {
    if (current.kind() == ValueKind.NONE) {
      return incoming;
    }
    Optional<String> difference = StructValue.typeDifference(current, incoming);
    if (difference.isPresent()) {
      throw new ScriptError("wrong-type", difference.get().strip());
    }
    return replaced(current, incoming);
  }

  /** As {@link #assign}, when the types are known to agree. */
  @SuppressWarnings("ReferenceEquality") // whether it is the same object is the question
  static Value replaced(Value current, Value incoming) throws ScriptError {
    // only containers keep what they are; asked first, as it takes long to find no interface
    if (current == incoming || !(incoming instanceof Container)) {
      return incoming;
    }
    if (current instanceof ListValue list && incoming instanceof ListValue source) {
      list.assign(source);
      return list;
    }
    if (current instanceof StructValue struct && incoming instanceof StructValue source) {
      struct.assign(source);
      return struct;
    }
    return incoming;
  }
}
