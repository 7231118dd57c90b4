package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HexFormat;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.pendant.controller.command.Reply;
import org.pendant.controller.eip.AssemblyCommand;
import org.pendant.controller.eip.AssemblyData;
import org.pendant.controller.eip.AssemblyPair;
import org.pendant.controller.safety.SafetyMode;
import org.pendant.script.vm.ProgramState;

@Tag("slow")
class AssemblyProgramTest {
  private static final int FROM_PLC = 111;
  private static final int TO_PLC = 101;
  private static final int FRAMES_PER_S = 500;

  private final RunningProgram program = new RunningProgram();

  private void configure() {
    program.done(
        new AssemblyCommand.ConfigureAssemblies(new AssemblyPair(TO_PLC, 16, FROM_PLC, 16)));
  }

  private void receive(String hex) {
    program.done(new AssemblyCommand.ReceiveAssembly(FROM_PLC, data(hex)));
  }

  private static AssemblyData data(String hex) {
    return AssemblyData.of(HexFormat.of().parseHex(hex.replace(" ", "")));
  }

  private static String reading(String lines) {
    return "def f():\n  r = eip_reader_factory(\"111\", 16)\n" + lines + "\nend\n";
  }

  private static String writing(String lines) {
    return "def f():\n  w = eip_writer_factory(\"101\", 16)\n" + lines + "\nend\n";
  }

  private AssemblyData sent() {
    return program.state().assemblies().toPlc(TO_PLC).orElseThrow();
  }

  private void assertRefused(String text, String reason) {
    program.run(text);
    String last = program.reported().getLast();
    assertTrue(last.endsWith(": " + reason), last);
  }

  @Test
  void readsEveryTypeLittleEndian() {
    configure();
    receive("FF 3412 FEFF 0000C03F 05000000 4142 00");
    program.run(
        reading(
            """
              r.define_uint8(0, "a")
              r.define_uint16(1, "b")
              r.define_int16(3, "c")
              r.define_float32(5, "d")
              r.define_int32(9, "e")
              r.define_string(13, 3, "f")
              s = r.read(["a", "b", "c", "d", "e", "f"])
              textmsg(s)
              textmsg(r.read("c") + s.e)
            """));
    assertEquals(
        List.of("{a = 255, b = 4660, c = -2, d = 1.5, e = 5, f = \"AB\"}", "3"), program.said());
  }

  @Test
  void readsBitsOfBytesWordsAndDoubleWordsWithinNumbers() {
    configure();
    receive("01 0002 00000080 000000000000000000");
    program.run(
        reading(
            """
              r.define_uint8(0, "all")
              r.define_bit(0, 0, "low")
              r.define_bit(0, 1, "next")
              r.define_bit(1, 9, "word", 2)
              r.define_bit(3, 31, "double", 4)
              textmsg(r.read(["all", "low", "next", "word", "double"]))
            """));
    assertEquals(
        List.of("{all = 1, low = True, next = False, word = True, double = True}"), program.said());
  }

  @Test
  void writesAllMembersAtOnceAndFillsArraysAndTextsWithZeros() {
    configure();
    program.run(
        writing(
            """
              w.define_uint8_array(0, 4, "numbers")
              w.define_int16_array(4, 2, "offsets")
              w.define_string(8, 4, "name")
              w.define_float32(12, "speed")
              w.define_bit(3, 7, "start")
              w.write(struct(numbers=[9, 9, 9, 9], name="long"))
              w.write(struct(numbers=[1, 2], offsets=[-1, 300], name="ab", speed=1.5))
              w.write(struct(start=True))
            """));
    assertEquals(data("01020080 FFFF2C01 61620000 0000C03F"), sent());
  }

  @Test
  void clearMakesAllOfItZero() {
    configure();
    program.run(
        writing("  w.define_uint8(3, \"x\")\n  w.write(struct(x=7))\n  sync()\n  w.clear()"));
    assertEquals(AssemblyData.zero(16), sent());
  }

  @ParameterizedTest
  @CsvSource({
    "uint8, 256, 'a is 256, must be 0 to 255 for uint8'",
    "uint8, -1, 'a is -1, must be 0 to 255 for uint8'",
    "uint16, 65536, 'a is 65536, must be 0 to 65535 for uint16'",
    "int16, 32768, 'a is 32768, must be -32768 to 32767 for int16'",
    "int16, -32769, 'a is -32769, must be -32768 to 32767 for int16'",
    "int32, 1.5, 'a is 1.5, must be an int for int32'",
    "uint8, True, 'a is a bool, must be a number for uint8'",
    "uint8, '[1]', 'a is a list, must be a number for uint8'",
  })
  void refusesNumbersThatDoNotFitTheirType(String type, String value, String reason) {
    configure();
    assertRefused(
        writing("  w.define_" + type + "(0, \"a\")\n  w.write(struct(a=" + value + "))"),
        "write: " + reason);
  }

