package org.pendant.controller.device;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.RunningProgram;
import org.pendant.controller.box.CellEquipment;

/** Grippers that are worked by remote procedures, as programs in the wild call them. */
class GripProceduresProgramTest {
  private static RunningProgram with(String kind, double partWidthM) {
    return new RunningProgram(
        ControllerOptions.headless()
            .withEquipment(
                CellEquipment.NONE.and(
                    List.of(new DeviceSetup.RpcGripper(kind, kind, partWidthM)))));
  }

  private static final String RG =
      """
      def f():
        rpc = rpc_factory("xmlrpc", "http://localhost:41414")
        def grip(width, force):
          rpc.rg_grip(0, width + 0.0, force + 0.0)
          sleep(0.01)
          while (rpc.rg_get_busy(0)):
            sync()
          end
        end
      """;

  @Test
  void goesToAWidth() {
    RunningProgram program = with("rg", 0);
    program.run(RG + "  grip(50, 20)\n  textmsg(rpc.rg_get_width(0))\nend\n");
    assertEquals(50, program.numbers().getFirst(), 1e-6);
    assertEquals(0.060 / 0.110, program.state().timeS(), 0.05);
    assertFalse(program.waitsForOutside());
    assertTrue(program.repeats());
  }

  @Test
  void findsAPart() {
    RunningProgram program = with("rg", 0.03);
    program.run(
        RG
            + "  textmsg(rpc.rg_get_grip_detected(0))\n  grip(0, 20)\n"
            + "  textmsg(rpc.rg_grip_detected(0))\n  textmsg(rpc.rg_get_width(0))\n"
            + "  textmsg(rpc.rg_get_status(0))\n  grip(110, 20)\n"
            + "  textmsg(rpc.rg_get_grip_detected(0))\nend\n");
    assertEquals(List.of("False", "True", "30", "2", "False"), program.said());
    assertTrue(program.reported().contains("rg: part gripped at 30.0 mm with 20 N"));
  }

  @Test
  void aToolThatIsNotThereSaysSo() {
    RunningProgram program = with("rg", 0);
    program.run(
        RG
            + "  textmsg(rpc.rg_get_width(1))\n  textmsg(rpc.rg_get_status(1))\n"
            + "  textmsg(rpc.rg_grip(1, 10.0, 20.0))\nend\n");
    assertEquals(List.of("-999", "-1", "-1"), program.said());
  }

  @Test
  void theOtherMakeHasASpeedInItsCall() {
    RunningProgram program = with("2fg", 0.01);
    program.run(
        """
        def f():
          tool = rpc_factory("xmlrpc", "http://127.0.0.1:41414/RPC2")
          tool.twofg_grip_external(0, 5.0, 80, 100)
          sleep(0.5)
          textmsg(tool.twofg_get_grip_detected(0))
          textmsg(tool.twofg_get_external_width(0))
        end
        """);
    assertEquals(List.of("True", "10"), program.said());
  }

  @Test
  void procedureThatIsNotThereEndsTheProgram() {
    RunningProgram program = with("rg", 0);
    program.start(RG + "  rpc.rg_dance(0)\nend\n");
    program.finish();
    assertTrue(
        program.reported().toString().contains("rg_dance: no such procedure of rg"),
        program.reported().toString());
  }
}
