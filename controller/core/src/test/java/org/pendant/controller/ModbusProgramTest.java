package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.controller.external.Connectors;
import org.pendant.controller.external.FakeModbus;
import org.pendant.controller.external.FakeModbus.FakePoint;
import org.pendant.controller.external.ModbusAddress;
import org.pendant.controller.external.ModbusErrors;
import org.pendant.controller.external.ModbusExchange;
import org.pendant.controller.external.ModbusKind;
import org.pendant.controller.modbus.ModbusSignalState;
import org.pendant.script.vm.ProgramState;

class ModbusProgramTest {
  private final FakeModbus devices = new FakeModbus();
  private final RunningProgram program =
      new RunningProgram(
          ControllerOptions.headless()
              .withOutside(
                  new Connectors(Connectors.NONE.sockets(), Connectors.NONE.rpc(), devices)));

  private void start(String lines) {
    program.start("def f():\n" + lines + "end\n");
  }

  private void run(String lines) {
    program.run("def f():\n" + lines + "end\n");
  }

  private FakePoint point() {
    return devices.points().getFirst();
  }

  private ModbusSignalState shown() {
    return program.state().modbus().getFirst();
  }

  private String reported() {
    return program.reported().getLast();
  }

  private void refuses(String call, String message) {
    run("  " + call + "\n");
    assertTrue(reported().endsWith(message), this::reported);
  }

  @Test
  void asksWhatTheSignalSays() {
    run(
        """
          modbus_add_signal("172.140.17.11", 255, 5, 1, "output1")
          modbus_add_signal("plc:1122", 0, 65535, 0, "input1", True)
          modbus_add_signal("[::1]:1122", 7, 0, 16, "registers", False, 123)
          modbus_add_rw_signal("172.140.17.11", 255, 5, 10, 15, 12, "both")
        """);
    ModbusAddress plc = new ModbusAddress("172.140.17.11", 502);
    assertEquals(
        List.of(
            new ModbusExchange(plc, 255, ModbusKind.DIGITAL_OUTPUT, 5, 1, 5, 1, false),
            new ModbusExchange(
                new ModbusAddress("plc", 1122),
                0,
                ModbusKind.DIGITAL_INPUT,
                65535,
                1,
                65535,
                1,
                true),
            new ModbusExchange(
                new ModbusAddress("::1", 1122),
                7,
                ModbusKind.REGISTER_OUTPUTS,
                0,
                123,
                0,
                123,
                false),
            new ModbusExchange(plc, 255, ModbusKind.READ_WRITE_REGISTERS, 5, 10, 15, 12, false)),
        devices.points().stream().map(FakePoint::exchange).toList());
  }

  @Test
  void valuesAreBoolsAndIntsAndListsOfSeveral() {
    start(
        """
          modbus_add_signal("d", 1, 0, 0, "bit")
          modbus_add_signal("d", 1, 0, 2, "word")
          modbus_add_signal("d", 1, 0, 15, "bits", False, 3)
          modbus_add_signal("d", 1, 0, 16, "words", False, 2)
          modbus_add_rw_signal("d", 1, 0, 2, 9, 1, "both")
          sleep(0.1)
          textmsg(modbus_get_signal_status("bit", False))
          textmsg(modbus_get_signal_status("word"))
          textmsg(modbus_get_signal_status("bits"))
          textmsg(modbus_get_signal_status("words"))
          textmsg(modbus_get_signal_status("both"))
        """);
    devices.points().get(0).answer(1);
    devices.points().get(1).answer(65535);
    devices.points().get(2).answer(1, 0, 1);
    devices.points().get(3).answer(7, 40000);
    devices.points().get(4).answer(3, 4);
    program.finish();
    assertEquals(
        List.of("True", "65535", "[True, False, True]", "[7, 40000]", "[3, 4]"), program.said());
  }

  @Test
  void theLastValidValueLastsAsLongAsTheWatchdog() {
    start(
        """
          modbus_add_signal("d", 1, 0, 2, "word")
          modbus_set_signal_watchdog("word", 0.5)
          while True:
            sync()
            w = modbus_get_signal_status("word")
          end
        """);
    point().answer(5);
    program.advance(5);
    point().lose(ModbusErrors.RESET);
    program.advance(240);
    assertEquals(ProgramState.RUNNING, program.programState());
    program.advance(12);
    assertEquals(ProgramState.STOPPED, program.programState());
    assertTrue(
        reported().contains("modbus_get_signal_status: signal \"word\" has not been valid for 0.5"),
        this::reported);
    assertTrue(reported().endsWith("s: connection reset"), this::reported);
  }