  @Test
  void aRefusedWriteChangesNothing() {
    configure();
    program.run(
        writing(
            """
              w.define_uint8(0, "a")
              w.define_uint8(1, "b")
              w.write(struct(a=1, b=300))
            """));
    assertEquals(AssemblyData.zero(16), sent());
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "define_uint8(3, \"b\")",
        "define_int32(3, \"b\")",
        "define_uint8_array(0, 3, \"b\")",
        "define_string(3, 1, \"b\")"
      })
  void refusesLabelsThatOverlap(String definition) {
    configure();
    assertRefused(
        reading("  r.define_uint16(2, \"a\")\n  r." + definition),
        definition.replaceAll("\\(.*", "") + ": b overlaps a");
  }

  @Test
  void refusesBitsThatOverlapBitsAndTexts() {
    configure();
    assertRefused(
        reading("  r.define_bit(1, 1, \"a\")\n  r.define_bit(0, 9, \"b\", 2)"),
        "define_bit: b overlaps a");
    assertRefused(
        reading("  r.define_string(0, 2, \"a\")\n  r.define_bit(1, 0, \"b\")"),
        "define_bit: b overlaps a");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "r.define_uint16(15, \"a\") | define_uint16: a ends at byte 17, must end within the 16"
            + " bytes of instance 111",
        "r.define_int32_array(0, 5, \"a\") | define_int32_array: a ends at byte 20, must end within"
            + " the 16 bytes of instance 111",
        "r.define_uint8(-1, \"a\") | define_uint8: offset is -1, must be 0 to 65535",
        "r.define_string(0, 0, \"a\") | define_string: length is 0, must be 1 to 65535",
        "r.define_bit(0, 8, \"a\") | define_bit: bit_number is 8, must be 0 to 7",
        "r.define_bit(0, 32, \"a\", 4) | define_bit: bit_number is 32, must be 0 to 31",
        "r.define_bit(0, 1, \"a\", 3) | define_bit: bitfield_width is 3, must be 1, 2 or 4",
        "r.define_uint8(0, \"\") | define_uint8: data_name has 0 characters, must have 1 to 255",
        "r.read([1]) | read: data_names is list [1], must be a string or a list of strings",
        "r.read(1) | read: data_names is int 1, must be a string or a list of strings",
        "r.define_uint8(0, 5) | define_uint8: data_name is int 5, must be a string",
        "r.define_bit(0, 0) | define_bit(offset, bit_number, data_name, bitfield_width=1) takes 3"
            + " to 4 arguments, not 2",
        "r.read(\"b\") | read: data_name b is not defined",
        "r.read([\"x\", \"x\"]) | read: data_names has x twice",
        "r.read([]) | read: data_names is list [], must be a string or a list of strings",
        "r.write(struct(a=1)) | write: this handle is for reading",
        "r.clear() | clear: this handle is for reading",
        "r.set_watchdog(0, 1) | set_watchdog: frequency is 0 Hz, must be above 0 and at most 10 Hz",
        "r.set_watchdog(11, 1) | set_watchdog: frequency is 11 Hz, must be above 0 and at most"
            + " 10 Hz",
        "r.set_watchdog(1, 3) | set_watchdog: action is 3, must be 0 to 2",
        "r.start_watchdog() | start_watchdog: no watchdog is set, set_watchdog sets one",
        "r.stop_watchdog() | stop_watchdog: no watchdog is set, set_watchdog sets one",
        "r.jump() | an eip handle has no method jump",
      })
  void refusesWhatTheManualRefuses(String line, String reason) {
    configure();
    String known = "  r.define_uint8(15, \"x\")\n";
    program.run(reading((line.contains("\"x\"") ? known : "") + "  " + line));
    String last = program.reported().getLast();
    assertTrue(last.endsWith(": " + reason), last);
  }

  @Test
  void refusesALabelThatIsInUse() {
    configure();
    assertRefused(
        reading("  r.define_uint8(0, \"a\")\n  r.define_uint8(1, \"a\")"),
        "define_uint8: data_name a is defined already");
  }

  @Test
  void onlyAStructCanBeWritten() {
    configure();
    assertRefused(writing("  w.write(5)"), "write: data_struct is int 5, must be a struct");
    assertRefused(
        writing("  w.define_string(0, 2, \"a\")\n  w.write(struct(a=\"abc\"))"),
        "write: a is a string of 3, must be at most 2 characters");
    assertRefused(
        writing("  w.define_int16_array(0, 2, \"a\")\n  w.write(struct(a=[1, 2, 3]))"),
        "write: a is a list of 3, must be at most 2 numbers");
  }

  @Test
  void aWriterCannotReadOrWatch() {
    configure();
    assertRefused(
        writing("  w.define_uint8(0, \"a\")\n  w.read(\"a\")"), "read: this handle is for writing");
    assertRefused(writing("  w.set_watchdog(1, 1)"), "set_watchdog: this handle is for writing");
  }

  @Test
  void theInstanceMustExistWithItsSize() {
    assertRefused(
        reading(""),
        "eip_reader_factory: there is no instance 111 from scanner to robot, add_configuration of"
            + " the service at port 40000 makes one");
    configure();
    assertRefused(
        "def f():\n  eip_writer_factory(\"101\", 17)\nend\n",
        "eip_writer_factory: data_size is 17, must be 16 for instance 101");
    assertRefused(
        "def f():\n  eip_reader_factory(\"x\", 17)\nend\n",
        "eip_reader_factory: instance_name is x, must be the number of an assembly instance");
  }

  @Test
  void aClosedHandleIsNoUseAndAnotherOneBeginsWithoutLabels() {
    configure();
    assertRefused(
        reading("  r.close()\n  r.define_uint8(0, \"a\")"),
        "define_uint8: this handle is closed, open a new one");
    program.run(
        reading(
            """
              r.define_uint8(0, "a")
              q = eip_reader_factory("111", 16)
              q.define_uint16(0, "a")
              textmsg(q.read("a"))
            """));
    assertEquals(List.of("0"), program.said());
  }

  @Test
  void aPairCannotBeChangedAndTheSameOneIsNoMistake() {
    configure();
    configure();
    assertInstanceOf(
        Reply.Refused.class,
        program.ask(
            new AssemblyCommand.ConfigureAssemblies(new AssemblyPair(TO_PLC, 17, FROM_PLC, 16))));
    assertInstanceOf(
        Reply.Refused.class,
        program.ask(
            new AssemblyCommand.ConfigureAssemblies(new AssemblyPair(FROM_PLC, 1, TO_PLC, 1))));
  }

  @Test
  void aLateScannerPausesTheProgramWithAProtectiveStop() {
    configure();
    program.start(reading("  r.set_watchdog(2, 1)\n  sleep(100)"));
    for (int i = 0; i < 4; i++) {
      program.advance(FRAMES_PER_S * 2 / 5);
      receive("00".repeat(16));
    }
    assertEquals(ProgramState.RUNNING, program.programState());
    program.advance(FRAMES_PER_S * 3 / 5);
    assertEquals(ProgramState.PAUSED, program.programState());
    assertEquals(SafetyMode.PROTECTIVE_STOP, program.state().safety().safetyMode());
    assertTrue(
        program
            .reported()
            .contains(
                "EtherNet/IP instance 111 must be written at least at 2 Hz and was not: protective"
                    + " stop, the program pauses"),
        () -> program.reported().toString());
  }

  @Test
  void aLateScannerEndsTheProgramWhenThatIsAsked() {
    configure();
    program.start(reading("  r.set_watchdog(10, 2)\n  sleep(100)"));
    program.advance(FRAMES_PER_S / 5);
    assertEquals(ProgramState.STOPPED, program.programState());
    assertEquals(SafetyMode.PROTECTIVE_STOP, program.state().safety().safetyMode());
  }

  @Test
  void anIgnoredOrStoppedWatchdogLeavesTheProgramAlone() {
    configure();
    program.start(
        reading("  r.set_watchdog(10, 2)\n  r.stop_watchdog()\n  sleep(1)\n  textmsg(\"on\")"));
    program.finish();
    assertEquals(List.of("on"), program.said());
    program.run(reading("  r.set_watchdog(10, 0)\n  sleep(1)\n  textmsg(\"and on\")"));
    assertEquals(List.of("on", "and on"), program.said());
    assertTrue(
        program.reported().stream().anyMatch(line -> line.endsWith("the program continues")),
        () -> program.reported().toString());
  }

  @Test
  void aStartedWatchdogHasItsFullTimeAgain() {
    configure();
    program.start(
        reading(
            "  r.set_watchdog(1, 2)\n  r.stop_watchdog()\n  sleep(5)\n  r.start_watchdog()\n"
                + "  sleep(100)"));
    program.advance(FRAMES_PER_S * 11 / 2);
    assertEquals(ProgramState.RUNNING, program.programState());
    program.advance(FRAMES_PER_S);
    assertEquals(ProgramState.STOPPED, program.programState());
  }

  @Test
  void whatWasWrittenOutlivesTheProgram() {
    configure();
    program.run(writing("  w.define_uint8(0, \"a\")\n  w.write(struct(a=5))"));
    program.advance(10);
    assertEquals(data("05" + "00".repeat(15)), sent());
  }
}
