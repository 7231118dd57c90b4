package org.pendant.desktop.debug;

import java.util.List;
import org.pendant.script.debug.Variable;

/**
 * Value node: a value and those of its parts that were asked for.
 *
 * @param parts the first of them; empty unless they were asked for
 * @param failure why there is no value or no part; empty if nothing failed
 */
record ValueNode(Variable variable, List<ValueNode> parts, String failure) {
  ValueNode {
    parts = List.copyOf(parts);
  }

  static ValueNode of(Variable variable) {
    return new ValueNode(variable, List.of(), "");
  }

  static ValueNode failed(Variable variable, String failure) {
    return new ValueNode(variable, List.of(), failure);
  }

  /** The same under the name that the user has typed. */
  ValueNode called(String expression) {
    Variable named =
        new Variable(expression, expression, variable.kind(), variable.text(), variable.children());
    return new ValueNode(named, parts, failure);
  }

  /**
   * Values under a heading.
   *
   * @param title empty for none
   * @param scope in which their expressions are meant
   */
  record Group(String title, Scope scope, List<ValueNode> nodes) {
    Group {
      nodes = List.copyOf(nodes);
    }
  }
}
