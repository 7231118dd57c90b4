package org.pendant.controller.device;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.Test;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.RunningProgram;
import org.pendant.controller.box.EquipmentReader;
import org.pendant.controller.box.WorldCommand;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.io.IoCommand;
import org.pendant.controller.io.RegisterDirection;
import org.pendant.controller.io.SignalWrite;
import org.pendant.controller.io.WatchdogAction;
import org.pendant.controller.rtde.ControlAssembly;
import org.pendant.controller.rtde.RtdeCommand;
import org.pendant.models.json.JsonException;
import org.pendant.script.vm.ProgramState;

/** A PLC of the cell that is a scanner of the controller's EtherNet/IP adapter. */
class EthernetIpDeviceTest {
  private static final String PLC =
      "{'devices': [{'type': 'ethernetip', 'name': 'plc', 'interval': 0.01,"
          + " 'values': {'input_integer_register[3]': 17, 'input_boolean_register[63]': 1}}%s]%s}";

  private static ControllerOptions options(String devices, String rules) throws JsonException {
    byte[] text = PLC.formatted(devices, rules).replace('\'', '"').getBytes(StandardCharsets.UTF_8);
    return ControllerOptions.headless()
        .withEquipment(EquipmentReader.read("cell.json", new ByteArrayInputStream(text)));
  }

  private static RunningProgram cell(String rules) throws JsonException {
    return new RunningProgram(options("", rules));
  }

  private static List<String> said(RunningProgram program, String lines) {
    program.run("def f():\n" + lines.indent(2) + "end\n");
    return program.said();
  }

  private static int value(RunningProgram program, String group, int index) {
    return program.state().devices().getFirst().signals().stream()
        .filter(each -> each.name().equals(group))
        .findFirst()
        .orElseThrow()
        .values()
        .get(index);
  }

  private static Set<String> claim(RunningProgram program, String owner) {
    AtomicReference<Set<String>> inUse = new AtomicReference<>();
    program.done(new RtdeCommand.ClaimInputs(owner, ControlAssembly.RECIPE, inUse::set));
    return inUse.get();
  }

  @Test
  void programsReadWhatItWritesAtFirst() throws Exception {
    assertEquals(
        List.of("17", "True", "0"),
        said(
            cell(""),
            """
            sleep(0.01)
            textmsg(read_input_integer_register(3))
            textmsg(read_input_boolean_register(63))
            textmsg(read_input_integer_register(4))
            """));
  }

  @Test
  void rulesOfThePlcAnswerTheRegistersOfTheRobot() throws Exception {
    RunningProgram program =
        cell(
            ", 'rules': [{'when': 'plc.output_boolean_register[0] rises', 'after': 0.1,"
                + " 'set': 'plc.input_boolean_register[0]'},"
                + "{'when': 'plc.output_integer_register[23] is -9',"
                + " 'set': 'plc.input_integer_register[0]', 'to': -400}]");
    assertEquals(
        List.of("False", "True -400"),
        said(
            program,
            """
            write_output_boolean_register(0, True)
            write_output_integer_register(23, -9)
            sleep(0.08)
            textmsg(read_input_boolean_register(0))
            sleep(0.06)
            textmsg(str_cat(read_input_boolean_register(0), " "), read_input_integer_register(0))
            """));
    assertTrue(program.repeats());
  }

  @Test
  void packetsComeInTheirInterval() throws Exception {
    RunningProgram program = cell("");
    program.advance(5);
    program.done(new WorldCommand.SetSignal("plc.input_integer_register[1]", 5));
    int frames = 0;
    while (program.state().signals().registers(RegisterDirection.INPUT).integer(1) == 0) {
      program.advance(1);
      frames++;
      assertTrue(frames <= 5, "within 10 ms");
    }
  }

  @Test
  void itSeesModesAndStatus() throws Exception {
    RunningProgram program = cell("");
    program.start("def f():\n  sleep(1)\nend\n");
    program.advance(20);
    assertEquals(7, value(program, "robot_mode", 0));
    assertEquals(1, value(program, "safety_mode", 0));
    assertEquals(1, value(program, "robot_status", 0), "power is on");
    assertEquals(1, value(program, "robot_status", 1), "a program runs");
    assertEquals(1, value(program, "safety_status", 0), "normal");
    program.finish();
    program.advance(10);
    assertEquals(0, value(program, "robot_status", 1));
  }

