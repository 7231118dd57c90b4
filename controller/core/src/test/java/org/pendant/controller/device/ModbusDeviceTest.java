package org.pendant.controller.device;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.RunningProgram;
import org.pendant.controller.box.EquipmentReader;
import org.pendant.controller.box.WorldCommand;
import org.pendant.script.vm.ProgramState;

/** A PLC of the cell as programs reach it by Modbus signals. */
class ModbusDeviceTest {
  private static final String PLC =
      "{'devices': [{'type': 'modbus', 'name': 'plc', 'address': '192.168.0.20', 'unit': 1,"
          + " 'coils': 4, 'registers': 8, 'values': {'register[3]': 17, 'input[1]': 1}}%s]%s}";

  private static RunningProgram cell(String devices, String rules) throws Exception {
    byte[] text = PLC.formatted(devices, rules).replace('\'', '"').getBytes(StandardCharsets.UTF_8);
    return new RunningProgram(
        ControllerOptions.headless()
            .withEquipment(EquipmentReader.read("cell.json", new ByteArrayInputStream(text))));
  }

  private static List<String> said(RunningProgram program, String lines) {
    program.run("def f():\n" + lines.indent(2) + "end\n");
    return program.said();
  }

  @Test
  void signalsReadWhatItHasAtFirst() throws Exception {
    assertEquals(
        List.of("17", "True", "False", "[17, 0]"),
        said(
            cell("", ""),
            """
            modbus_add_signal("192.168.0.20", 1, 3, 3, "level")
            modbus_add_signal("192.168.0.20", 1, 1, 0, "ready")
            modbus_add_signal("192.168.0.20:502", 1, 2, 1, "valve")
            modbus_add_signal("192.168.0.20", 1, 3, 16, "two", False, 2)
            sleep(0.1)
            textmsg(modbus_get_signal_status("level"))
            textmsg(modbus_get_signal_status("ready"))
            textmsg(modbus_get_signal_status("valve"))
            textmsg(modbus_get_signal_status("two"))
            """));
  }

  @Test
  void outputsDriveRulesAndRulesSetWhatProgramsRead() throws Exception {
    RunningProgram program =
        cell(
            "",
            ", 'rules': [{'when': 'plc.coil[0] rises', 'after': 0.2, 'set': 'plc.input[0]'},"
                + "{'when': 'plc.register[5] is 9', 'set': 'plc.input_register[2]', 'to': 400}]");
    assertEquals(
        List.of("True 400"),
        said(
            program,
            """
            modbus_add_signal("192.168.0.20", 1, 0, 1, "start")
            modbus_add_signal("192.168.0.20", 1, 0, 0, "done")
            modbus_add_signal("192.168.0.20", 1, 5, 3, "job")
            modbus_add_signal("192.168.0.20", 1, 2, 2, "count")
            modbus_set_output_signal("start", True)
            modbus_set_output_register("job", 9)
            sleep(0.8)
            textmsg(str_cat(modbus_get_signal_status("done"), " "), modbus_get_signal_status("count"))
            """));
    assertFalse(program.waitsForOutside());
    assertTrue(program.repeats());
  }

  @Test
  void doorAndLimitSwitchAreWiredToIt() throws Exception {
    RunningProgram program =
        cell(
            ", {'type': 'door', 'close': 'plc.coil[1]', 'closed': 'plc.input[2]', 'time': 0.2}",
            "");
    assertEquals(
        List.of("True"),
        said(
            program,
            """
            modbus_add_signal("192.168.0.20", 1, 1, 1, "shut")
            modbus_add_signal("192.168.0.20", 1, 2, 0, "is shut")
            modbus_set_output_signal("shut", True)
            sleep(0.6)
            textmsg(modbus_get_signal_status("is shut"))
            """));
  }

  @Test
  void whatIsNotThereIsTheExceptionOfARealOne() throws Exception {
    assertEquals(
        List.of("2", "11", "0"),
        said(
            cell("", ""),
            """
            modbus_add_signal("192.168.0.20", 1, 8, 3, "beyond")
            modbus_add_signal("192.168.0.20", 7, 0, 3, "unit 7")
            modbus_add_signal("192.168.0.20", 1, 7, 3, "last")
            sleep(0.1)
            textmsg(modbus_get_error("beyond"))
            textmsg(modbus_get_error("unit 7"))
            textmsg(modbus_get_error("last"))
            """));
  }

