package org.pendant.gui.program;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.installation.SignalUse;
import org.pendant.controller.io.InputAction;
import org.pendant.controller.io.RunStateAction;
import org.pendant.controller.program.ActionStep;
import org.pendant.controller.program.ProgramTree;
import org.pendant.controller.program.Setting;

final class CalledSignalsTest {
  private static final String GRIPPER = "digital_out[0]";

  private final CalledSignals names =
      new CalledSignals(
          Installation.NONE.withSignals(
              List.of(
                  new SignalUse(
                      GRIPPER, "Close gripper", InputAction.DEFAULT, RunStateAction.PRESERVE),
                  new SignalUse(
                      "digital_out[1]", "", InputAction.DEFAULT, RunStateAction.PRESERVE))));

  /** Keys: set 2. */
  private final ProgramTree tree =
      Trees.of(ProgramTree.node(new ActionStep.SetAction(new Setting.Digital(GRIPPER, true))));

  @Test
  void signalsWithoutANameAreCalledAsScriptsCallThem() {
    assertEquals("Close gripper", names.of(GRIPPER));
    assertEquals("digital_out[1]", names.of("digital_out[1]"));
    assertEquals("digital_in[7]", names.of("digital_in[7]"));
  }

  @Test
  void linesOfTheTreeCallSignalsByTheirNames() {
    List<String> labels =
        TreeRow.of(tree, Set.of()).stream().map(row -> row.label(names::of)).toList();
    assertEquals("Set Close gripper = On", labels.getLast());
  }

  @Test
  void aSearchFindsSignalsByBothNames() {
    assertEquals(1, TreeSearch.matches(tree, "close grip", names::of).size());
    assertEquals(1, TreeSearch.matches(tree, "digital_out[0]", names::of).size());
    assertEquals(0, TreeSearch.matches(tree, "close grip", signal -> signal).size());
  }
}
