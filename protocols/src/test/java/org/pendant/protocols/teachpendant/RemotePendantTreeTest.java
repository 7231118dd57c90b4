package org.pendant.protocols.teachpendant;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.command.Reply;
import org.pendant.controller.file.ProgramsFolder;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.state.StateStream;
import org.pendant.protocols.script.RunningBox;
import org.pendant.protocols.server.RemoteControl;
import org.pendant.script.vm.ProgramState;

@Timeout(60)
class RemotePendantTreeTest {
  @TempDir Path folder;

  @Test
  void variablesOfTheInstallationKeepTheirValuesFromRunToRun() throws Exception {
    Files.writeString(
        folder.resolve("cell.pinst"),
        """
        pendant installation 1
        tool name="Gripper" in-flange=[0, 0, 0.12, 0, 0, 0]
        active-tool name="Gripper"
        variable name="count" value="5"
        """);
    Files.writeString(
        folder.resolve("counts.pendant"),
        """
        pendant program 1
        installation file="cell"
        main
          script-line code="count = count + 1"
          script-line code="textmsg(count)"
        """);
    try (RunningBox box = new RunningBox(ControllerOptions.headless(), RemoteControl.disabled())) {
      RemotePendant remotePendant =
          new RemotePendant(
              box.controller(), new PendantSetup("ur5e", ProgramsFolder.at(folder), folder));
      assertEquals("counts.pendant", remotePendant.load("counts.pendant").name());
      assertEquals("Gripper", remotePendant.state().arm().tool().name());
      for (int run = 0; run < 3; run++) {
        assertEquals(Reply.done(), remotePendant.play());
        try (StateStream.Subscription frames = box.controller().feed().follow()) {
          while (remotePendant.state().program().state() != ProgramState.STOPPED) {
            var _ = frames.take();
          }
        }
      }
      List<String> said =
          box.controller().logSince(0).stream()
              .filter(each -> each.origin() == LogEntry.Origin.SCRIPT)
              .map(LogEntry::text)
              .toList();
      assertEquals(List.of("6", "7", "8"), said);
    }
  }
}
