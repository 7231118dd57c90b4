package org.pendant.desktop.debug;

import static org.pendant.desktop.debug.DebugTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.pendant.script.debug.Debugger;
import org.pendant.script.variables.VariableSample;
import org.pendant.script.variables.VariableSamples;

/** Live values: makes groups of values out of the samples of a program that is not paused. */
final class LiveValues {
  private LiveValues() {}

  /**
   * The variables of a program.
   *
   * @param ended what it is called if it has ended; it need not be the one in front
   * @param unfolded how many parts are wanted of those values that are
   */
  static List<ValueNode.Group> of(
      VariableSamples samples, String ended, Map<ValueKey, Integer> unfolded) {
    List<ValueNode.Group> groups = new ArrayList<>();
    if (!samples.locals().isEmpty()) {
      Scope scope = new Scope(Debugger.MAIN, Debugger.OUTERMOST + 1, samples.mainFunction());
      groups.add(
          new ValueNode.Group(
              text("localIn", samples.mainFunction()),
              scope,
              nodes(samples.locals(), scope, unfolded)));
    }
    if (!samples.globals().isEmpty()) {
      groups.add(
          new ValueNode.Group(
              ended.isEmpty() ? text("global") : text("globalLastValuesOf", ended),
              Scope.GLOBAL,
              nodes(samples.globals(), Scope.GLOBAL, unfolded)));
    }
    return groups;
  }

  private static List<ValueNode> nodes(
      List<VariableSample> samples, Scope scope, Map<ValueKey, Integer> unfolded) {
    return samples.stream().map(each -> node(each, scope, unfolded)).toList();
  }

  /** A value with those of its parts that are wanted. */
  static ValueNode node(VariableSample sample, Scope scope, Map<ValueKey, Integer> unfolded) {
    Integer wanted = unfolded.get(new ValueKey(scope, sample.expression()));
    if (wanted == null || sample.length() == 0) {
      return ValueNode.of(sample.variable());
    }
    return new ValueNode(sample.variable(), nodes(sample.parts(wanted), scope, unfolded), "");
  }
}
