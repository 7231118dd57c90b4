package org.pendant.desktop.plot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;

final class ScriptVariablesTest {
  private final RecordedArm arm = new RecordedArm();
  private final ScriptVariables variables = new ScriptVariables();

  private void run() {
    arm.run(
        """
        def p():
          count = 3
          name = "bolt"
          on = True
          pose = p[1, 2, 3, 0, 0, 0]
          part = struct(size=7, label="x", sizes=[4, 5])
          matrix = [[1, 2], [3, 4]]
          sleep(1)
        end
        """);
    arm.frames(2);
  }

  private static List<String> ids(List<ChartQuantity> quantities) {
    return quantities.stream().map(ChartQuantity::id).toList();
  }

  @Test
  void hiddenOnesAreListedOnlyForThoseWhoSearchThem() {
    run();
    ChartQuantities quantities = new ChartQuantities();
    quantities.variables().show(arm.controller().state().variables());
    quantities.variables().hide(name -> !name.equals("on"));
    assertEquals(List.of("var:on"), ids(quantities.search("")));
    assertEquals(List.of("var:part.size"), ids(quantities.search("part size")).subList(0, 1));
  }

  @Test
  void numbersAndThoseInOtherValuesAreListed() {
    run();
    assertTrue(variables.show(arm.controller().state().variables()));
    assertEquals(
        List.of(
            "var:count",
            "var:on",
            "var:pose[0]",
            "var:pose[1]",
            "var:pose[2]",
            "var:pose[3]",
            "var:pose[4]",
            "var:pose[5]",
            "var:part.size",
            "var:part.sizes[0]",
            "var:part.sizes[1]",
            "var:matrix[0][0]",
            "var:matrix[0][1]",
            "var:matrix[1][0]",
            "var:matrix[1][1]"),
        ids(variables.all()));
    assertEquals("Script variables/part/sizes", variables.all().get(9).group());
    assertFalse(variables.show(arm.controller().state().variables()));
  }

  @Test
  void anExpressionMeansItsNumbers() {
    run();
    variables.show(arm.controller().state().variables());
    assertEquals(List.of("var:count"), ids(variables.of("count")));
    assertEquals(List.of("var:part.sizes[1]"), ids(variables.of(" part . sizes[1]")));
    assertEquals(6, variables.of("pose").size());
    assertEquals(List.of(), variables.of("name"));
    assertEquals(List.of(), variables.of("count + 1"));
    assertEquals(List.of("var:other"), ids(variables.of("other")), "a program to come may have it");
  }

  @Test
  void theValueIsWhatTheControllerTraces() {
    arm.trace("pose[1]", "matrix[1][0]");
    run();
    assertEquals(
        2, RecordedArm.quantity("var:pose[1]").value().applyAsDouble(arm.controller().state()));
    assertEquals(
        3,
        RecordedArm.quantity("var:matrix[1, 0]").value().applyAsDouble(arm.controller().state()));
    assertEquals(
        Double.NaN,
        RecordedArm.quantity("var:count").value().applyAsDouble(arm.controller().state()));
  }
}
