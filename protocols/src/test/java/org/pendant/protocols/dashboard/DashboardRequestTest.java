package org.pendant.protocols.dashboard;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Locale;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class DashboardRequestTest {
  private static void assertReads(DashboardCommand word, String argument, String line) {
    assertEquals(
        Optional.of(new DashboardRequest(word, argument)), DashboardRequest.read(line), line);
  }

  private static void assertUnknown(String line) {
    assertEquals(Optional.empty(), DashboardRequest.read(line), line);
  }

  @Test
  void everyWordIsReadAsItself() {
    for (DashboardCommand word : DashboardCommand.values()) {
      String line = String.join(" ", word.words());
      assertReads(word, "", line);
      assertReads(word, "", line.toUpperCase(Locale.ROOT));
      assertReads(word, "", "  " + line.replace(" ", "   ") + " \t");
    }
  }

  @Test
  void argumentsKeepTheirCapitalsAndBlanks() {
    assertReads(DashboardCommand.LOAD, "My  Program.urp", "LOAD   My  Program.urp ");
    assertReads(DashboardCommand.POPUP, "Close the Door", "popup Close the Door");
    assertReads(DashboardCommand.ADD_TO_LOG, "one", "addToLog one");
  }

  @Test
  void anInstallationIsNoProgram() {
    assertReads(
        DashboardCommand.LOAD_INSTALLATION,
        "default.installation",
        "load installation default.installation");
    assertReads(DashboardCommand.LOAD, "installations.urp", "load installations.urp");
  }

  @Test
  void refusesArgumentsThatNothingTakes() {
    assertUnknown("play now");
    assertUnknown("power on please");
    assertUnknown("quit 1");
  }

  @Test
  void refusesWhatIsNoCommand() {
    assertUnknown("");
    assertUnknown("   ");
    assertUnknown("power");
    assertUnknown("poweron");
    assertUnknown("loader x.urp");
    assertUnknown("setUserRole locked");
    assertUnknown("\0\u00ff");
  }
}
