package org.pendant.controller.builtin;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.pendant.language.signature.Parameter;
import org.pendant.language.signature.Signature;
import org.pendant.language.signature.Type;

/**
 * Compares the catalogue with the signatures that the manual prints. Columns of the table: module,
 * receiver (empty for functions), name, section, physical time and secondary programs (yes, no, or
 * sometimes, which leaves it open), deprecated, and the parameters between semicolons.
 */
class CatalogueTest {
  private static final String TABLE = "manual-signatures.csv";
  private static final int COLUMNS = 8;

  /** What older manuals had and old programs still call. */
  private static final Set<String> OLDER =
      Set.of("get_joint_positions", "servoc", "tool_pose", "varmsg");

  /** What newer controllers take beyond the parameters that the manual has. */
  private static final Set<String> NEWER =
      Set.of("direct_torque.viscous_scale", "direct_torque.coulomb_scale");

  private record Row(
      String module,
      String receiver,
      String name,
      String section,
      String time,
      String secondary,
      boolean deprecated,
      List<String> parameters) {

    String key() {
      return receiver.isEmpty() ? name : receiver + "." + name;
    }
  }

  @Test
  void everyDeclaredFunctionMatchesTheManualRowByRow() throws IOException {
    Map<String, Row> manual = manual();
    List<String> differences = new ArrayList<>();
    for (Signature declared : CallFixture.BUILTINS.all()) {
      String key = declared.receiver().map(type -> type.text() + ".").orElse("") + declared.name();
      Row row = manual.get(key);
      if (row == null && OLDER.contains(key)) {
        compare(differences, key + " deprecated", true, !declared.deprecated().isEmpty());
      } else if (row == null) {
        differences.add(key + " is not in the manual");
      } else {
        compare(differences, key + " module", row.module(), declared.module());
        compare(differences, key + " section", row.section(), declared.section());
        compareFlag(differences, key + " physical time", row.time(), declared.physicalTime());
        compareFlag(
            differences, key + " in secondary", row.secondary(), declared.allowedInSecondary());
        compare(
            differences, key + " deprecated", row.deprecated(), !declared.deprecated().isEmpty());
        compare(differences, key, row.parameters(), parameters(declared, row.parameters()));
      }
    }
    assertEquals("", String.join("\n", differences));
  }

  @Test
  void allMathematicsAndAllMethodsAreDeclared() throws IOException {
    List<String> missing =
        manual().values().stream()
            .filter(row -> row.module().equals("urmath") || !row.receiver().isEmpty())
            .filter(row -> row.receiver().isEmpty() || type(row.receiver()) != Type.ANY)
            .filter(
                row ->
                    row.receiver().isEmpty()
                        ? CallFixture.BUILTINS.find(row.name()).isEmpty()
                        : CallFixture.BUILTINS
                            .findMethod(type(row.receiver()), row.name())
                            .isEmpty())
            .map(Row::key)
            .toList();
    assertEquals(List.of(), missing);
  }

  @Test
  void everyEntryBeginsWithASentence() {
    for (Signature declared : CallFixture.BUILTINS.all()) {
      String text = declared.documentation();
      assertTrue(text.matches("[A-Z][^\\n]*[.]"), () -> declared.name() + ": " + text);
    }
  }

  private static void compareFlag(List<String> differences, String what, String row, boolean flag) {
    if (!row.equals("sometimes")) {
      compare(differences, what, row.equals("yes"), flag);
    }
  }

  private static void compare(List<String> differences, String what, Object row, Object declared) {
    if (!row.equals(declared)) {
      differences.add(what + ": the manual says " + row + ", declared is " + declared);
    }
  }

  /** The declared parameters as the table writes them; descriptions only have to be some. */
  private static List<String> parameters(Signature declared, List<String> row) {
    List<String> texts = new ArrayList<>();
    for (Parameter parameter : declared.parameters()) {
      if (NEWER.contains(declared.name() + "." + parameter.name())) {
        continue;
      }
      String text = parameter.name();
      String inTable = texts.size() < row.size() ? row.get(texts.size()) : "";
      if (!parameter.required()) {
        text += "=" + plainNumbers(parameter.defaultText());
      }
      boolean bothDescribed =
          inTable.startsWith(parameter.name() + "=<") && parameter.defaultText().startsWith("<");
      texts.add(bothDescribed ? inTable : text);
    }
    return texts;
  }

  /** The text with floats that are whole written without their point. */
  private static String plainNumbers(String text) {
    return text.replaceAll("(?<=[0-9])\\.0(?![0-9])", "");
  }

  private static Type type(String receiver) {
    return Arrays.stream(Type.values())
        .filter(type -> type.text().equals(receiver))
        .findFirst()
        .orElse(Type.ANY);
  }

  private static Map<String, Row> manual() throws IOException {
    try (InputStream table = CatalogueTest.class.getResourceAsStream(TABLE)) {
      return new String(table.readAllBytes(), StandardCharsets.UTF_8)
          .lines()
          .skip(1)
          .map(CatalogueTest::row)
          .collect(
              Collectors.toMap(Row::key, row -> row, (first, second) -> first, LinkedHashMap::new));
    }
  }

  private static Row row(String line) {
    List<String> cells = List.of(line.split(",", COLUMNS));
    String parameters = cells.get(COLUMNS - 1);
    return new Row(
        cells.get(0),
        cells.get(1),
        cells.get(2),
        cells.get(3),
        cells.get(4),
        cells.get(5),
        cells.get(6).equals("yes"),
        parameters.isEmpty()
            ? List.of()
            : List.of(parameters.split("; ")).stream().map(CatalogueTest::plainNumbers).toList());
  }
}
