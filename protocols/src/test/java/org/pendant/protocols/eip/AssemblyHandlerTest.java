package org.pendant.protocols.eip;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.command.Reply;
import org.pendant.controller.eip.AssemblyPair;
import org.pendant.controller.rtde.ControlAssembly;

class AssemblyHandlerTest {
  private final Controller controller = new Controller(ControllerOptions.headless());
  private final AssemblyHandler assemblyHandler = new AssemblyHandler(controller);

  @Test
  void aScannerThatWritesWhileTimeStandsStillLeavesThePlacesToOthers() {
    for (int i = 0; i < 5000; i++) {
      assemblyHandler.write(
          "scanner",
          AssemblyPair.BUILT_IN_FROM_PLC,
          ByteBuffer.allocate(ControlAssembly.BYTES).order(ByteOrder.LITTLE_ENDIAN));
    }
    CompletableFuture<Reply> byHand = controller.submit(new ProgramCommand.StopProgram());
    controller.advance();
    assertEquals(new Reply.Done(), byHand.join());
  }
}
