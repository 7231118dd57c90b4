package org.pendant.script.value;

/** List checks: the refusals that all lists share. */
final class ListChecks {
  private ListChecks() {}

  static void index(int index, int length) throws ScriptError {
    if (index < 0 || index >= length) {
      throw new ScriptError(
          "index-out-of-range",
          "index is "
              + index
              + (length == 0 ? ", but the list is empty" : ", must be 0 to " + (length - 1)));
    }
  }

  static void range(int begin, int end, int length) throws ScriptError {
    if (begin < 0 || end < begin || end > length) {
      throw new ScriptError(
          "index-out-of-range",
          "slice is " + begin + " to " + end + ", must lie in order within 0 to " + length);
    }
  }

  static void room(int needed, int capacity) throws ScriptError {
    if (needed > capacity) {
      throw new ScriptError(
          "list-capacity", needed + " elements do not fit a list with capacity " + capacity);
    }
  }

  static ScriptError elementType(ValueKind list, ValueKind element) {
    return new ScriptError(
        "wrong-type", "a list of " + list.text() + " cannot take " + element.described());
  }
}
