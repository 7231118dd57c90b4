package org.pendant.protocols.eip;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.charset.StandardCharsets;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.ProgramCommand;
import org.pendant.language.source.Source;
import org.pendant.protocols.ScriptConnectors;
import org.pendant.protocols.egress.AllowedHosts;
import org.pendant.protocols.script.RunningBox;
import org.pendant.protocols.server.PortNumbers;
import org.pendant.protocols.server.RemoteControl;
import org.pendant.script.vm.LoadResult;
import org.pendant.script.vm.ProgramState;

/** The example of the manual: a program configures its assemblies and talks to a scanner. */
class ConfiguredByScriptTest {
  private static final String PROGRAM =
      """
      def cnc():
        service = rpc_factory("xmlrpc", "http://127.0.0.1:PORT/RPC2")
        before = service.is_instance_connected(111)
        made = service.add_configuration(101, 8, 111, 4)
        again = service.add_configuration(101, 8, 111, 4)
        wrong = service.add_configuration(100, 8, 112, 4)
        status = eip_reader_factory("111", 4)
        command = eip_writer_factory("101", 8)
        status.define_uint16(0, "code")
        command.define_uint16(0, "answer")
        command.define_bit(2, 0, "made")
        command.define_bit(2, 1, "again")
        command.define_bit(2, 2, "wrong")
        command.define_bit(2, 3, "before")
        command.define_bit(2, 4, "after")
        command.write(struct(made=made, again=again, wrong=wrong, before=before))
        while status.read("code") == 0:
          sync()
        end
        after = service.is_instance_connected(111)
        service.closeXMLRPCClientConnection()
        command.write(struct(answer=status.read("code") + 1, after=after))
      end
      """;

  @Test
  void aProgramAndAScannerTalk() throws Exception {
    try (ScriptConnectors scriptConnectors = new ScriptConnectors(AllowedHosts.ANY);
        RunningBox box =
            new RunningBox(
                ControllerOptions.headless().withOutside(scriptConnectors.connectors()),
                RemoteControl.disabled());
        EipServer server = EipServer.open(box.serverContext(), PortNumbers.anyFree())) {
      start(box, PROGRAM.replace("PORT", "" + server.ports().get(1).number()));
      try (EipClient client = EipClient.registered(server.ports().getFirst().number());
          Scanner scanner = new Scanner(client, 1)) {
        // until the program has made the assemblies
        while (scanner.open(scanner.request(20_000, 111, 4, 101, 8)) != 0) {
          assertEquals(ProgramState.RUNNING, box.controller().state().program().state());
        }
        String last = "";
        while (!last.startsWith("09")) {
          scanner.run(Hex.bytes("0803 0000"));
          last = Hex.text(scanner.receive().data());
        }
        assertEquals("0903130000000000", last);
      }
    }
  }

  private static void start(RunningBox box, String program) throws Exception {
    LoadResult loadResult =
        box.controller()
            .load(Source.of("cnc.script", program.getBytes(StandardCharsets.ISO_8859_1)));
    box.controller()
        .submit(new ProgramCommand.StartProgram(loadResult.program().orElseThrow()))
        .get(RunningBox.GIVE_UP_MS, TimeUnit.MILLISECONDS);
  }
}
