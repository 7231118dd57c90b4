package org.pendant.desktop.debug;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.pendant.kit.text.Messages;
import org.pendant.language.source.ByteText;
import org.pendant.script.debug.Debugger;
import org.pendant.script.debug.Variable;
import org.pendant.script.value.ScriptError;

/**
 * Value reader: reads values and those of their parts that are unfolded, in the frame loop.
 *
 * @param unfolded how many parts are wanted of those that are
 */
record ValueReader(Debugger debugger, Map<ValueKey, Integer> unfolded) {
  /** Most parts that the debugger makes at once. */
  private static final int AT_ONCE = 1000;

  List<ValueNode> read(Scope scope, List<Variable> variables) {
    return variables.stream().map(each -> read(scope, each)).toList();
  }

  private ValueNode read(Scope scope, Variable variable) {
    Integer wanted = unfolded.get(new ValueKey(scope, variable.expression()));
    if (wanted == null || variable.children() == 0) {
      return ValueNode.of(variable);
    }
    try {
      List<ValueNode> parts = new ArrayList<>();
      int end = Math.min(wanted, variable.children());
      while (parts.size() < end) {
        List<Variable> more =
            debugger.children(
                scope.thread(),
                scope.depth(),
                variable.expression(),
                parts.size(),
                Math.min(AT_ONCE, end - parts.size()));
        if (more.isEmpty()) {
          break;
        }
        parts.addAll(read(scope, more));
      }
      return new ValueNode(variable, parts, "");
    } catch (ScriptError e) {
      return ValueNode.failed(variable, Messages.shown(ByteText.decoded(e.getMessage())));
    }
  }
}
