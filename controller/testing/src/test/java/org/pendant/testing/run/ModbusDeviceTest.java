package org.pendant.testing.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.testing.TestResult;
import org.pendant.testing.TestStatus;

class ModbusDeviceTest {
  private static final String[] PLC = {
    "def plc():",
    "  modbus_add_signal(\"192.168.1.30\", 255, 4, 0, \"ready\")",
    "  modbus_add_signal(\"192.168.1.30\", 255, 7, 1, \"busy\")",
    "  modbus_add_signal(\"192.168.1.30\", 255, 128, 2, \"order\")",
    "  modbus_add_signal(\"192.168.1.30\", 255, 129, 3, \"count\")",
    "  while not modbus_get_signal_status(\"ready\", False):",
    "    sync()",
    "  end",
    "  modbus_set_output_signal(\"busy\", True)",
    "  global order = modbus_get_signal_status(\"order\", False)",
    "  modbus_set_output_register(\"count\", order * 2)",
    "  sleep(0.3)",
    "end"
  };

  private static void passes(String... lines) {
    TestResult result = Suite.of(lines).with("cell/plc.script", PLC).only();
    assertEquals(Optional.empty(), result.failure());
    assertEquals(TestStatus.PASSED, result.status());
  }

  /** One test that is its program itself. */
  private static String[] test(String... lines) {
    List<String> all = new ArrayList<>(List.of("def test_a():"));
    all.addAll(List.of(lines));
    all.add("end");
    return all.toArray(String[]::new);
  }

  @Test
  void theTestPlaysThePlcThatAProgramHasSignalsAt() {
    passes(
        test(
            "modbus_device(\"192.168.1.30\")",
            "device_set_input_register(\"192.168.1.30\", 128, 21)",
            "start(\"plc.script\")",
            "sleep(0.5)",
            "assert_false(device_coil(\"192.168.1.30\", 7))",
            "device_set_input(\"192.168.1.30\", 4, True)",
            "eventually(device_coil(\"192.168.1.30\", 7), within=0.25)",
            "eventually(device_register(\"192.168.1.30\", 129) == 42, within=0.25)",
            "wait_for_end()",
            "assert_equal(program_variable(\"order\"), 21)"));
  }

  @Test
  void severalValuesAreSetAndReadAsLists() {
    passes(
        test(
            "modbus_device(\"plc:1502\")",
            "device_set_register(\"plc:1502\", 10, [7, 40000])",
            "device_set_coil(\"plc:1502\", 0, [True, False, True])",
            "modbus_add_signal(\"plc:1502\", 1, 0, 15, \"bits\", False, 3)",
            "modbus_add_rw_signal(\"plc:1502\", 1, 10, 2, 20, 1, \"both\")",
            "sleep(0.1)",
            "assert_equal(modbus_get_signal_status(\"bits\", False), [True, False, True])",
            "assert_equal(modbus_get_signal_status(\"both\", False), [7, 40000])",
            "modbus_set_output_register(\"both\", 5)",
            "eventually(device_register(\"plc:1502\", 20) == 5, within=0.25)"));
  }

  @Test
  void signalsAreAskedInTheirFrequencyOfRobotTime() {
    passes(
        test(
            "modbus_device(\"plc\")",
            "modbus_add_signal(\"plc\", 1, 0, 2, \"word\")",
            "sleep(1)",
            "assert_near(device_requests(\"plc\"), 10, 1)",
            "modbus_set_signal_update_frequency(\"word\", 50)",
            "sleep(1)",
            "assert_near(device_requests(\"plc\"), 60, 2)",
            "modbus_set_signal_update_frequency(\"word\", 0)",
            "sleep(1)",
            "assert_near(device_requests(\"plc\"), 60, 2)"));
  }

