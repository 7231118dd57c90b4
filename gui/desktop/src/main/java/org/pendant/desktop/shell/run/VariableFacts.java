package org.pendant.desktop.shell.run;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Stream;
import org.pendant.controller.installation.InstallationVariable;
import org.pendant.language.source.ByteText;
import org.pendant.script.debug.Variable;
import org.pendant.script.value.ValueKind;
import org.pendant.script.variables.VariableSample;
import org.pendant.script.variables.VariableSamples;

/**
 * Variable facts: what the Run screen says about the variables of a program.
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
   * @param installed whether it is one of the installation's, which keep their values
   */
  record Row(String name, String value, boolean favourite, boolean installed) {}

  /**
   * The facts of samples.
   *
   * @param favourites names of variables that come first
   * @param hidden names of variables that are left out unless they are favourites
   * @param installed variables that every program has; their favourites come first as well
   */
  static VariableFacts of(
      VariableSamples samples,
      Set<String> favourites,
      Predicate<String> hidden,
      List<InstallationVariable> installed) {
    Set<String> first = new HashSet<>(favourites);
    Map<String, Row> rows = new LinkedHashMap<>();
    for (InstallationVariable each : installed) {
      if (each.favourite()) {
        first.add(each.name());
      }
    }
    Stream.concat(samples.locals().stream(), samples.globals().stream())
        .map(VariableSample::variable)
        .filter(each -> first.contains(each.name()) || !hidden.test(each.name()))
        .map(each -> row(each, first, installed))
        .forEach(row -> rows.putIfAbsent(row.name(), row));
    for (InstallationVariable each : installed) {
      rows.putIfAbsent(
          each.name(), new Row(each.name(), each.value(), first.contains(each.name()), true));
    }
    List<Row> ordered = new ArrayList<>(rows.values());
    ordered.sort(Comparator.comparing(Row::favourite).reversed());
    List<Row> shown = ordered.stream().limit(MOST).toList();
    return new VariableFacts(shown, ordered.size() - shown.size() + samples.omitted());
  }

  private static Row row(
      Variable variable, Set<String> favourites, List<InstallationVariable> installed) {
    String text = ByteText.decoded(variable.text());
    String value = variable.kind().equals(Optional.of(ValueKind.STRING)) ? '"' + text + '"' : text;
    return new Row(
        ByteText.decoded(variable.name()),
        variable.kind().isEmpty() ? "\u2013" : value,
        favourites.contains(variable.name()),
        installed.stream().anyMatch(each -> each.name().equals(variable.name())));
  }
}
