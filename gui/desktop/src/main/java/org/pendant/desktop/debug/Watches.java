package org.pendant.desktop.debug;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.pendant.kit.settings.Settings;
import org.pendant.kit.text.Messages;
import org.pendant.language.source.ByteText;
import org.pendant.script.debug.Debugger;
import org.pendant.script.debug.Variable;
import org.pendant.script.value.ScriptError;
import org.pendant.script.variables.VariablePath;
import org.pendant.script.variables.VariableSamples;

/** Watch expressions: computed at every stop; they are kept in the settings. */
final class Watches {
  private static final String SETTING = "debug.watches";

  private final Settings settings;
  private final List<String> expressions = new ArrayList<>();

  Watches(Settings settings) {
    this.settings = settings;
    settings.get(SETTING).ifPresent(text -> text.lines().forEach(expressions::add));
    expressions.removeIf(String::isBlank);
  }

  List<String> expressions() {
    return List.copyOf(expressions);
  }

  /** Adds one at the end; one that is there already stays where it is. */
  void add(String expression) {
    String added = line(expression);
    if (!added.isEmpty() && !expressions.contains(added)) {
      expressions.add(added);
      save();
    }
  }

  /** Replaces one; blank text removes it. */
  void change(String from, String to) {
    int place = expressions.indexOf(from);
    String wanted = line(to);
    if (place < 0 || from.equals(wanted)) {
      return;
    }
    if (wanted.isEmpty() || expressions.contains(wanted)) {
      expressions.remove(place);
    } else {
      expressions.set(place, wanted);
    }
    save();
  }

  void remove(String expression) {
    change(expression, "");
  }

  private static String line(String expression) {
    return expression.replaceAll("\\s*\\R\\s*", " ").strip();
  }

  private void save() {
    settings.put(SETTING, String.join("\n", expressions));
  }

  /** Without values, while nothing is paused. */
  List<ValueNode.Group> idle() {
    return List.of(
        new ValueNode.Group(
            "", Scope.GLOBAL, expressions.stream().map(e -> ValueNode.of(blank(e))).toList()));
  }

  /** What can be followed while the program runs: variables, and elements and members of them. */
  static List<ValueNode.Group> live(
      List<String> wanted, VariableSamples samples, Map<ValueKey, Integer> unfolded) {
    List<ValueNode> nodes = new ArrayList<>();
    for (String each : wanted) {
      nodes.add(live(each, samples, unfolded));
    }
    return List.of(new ValueNode.Group("", Scope.GLOBAL, nodes));
  }

  private static ValueNode live(
      String expression, VariableSamples samples, Map<ValueKey, Integer> unfolded) {
    if (!VariablePath.isOne(expression)) {
      return ValueNode.of(blank(expression));
    }
    return samples
        .find(VariablePath.of(expression))
        .map(sample -> LiveValues.node(sample, Scope.GLOBAL, unfolded))
        .map(node -> node.called(ByteText.asBytes(expression)))
        .orElseGet(() -> ValueNode.of(blank(expression)));
  }

  private static Variable blank(String expression) {
    String bytes = ByteText.asBytes(expression);
    return new Variable(bytes, bytes, Optional.empty(), "", 0);
  }

  /** Computes {@code wanted} in a call, in the frame loop. */
  static List<ValueNode.Group> read(List<String> wanted, ValueReader reader, Scope scope) {
    List<ValueNode> nodes = new ArrayList<>();
    for (String each : wanted) {
      nodes.addAll(read(each, reader, scope));
    }
    return List.of(new ValueNode.Group("", scope, nodes));
  }

  private static List<ValueNode> read(String expression, ValueReader reader, Scope scope) {
    Debugger debugger = reader.debugger();
    try {
      Variable value =
          debugger.evaluate(scope.thread(), scope.depth(), ByteText.asBytes(expression));
      return reader.read(scope, List.of(value));
    } catch (ScriptError e) {
      return List.of(
          ValueNode.failed(blank(expression), Messages.shown(ByteText.decoded(e.getMessage()))));
    }
  }
}
