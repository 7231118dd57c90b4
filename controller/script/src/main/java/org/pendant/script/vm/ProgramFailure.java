package org.pendant.script.vm;

import java.util.ArrayList;
import java.util.List;
import org.pendant.language.source.SourceRange;
import org.pendant.script.value.ScriptError;

/** Program failure: turns the error of a thread into a failure with its place and call stack. */
final class ProgramFailure {
  private ProgramFailure() {}

  static ScriptFailure of(ScriptThread thread, ScriptError error) {
    List<ScriptFailure.StackEntry> stack = new ArrayList<>();
    for (int i = thread.depth - 1; i >= 0; i--) {
      ScriptFunction function = thread.functions[i];
      stack.add(new ScriptFailure.StackEntry(function.name(), function.line(thread.pcs[i] - 1)));
    }
    ScriptFunction function = thread.functions[thread.depth - 1];
    SourceRange range = function.range(thread.pcs[thread.depth - 1] - 1);
    return new ScriptFailure(
        error.code(),
        error.getMessage(),
        range,
        function.source().line(range.start()),
        function.source().column(range.start()),
        stack);
  }
}