  @Test
  void itDrivesTheSpeedSliderWhereItsMaskSaysSo() throws Exception {
    RunningProgram program = cell("");
    program.done(new WorldCommand.SetSignal("plc.speed_slider", 25));
    program.advance(10);
    assertEquals(1, program.state().arm().speedFraction());
    program.done(new WorldCommand.SetSignal("plc.speed_slider_mask", 1));
    program.advance(10);
    assertEquals(0.25, program.state().arm().speedFraction());
  }

  @Test
  void nobodyElseWritesWhatItHas() throws Exception {
    RunningProgram program = cell("");
    program.advance(2);
    assertEquals(1, value(program, "connected", 0));
    assertEquals(ControlAssembly.RECIPE.names(), claim(program, "a real scanner"));
    String refusal =
        program
            .ask(
                new IoCommand.WriteSignals(
                    new SignalWrite.IntegerRegister(RegisterDirection.INPUT, 0, 1)))
            .complaint()
            .orElse("");
    assertTrue(refusal.contains("in use by EtherNet/IP scanner plc"), refusal);
  }

  @Test
  void whatAnotherHasIsAskedForAgainEachSecond() throws Exception {
    RunningProgram program = cell("");
    program.done(new WorldCommand.SetSignal("plc.online", 0));
    program.advance(100);
    assertEquals(Set.of(), claim(program, "a real scanner"));
    program.done(new WorldCommand.SetSignal("plc.online", 1));
    program.advance(10);
    assertEquals(0, value(program, "connected", 0));
    assertTrue(
        program.reported().toString().contains("refused (0x0106)"), program.reported().toString());
    program.done(new IoCommand.ReleaseSignals("a real scanner"));
    program.advance(501);
    assertEquals(1, value(program, "connected", 0));
  }

  @Test
  void oneThatIsLostDoesWhatTheInstallationSays() throws Exception {
    Installation pausing =
        Installation.NONE.with(parts -> parts.ethernetIpLoss = Optional.of(WatchdogAction.PAUSE));
    RunningProgram program = new RunningProgram(options("", "").withInstallation(pausing));
    program.start("def f():\n  sleep(10)\nend\n");
    program.advance(20);
    program.done(new WorldCommand.SetSignal("plc.online", 0));
    program.advance(15);
    assertEquals(ProgramState.RUNNING, program.programState());
    program.advance(6);
    assertEquals(ProgramState.PAUSED, program.programState());
    assertEquals(0, value(program, "connected", 0));
    assertTrue(program.reported().toString().contains("plc timed out"));
    assertEquals(Set.of(), claim(program, "a real scanner"), "what it had is given back");
    assertEquals(17, program.state().signals().inputs().integer(3), "what it has written stays");
  }

  @Test
  void silenceOfThreeIntervalsIsForgiven() throws Exception {
    RunningProgram program = cell("");
    program.advance(10);
    program.done(new WorldCommand.SetSignal("plc.online", 0));
    program.advance(14);
    program.done(new WorldCommand.SetSignal("plc.online", 1));
    program.advance(30);
    assertEquals(1, value(program, "connected", 0));
    assertTrue(!program.reported().toString().contains("timed out"));
  }

  @Test
  void ofTwoScannersTheSecondIsRefused() throws Exception {
    RunningProgram program =
        new RunningProgram(options(", {'type': 'ethernetip', 'name': 'other'}", ""));
    program.advance(10);
    assertTrue(program.state().devices().getFirst().on());
    assertTrue(!program.state().devices().getLast().on());
  }

  @Test
  void whatItOnlyReadsCannotBeSet() {
    JsonException wrong =
        assertThrows(
            JsonException.class,
            () -> cell(", 'rules': [{'every': 1, 'set': 'plc.output_boolean_register[0]'}]"));
    assertTrue(wrong.getMessage().contains("must be an input, such as"), wrong.getMessage());
  }

  @Test
  void whatItWritesAtFirstMustBeThere() {
    JsonException wrong =
        assertThrows(
            JsonException.class,
            () -> options(", {'type': 'ethernetip', 'name': 'b', 'values': {'coil[0]': 1}}", ""));
    assertTrue(
        wrong.getMessage().contains("must be one of input_boolean_register[0] to [63]"),
        wrong.getMessage());
  }
}