  @Test
  void aNewSignalHasTwoSecondsToBecomeValid() {
    start(
        """
          modbus_add_signal("d", 1, 0, 2, "word")
          textmsg(modbus_get_signal_status("word"))
          sleep(1.9)
          textmsg(modbus_get_signal_status("word"))
          sleep(0.2)
          textmsg(modbus_get_signal_status("word"))
        """);
    program.finish();
    assertEquals(List.of("0", "0"), program.said());
    assertTrue(reported().endsWith("s: not connected"), this::reported);
  }

  @Test
  void aSignalThatIsNotAskedStaysValid() {
    start(
        """
          modbus_add_signal("d", 1, 0, 2, "word")
          modbus_set_signal_update_frequency("word", 0)
          sleep(5)
          textmsg(modbus_get_signal_status("word"))
        """);
    point().answer(9);
    program.finish();
    assertEquals(List.of("9"), program.said());
    assertEquals(List.of("0 Hz", "update"), point().wishes());
  }

  @Test
  void errorsAreTheConnectionAboveTheDevice() {
    start(
        """
          modbus_add_signal("d", 1, 0, 2, "word")
          thread watch():
            last = 1
            while True:
              now = modbus_get_error("word")
              if now != last:
                last = now
                textmsg(now, "")
                textmsg(modbus_get_error("word", 1), " device")
                textmsg(modbus_get_error("word", 2), " connection")
              end
              sync()
            end
          end
          run watch()
          sleep(10)
        """);
    program.advance(2);
    point().answer(1);
    program.advance(2);
    point().refuse(4);
    program.advance(2);
    point().lose(ModbusErrors.DISCONNECTED);
    program.advance(2);
    assertEquals(
        List.of(
            "-131072",
            "0 device",
            "-2 connection",
            "0",
            "0 device",
            "0 connection",
            "4",
            "4 device",
            "0 connection",
            "-131068",
            "4 device",
            "-2 connection"),
        program.said());
  }

  @Test
  void tellsHowLongASignalHasNotBeenValid() {
    start(
        """
          modbus_add_signal("d", 1, 0, 2, "word")
          sleep(0.1)
          textmsg(modbus_get_time_since_signal_invalid("word"))
          sleep(1)
          textmsg(modbus_get_time_since_signal_invalid("word") > 0.99)
        """);
    point().answer(1);
    program.advance(60);
    point().refuse(2);
    program.finish();
    assertEquals(List.of("0", "True"), program.said());
    assertEquals(
        List.of("Modbus signal \"word\": device error 2, illegal data access"), program.reported());
  }

  @Test
  void shorterListsLeaveTheOtherOutputsAsTheyWere() {
    start(
        """
          modbus_add_signal("d", 1, 0, 16, "words", False, 3)
          modbus_add_signal("d", 1, 0, 15, "bits", False, 3)
          sleep(0.1)
          modbus_set_output_register("words", [9])
          modbus_set_output_register("words", 8)
          modbus_set_output_register("words", [1, 65535, 3], False)
          modbus_set_output_signal("bits", [False, True])
          modbus_set_output_signal("bits", True)
          textmsg(modbus_get_signal_status("words"))
          textmsg(modbus_get_signal_status("bits"))
        """);
    devices.points().get(0).answer(5, 6, 7);
    devices.points().get(1).answer(1, 0, 1);
    program.finish();
    assertEquals(
        List.of("write [9, 6, 7]", "write [8, 6, 7]", "write [1, 65535, 3]"), point().wishes());
    assertEquals(List.of("write [0, 1, 1]", "write [1, 1, 1]"), devices.points().get(1).wishes());
    assertEquals(List.of("[1, 65535, 3]", "[True, True, True]"), program.said());
  }

  @Test
  void aReadWriteSignalKeepsTheTwoApart() {
    start(
        """
          modbus_add_rw_signal("d", 1, 0, 2, 9, 3, "both")
          sleep(0.1)
          modbus_set_output_register("both", [1, 2])
          textmsg(modbus_get_signal_status("both"))
        """);
    point().answer(5, 6);
    program.finish();
    assertEquals(List.of("write [1, 2, 0]"), point().wishes());
    assertEquals(List.of("[5, 6]"), program.said());
  }