  @Test
  void aDeviceMayAnswerLateOrWithAnExceptionOrNotAtAll() {
    passes(
        test(
            "modbus_device(\"plc\")",
            "device_set_input_register(\"plc\", 0, 1)",
            "device_delay(\"plc\", 0.3)",
            "modbus_add_signal(\"plc\", 1, 0, 2, \"word\")",
            "began = robot_time()",
            "eventually(modbus_get_signal_status(\"word\", False) == 1, within=1)",
            "assert_near(robot_time() - began, 0.3, 0.02)",
            "device_delay(\"plc\", 0)",
            "device_error(\"plc\", 2)",
            "eventually(modbus_get_error(\"word\", 1) == 2, within=0.5)",
            "assert_equal(modbus_get_signal_status(\"word\", False), 1)",
            "device_error(\"plc\", 0)",
            "eventually(modbus_get_error(\"word\") == 0, within=0.25)",
            "device_silent(\"plc\")",
            "eventually(modbus_get_error(\"word\", 2) == 110, within=1.3)",
            "device_silent(\"plc\", False)",
            "eventually(modbus_get_error(\"word\") == 0, within=1.3)",
            "device_refuse(\"plc\")",
            "eventually(modbus_get_error(\"word\", 2) == 111, within=0.25)",
            "device_refuse(\"plc\", False)",
            "eventually(modbus_get_error(\"word\") == 0, within=0.25)"));
  }

  @Test
  void whatADeviceRefusesIsNotWritten() {
    passes(
        test(
            "modbus_device(\"plc\")",
            "device_error(\"plc\", 4)",
            "modbus_add_signal(\"plc\", 1, 3, 3, \"word\")",
            "modbus_set_output_register(\"word\", 9)",
            "sleep(0.3)",
            "assert_equal(device_register(\"plc\", 3), 0)",
            "device_error(\"plc\", 0)",
            "eventually(device_register(\"plc\", 3) == 9, within=0.25)"));
  }

  @Test
  void requestsOfBytesAreKeptAndWriteWhatTheySay() {
    passes(
        test(
            "modbus_device(\"plc\")",
            "modbus_send_custom_command(\"plc\", 255, 6, [0, 8, 1, 2])",
            "assert_equal(device_register(\"plc\", 8), 258)",
            "modbus_send_custom_command(\"plc\", 255, 5, [0, 1, 255, 0])",
            "assert_true(device_coil(\"plc\", 1))",
            "modbus_send_custom_command(\"plc\", 1, 15, [0, 4, 0, 3, 1, 5])",
            "assert_true(device_coil(\"plc\", 4) and not device_coil(\"plc\", 5))",
            "assert_true(device_coil(\"plc\", 6))",
            "modbus_send_custom_command(\"plc\", 1, 16, [0, 0, 0, 2, 4, 0, 1, 0, 2])",
            "assert_equal(device_register(\"plc\", 1), 2)",
            "assert_equal(device_commands(\"plc\"), 4)",
            "assert_equal(device_command(\"plc\", 0), [255, 6, 0, 8, 1, 2])"));
  }

  @Test
  void connectionsAreMadeAgainWhenAProgramAsks() {
    passes(
        test(
            "modbus_device(\"plc\")",
            "modbus_add_signal(\"plc\", 1, 0, 2, \"word\")",
            "sleep(0.1)",
            "modbus_reset_connection(\"plc\")",
            "assert_equal(modbus_get_error(\"word\"), 0)"));
  }

  @Test
  void whereTheTestPlaysNoDeviceConnectionsAreRefused() {
    TestResult result =
        Suite.of(test("start(\"plc.script\")", "wait_for_end()"))
            .with("cell/plc.script", PLC)
            .only();

    String message = result.failure().orElseThrow().message();
    assertTrue(message.endsWith("connection refused"), message);
  }

  @Test
  void whatIsAskedOfADeviceThatNobodyPlaysIsAnError() {
    TestResult result = Suite.of(test("device_coil(\"plc\", 0)")).only();

    assertEquals(
        "device_coil: the test plays no device at plc:502, modbus_device(\"plc:502\") does",
        result.failure().orElseThrow().message());
  }
}
