package org.pendant.desktop.program;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.pendant.controller.installation.ControlHost;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.installation.SignalUse;
import org.pendant.controller.io.InputAction;
import org.pendant.controller.io.RunStateAction;
import org.pendant.project.program.ActionStep;
import org.pendant.project.program.ForeignStep;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.Setting;

final class NodeLabelsTest {
  private static final String GRIPPER = "digital_out[0]";

  private final NodeLabels names =
      new NodeLabels(
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
    assertEquals("Close gripper", names.signal(GRIPPER));
    assertEquals("digital_out[1]", names.signal("digital_out[1]"));
    assertEquals("digital_in[7]", names.signal("digital_in[7]"));
  }

  @Test
  void linesOfTheTreeCallSignalsByTheirNames() {
    List<String> labels = TreeRow.of(tree, Set.of()).stream().map(row -> row.label(names)).toList();
    assertEquals("Set Close gripper = On", labels.getLast());
  }

  @Test
  void externalControlSaysWhomItAsks() {
    Installation cell =
        Installation.NONE.with(parts -> parts.controlHost = new ControlHost("10.0.0.7", 50012));
    ForeignStep.Contributed node =
        new ForeignStep.Contributed("FZI", "External Control", List.of("<x/>"), List.of());
    assertEquals("External Control: 10.0.0.7:50012", new NodeLabels(cell).of(node));
    assertEquals("External Control: 192.168.56.1:50002", NodeLabels.PLAIN.of(node));
  }

  @Test
  void aSearchFindsSignalsByBothNames() {
    assertEquals(1, TreeSearch.matches(tree, "close grip", names).size());
    assertEquals(1, TreeSearch.matches(tree, "digital_out[0]", names).size());
    assertEquals(0, TreeSearch.matches(tree, "close grip", NodeLabels.PLAIN).size());
  }
}