  @Test
  void aNameThatIsTakenGetsTheNewSignal() {
    run(
        """
          modbus_add_signal("d", 1, 0, 2, "s")
          modbus_add_signal("d", 1, 0, 3, "s")
        """);
    assertEquals(List.of("end"), point().wishes());
    assertEquals(1, program.state().modbus().size());
    assertEquals(ModbusKind.REGISTER_OUTPUT, shown().exchange().kind());
  }

  @Test
  void signalsOutliveTheProgramAndTheNextOneHasThem() {
    run("  modbus_add_signal(\"d\", 1, 0, 2, \"s\")\n");
    point().answer(3);
    program.advance(2);
    assertTrue(shown().valid());
    assertEquals(List.of(3), shown().values());
    run("  textmsg(modbus_get_signal_status(\"s\"))\n  modbus_delete_signal(\"s\")\n");
    assertEquals(List.of("3"), program.said());
    assertEquals(List.of("end"), point().wishes());
    assertEquals(List.of(), program.state().modbus());
  }

  @Test
  void theStateShowsWhatAnOutputIsSetToInTheSameFrame() {
    start("  modbus_add_signal(\"d\", 1, 0, 3, \"s\")\n  sleep(1)\n");
    program.advance(1);
    List<ModbusSignalState> before = program.state().modbus();
    program.advance(1);
    assertSame(before, program.state().modbus());
    program.done(
        new ProgramCommand.RunSecondary(
            program.program("sec s():\n modbus_set_output_register(\"s\", 7)\nend\n")));
    assertEquals(List.of(7), shown().values());
    assertFalse(shown().valid());
    assertEquals(-2, shown().connectionError());
  }

  @Test
  void aSecondaryProgramMaySetSeveralOutputsAndResetWithoutWaiting() {
    start("  modbus_add_signal(\"d\", 1, 0, 1, \"s\")\n  sleep(1)\n");
    program.done(
        new ProgramCommand.RunSecondary(
            program.program(
                """
                sec s():
                  modbus_set_output_signal("s", True)
                  modbus_set_output_signal("s", False)
                  modbus_reset_connection("d", False)
                end
                """)));
    assertEquals(List.of("write [1]", "write [0]", "reconnect"), point().wishes());
  }

  @Test
  void outputsFollowTheProgram() {
    start(
        """
          modbus_add_signal("d", 1, 0, 1, "only")
          modbus_add_signal("d", 1, 0, 3, "low")
          modbus_add_signal("d", 1, 0, 16, "failed", False, 2)
          modbus_set_runstate_dependent_choice("only", 3)
          modbus_set_runstate_dependent_choice("low", 1)
          modbus_set_runstate_dependent_choice("failed", 5)
          sync()
          halt
        """);
    program.finish();
    assertEquals(List.of("write [1]", "write [0]"), devices.points().get(0).wishes());
    assertEquals(List.of("write [0]"), devices.points().get(1).wishes());
    assertEquals(List.of("write [65535, 65535]"), devices.points().get(2).wishes());
    run("  sqrt(-1)\n");
    assertEquals(
        List.of("write [1]", "write [0]", "write [1]", "write [0]"),
        devices.points().get(0).wishes());
    assertEquals(
        List.of("write [65535, 65535]", "write [65535, 65535]", "write [0, 0]"),
        devices.points().get(2).wishes());
  }

  @Test
  void anInputCanSwitchFreedriveOnAndALostOneSwitchesItOff() {
    run(
        """
          modbus_add_signal("d", 1, 0, 0, "s")
          modbus_set_digital_input_action("s", "freedrive")
        """);
    program.advance(2);
    assertFalse(program.state().freedrive().active());
    point().answer(1);
    program.advance(2);
    assertTrue(program.state().freedrive().active());
    point().lose(ModbusErrors.NO_ANSWER);
    program.advance(900);
    assertTrue(program.state().freedrive().active());
    program.advance(110);
    assertFalse(program.state().freedrive().active());
    point().answer(1);
    program.advance(2);
    assertTrue(program.state().freedrive().active());
    run("  modbus_set_digital_input_action(\"s\", \"default\")\n");
    program.advance(2);
    assertFalse(program.state().freedrive().active());
  }

