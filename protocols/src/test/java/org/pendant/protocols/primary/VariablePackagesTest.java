package org.pendant.protocols.primary;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.util.HexFormat;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.command.Reply;
import org.pendant.language.source.Source;
import org.pendant.script.value.Value;
import org.pendant.script.variables.VariableSample;
import org.pendant.script.vm.Program;
import org.pendant.script.vm.ProgramState;

class VariablePackagesTest {
  private static final long TIME_US = 12_345_678_000L;

  /** The variables of a program at its end. */
  private static List<VariableSample> variablesOf(String statements) {
    Controller controller = new Controller(ControllerOptions.headless());
    Program program =
        controller
            .load(Source.of("p", "def p():\n" + statements + "end\n"))
            .program()
            .orElseThrow();
    CompletableFuture<Reply> reply = controller.submit(new ProgramCommand.StartProgram(program));
    controller.advance();
    assertEquals(new Reply.Done(), reply.join());
    assertTrue(
        controller.runUntil(
            () -> controller.state().program().state() == ProgramState.STOPPED, 1000));
    assertTrue(!controller.state().program().failed(), () -> "" + controller.state().program());
    return controller.state().variables().globals();
  }

  private static void assertBytes(String notation, byte[] bytes) {
    assertEquals(RobotMessageCodecTest.hex(notation), HexFormat.of().formatHex(bytes));
  }

  private static String value(Value value) {
    return HexFormat.of().formatHex(ValueCodec.encode(value));
  }

  @Test
  void names() {
    List<VariableSample> variables = variablesOf("  a = 5\n  b = True\n");
    List<byte[]> packages = VariablePackages.setup(TIME_US, variables);
    assertEquals(1, packages.size());
    assertBytes("00000014 19 00000002DFDC18B0 00 0000 610A 620A", packages.getFirst());
  }

  @Test
  void values() {
    List<VariableSample> variables = variablesOf("  a = 5\n  b = True\n");
    List<byte[]> packages = VariablePackages.update(TIME_US, variables);
    assertEquals(1, packages.size());
    assertBytes(
        "00000019 19 00000002DFDC18B0 01 0000 0F 00000005 0A 0D 01 0A", packages.getFirst());
  }

  @Test
  void nothingNew() {
    assertBytes("00000010 19 FFFFFFFFFFFFFFFF 01 0000", VariablePackages.empty());
  }

  @Test
  void everyKindOfValue() {
    List<VariableSample> variables =
        variablesOf(
            """
              f = 0.5
              s = "hi"
              p = p[1, 2, 3, 0, 0, 0]
              l = [1, 2]
              b = [True, False]
              m = [[1, 2.5], [3, 4]]
              t = struct(x = 1)
              q = [p, p]
            """);
    assertBytes(
        "00000066 19 00000002DFDC18B0 01 0000"
            + " 10 3F000000 0A"
            + " 04 0002 \"hi\" 0A"
            + " 0C 3F800000 40000000 40400000 00000000 00000000 00000000 0A"
            + " 11 0002 0F 00000001 0F 00000002 0A"
            + " 11 0002 0D 01 0D 00 0A"
            + " 12 0002 0002 10 3F800000 10 40200000 10 40400000 10 40800000 0A",
        VariablePackages.update(TIME_US, variables.subList(0, 6)).getFirst());
    assertEquals("04", value(variables.get(6).value().orElseThrow()).substring(0, 2));
    assertEquals(
        2 + 4 + 2 * 50, value(variables.get(7).value().orElseThrow()).length(), "two poses");
  }

  @Test
  void variablesWithoutAValueHaveTypeNone() {
    List<VariableSample> variables = variablesOf("  if False:\n    a = 1\n  end\n  b = 2\n");
    assertBytes(
        "00000018 19 00000002DFDC18B0 01 0000 00 0A 0F 00000002 0A",
        VariablePackages.update(TIME_US, variables).getFirst());
  }

  @Test
  void manyVariablesTakeSeveralPackagesThatSayWhereTheyBegin() {
    StringBuilder text = new StringBuilder();
    IntStream.range(0, 700).forEach(i -> text.append("  v" + (1000 + i) + " = " + i + "\n"));
    List<VariableSample> variables = variablesOf(text.toString());
    for (List<byte[]> packages :
        List.of(
            VariablePackages.setup(TIME_US, variables),
            VariablePackages.update(TIME_US, variables))) {
      assertTrue(packages.size() > 1);
      int next = 0;
      for (byte[] each : packages) {
        assertTrue(each.length <= VariablePackages.USUAL_BYTES, "" + each.length);
        assertEquals(each.length, ByteBuffer.wrap(each).getInt());
        assertEquals(next, ByteBuffer.wrap(each).getShort(14));
        next += entries(each);
      }
      assertEquals(700, next);
    }
  }

  /** How many variables a package has: names and ints take five bytes and a line end each. */
  private static int entries(byte[] bytes) {
    int count = 0;
    for (int i = 16; i < bytes.length; i += 6) {
      assertEquals('\n', bytes[i + 5]);
      count++;
    }
    return count;
  }
}
