package org.pendant.protocols.script;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.DebugCommand;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.TestController;
import org.pendant.controller.box.BoxCommand;
import org.pendant.controller.command.Command;
import org.pendant.protocols.net.PeerLog;
import org.pendant.protocols.net.StateBroadcaster;
import org.pendant.protocols.server.RemoteControl;
import org.pendant.protocols.server.ServerContext;
import org.pendant.script.debug.Breakpoint;

/** Whatever a secondary program is refused for, its client is told. */
class RefusedScriptTest {
  private static final ScriptItem SECONDARY =
      new ScriptItem.Program("sec beside():\n  set_digital_out(1, True)\nend\n");

  private final RunningBox box =
      new RunningBox(ControllerOptions.headless(), RemoteControl.disabled());
  private final List<ScriptTrouble> told = new ArrayList<>();

  @AfterEach
  void close() {
    box.close();
  }

  private String refusal(ServerContext serverContext) {
    ScriptHandler scriptHandler = new ScriptHandler(serverContext);
    scriptHandler.onTrouble(told::add);
    scriptHandler.accept(SECONDARY, "client");
    return assertInstanceOf(ScriptTrouble.NotStarted.class, told.getFirst()).why();
  }

  private void ask(Command command) throws Exception {
    box.controller().submit(command).get(RunningBox.GIVE_UP_MS, TimeUnit.MILLISECONDS);
  }

  @Test
  void byABoxThatIsShutDown() throws Exception {
    ask(new BoxCommand.ShutDown());
    assertEquals("the controller has been shut down", refusal(box.serverContext()));
    assertEquals(
        "program beside of client was not started: the controller has been shut down",
        box.nextLogged());
  }

  @Test
  void whileADebuggerHoldsTheFrame() throws Exception {
    ask(new DebugCommand.Debug(debugger -> debugger.set(Breakpoint.at(2))));
    ask(
        new ProgramCommand.ReplaceProgram(
            TestController.program(box.controller(), "def p():\n  x = 1\n  sleep(9)\nend\n")));
    assertEquals("a debugger has paused program p", refusal(box.serverContext()));
    assertTrue(box.nextLogged().endsWith("a debugger has paused program p"));
  }

  @Test
  void whenTooManyCommandsWait() {
    Controller still = new Controller(ControllerOptions.headless());
    List<String> logged = new ArrayList<>();
    PeerLog log = new PeerLog((level, text) -> logged.add(text));
    for (int i = 0; i < 1024; i++) {
      still.post(new ProgramCommand.StopProgram());
    }
    try (StateBroadcaster frames = new StateBroadcaster(still.feed(), log)) {
      assertTrue(
          refusal(new ServerContext(still, frames, log, RemoteControl.disabled()))
              .startsWith("more than 1024 commands in a frame"));
    }
    assertEquals(1, logged.size());
  }
}
