package org.pendant.desktop.installation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.installation.SignalUse;
import org.pendant.controller.io.AnalogDomain;
import org.pendant.controller.io.InputAction;
import org.pendant.controller.io.RunStateAction;
import org.pendant.desktop.session.ActiveInstallation;
import org.pendant.models.arm.ArmLibrary;

final class SignalTableTest {
  private static final int USE = 2;
  private static final int DOMAIN = 3;

  private final ActiveInstallation active = new ActiveInstallation();
  private String refusal = "";
  private final SignalTable table =
      new SignalTable(new Editing(active, () -> ArmLibrary.load("ur5e")), why -> refusal = why);

  private int row(String signal) {
    for (int i = 0; i < table.getRowCount(); i++) {
      if (table.getValueAt(i, 0).equals(signal)) {
        return i;
      }
    }
    throw new AssertionError("no row " + signal);
  }

  @Test
  void namesAreWrittenAndForgotten() {
    table.setValueAt(" Part there ", row("digital_in[0]"), SignalTable.NAME);
    assertEquals(
        List.of(
            new SignalUse(
                "digital_in[0]", "Part there", InputAction.DEFAULT, RunStateAction.PRESERVE)),
        active.current().signals());
    table.setValueAt("", row("digital_in[0]"), SignalTable.NAME);
    assertEquals(List.of(), active.current().signals());
  }

  @Test
  void refusesTheNameOfAnotherSignal() {
    table.setValueAt("Part", row("digital_in[0]"), SignalTable.NAME);
    table.setValueAt("Part", row("digital_in[1]"), SignalTable.NAME);
    assertEquals("Part is the name of another one too", refusal);
    assertEquals("", table.getValueAt(row("digital_in[1]"), SignalTable.NAME));
  }

  @Test
  void inputsCanGiveFreedriveAndOutputsFollowPrograms() {
    table.setValueAt("High: freedrive", row("digital_in[7]"), USE);
    table.setValueAt("Low when not running", row("digital_out[0]"), USE);
    assertEquals(InputAction.FREEDRIVE, active.current().signals().get(0).input());
    assertEquals(RunStateAction.LOW_WHEN_NOT_RUNNING, active.current().signals().get(1).output());
    assertFalse(table.choices(row("digital_in[0]"), USE).contains("Low when not running"));
  }

  @Test
  void analogSignalsAreMadeOfCurrentOrVoltage() {
    table.show(SignalTable.Group.ANALOG, "");
    table.setValueAt("Current", row("analog_in[1]"), DOMAIN);
    assertEquals(
        List.of(AnalogDomain.VOLTAGE, AnalogDomain.CURRENT), active.current().wiring().analogIn());
    assertEquals(Installation.NONE.wiring().analogOut(), active.current().wiring().analogOut());
  }

  @Test
  void listsWhatHasAPartOfAName() {
    table.setValueAt("Valve", row("digital_out[3]"), SignalTable.NAME);
    table.show(SignalTable.Group.ALL, "valve");
    assertEquals(1, table.getRowCount());
    table.show(SignalTable.Group.FLAGS, "");
    assertEquals(32, table.getRowCount());
    assertTrue(table.choices(0, USE).isEmpty());
  }

  @Test
  void aSignalIsRenamedUnlessTheNameIsTaken() {
    Installation named =
        SignalNames.rename(Installation.NONE, ArmLibrary.load("ur5e"), "flag[3]", "Busy")
            .orElseThrow();
    assertEquals("Busy", SignalNames.use(named, "flag[3]").name());
    assertEquals(
        Optional.empty(), SignalNames.rename(named, ArmLibrary.load("ur5e"), "flag[4]", "Busy"));
  }
}
