package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.controller.external.Connectors;
import org.pendant.controller.external.ToolCommunication;
import org.pendant.controller.external.ToolCommunication.Parity;
import org.pendant.controller.external.ToolSerialConnector;
import org.pendant.controller.io.AnalogBank;
import org.pendant.controller.io.AnalogDomain;
import org.pendant.controller.io.SignalWrite;
import org.pendant.controller.message.LogEntry;
import org.pendant.script.vm.ProgramState;

/** Programs that set up the serial line of the tool connector. */
class ToolCommunicationTest {
  private static final ToolCommunication EXAMPLE =
      new ToolCommunication(true, 115200, Parity.ODD, 2, 1, 3.5f);

  private final Line line = new Line();
  private final RunningProgram program =
      new RunningProgram(
          ControllerOptions.headless()
              .withOutside(Connectors.NONE.withToolSerial(line))
              .withSignals(
                  List.of(
                      new SignalWrite.AnalogInput(
                          AnalogBank.TOOL_IN, 1, 7, AnalogDomain.VOLTAGE))));

  /** Something at the tool that takes its time. */
  private static final class Line implements ToolSerialConnector {
    private final List<ToolCommunication> asked = new ArrayList<>();
    private List<News> news = List.of();
    private boolean ready = true;

    @Override
    public SetUp setUp(ToolCommunication wanted) {
      asked.add(wanted);
      return () -> ready;
    }

    @Override
    public List<News> takeNews() {
      List<News> taken = news;
      news = List.of();
      return taken;
    }
  }

  private ToolCommunication published() {
    return program.state().signals().tool().communication();
  }

  @Test
  void isOffAtFirst() {
    assertEquals(ToolCommunication.STANDARD, published());
    assertFalse(published().enabled());
  }

  @Test
  void isPublishedAndOutlivesTheProgram() {
    program.run("set_tool_communication(True, 115200, 1, 2, 1.0, 3.5)\n");
    assertEquals(EXAMPLE, published());
    assertEquals(List.of(EXAMPLE), line.asked);
  }

  @Test
  void theToolsAnalogInputsReadTheirLowEndMeanwhile() {
    program.run(
        """
        def f():
          set_tool_analog_input_domain(0, 0)
          set_tool_analog_input_domain(1, 1)
          textmsg(get_tool_analog_in(1))
          set_tool_communication(True, 9600, 0, 1, 1.5, 3.5)
          textmsg(get_tool_analog_in(0), get_tool_analog_in(1))
          set_tool_communication(False, 9600, 0, 1, 1.5, 3.5)
          textmsg(get_tool_analog_in(1))
        end
        """);
    assertEquals(List.of("7", "0.0040", "7"), program.said());
  }

  @Test
  void theProgramWaitsUntilItIsSetUp() {
    line.ready = false;
    program.start("set_tool_communication(True, 9600, 0, 1, 1.5, 3.5)\ntextmsg(\"set up\")\n");
    program.advance(100);
    assertEquals(List.of(), program.said());
    line.ready = true;
    program.finish();
    assertEquals(List.of("set up"), program.said());
  }

  @Test
  void theProgramGoesOnWithoutALineThatTakesTooLong() {
    line.ready = false;
    program.start("set_tool_communication(True, 9600, 0, 1, 1.5, 3.5)\n");
    program.advance(990);
    assertEquals(ProgramState.RUNNING, program.programState());
    program.advance(20);
    assertEquals(ProgramState.STOPPED, program.programState());
  }

  @Test
  void aSecondaryProgramDoesNotWait() {
    line.ready = false;
    program.done(
        new ProgramCommand.RunSecondary(
            program.program(
                "sec f():\n  set_tool_communication(True, 115200, 1, 2, 1.0, 3.5)\nend\n")));
    assertEquals(List.of(), program.reported());
    assertEquals(EXAMPLE, published());
  }

  @Test
  void troubleIsAWarningAtTheLineThatBeganIt() {
    program.start(
        "def f():\n  sleep(0.1)\n  set_tool_communication(True, 9600, 0, 1, 1, 0)\nend\n");
    line.ready = false;
    program.advance(52);
    line.news = List.of(new ToolSerialConnector.News(true, "there is no such device"));
    line.ready = true;
    program.advance(1);
    LogEntry entry = program.state().newEntries().getFirst();
    assertEquals(LogEntry.Level.WARNING, entry.level());
    assertEquals("there is no such device", entry.text());
    assertTrue(entry.place().isPresent());
    assertEquals(3, entry.place().get().line());
  }
}
