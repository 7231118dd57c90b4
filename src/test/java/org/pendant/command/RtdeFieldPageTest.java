package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.pendant.controller.quantity.StateQuantity;
import org.pendant.controller.rtde.InputFields;
import org.pendant.controller.rtde.OutputField;
import org.pendant.controller.rtde.OutputFields;

/** docs/protocols/rtde-reference.md against the fields that are declared. */
final class RtdeFieldPageTest {
  /** {@code src/site/reference} has the page written with it. */
  private static final boolean WRITES = Boolean.getBoolean("pendant.pages.write");

  private static final Pattern NUMBERED = Pattern.compile("(.*?)(\\d+)(\\D*)");

  /**
   * A row of a table.
   *
   * @param first the name of its field, or of the first of its fields
   * @param last that of the last
   * @param rest the other cells
   */
  private record Row(String first, String last, String rest) {
    private static Row of(String name, String rest) {
      return new Row(name, name, rest);
    }

    /** Whether a field is the next of a series. */
    private boolean continuedBy(Row next) {
      Matcher before = NUMBERED.matcher(last);
      Matcher behind = NUMBERED.matcher(next.first);
      return rest.equals(next.rest)
          && before.matches()
          && behind.matches()
          && before.group(1).equals(behind.group(1))
          && before.group(3).equals(behind.group(3))
          && Integer.parseInt(before.group(2)) + 1 == Integer.parseInt(behind.group(2));
    }

    private String line() {
      String names = first.equals(last) ? "`" + first + "`" : "`" + first + "` to `" + last + "`";
      return "| " + names + " | " + rest + " |\n";
    }
  }

  @Test
  void pageHasTheFieldsThatAreDeclared() throws IOException {
    Path file = Launcher.home().resolve("docs/protocols/rtde-reference.md");
    if (WRITES) {
      Files.writeString(file, page());
    }
    assertEquals(Files.readString(file), page(), "renew it with src/site/reference");
  }

  private static String page() {
    List<Row> outputs = new ArrayList<>();
    for (OutputField field : OutputFields.all()) {
      outputs.add(Row.of(field.name(), field.type() + " | " + unit(field) + " | " + what(field)));
    }
    List<Row> inputs = new ArrayList<>();
    InputFields.all().forEach(field -> inputs.add(Row.of(field.name(), field.type().toString())));
    return """
    # All fields of RTDE

    This page is generated from the fields that the controller declares: `src/site/reference`. [rtde.md](rtde.md) has the protocol,
    [rtde-fields.md](rtde-fields.md) what was chosen where the interface leaves something open.

    ## Outputs

    What clients may ask for, and programs with `get_rtde_value`.

    | field | type | unit | what |
    | --- | --- | --- | --- |
    """
        + lines(outputs)
        + """

        ## Inputs

        What clients may write. What has a mask is written only where the mask selects it.

        | field | type |
        | --- | --- |
        """
        + lines(inputs);
  }

  private static String lines(List<Row> rows) {
    StringBuilder lines = new StringBuilder();
    for (int i = 0; i < rows.size(); i++) {
      Row series = rows.get(i);
      while (i + 1 < rows.size() && series.continuedBy(rows.get(i + 1))) {
        i++;
        series = new Row(series.first(), rows.get(i).first(), series.rest());
      }
      lines.append(series.line());
    }
    return lines.toString();
  }

  private static String unit(OutputField field) {
    List<String> units =
        field.quantity().components().stream()
            .skip(field.from())
            .limit(field.count())
            .map(each -> each.unit().symbol())
            .distinct()
            .toList();
    return String.join(", ", units);
  }

  private static String what(OutputField field) {
    StateQuantity quantity = field.quantity();
    String group = quantity.group().replace("/", ", ");
    if (field.count() == 1) {
      group += ", " + quantity.components().get(field.from()).title();
    }
    return quantity.explanation().isEmpty() ? group : group + ": " + quantity.explanation();
  }
}
