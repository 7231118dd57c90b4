package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.controller.external.Connectors;
import org.pendant.controller.external.FakeServer;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;

class RpcProgramTest {
  private final FakeServer server = new FakeServer();
  private final RunningProgram program =
      new RunningProgram(
          ControllerOptions.headless()
              .withOutside(new Connectors(Connectors.NONE.sockets(), url -> server)));

  /** Starts a program whose first line has made a handle. */
  private void connected(String lines) {
    program.start("def f():\n  h = rpc_factory(\"xmlrpc\", \"http://peer/\")\n" + lines + "end\n");
    program.advance(2);
  }

  private String reported() {
    return program.reported().getLast();
  }

  @Test
  void callsWithAnyNameAndAnyArguments() {
    connected("  textmsg(h.examples.more.add(1, 2.5, \"x\", p[1,2,3,4,5,6], [True]))\n");
    assertEquals(
        List.of("connect", "examples.more.add[1, 2.5, x, p[1, 2, 3, 4, 5, 6], [True]]"),
        server.calls());
    server.answer(Value.of(7));
    program.finish();
    assertEquals(List.of("7"), program.said());
  }

  @Test
  void aHandleCanBeKeptAndPassedOn() {
    connected(
        """
          def ask(who, what):
            return who.get(what)
          end
          part = h.server
          textmsg(ask(part, 5))
        """);
    assertEquals("server.get[5]", server.calls().getLast());
    server.answer(Value.of("five"));
    program.finish();
    assertEquals(List.of("five"), program.said());
  }

  @Test
  void onlyTheThreadThatCallsWaits() {
    connected(
        """
          thread counter():
            while True:
              textmsg("tick")
              sync()
            end
          end
          run counter()
          h.slow()
        """);
    int before = program.said().size();
    program.advance(100);
    assertEquals(before + 100, program.said().size());
  }

  @Test
  void aFaultEndsTheProgramAndIsQuoted() {
    connected("  h.initialize(\"RGB\")\n");
    server.fail(new ScriptError("rpc-fault", "fault 4: no camera"));
    program.finish();
    assertTrue(reported().endsWith("initialize: fault 4: no camera"), this::reported);
  }

  @Test
  void closingTheConnectionIsNoRemoteCall() {
    connected("  h.closeXMLRPCClientConnection()\n");
    program.finish();
    assertEquals(List.of("connect", "disconnect", "close"), server.calls());
  }

  @Test
  void aKilledThreadGivesItsCallUp() {
    connected(
        """
          thread caller():
            h.slow()
          end
          c = run caller()
          sync()
          kill c
          sleep(1)
        """);
    program.advance(3);
    assertTrue(server.cancelled());
  }

  @Test
  void theEndOfTheProgramGivesItsCallsUpAndClosesTheServer() {
    connected("  h.slow()\n");
    program.advance(1);
    assertFalse(server.cancelled());
    program.done(new ProgramCommand.StopProgram());
    assertTrue(server.cancelled());
    assertEquals("close", server.calls().getLast());
  }

  @Test
  void onlyXmlrpcIsAType() {
    program.run("def f():\n  rpc_factory(\"soap\", \"http://peer/\")\nend\n");
    assertTrue(
        reported().endsWith("rpc_factory: type is soap, must be \"xmlrpc\""), this::reported);
  }

  @Test
  void aControllerWithoutDoorsRefusesClearly() {
    RunningProgram alone = new RunningProgram();
    alone.run("def f():\n  rpc_factory(\"xmlrpc\", \"http://peer/\")\nend\n");
    assertTrue(
        alone
            .reported()
            .getLast()
            .endsWith("rpc_factory: this controller has no way to the outside"),
        () -> alone.reported().getLast());
  }
}