  @Test
  void resettingWaitsUntilAllSignalsOfTheDeviceHaveAnAnswer() {
    start(
        """
          modbus_add_signal("d", 1, 0, 0, "a")
          modbus_add_signal("d:1502", 1, 0, 0, "b")
          modbus_add_signal("other", 1, 0, 0, "c")
          modbus_reset_connection("d:1502", False)
          modbus_reset_connection("d")
          textmsg("again")
        """);
    program.advance(50);
    assertEquals(List.of("reconnect"), point().wishes());
    assertEquals(List.of("reconnect", "reconnect"), devices.points().get(1).wishes());
    assertEquals(List.of(), devices.points().get(2).wishes());
    point().answer(0);
    program.advance(50);
    assertEquals(List.of(), program.said());
    devices.points().get(1).refuse(4);
    program.finish();
    assertEquals(List.of("again"), program.said());
  }

  @Test
  void aCommandOfTheProgramsOwnWaitsForTheDevice() {
    start(
        """
          modbus_send_custom_command("172.140.17.11", 103, 6, [17, 32, 2, 88])
          textmsg("sent")
          modbus_send_custom_command("172.140.17.11:5", 0, 127, [])
          textmsg("sent")
        """);
    program.advance(20);
    assertEquals(List.of(), program.said());
    assertEquals("172.140.17.11:502 103 6 17 32 2 88", devices.commands().getFirst().toString());
    devices.commands().getFirst().end();
    program.advance(2);
    assertEquals(List.of("sent"), program.said());
    devices.commands().get(1).fail("172.140.17.11:5: connection refused");
    program.finish();
    assertTrue(
        reported().endsWith("modbus_send_custom_command: 172.140.17.11:5: connection refused"),
        this::reported);
  }

  @Test
  void oneLineTellsOfADeviceThatIsGone() {
    start(
        """
          modbus_add_signal("d", 1, 0, 0, "a")
          modbus_add_signal("d", 1, 1, 0, "b")
          sleep(1)
        """);
    program.advance(1);
    devices.points().forEach(each -> each.lose(ModbusErrors.REFUSED));
    program.advance(5);
    devices.points().forEach(each -> each.answer(0));
    program.advance(5);
    devices.points().forEach(each -> each.lose(ModbusErrors.REFUSED));
    program.finish();
    assertEquals(List.of("Modbus device d:502: connection refused"), program.reported());
  }

  @Test
  void thereIsAMostOfSignals() {
    run(
        """
          i = 0
          while i < 1001:
            modbus_add_signal("d", 1, 0, 0, str_cat("s", i))
            i = i + 1
          end
        """);
    assertEquals(1000, devices.points().size());
    assertTrue(
        reported()
            .endsWith("modbus_add_signal: there are 1000 Modbus signals already, delete some"),
        this::reported);
  }

  @Test
  void refusesWhatCannotBeAdded() {
    refuses(
        "modbus_add_signal(\"\", 1, 0, 0, \"s\")",
        "modbus_add_signal: IP is \"\", must not be empty");
    refuses(
        "modbus_add_signal(\"d:0\", 1, 0, 0, \"s\")",
        "IP is d:0, must have a port of 1 to 65535 behind the colon");
    refuses("modbus_add_signal(\"d\", 256, 0, 0, \"s\")", "slave_number is 256, must be 0 to 255");
    refuses(
        "modbus_add_signal(\"d\", 1, -1, 0, \"s\")", "signal_address is -1, must be 0 to 65535");
    refuses(
        "modbus_add_signal(\"d\", 1, 65530, 16, \"s\", False, 10)",
        "signal_address is 65530, must leave room for 10 up to 65535");
    refuses(
        "modbus_add_signal(\"d\", 1, 0, 23, \"s\")",
        "signal_type is 23, must be 0, 1, 2, 3, 15 or 16");
    refuses(
        "modbus_add_signal(\"d\", 1, 0, 0, \"\")",
        "signal_name is \"\", must have 1 to 20 characters");
    refuses(
        "modbus_add_signal(\"d\", 1, 0, 0, \"" + "s".repeat(21) + "\")",
        "must have 1 to 20 characters");
    refuses(
        "modbus_add_signal(\"d\", 1, 0, 16, \"s\", False, 124)",
        "register_count is 124, must be 1 to 123");
    refuses(
        "modbus_add_rw_signal(\"d\", 1, 0, 124, 0, 1, \"s\")",
        "read_register_count is 124, must be 1 to 123");
    refuses(
        "modbus_add_rw_signal(\"d\", 1, 0, 1, 0, 122, \"s\")",
        "write_register_count is 122, must be 1 to 121, more do not fit one request");
    assertEquals(List.of(), devices.points());
  }

