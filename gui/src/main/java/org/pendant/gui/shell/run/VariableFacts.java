package org.pendant.gui.shell.run;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.pendant.controller.debug.Variable;
import org.pendant.controller.value.Kind;
import org.pendant.controller.variables.VariableSample;
import org.pendant.controller.variables.VariableSamples;
import org.pendant.language.source.ByteText;

/**
 * What the Run screen says about the variables of a program.
 *
 * @param rows favourites first, as many as there is room for
 * @param more how many there are besides
 */
record VariableFacts(List<Row> rows, int more) {
  /** Rows that the card shows at most. */
  static final int MOST = 10;

  VariableFacts {
    rows = List.copyOf(rows);
  }

  /**
   * A variable.
   *
   * @param value as scripts print it, strings in quotes; a dash before it was assigned
   */
  record Row(String name, String value, boolean favourite) {}

  /**
   * The facts of samples.
   *
   * @param favourites names of variables that come first
   */
  static VariableFacts of(VariableSamples samples, Set<String> favourites) {
    List<VariableSample> all =
        Stream.concat(samples.locals().stream(), samples.globals().stream()).toList();
    List<VariableSample> ordered = new ArrayList<>(all);
    ordered.removeIf(each -> !favourites.contains(each.name()));
    all.stream().filter(each -> !favourites.contains(each.name())).forEach(ordered::add);
    List<Row> rows =
        ordered.stream().limit(MOST).map(each -> row(each.variable(), favourites)).toList();
    return new VariableFacts(rows, all.size() - rows.size() + samples.omitted());
  }

  private static Row row(Variable variable, Set<String> favourites) {
    String text = ByteText.decoded(variable.text());
    String value = variable.kind().equals(Optional.of(Kind.STRING)) ? '"' + text + '"' : text;
    return new Row(
        ByteText.decoded(variable.name()),
        variable.kind().isEmpty() ? "\u2013" : value,
        favourites.contains(variable.name()));
  }
}
