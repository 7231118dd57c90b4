package org.pendant.controller.device;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.RunningProgram;
import org.pendant.controller.box.EquipmentReader;
import org.pendant.models.json.JsonException;

/** Devices and rules that outputs drive and that drive inputs. */
class WiredDevicesTest {
  private static RunningProgram cell(String text) throws JsonException {
    return new RunningProgram(
        ControllerOptions.headless()
            .withEquipment(
                EquipmentReader.read(
                    "cell.json",
                    new ByteArrayInputStream(
                        text.replace('\'', '"').getBytes(StandardCharsets.UTF_8)))));
  }

  private static final String WAIT =
      """
        def wait_in(n, level):
          t = 0.0
          while get_standard_digital_in(n) != level:
            sync()
            t = t + get_steptime()
          end
          return t
        end
      """;

  private static double time(RunningProgram program, int index) {
    return program.numbers().get(index);
  }

  private static void run(RunningProgram program, String lines) {
    program.run("def f():\n" + WAIT + lines + "end\n");
  }

  @Test
  void aGripperClosesOpensAndTellsItsEnds() throws Exception {
    RunningProgram program =
        cell(
            "{'devices': [{'type': 'gripper', 'close': 'digital_out[0]', 'closed':"
                + " 'digital_in[0]', 'opened': 'digital_in[1]', 'time': 0.3}]}");
    run(
        program,
        """
          textmsg(wait_in(1, True))
          set_standard_digital_out(0, True)
          textmsg(wait_in(0, True))
          set_standard_digital_out(0, False)
          textmsg(wait_in(1, True))
        """);
    assertEquals(0, time(program, 0), 0.01);
    assertEquals(0.3, time(program, 1), 0.01);
    assertEquals(0.3, time(program, 2), 0.01);
  }

  @Test
  void aGripperHoldsAPartBeforeItIsClosed() throws Exception {
    RunningProgram program =
        cell(
            "{'devices': [{'type': 'gripper', 'name': 'g', 'close': 'tool_out[0]', 'open':"
                + " 'tool_out[1]', 'closed': 'digital_in[0]', 'gripped': 'digital_in[2]',"
                + " 'stroke': 0.04, 'part': 0.02}]}");
    run(
        program,
        """
          set_tool_digital_out(0, True)
          textmsg(wait_in(2, True))
          textmsg(get_standard_digital_in(0))
        """);
    assertEquals("0.1", program.said().getFirst().substring(0, 3));
    assertEquals("False", program.said().get(1));
    assertTrue(program.reported().contains("g: part gripped at 20.0 mm with 100 N"));
  }

  @Test
  void aVacuumBuildsUpOnAPartAlone() throws Exception {
    RunningProgram program =
        cell(
            "{'devices': [{'type': 'vacuum', 'suck': 'digital_out[1]', 'holds': 'digital_in[0]',"
                + " 'time': 0.2}], 'rules': [{'when': 'digital_out[7] rises', 'part': 'vacuum',"
                + " 'width': 1}]}");
    run(
        program,
        """
          set_standard_digital_out(1, True)
          sleep(1)
          textmsg(get_standard_digital_in(0))
          set_standard_digital_out(7, True)
          textmsg(wait_in(0, True))
        """);
    assertEquals("False", program.said().getFirst());
    assertEquals(0.2, Double.parseDouble(program.said().get(1)), 0.01);
  }

  @Test
  void aSensorSeesTheToolCentrePoint() throws Exception {
    RunningProgram program =
        cell(
            "{'devices': [{'type': 'area', 'name': 'a', 'signal': 'digital_in[3]', 'min': [-10,"
                + " -10, 0.3], 'max': [10, 10, 10]}, {'type': 'area', 'name': 'b', 'signal':"
                + " 'digital_in[4]', 'min': [-10, -10, 0.3], 'max': [10, 10, 10], 'inverted':"
                + " true}]}");
    run(
        program,
        """

                  sync()
                  textmsg(get_standard_digital_in(3))
                  textmsg(get_standard_digital_in(4))
                  p = get_actual_tcp_pose()
                  p[2] = 0.2
                  movel(p)
                  textmsg(get_standard_digital_in(3))
                  textmsg(get_standard_digital_in(4))

        """);
    assertEquals(List.of("True", "False", "False", "True"), program.said());
  }

  @Test
  void aRuleActsLaterAndBack() throws Exception {
    RunningProgram program =
        cell(
            "{'rules': [{'when': 'digital_out[2] rises', 'after': 0.4, 'set': 'digital_in[3]',"
                + " 'for': 0.1}]}");
    run(
        program,
        """
          set_standard_digital_out(2, True)
          textmsg(wait_in(3, True))
          textmsg(wait_in(3, False))
          sleep(1)
          textmsg(get_standard_digital_in(3))
        """);
    assertEquals(0.4, Double.parseDouble(program.said().getFirst()), 0.01);
    assertEquals(0.1, Double.parseDouble(program.said().get(1)), 0.01);
    assertEquals("False", program.said().get(2));
  }

  @Test
  void aRuleHoldsAsLongAsItsCondition() throws Exception {
    RunningProgram program =
        cell(
            "{'rules': [{'while': 'digital_out[2] and digital_out[3] is off', 'after': 0.2, 'set':"
                + " 'digital_in[0]', 'to': false}]}");
    run(
        program,
        """
          sleep(0.01)
          textmsg(get_standard_digital_in(0))
          set_standard_digital_out(2, True)
          textmsg(wait_in(0, False))
          set_standard_digital_out(3, True)
          textmsg(wait_in(0, True))
        """);
    assertEquals("True", program.said().getFirst());
    assertEquals(0.2, Double.parseDouble(program.said().get(1)), 0.01);
    assertEquals(0, Double.parseDouble(program.said().get(2)), 0.01);
  }

  @Test
  void aRuleRepeats() throws Exception {
    RunningProgram program =
        cell("{'rules': [{'every': 0.5, 'set': 'digital_in[0]', 'for': 0.1}]}");
    run(
        program,
        """

                  wait_in(0, True)
                  wait_in(0, False)
                  textmsg(wait_in(0, True))
                  textmsg(wait_in(0, False))

        """);
    assertEquals(0.4, Double.parseDouble(program.said().getFirst()), 0.01);
    assertEquals(0.1, Double.parseDouble(program.said().get(1)), 0.01);
  }
}