  @Test
  void frequencyIsThatOfTheSignal() throws Exception {
    assertEquals(
        List.of("17", "18", "17", "18"),
        said(
            cell("", ", 'rules': [{'when': 'flag[0] rises', 'set': 'plc.register[3]', 'to': 18}]"),
            """
            modbus_add_signal("192.168.0.20", 1, 3, 3, "slow")
            modbus_set_signal_update_frequency("slow", 1)
            modbus_add_signal("192.168.0.20", 1, 3, 3, "fast")
            modbus_set_signal_update_frequency("fast", 500)
            sleep(0.1)
            set_flag(0, True)
            sleep(0.01)
            textmsg(modbus_get_signal_status("slow"))
            textmsg(modbus_get_signal_status("fast"))
            sleep(0.8)
            textmsg(modbus_get_signal_status("slow"))
            sleep(0.1)
            textmsg(modbus_get_signal_status("slow"))
            """));
  }

  @Test
  void readsAndWritesAtTwoAddresses() throws Exception {
    assertEquals(
        List.of("[17, 5]"),
        said(
            cell("", ""),
            """
            modbus_add_rw_signal("192.168.0.20", 1, 3, 2, 4, 1, "both")
            sleep(0.1)
            modbus_set_output_register("both", 5)
            sleep(0.2)
            textmsg(modbus_get_signal_status("both"))
            """));
  }

  @Test
  void customCommandsWriteToIt() throws Exception {
    RunningProgram program = cell("", "");
    program.run(
        "def f():\n"
            + "  modbus_send_custom_command(\"192.168.0.20\", 1, 6, [0, 2, 1, 44])\n"
            + "  modbus_send_custom_command(\"192.168.0.20\", 1, 5, [0, 3, 255, 0])\nend\n");
    assertEquals(300, value(program, "register", 2));
    assertEquals(1, value(program, "coil", 3));
  }

  @Test
  void programsTalkToItByASocketAsWell() throws Exception {
    assertEquals(
        List.of("[11, 0, 7, 0, 0, 0, 5, 1, 3, 2, 0, 17]"),
        said(
            cell("", ""),
            """
            socket_open("192.168.0.20", 502, "plc")
            request = [0, 7, 0, 0, 0, 6, 1, 3, 0, 3, 0, 1]
            i = 0
            while i < 12:
              socket_send_byte(request[i], "plc")
              i = i + 1
            end
            textmsg(socket_read_byte_list(11, "plc"))
            """));
  }

  @Test
  void oneThatIsOffTheNetworkIsLostAfterTheWatchdog() throws Exception {
    RunningProgram program = cell("", "");
    program.start(
        """
        def f():
          modbus_add_signal("192.168.0.20", 1, 3, 3, "level")
          sleep(0.2)
          while True:
            global level = modbus_get_signal_status("level")
            global error = modbus_get_error("level", 2)
            sync()
          end
        end
        """);
    program.advance(200);
    program.done(new WorldCommand.SetSignal("plc.online", 0));
    program.advance(800);
    assertEquals(ProgramState.RUNNING, program.programState());
    program.finish();
    assertTrue(program.reported().toString().contains("level"), program.reported().toString());
  }

  @Test
  void peopleSetItsSignalsAndAreToldWhatCannotBe() throws Exception {
    RunningProgram program = cell("", "");
    program.done(new WorldCommand.SetSignal("plc.register[0]", 65_535));
    program.advance(1);
    assertEquals(65_535, value(program, "register", 0));
    assertEquals(
        "plc.register[0] is 65536, must be 0 to 65535",
        program.ask(new WorldCommand.SetSignal("plc.register[0]", 65_536)).complaint().orElse(""));
  }

  private static int value(RunningProgram program, String group, int index) {
    return program.state().devices().getFirst().signals().stream()
        .filter(each -> each.name().equals(group))
        .findFirst()
        .orElseThrow()
        .values()
        .get(index);
  }
}
