package org.pendant.desktop.plot;

import static org.pendant.desktop.plot.PlotTexts.text;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import org.pendant.language.source.ByteText;
import org.pendant.script.value.ValueKind;
import org.pendant.script.variables.VariablePath;
import org.pendant.script.variables.VariableSample;
import org.pendant.script.variables.VariableSamples;

/**
 * Script variables: the script variables that can be drawn: numbers and booleans, and those among
 * the elements and members of others.
 */
final class ScriptVariables {
  /** Ids of variables begin with this; their path follows. */
  static final String PREFIX = "var:";

  static final String GROUP = text("scriptVariables");

  /** Parts of one value that are listed; others can be dragged from the panel of variables. */
  private static final int MAX_PARTS = 64;

  private final Map<String, ChartQuantity> made = new HashMap<>();
  private VariableSamples samples = VariableSamples.NONE;
  private List<ChartQuantity> listed = List.of();
  private Predicate<String> hidden = name -> false;

  /** The variables of a program; returns whether the list is another one now. */
  boolean show(VariableSamples now) {
    if (now.equals(samples)) {
      return false;
    }
    samples = now;
    List<ChartQuantity> found = new ArrayList<>();
    now.locals().forEach(each -> list(found, GROUP, each));
    now.globals().forEach(each -> list(found, GROUP, each));
    List<ChartQuantity> different = found.stream().distinct().toList();
    boolean changed = !different.equals(listed);
    listed = different;
    return changed;
  }

  private void list(List<ChartQuantity> into, String group, VariableSample sample) {
    if (isNumber(sample)) {
      into.add(quantity(group, ByteText.decoded(sample.name()), path(sample)));
    } else if (sample.kept() > 0) {
      String below = group + "/" + ByteText.decoded(sample.name());
      sample.parts(MAX_PARTS).forEach(part -> list(into, below, part));
    }
  }

  private static boolean isNumber(VariableSample sample) {
    return sample.kind().filter(kind -> kind.isNumber() || kind == ValueKind.BOOL).isPresent();
  }

  private static VariablePath path(VariableSample sample) {
    return VariablePath.of(sample.expression());
  }

  private ChartQuantity quantity(String group, String title, VariablePath path) {
    String text = path.text();
    ChartQuantity present = made.get(text);
    if (present != null && present.group().equals(group)) {
      return present;
    }
    ChartQuantity fresh =
        new ChartQuantity(
            PREFIX + text, group, title, text, "", state -> state.traced().value(text));
    made.put(text, fresh);
    return fresh;
  }

  /** Has variables of these names left out where nobody looks for them. */
  void hide(Predicate<String> names) {
    hidden = names;
  }

  /** Whether a quantity is one that is left out, or a part of such a variable. */
  boolean hides(ChartQuantity quantity) {
    return quantity.id().startsWith(PREFIX)
        && hidden.test(VariablePath.of(quantity.id().substring(PREFIX.length())).name());
  }

  /** Those of the running or last program. */
  List<ChartQuantity> all() {
    return listed;
  }

  /** The variable of an id, whether a program has it or not; empty for what is no id of one. */
  Optional<ChartQuantity> find(String id) {
    if (!id.startsWith(PREFIX) || !VariablePath.isOne(id.substring(PREFIX.length()))) {
      return Optional.empty();
    }
    VariablePath path = VariablePath.of(id.substring(PREFIX.length()));
    ChartQuantity present = made.get(path.text());
    return Optional.of(present == null ? quantity(GROUP, path.text(), path) : present);
  }

  /**
   * What to draw for an expression: itself, or the numbers in a pose, a list or a struct; nothing
   * for what is no variable, or one that has no numbers now.
   */
  List<ChartQuantity> of(String expression) {
    if (!VariablePath.isOne(expression)) {
      return List.of();
    }
    VariablePath path = VariablePath.of(expression);
    Optional<VariableSample> sample = samples.find(path);
    if (sample.isEmpty() || sample.get().kind().isEmpty()) {
      // not assigned yet, or of a program to come
      return find(PREFIX + path.text()).stream().toList();
    }
    List<ChartQuantity> found = new ArrayList<>();
    list(found, GROUP, sample.get());
    return found.stream().map(each -> find(each.id()).orElse(each)).toList();
  }
}