  @Test
  void refusesWhatNoSignalCanDo() {
    run(
        """
          modbus_add_signal("d", 1, 0, 0, "in")
          modbus_add_signal("d", 1, 0, 1, "out")
          modbus_add_signal("d", 1, 0, 16, "reg", False, 2)
        """);
    refuses(
        "modbus_get_signal_status(\"x\")",
        "modbus_get_signal_status: signal_name is \"x\", must be a signal that was added");
    refuses("modbus_delete_signal(\"\")", "signal_name is \"\", must be a signal that was added");
    refuses(
        "modbus_get_signal_status(\"in\", True)", "is_secondary_program is True, must be False");
    refuses(
        "modbus_set_output_signal(\"in\", True)",
        "\"in\" is a digital input, must be a digital output");
    refuses(
        "modbus_set_output_signal(\"reg\", True)",
        "\"reg\" is a multiple register output, must be a digital output");
    refuses(
        "modbus_set_output_register(\"out\", 1)",
        "\"out\" is a digital output, must be a register output");
    refuses(
        "modbus_set_output_register(\"reg\", 65536)",
        "register_value is 65536, must be 0 to 65535");
    refuses(
        "modbus_set_output_register(\"reg\", [1, -1])",
        "register_value is [1, -1], must have ints of 0 to 65535");
    refuses(
        "modbus_set_output_register(\"reg\", [1, 2, 3])",
        "register_value is [1, 2, 3], must have 1 to 2 elements");
    refuses(
        "modbus_set_output_signal(\"out\", [1])",
        "digital_value is list [1], must be a bool or a list of bools");
    refuses(
        "modbus_set_signal_update_frequency(\"in\", 501)",
        "update_frequency is 501, must be -1 to 500");
    refuses("modbus_get_error(\"in\", 3)", "error_source is 3, must be 0 to 2");
    refuses(
        "modbus_set_signal_watchdog(\"in\", 301)", "new_timeout_in_sec is 301, must be 0 to 300");
    refuses(
        "modbus_set_digital_input_action(\"out\", \"freedrive\")",
        "\"out\" is a digital output, must be a digital input");
    refuses(
        "modbus_set_digital_input_action(\"in\", \"stop\")",
        "action is stop, must be \"default\" or \"freedrive\"");
    refuses(
        "modbus_set_runstate_dependent_choice(\"in\", 1)",
        "\"in\" is a digital input, must be an output");
    refuses(
        "modbus_set_runstate_dependent_choice(\"out\", 6)", "runstate_choice is 6, must be 0 to 5");
    refuses(
        "modbus_request_update_signal_value(\"y\")",
        "signal_name is \"y\", must be a signal that was added");
  }

  @Test
  void refusesWhatCannotBeSent() {
    refuses(
        "modbus_reset_connection(\"d\")",
        "connection_id is \"d\", must be a device that a signal is at");
    refuses(
        "modbus_send_custom_command(\"d\", 1, 128, [1])", "function_code is 128, must be 1 to 127");
    refuses(
        "modbus_send_custom_command(\"d\", 1, 6, [256])",
        "data is [256], must have ints of 0 to 255");
    refuses(
        "modbus_send_custom_command(\"d\", 1, 6, [1.5])",
        "data is list [1.5], must be a list of ints");
    assertEquals(Collections.emptyList(), devices.commands());
  }

  @Test
  void aControllerWithoutDoorsRefusesClearly() {
    RunningProgram alone = new RunningProgram();
    alone.run("def f():\n  modbus_add_signal(\"d\", 1, 0, 0, \"s\")\nend\n");
    assertTrue(
        alone
            .reported()
            .getLast()
            .endsWith("modbus_add_signal: this controller has no way to the outside"),
        () -> alone.reported().getLast());
  }
}
