package org.pendant.script.value;

import static org.pendant.script.value.ValueTexts.text;

/** List checks: the refusals that all lists share. */
final class ListChecks {
  private ListChecks() {}

  static void index(int index, int length) throws ScriptError {
    if (index < 0 || index >= length) {
      throw new ScriptError(
          "index-out-of-range",
          length == 0 ? text("indexOfEmptyList", index) : text("indexOutside", index, length - 1));
    }
  }

  static void range(int begin, int end, int length) throws ScriptError {
    if (begin < 0 || end < begin || end > length) {
      throw new ScriptError("index-out-of-range", text("sliceOutside", begin, end, length));
    }
  }

  static void room(int needed, int capacity) throws ScriptError {
    if (needed > capacity) {
      throw new ScriptError("list-capacity", text("listFull", needed, capacity));
    }
  }

  static ScriptError elementType(ValueKind list, ValueKind element) {
    return new ScriptError("wrong-type", text("elementRefused", list.text(), element.described()));
  }
}
